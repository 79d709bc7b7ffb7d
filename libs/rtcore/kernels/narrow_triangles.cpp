#include "rtcore/kernels/narrow_triangles.h"

#include "rtcore/kernels/precise_hit.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

std::size_t words(std::size_t bits) { return (bits + 31) / 32; }

void setBit(std::vector<std::uint32_t>& bits, std::size_t i) { bits[i / 32] |= 1U << i % 32; }

std::vector<std::uint32_t> narrowOf(const Mesh& mesh) {
    std::vector<std::uint32_t> bits(words(mesh.triangles.size()));
#pragma omp parallel for schedule(static)
    for (std::size_t word = 0; word < bits.size(); ++word) {
        const std::size_t end = std::min(32 * (word + 1), mesh.triangles.size());
        for (std::size_t i = 32 * word; i < end; ++i) {
            const auto corner = [&](int c) { return mesh.position(static_cast<std::uint32_t>(i), c); };
            if (isNarrow(corner(0), corner(1), corner(2))) setBit(bits, i);
        }
    }
    return bits;
}

} // namespace

NarrowTriangles::NarrowTriangles(const KdTree& tree, const Mesh& mesh) : triangles(narrowOf(mesh)) {
    if (std::all_of(triangles.begin(), triangles.end(), [](std::uint32_t word) { return word == 0; })) {
        triangles = {};
        return;
    }
    leaves.resize(words(tree.references.size()));
    for (const KdNode node : tree.nodes) {
        if (!node.isLeaf() || node.count() == 0) continue;
        const auto first = tree.references.begin() + node.firstReference;
        const auto isOne = [&](std::uint32_t triangle) { return isBitSet(triangles.data(), triangle); };
        if (std::any_of(first, first + node.count(), isOne)) setBit(leaves, node.firstReference);
    }
}

} // namespace rtcore
