#include "rtcore/kernels/leaf_records.h"

#include <bit>
#include <cstdint>

namespace rtcore {

namespace {

constexpr std::size_t kPadding = 16; // floats of the longest vector

void fillLeaf(const KdTree& tree, const Mesh& mesh, const KdNode& leaf, float* records) {
    const std::size_t count = leaf.count();
    float* const out = records + kFloatsPerRecord * leaf.firstReference;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = tree.references[leaf.firstReference + i];
        const Triangle& triangle = mesh.triangles[index];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vertex& vertex = mesh.vertices[triangle.v[corner]];
            out[(3 * corner + 0) * count + i] = vertex.x;
            out[(3 * corner + 1) * count + i] = vertex.y;
            out[(3 * corner + 2) * count + i] = vertex.z;
        }
        out[9 * count + i] = std::bit_cast<float>(index);
    }
}

} // namespace

std::vector<float> makeLeafRecords(const KdTree& tree, const Mesh& mesh) {
    std::vector<float> records(kFloatsPerRecord * tree.references.size() + kPadding);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].isLeaf()) fillLeaf(tree, mesh, tree.nodes[i], records.data());
    }
    return records;
}

} // namespace rtcore
