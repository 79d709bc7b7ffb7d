#include "rtcore/lights/light_tree.h"

#include "rtcore/math/constants.h"
#include "rtcore/scene/photometry.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr int kBuckets = 12;
/// Levels of the tree at most: the ways down from a cut are in 32 bits.
constexpr int kMaxDepth = 32;
/// Distance of lights that are endlessly far, in radii of what is lit.
constexpr float kFar = 1000;

/// The cosine of the sum of two angles up to pi, -1 where that is beyond it.
float cosOfSum(float cosA, float cosB) {
    if (cosA + cosB <= 0) return -1; // a + b >= pi
    const float sines = std::sqrt(std::max(1 - cosA * cosA, 0.0F) * std::max(1 - cosB * cosB, 0.0F));
    return std::max(cosA * cosB - sines, -1.0F);
}

LightCluster merged(std::span<const LightCluster> parts) {
    LightCluster all;
    all.cosEdge = 1;
    for (const LightCluster& part : parts) {
        if (part.box.empty()) continue;
        all.box.extend(part.box);
        all.axis = all.axis + part.axis * part.intensity;
        all.intensity += part.intensity;
        all.cosEdge = std::min(all.cosEdge, part.cosEdge);
        all.toHit = all.toHit || part.toHit;
    }
    const float size = length(all.axis);
    all.axis = size > 0 ? all.axis / size : Vec3{0, 0, 1};
    for (const LightCluster& part : parts) {
        if (part.box.empty()) continue;
        const float apart = std::clamp(dot(all.axis, part.axis), -1.0F, 1.0F);
        all.cosSpread = std::min(all.cosSpread, part.cosSpread <= -1 ? -1 : cosOfSum(apart, part.cosSpread));
    }
    return all;
}

LightCluster clusterOf(const Light& light, const Box3& bounds) {
    const float reach = 0.5F * bounds.diagonal();
    LightCluster cluster;
    cluster.intensity = luminance(light.intensity);
    if (!std::isfinite(cluster.intensity) || cluster.intensity < 0) cluster.intensity = 0;
    cluster.toHit = isAreaLight(light.kind);
    const LightTraits& traits = traitsOf(light);
    if (!traits.position) {
        const float distance = kFar * reach;
        cluster.box.extend(bounds.centre() - light.direction * distance);
        cluster.intensity *= distance * distance;
        cluster.far = true;
        cluster.cosSpread = -1;
        return cluster;
    }
    cluster.box.extend(light.position);
    if (traits.radius) {
        const Vec3 radius{light.radius, light.radius, light.radius};
        cluster.box.extend(light.position - radius);
        cluster.box.extend(light.position + radius);
    }
    if (traits.sides) {
        const Vec3 along = light.right * (0.5F * light.width);
        const Vec3 across = cross(light.direction, light.right) * (0.5F * light.height);
        for (const float side : {-1.0F, 1.0F}) {
            cluster.box.extend(light.position + along + across * side);
            cluster.box.extend(light.position - along + across * side);
        }
    }
    cluster.cosSpread = -1;
    if (traits.beam == Beam::Even) return cluster;
    cluster.axis = light.direction;
    if (traits.beam == Beam::Measured) {
        cluster.cosSpread = photometryOf(light).cosSpread;
        cluster.cosEdge = photometryOf(light).cosEdge;
        return cluster;
    }
    const bool cone = traits.beam == Beam::Cone;
    cluster.cosSpread = cone ? light.cosInner : 1;
    // Of the angles of a cone's rim the difference.
    cluster.cosEdge = cone ? std::min(light.cosInner * light.cosOuter +
                                          std::sqrt(std::max(1 - light.cosInner * light.cosInner, 0.0F) *
                                                    std::max(1 - light.cosOuter * light.cosOuter, 0.0F)),
                                      1.0F)
                           : 0;
    return cluster;
}

/// The solid angle into which they shine, weighted by how much. (Conty Estevez and Kulla 2018, section 4.4)
float orientationCost(const LightCluster& cluster) {
    const auto pi = static_cast<float>(kPi);
    const float spread = portableAcos(cluster.cosSpread), edge = portableAcos(cluster.cosEdge);
    const float widest = std::min(spread + edge, pi);
    const float sine = portableSin(spread), cosine = portableCos(spread);
    return 2 * pi * (1 - cosine) +
           pi / 2 * (2 * widest * sine - portableCos(spread - 2 * widest) - 2 * spread * sine + cosine);
}

float cost(const LightCluster& cluster) {
    const Vec3 size = cluster.box.size();
    // Lights on a line have no surface, and one of them no length.
    return cluster.intensity * orientationCost(cluster) * (cluster.box.halfArea() + 1e-3F * dot(size, size));
}

struct Split {
    int axis = -1;
    float position = 0;
    float cost = std::numeric_limits<float>::max();
};

class Builder {
  public:
    Builder(std::vector<LightCluster> clusters, std::vector<std::uint32_t> lights,
            std::vector<LightNode>& nodes)
        : clusters_(std::move(clusters)), lights_(std::move(lights)), nodes_(nodes) {}

    /// Returns the root.
    std::uint32_t build() { return build(0, lights_.size(), 0); }

  private:
    std::uint32_t build(std::size_t first, std::size_t last, int depth) {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(nodeOf(first, last));
        if (last - first == 1) {
            nodes_[number].next = lights_[first];
            nodes_[number].kind |= light_node::kLeaf;
            return number;
        }
        const std::size_t middle = divide(first, last, depth);
        build(first, middle, depth + 1);
        const std::uint32_t second = build(middle, last, depth + 1);
        nodes_[number].next = second;
        return number;
    }

    LightNode nodeOf(std::size_t first, std::size_t last) const {
        const LightCluster all = merged(std::span(clusters_).subspan(first, last - first));
        LightNode node;
        node.centre = all.box.centre();
        node.half = all.box.size() * 0.5F;
        node.radius = length(node.half);
        node.axis = all.axis;
        node.cosSpread = all.cosSpread;
        node.cosEdge = all.cosEdge;
        node.intensity = all.intensity;
        node.lights = static_cast<float>(last - first);
        node.kind = all.toHit ? light_node::kToHit : 0;
        return node;
    }

    /// Where the second child begins.
    std::size_t divide(std::size_t first, std::size_t last, int depth) {
        Box3 middles;
        for (std::size_t i = first; i < last; ++i) middles.extend(clusters_[i].box.centre());
        const auto count = static_cast<std::uint32_t>(last - first);
        const bool deep = depth + std::bit_width(count) >= kMaxDepth - 1;
        const Split split = deep ? Split{} : bestSplit(first, last, middles);
        if (split.axis < 0) return halve(first, last, middles);
        const auto below = [&](const LightCluster& c) { return c.box.centre()[split.axis] < split.position; };
        std::size_t middle = first;
        for (std::size_t i = first; i < last; ++i) {
            if (below(clusters_[i])) swap(i, middle++);
        }
        return middle == first || middle == last ? halve(first, last, middles) : middle;
    }

    std::size_t halve(std::size_t first, std::size_t last, const Box3& middles) {
        const Vec3 size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::vector<std::uint32_t> order(last - first);
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
        std::ranges::stable_sort(order, {},
                                 [&](std::uint32_t i) { return clusters_[first + i].box.centre()[axis]; });
        const std::vector<LightCluster> clusters(clusters_.begin() + static_cast<std::ptrdiff_t>(first),
                                                 clusters_.begin() + static_cast<std::ptrdiff_t>(last));
        const std::vector<std::uint32_t> lights(lights_.begin() + static_cast<std::ptrdiff_t>(first),
                                                lights_.begin() + static_cast<std::ptrdiff_t>(last));
        for (std::size_t i = 0; i < order.size(); ++i) {
            clusters_[first + i] = clusters[order[i]];
            lights_[first + i] = lights[order[i]];
        }
        return first + order.size() / 2;
    }

    Split bestSplit(std::size_t first, std::size_t last, const Box3& middles) const {
        Split best;
        const Vec3 size = middles.size();
        const float longest = std::max({size.x, size.y, size.z});
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 0)) continue;
            const auto buckets = bucketsOf(first, last, axis, middles);
            for (int b = 1; b < kBuckets; ++b) {
                const LightCluster below = merged(std::span(buckets).first(static_cast<std::size_t>(b)));
                const LightCluster above = merged(std::span(buckets).subspan(static_cast<std::size_t>(b)));
                if (below.box.empty() || above.box.empty()) continue;
                // Thin slices of long boxes are to be avoided.
                const float each = (cost(below) + cost(above)) * (longest / size[axis]);
                if (each < best.cost) best = {axis, positionOf(b, axis, middles), each};
            }
        }
        return best;
    }

    std::array<LightCluster, kBuckets> bucketsOf(std::size_t first, std::size_t last, int axis,
                                                 const Box3& middles) const {
        std::array<std::vector<LightCluster>, kBuckets> members;
        for (std::size_t i = first; i < last; ++i) {
            const float at = clusters_[i].box.centre()[axis];
            int bucket = 0;
            while (bucket + 1 < kBuckets && !(at < positionOf(bucket + 1, axis, middles))) ++bucket;
            members[static_cast<std::size_t>(bucket)].push_back(clusters_[i]);
        }
        std::array<LightCluster, kBuckets> buckets;
        for (std::size_t b = 0; b < buckets.size(); ++b)
            if (!members[b].empty()) buckets[b] = merged(members[b]);
        return buckets;
    }

    static float positionOf(int bucket, int axis, const Box3& middles) {
        return middles.lo[axis] + middles.size()[axis] * (static_cast<float>(bucket) / kBuckets);
    }

    void swap(std::size_t a, std::size_t b) {
        std::swap(clusters_[a], clusters_[b]);
        std::swap(lights_[a], lights_[b]);
    }

    std::vector<LightCluster> clusters_;
    std::vector<std::uint32_t> lights_; ///< of the clusters
    std::vector<LightNode>& nodes_;
};

} // namespace

float reachOf(const Light& light) {
    constexpr float kReach = 50; // of its size
    if (!isAreaLight(light.kind)) return 0;
    const float size = isFlatLight(light.kind) ? 0.5F * std::hypot(light.width, light.height) : light.radius;
    return kReach * size;
}

void LightTree::prepare(std::span<const Light> lights, const Box3& bounds) {
    std::vector<LightCluster> clusters;
    clusters.reserve(lights.size());
    for (const Light& light : lights) clusters.push_back(clusterOf(light, bounds));
    prepare(clusters);
    findReach(lights);
}

/// Children follow their parents.
void LightTree::findReach(std::span<const Light> lights) {
    reach_.resize(nodes_.size());
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        const LightNode& node = nodes_[i];
        reach_[i] = (node.kind & light_node::kLeaf) != 0 ? reachOf(lights[node.next])
                                                         : std::max(reach_[i + 1], reach_[node.next]);
    }
}

void LightTree::prepare(std::span<const LightCluster> clusters) {
    *this = {};
    lights_ = clusters.size();
    std::array<std::vector<LightCluster>, 2> sides;
    std::array<std::vector<std::uint32_t>, 2> numbers;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const std::size_t side = clusters[i].far ? 1 : 0;
        sides[side].push_back(clusters[i]);
        numbers[side].push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<std::uint32_t> roots;
    for (std::size_t side = 0; side < 2; ++side) {
        if (!sides[side].empty())
            roots.push_back(Builder(std::move(sides[side]), std::move(numbers[side]), nodes_).build());
        if (side == 0) near_ = nodes_.size();
    }
    chooseCut(std::move(roots), 1 / (kFar * kFar));
    markTrails();
    directed_ = std::ranges::any_of(nodes_, [](const LightNode& node) { return node.cosSpread > -1; });
}

/// The brightest node is divided as long as there is room. `farScale` makes lights that are far comparable:
/// by what they would have to be at the border of what is lit.
void LightTree::chooseCut(std::vector<std::uint32_t> roots, float farScale) {
    cut_ = std::move(roots);
    const auto weight = [&](std::uint32_t number) {
        const LightNode& node = nodes_[number];
        const float scale = number < near_ ? 1 : farScale;
        return (node.kind & light_node::kLeaf) != 0 ? -1 : node.intensity * scale;
    };
    while (!cut_.empty() && cut_.size() < kMaxCut) {
        const auto brightest = std::ranges::max_element(cut_, {}, weight);
        if (weight(*brightest) < 0) break;
        const std::uint32_t first = *brightest + 1, second = nodes_[*brightest].next;
        *brightest = first;
        cut_.push_back(second);
    }
}

void LightTree::markTrails() {
    cutOf_.resize(lights_);
    trail_.resize(lights_);
    struct Subtree {
        std::uint32_t node, trail;
        int depth;
    };
    for (std::size_t c = 0; c < cut_.size(); ++c) {
        std::vector<Subtree> open{{cut_[c], 0, 0}};
        while (!open.empty()) {
            const Subtree subtree = open.back();
            open.pop_back();
            const LightNode& node = nodes_[subtree.node];
            if ((node.kind & light_node::kLeaf) != 0) {
                cutOf_[node.next] = static_cast<std::uint32_t>(c);
                trail_[node.next] = subtree.trail;
                continue;
            }
            open.push_back({subtree.node + 1, subtree.trail, subtree.depth + 1});
            open.push_back({node.next, subtree.trail | std::uint32_t{1} << subtree.depth, subtree.depth + 1});
        }
    }
}

LightTreeRows LightTree::rows() const {
    return {nodes_.data(), cut_.data(),  static_cast<std::uint32_t>(cut_.size()), directed_, cutOf_.data(),
            trail_.data(), reach_.data()};
}

} // namespace rtcore
