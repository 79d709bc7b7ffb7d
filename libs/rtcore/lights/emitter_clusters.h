/// Many emissive triangles as a tree of lights: its leaves are clusters of those that lie together, within
/// which one is chosen in proportion to power.
#pragma once

#include "rtcore/lights/light_tree.h"
#include "rtcore/sampling/alias_table.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Arrays for vector code (emitters-inl.h). Each cluster has as many rows, the last of which may be empty.
struct EmitterClusterRows {
    LightTreeRows tree;
    AliasRows choice;                         ///< the tables of all clusters, one after another
    const std::uint32_t* triangles = nullptr; ///< of the mesh, by row
    int rowBits = 0;                          ///< a cluster has so many rows, as a power of 2
};

/// Immutable once prepared; safe from many threads. About 40 bytes for each triangle, and 140 for each
/// cluster.
class EmitterClusters {
  public:
    static constexpr std::size_t kMaxClusters = 4096;

    /// `triangles` of the mesh, at most 2^24, each with an area and its power in W, both sides together.
    /// Takes 10 microseconds for each cluster, and about 0.5 for each triangle.
    void prepare(const Mesh& mesh, std::span<const std::uint32_t> triangles, std::span<const double> powers);

    bool empty() const { return tree_.empty(); }
    EmitterClusterRows rows() const {
        return {tree_.rows(),
                {threshold_.data(), other_.data(), probability_.data(), 32 - rowBits_},
                triangles_.data(),
                rowBits_};
    }
    /// By the index of a triangle in prepare(): its cluster, and its probability there.
    std::uint32_t clusterOf(std::size_t index) const { return rowOf_[index] >> rowBits_; }
    float probability(std::size_t index) const { return probability_[rowOf_[index]]; }

  private:
    void addCluster(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                    std::span<const double> powers, std::span<const std::uint32_t> members);

    LightTree tree_;
    std::vector<LightCluster> clusters_; ///< while they are prepared
    std::vector<std::uint32_t> threshold_, other_, triangles_;
    std::vector<float> probability_;
    std::vector<std::uint32_t> rowOf_; ///< by index
    int rowBits_ = 0;
};

} // namespace rtcore
