#include "rtcore/kernels/narrow_triangles.h"

#include "rtcore/kernels/narrow_noise.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

std::vector<float> noiseOf(const Mesh& mesh) {
    std::vector<float> noise(mesh.triangles.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const auto corner = [&](int c) { return mesh.position(static_cast<std::uint32_t>(i), c); };
        noise[i] = narrowNoise(corner(0), corner(1), corner(2));
    }
    return noise;
}

} // namespace

NarrowTriangles::NarrowTriangles(const KdTree& tree, const Mesh& mesh) : noise(noiseOf(mesh)) {
    if (std::all_of(noise.begin(), noise.end(), [](float n) { return n == 0; })) {
        noise = {};
        return;
    }
    leaves.resize((tree.references.size() + 31) / 32);
    for (const KdNode node : tree.nodes) {
        if (!node.isLeaf() || node.count() == 0) continue;
        const std::uint32_t first = node.firstReference;
        const auto references = tree.references.begin() + first;
        const auto isNarrow = [&](std::uint32_t triangle) { return noise[triangle] > 0; };
        if (std::any_of(references, references + node.count(), isNarrow))
            leaves[first / 32] |= 1U << first % 32;
    }
}

} // namespace rtcore
