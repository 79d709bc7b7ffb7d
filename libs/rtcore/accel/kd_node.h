/// The node of the kd-tree: exactly 8 bytes (thesis 2.1.1). Written to .bsp files as it stands here.
#pragma once

#include <cstdint>
#include <type_traits>

namespace rtcore {

/// Inner node: split position, and the index of the lower child; the upper child is the next node.
/// Leaf: index of its first reference, and their number. The low two bits of `bits` tell them apart: 0, 1, 2
/// is the split axis, 3 a leaf.
struct KdNode {
    union {
        float split;
        std::uint32_t firstReference;
    };
    std::uint32_t bits;

    static KdNode leaf(std::uint32_t firstReference, std::uint32_t count) {
        KdNode node;
        node.firstReference = firstReference;
        node.bits = count << 2U | 3U;
        return node;
    }
    static KdNode inner(int axis, float split, std::uint32_t lowerChild) {
        KdNode node;
        node.split = split;
        node.bits = lowerChild << 2U | static_cast<std::uint32_t>(axis);
        return node;
    }

    bool isLeaf() const { return (bits & 3U) == 3U; }
    int axis() const { return static_cast<int>(bits & 3U); }
    std::uint32_t lowerChild() const { return bits >> 2U; }
    std::uint32_t count() const { return bits >> 2U; }
};
static_assert(sizeof(KdNode) == 8 && std::is_trivially_copyable_v<KdNode>);

/// Limits that follow from 30 bits, and the depth that every traversal stack holds.
inline constexpr std::uint32_t kMaxKdNodes = 1U << 30U;
inline constexpr std::uint32_t kMaxLeafCount = (1U << 30U) - 1;
inline constexpr int kMaxKdDepth = 64;

} // namespace rtcore
