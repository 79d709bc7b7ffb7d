#include "rtcore/kernels/leaf_records.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace rtcore {

namespace {

constexpr std::size_t kPadding = 16; // floats of the longest vector

void fillLeaf(const KdNode& leaf, const std::uint32_t* references, const Mesh& mesh, float* out) {
    const std::size_t count = leaf.count();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = references[i];
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

UninitializedArray<float> makeLeafRecords(const KdTree& tree, std::span<const std::uint32_t> references,
                                          const Mesh& mesh) {
    const std::size_t size = kFloatsPerRecord * references.size();
    UninitializedArray<float> records(size + kPadding);
    std::fill_n(records.data() + size, kPadding, 0.0F);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const KdNode node = tree.nodes[i];
        if (!node.isLeaf()) continue;
        fillLeaf(node, references.data() + node.firstReference, mesh,
                 records.data() + kFloatsPerRecord * node.firstReference);
    }
    return records;
}

} // namespace rtcore
