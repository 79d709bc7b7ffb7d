/// Meshes in the pose of their joints.
#pragma once

#include "rtcore/io/import/gltf/accessors.h"
#include "rtcore/io/import/gltf/node_walk.h"
#include "rtcore/io/import/gltf/primitive.h"
#include "rtcore/io/import/mesh/affine.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace rtcore::gltf {

/// The skins of a file, with the joints where its nodes put them.
class Skins {
  public:
    /// All must outlive the object.
    Skins(const Json& root, const World& world, Accessors& accessors);

    bool has(std::size_t skin) const;
    /// From a mesh's coordinates to the world's, by joint. Valid until the next call.
    std::span<const Affine> joints(std::size_t skin);

  private:
    const Affine& toWorld(std::size_t node);

    const Json& root_;
    const World& world_;
    Accessors& accessors_;
    std::vector<std::size_t> parents_;          ///< by node; its own number where it has none
    std::vector<std::optional<Affine>> worlds_; ///< by node, those that were asked for
    std::map<std::size_t, std::vector<Affine>> joints_;
};

/// The weighted mean of the joints of a vertex; of one without weights, its first joint. Weights below 0 and
/// joints that do not exist do not count.
Affine skinOf(std::span<const std::vector<Influences>> sets, std::size_t vertex,
              std::span<const Affine> joints);

} // namespace rtcore::gltf
