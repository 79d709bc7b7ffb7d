// The choice of a light of a tree, and its probability, over the number F: float or Float. Included once for
// each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/light_tree.h"
#include "rtcore/math/float3-inl.h"

#if defined(RTCORE_LIGHTS_LIGHT_TREE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_LIGHT_TREE_INL_H_
#undef RTCORE_LIGHTS_LIGHT_TREE_INL_H_
#else
#define RTCORE_LIGHTS_LIGHT_TREE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Part of a node's probability that its children share by how many lights they have: what a child is
/// expected to throw says nothing about occluders.
inline constexpr float kByNumber = 0.125F;

/// What is asked of a node; each lane has its own.
template <typename F>
struct LightNodeOf {
    Vec3Of<F> centre, axis{};
    F radius, cosSpread{}, cosEdge{}, intensity, lights;
};
template <typename F>
HWY_INLINE LightNodeOf<F> broadcastNode(const LightNode& n) {
    return {broadcast<F>(n.centre), broadcast<F>(n.axis), F(n.radius), F(n.cosSpread),
            F(n.cosEdge),           F(n.intensity),       F(n.lights)};
}

/// The field of nodes at so many floats from their begin.
HWY_INLINE Float gatherField(const LightNode* nodes, std::size_t bytes, Int first) {
    return gather(reinterpret_cast<const float*>(nodes) + bytes / sizeof(float), first);
}
HWY_INLINE Float3 gatherField3(const LightNode* nodes, std::size_t bytes, Int first) {
    return {gatherField(nodes, bytes, first), gatherField(nodes, bytes + sizeof(float), first),
            gatherField(nodes, bytes + 2 * sizeof(float), first)};
}
HWY_INLINE Int fieldsOf(Uint node) {
    static_assert(sizeof(LightNode) == 16 * sizeof(float));
    return toInt(node << 4);
}
HWY_INLINE LightNodeOf<Float> gatherNode(const LightTreeRows& tree, Uint node) {
    const Int first = fieldsOf(node);
    LightNodeOf<Float> n;
    n.centre = gatherField3(tree.nodes, offsetof(LightNode, centre), first);
    n.radius = gatherField(tree.nodes, offsetof(LightNode, radius), first);
    n.intensity = gatherField(tree.nodes, offsetof(LightNode, intensity), first);
    n.lights = gatherField(tree.nodes, offsetof(LightNode, lights), first);
    if (!tree.directed) return n;
    n.axis = gatherField3(tree.nodes, offsetof(LightNode, axis), first);
    n.cosSpread = gatherField(tree.nodes, offsetof(LightNode, cosSpread), first);
    n.cosEdge = gatherField(tree.nodes, offsetof(LightNode, cosEdge), first);
    return n;
}
HWY_INLINE Uint gatherBits(const LightNode* nodes, std::size_t bytes, Uint node) {
    return gather(reinterpret_cast<const std::uint32_t*>(nodes) + bytes / sizeof(std::uint32_t),
                  fieldsOf(node));
}

/// The cosine of an angle less another one, 1 where that is larger; of both the cosine.
template <typename F>
HWY_INLINE F cosineOfRest(F a, F b) {
    const F sines = sqrt(max(1.0F - a * a, F(0)) * max(1.0F - b * b, F(0)));
    return select(a > b, F(1), min(a * b + sines, F(1)));
}

/// About the unoccluded irradiance from the lights of a node at a surface, as luminance, and rather more than
/// less; 0 where none can arrive. A ball that reaches above a horizon by r is taken to be as high by r.
template <typename F>
HWY_INLINE F expectedOfNode(bool directed, const LightNodeOf<F>& node, Vec3Of<F> point, Vec3Of<F> normal) {
    const Vec3Of<F> offset = node.centre - point;
    const F square = dot(offset, offset), distance = sqrt(max(square, F(1e-30F)));
    const F above = min(max(dot(normal, offset) + node.radius, F(0)), distance);
    F sent = node.intensity;
    if (directed) {
        const F ahead = min((node.radius - dot(node.axis, offset)) / distance, F(1));
        const F leaving = cosineOfRest<F>(max(ahead, F(-1)), node.cosSpread);
        sent = selectOrZero(leaving >= node.cosEdge, sent * max(leaving, F(0)));
    }
    const F expected = sent * above / (distance * max(square, max(node.radius * node.radius, F(1e-30F))));
    return selectOrZero(isFinite(expected), expected);
}

/// The probability of the first child, which is neither 0 nor 1.
template <typename F>
HWY_INLINE F probabilityOfFirst(bool directed, const LightNodeOf<F>& first, const LightNodeOf<F>& second,
                                Vec3Of<F> point, Vec3Of<F> normal) {
    const F a = expectedOfNode<F>(directed, first, point, normal),
            b = expectedOfNode<F>(directed, second, point, normal);
    const F sum = a + b, byNumber = first.lights / (first.lights + second.lights);
    const auto some = (sum > 0.0F) & isFinite(sum);
    const F byLight = select(some, a / select(some, sum, F(1)), byNumber);
    return byLight * (1 - kByNumber) + byNumber * kByNumber;
}

/// A light below a node, and the probability that it is chosen there.
struct ChosenLeaf {
    Uint light;
    Float probability;
};
/// From the `node` of each lane of `open`. `u`: 0 to 1, without 1.
HWY_INLINE ChosenLeaf chooseLeaf(const LightTreeRows& tree, Uint node, Mask open, Float3 point, Float3 normal,
                                 Float u) {
    const LightNode* const nodes = tree.nodes;
    ChosenLeaf chosen{Uint(0U), Float(1)};
    while (any(open)) {
        const Mask leaf =
            (gatherBits(nodes, offsetof(LightNode, kind), node) & Uint(light_node::kLeaf)) != Uint(0U);
        const Uint next = gatherBits(nodes, offsetof(LightNode, next), node);
        chosen.light = select(open & leaf, next, chosen.light);
        open = without(open, leaf);
        if (none(open)) break;
        const Uint first = select(open, node + 1U, Uint(0U)), second = select(open, next, Uint(0U));
        const Float p = probabilityOfFirst<Float>(tree.directed, gatherNode(tree, first),
                                                  gatherNode(tree, second), point, normal);
        const Mask isFirst = u < p;
        const Float own = select(isFirst, p, 1.0F - p);
        u = min(select(isFirst, u, u - p) / own, Float(1 - 0x1p-24F));
        chosen.probability = select(open, chosen.probability * own, chosen.probability);
        node = select(open, select(isFirst, first, second), node);
    }
    return chosen;
}

/// The same probability of the light `k`, from the node of the cut that it is in.
template <typename F>
HWY_INLINE F probabilityOfLeaf(const LightTreeRows& tree, std::uint32_t k, Vec3Of<F> point,
                               Vec3Of<F> normal) {
    std::uint32_t node = tree.cut[tree.cutOf[k]], trail = tree.trail[k];
    F probability = F(1);
    while ((tree.nodes[node].kind & light_node::kLeaf) == 0) {
        const std::uint32_t first = node + 1, second = tree.nodes[node].next;
        const F p = probabilityOfFirst<F>(tree.directed, broadcastNode<F>(tree.nodes[first]),
                                          broadcastNode<F>(tree.nodes[second]), point, normal);
        const bool isFirst = (trail & 1U) == 0;
        probability = probability * (isFirst ? p : 1.0F - p);
        node = isFirst ? first : second;
        trail >>= 1U;
    }
    return probability;
}

/// Whether a ray may meet the box of a node.
HWY_INLINE Mask meetsBox(const LightNode& node, Float3 origin, Float3 inverse) {
    constexpr float kMargin = 1e-4F;
    const Vec3 size{std::fabs(node.centre.x) + node.half.x, std::fabs(node.centre.y) + node.half.y,
                    std::fabs(node.centre.z) + node.half.z};
    const Vec3 half = node.half + size * kMargin;
    const Float3 a = (broadcast(node.centre - half) - origin) * inverse;
    const Float3 b = (broadcast(node.centre + half) - origin) * inverse;
    const Float near = max(max(min(a.x, b.x), min(a.y, b.y)), max(min(a.z, b.z), Float(0)));
    const Float far = min(min(max(a.x, b.x), max(a.y, b.y)), max(a.z, b.z));
    return !(near > far); // also where a direction along a side makes no number
}

/// Where rays from `origin` are to meet a light that reaches so far (reachOf()).
HWY_INLINE Mask isWithin(Float3 origin, Vec3 centre, float reach) {
    const Float3 offset = broadcast(centre) - origin;
    return dot(offset, offset) < reach * reach;
}

/// meet(k) with each light that rays may meet and some ray of `rays` passes nearby, from within its reach.
template <typename Meet>
HWY_INLINE void forLightsNear(const LightTreeRows& tree, Float3 origin, Float3 direction, Mask rays,
                              Meet&& meet) {
    const Float3 inverse{1.0F / direction.x, 1.0F / direction.y, 1.0F / direction.z};
    std::uint32_t open[64];
    for (std::uint32_t c = 0; c < tree.cuts; ++c) {
        std::size_t count = 0;
        open[count++] = tree.cut[c];
        while (count > 0) {
            const std::uint32_t number = open[--count];
            const LightNode& node = tree.nodes[number];
            if ((node.kind & light_node::kToHit) == 0) continue;
            const Mask near =
                rays & isWithin(origin, node.centre, 1.001F * (node.radius + tree.reach[number]));
            if (none(near) || none(near & meetsBox(node, origin, inverse))) continue;
            if ((node.kind & light_node::kLeaf) != 0) {
                meet(node.next);
            } else {
                open[count++] = node.next;
                open[count++] = number + 1;
            }
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
