/// Meshes that one node shows at many places (EXT_mesh_gpu_instancing).
#pragma once

#include "rtcore/io/import/gltf/accessors.h"
#include "rtcore/io/import/mesh/affine.h"

#include <optional>
#include <vector>

namespace rtcore::gltf {

inline constexpr const char* kInstancingExtension = "EXT_mesh_gpu_instancing";

/// From the mesh's coordinates to the node's, for each instance; nothing where the node is one alone.
/// Lists that cannot be read, or are shorter than others, are as if they were not there.
std::optional<std::vector<Affine>> instancesOf(const Json& node, Accessors& accessors);

/// As many as instancesOf() would give; 1 for a node alone.
std::uint64_t instanceCount(const Json& node, Accessors& accessors);

} // namespace rtcore::gltf
