/// Checks and final steps for the geometry, shared by all readers.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/mesh/mesh_assembly.h"

#include <cstddef>

namespace rtcore {

/// Refuses what does not fit into memory, else makes room. A `memoryLimit` of 0 is none.
void refuseTooMuch(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t memoryLimit,
                   MeshAssembler& assembler);

/// Refuses a file that has vertices alone.
[[noreturn]] void refusePoints(std::uint64_t count);

/// Moves the geometry into the model, with normals, and fills in the report what was dropped.
void finishGeometry(MeshAssembler& assembler, float creaseAngle, FileImport& import);

/// Afterwards: refuses a model, of `meshes` meshes, with nothing to see, and drops equal triangles.
void refuseUseless(const MeshAssembler& assembler, std::size_t meshes, FileImport& import);

} // namespace rtcore
