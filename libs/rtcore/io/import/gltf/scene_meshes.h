/// The meshes of the scene that a glTF file shows, at each place where they stand.
#pragma once

#include "rtcore/io/import/gltf/accessors.h"
#include "rtcore/io/import/gltf/node_walk.h"
#include "rtcore/io/import/gltf/primitive.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/io/import/mesh/instance_graph.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rtcore::gltf {

struct Placement {
    std::size_t mesh = 0;
    std::size_t placed = 0; ///< the number of its node in the walk
    Affine toWorld;
    std::optional<std::size_t> skin;       ///< which takes the place of `toWorld`
    std::optional<std::uint64_t> instance; ///< of a node that shows it many times
};

/// Of what the file shows, with all instances. Throws FileError BadData for a graph with cycles.
ExpandedCount shownOf(const Json& root, PrimitiveReader& primitives, Accessors& accessors);

/// In the order of the walk.
std::vector<Placement> placementsOf(const Json& root, const World& world, const NodeWalk& walk,
                                    Accessors& accessors);

/// What a mesh of a placement is called: by the way to its node, else by the mesh. The primitives of one mesh
/// go by their materials, instances by their numbers.
std::string nameOf(const Json& root, const NodeWalk& walk, const Placement& placement, std::size_t primitive);

} // namespace rtcore::gltf
