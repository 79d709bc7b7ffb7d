#include "rtcore/kernels/leaf_noise.h"

#include "rtcore/kernels/precise_hit.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

LeafNoise::LeafNoise(const KdTree& tree, const Mesh& mesh) : ofTriangle(mesh.triangles.size()) {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < ofTriangle.size(); ++i) {
        const auto corner = [&](int c) { return mesh.position(static_cast<std::uint32_t>(i), c); };
        ofTriangle[i] = noiseOfTriangle(corner(0), corner(1), corner(2));
    }
    const auto isNegative = [](float noise) { return noise < 0; };
    if (std::none_of(ofTriangle.begin(), ofTriangle.end(), isNegative)) return;
    narrow.resize(tree.references.size());
    for (const KdNode node : tree.nodes) {
        if (!node.isLeaf() || node.count() == 0) continue;
        const auto first = tree.references.begin() + node.firstReference;
        narrow[node.firstReference] = std::any_of(
            first, first + node.count(), [&](std::uint32_t triangle) { return ofTriangle[triangle] < 0; });
    }
}

} // namespace rtcore
