/// What every reader does with its geometry in the end.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/mesh/mesh_assembly.h"

#include <cstddef>

namespace rtcore {

/// Refuses what does not fit into memory, else makes room. A `memoryLimit` of 0 is none.
void refuseTooMuch(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t memoryLimit,
                   MeshAssembler& assembler);

/// Moves the geometry into the model, with normals, and fills in the report what was dropped.
void finishGeometry(MeshAssembler& assembler, float creaseAngle, FileImport& import);

/// After it: refuses a model of which there is nothing to see, of `meshes` meshes, and drops equal triangles.
void refuseUseless(const MeshAssembler& assembler, std::size_t meshes, FileImport& import);

} // namespace rtcore
