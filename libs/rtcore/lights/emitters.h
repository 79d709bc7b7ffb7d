/// The emissive triangles of a scene as lights. Points of few are sampled in proportion to power; more of
/// them are in a tree of clusters, one of which is chosen first.
#pragma once

#include "rtcore/lights/emitter_clusters.h"
#include "rtcore/sampling/alias_table.h"
#include "rtcore/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Arrays for vector code (emitters-inl.h).
struct EmitterRows {
    AliasRows choice;                         ///< of emitters; with a tree by row of its clusters
    const std::uint32_t* triangles = nullptr; ///< the same
    const std::uint32_t* corners = nullptr;   ///< of the mesh: three for each triangle
    const float* vertices = nullptr;          ///< of the mesh: x, y, z and one more for each
    LightTreeRows tree;                       ///< of clusters; without nodes: all are in one
    int rowBits = 0;                          ///< as EmitterClusterRows

    bool byTree() const { return tree.nodes != nullptr; }
};

/// Which triangles are left to rays that hit them by chance, or hit by none.
struct EmitterChoice {
    std::span<const std::uint8_t> hidden = {}; ///< by triangle of the model, not 0: it is (partTriangles())
    /// By material, not 0: its emission is visible, but lights nothing.
    std::span<const std::uint8_t> emitsNoLight = {};
    bool textures = true; ///< as RenderSettings::textures
};

/// Immutable once prepared; safe from many threads. About 20 bytes for each emitter; in a tree 60,
/// and 140 for each cluster. The scene's mesh must outlive it.
///
/// A triangle emits the same to both sides, as it is seen. Its power counts with the mean of its texture, and
/// holes of an alpha texture count as solid: that costs noise only, since the radiance of a point is looked
/// up where it is. Not among the emitters, since they have no finite probability, are triangles without area,
/// with corners or an emission that are not finite, and all of them where there are more than 2^24.
class Emitters {
  public:
    /// More of them are in a tree.
    static constexpr std::size_t kMaxWithoutTree = 32;

    /// Takes some 30 ns for each emissive triangle, in a tree half a microsecond and 40 ms at most, and a
    /// nanosecond for each other triangle and each texel of emission.
    void prepare(const Scene& scene, const EmitterChoice& choice = {});

    bool empty() const { return triangles_.empty(); }
    std::size_t size() const { return triangles_.size(); }

    /// The density by solid angle with which sampleEmitter() finds the point of a triangle that is seen at
    /// `distance`, once its cluster is chosen, where the cosine between the ray and the triangle's normal is
    /// `cosine`, of either sign. 0 of what is no emitter, and of cosines whose size is below 1e-6.
    float density(std::uint32_t triangle, float distance, float cosine) const;
    /// By area, the same number as in EmitterSample.
    float areaDensity(std::uint32_t triangle) const;
    /// The cluster of a triangle that is an emitter; 0 without a tree.
    std::uint32_t clusterOf(std::uint32_t triangle) const;

    /// Luminance of all that is given off, to both sides, W.
    double power() const { return power_; }
    const Box3& bounds() const { return bounds_; }
    /// Middle of the emitters, weighted by power.
    Vec3 centre() const { return centre_; }
    EmitterRows rows() const;

  private:
    /// Emitters whose triangles follow each other.
    struct Run {
        std::uint32_t firstTriangle, firstEmitter;
    };

    void addTriangles(const Scene& scene, const EmitterChoice& choice, std::vector<double>& powers);
    std::uint32_t emitterOf(std::uint32_t triangle) const;

    Mesh mesh_;
    AliasTable table_; ///< of few
    EmitterClusters clusters_;
    std::vector<std::uint32_t> triangles_;
    std::vector<Run> runs_;
    double power_ = 0;
    Box3 bounds_;
    Vec3 centre_;
};

} // namespace rtcore
