/// Checks and final steps for the geometry, shared by all readers.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/mesh/instance_graph.h"
#include "rtcore/io/import/mesh/mesh_assembly.h"

#include <cstddef>
#include <span>

namespace rtcore {

/// Memory that each part of a model takes beside its triangles, bytes.
inline constexpr std::uint64_t kBytesOfPart = 400;

/// Refuses what does not fit into so many bytes, and more than 50 million parts. A `memoryLimit` of 0 is
/// none.
void refuseTooMuch(const ExpandedCount& count, std::uint64_t memoryLimit,
                   std::uint64_t bytesOfPart = kBytesOfPart);

/// The same, else makes room.
void makeRoomFor(const ExpandedCount& count, std::uint64_t memoryLimit, MeshAssembler& assembler);

/// Refuses a file that has vertices alone.
[[noreturn]] void refusePoints(std::uint64_t count);

/// Thrown by finishGeometry(): floats are too coarse for the positions; the file is to be read once more,
/// with that origin taken off.
struct FarFromZero {
    LocalOrigin origin;
};

/// Throws FarFromZero for points from which nothing was taken off, and something should be.
void refuseFar(std::span<const Vec3> positions, const LocalOrigin& taken);

/// Moves the geometry into the model, with normals, and fills in the report what was dropped. `origin`: what
/// was taken off; throws FarFromZero where nothing was and something should be.
void finishGeometry(MeshAssembler& assembler, float creaseAngle, const LocalOrigin& origin,
                    FileImport& import);

/// Afterwards: refuses a model, of `meshes` meshes, with nothing to see, and drops equal triangles.
void refuseUseless(const MeshAssembler& assembler, std::size_t meshes, FileImport& import);

} // namespace rtcore
