#include "rtcore/kernels/narrow_triangles.h"

#include "rtcore/kernels/narrow_noise.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rtcore {

namespace {

float noiseOf(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](int c) -> const Vertex& { return mesh.vertices[mesh.triangles[triangle].v[c]]; };
    if (isSurelyCommon(load4(&corner(0)), load4(&corner(1)), load4(&corner(2)))) return 0;
    return narrowNoise(corner(0).position(), corner(1).position(), corner(2).position());
}

bool anyIsNarrow(const Mesh& mesh) {
    bool found = false;
#pragma omp parallel for schedule(static) reduction(|| : found)
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) found = found || noiseOf(mesh, i) != 0;
    return found;
}

/// Empty where all are 0.
std::vector<float> noiseOfAll(const Mesh& mesh) {
    if (!anyIsNarrow(mesh)) return {};
    std::vector<float> noise(mesh.triangles.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = noiseOf(mesh, i);
    return noise;
}

} // namespace

NarrowTriangles::NarrowTriangles(const KdTree& tree, const Mesh& mesh)
    : NarrowTriangles(tree, noiseOfAll(mesh)) {}

NarrowTriangles::NarrowTriangles(const KdTree& tree, std::vector<float> known) : noise(std::move(known)) {
    if (noise.empty()) return;
    references.assign(tree.references.begin(), tree.references.end());
    bits.resize((references.size() + 31) / 32);
    const auto isCommon = [&](std::uint32_t triangle) { return noise[triangle] == 0; };
    for (const KdNode node : tree.nodes) {
        if (!node.isLeaf()) continue;
        const auto first = references.begin() + node.firstReference;
        const auto narrow = std::stable_partition(first, first + node.count(), isCommon);
        for (auto i = narrow; i != first + node.count(); ++i) {
            const auto bit = static_cast<std::size_t>(i - references.begin());
            bits[bit / 32] |= 1U << bit % 32;
        }
    }
}

} // namespace rtcore
