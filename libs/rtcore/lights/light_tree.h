/// Many lights in a binary tree, by place, direction and power, so that a point finds those that light it
/// most without asking all of them. (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with
/// Adaptive Tree Splitting")
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/light.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// A node of the tree, 64 bytes, so that vector code reads its fields by index (light_tree-inl.h).
struct LightNode {
    Vec3 centre;
    float radius = 0;    ///< of the ball around its box
    Vec3 axis;           ///< unit; the directions of its lights' axes are within the spread of it
    float cosSpread = 1; ///< -1: they shine to all sides
    Vec3 half;           ///< of the box's sides
    float cosEdge = 0;   ///< how far beyond the spread they shine
    float intensity =
        0;            ///< sum of luminance, W/sr; of a light that is far, such that it is right at its place
    float lights = 0; ///< in it
    std::uint32_t next =
        0; ///< the second child (the first one follows the node); of a leaf the light's index
    std::uint32_t kind = 0; ///< of light_node

    friend bool operator==(const LightNode&, const LightNode&) = default;
};
static_assert(sizeof(LightNode) == 64);

/// Lights that lie together, or one of them: what a tree is made of.
struct LightCluster {
    Box3 box;
    Vec3 axis{0, 0, 0};  ///< unit; none where they shine to all sides
    float cosSpread = 1; ///< as LightNode's
    float cosEdge = 1;
    float intensity = 0; ///< as LightNode's
    bool toHit = false;
    bool far = false; ///< endlessly: it has a direction, no place
};

/// Bits of LightNode::kind.
namespace light_node {
inline constexpr std::uint32_t kLeaf = 1, kToHit = 2; ///< rays may meet a light of it
}

/// Arrays for vector code.
struct LightTreeRows {
    const LightNode* nodes = nullptr;
    const std::uint32_t* cut = nullptr; ///< nodes that hold each light once
    std::uint32_t cuts = 0;
    bool directed = false;                ///< some of the lights shine more to one side than to others
    const std::uint32_t* cutOf = nullptr; ///< by light: which of the cut it is in
    const std::uint32_t* trail =
        nullptr;                  ///< by light: the way from there, 1 for the second child, lowest bit first
    const float* reach = nullptr; ///< by node: the largest reachOf() of its lights
};

/// How far from a light with a size and a place scattered rays are to meet it, where there are many; 0 of all
/// others. Further away it is seen within 2 degrees or so: next event samples it as well as a lobe is smooth,
/// and hardly a ray would meet it.
float reachOf(const Light& light);

/// Immutable once prepared; safe from many threads. About 140 bytes for each light.
class LightTree {
  public:
    /// With 32 the error of 1,000 lights in a street is 0.96 of that, at 1.08 times the time.
    static constexpr std::size_t kMaxCut = 16;

    /// `bounds`: of all that is lit, to which directional lights are far. Takes about 10 microseconds for
    /// each light.
    void prepare(std::span<const Light> lights, const Box3& bounds);
    /// Of anything that shines: leaves are the numbers of `clusters`.
    void prepare(std::span<const LightCluster> clusters);

    bool empty() const { return nodes_.empty(); }
    LightTreeRows rows() const;
    std::span<const LightNode> nodes() const { return nodes_; }
    std::span<const std::uint32_t> cut() const { return cut_; }

  private:
    void chooseCut(std::vector<std::uint32_t> roots, float farScale);
    void markTrails();
    void findReach(std::span<const Light> lights);

    std::vector<LightNode> nodes_;
    std::vector<std::uint32_t> cut_, cutOf_, trail_;
    std::vector<float> reach_;
    std::size_t lights_ = 0;
    bool directed_ = false;
    std::size_t near_ = 0; ///< nodes of lights that have a place; the others follow
};

} // namespace rtcore
