/// The scene for kernels: plain pointers into a tree and a mesh.
#pragma once

#include "rtcore/accel/kd_node.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/candidate_filter.h"
#include "rtcore/kernels/narrow_triangles.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>

namespace rtcore {

/// Valid as long as the arrays behind the tree, the mesh, the records and the narrow triangles.
struct KernelScene {
    KernelScene(const KdTree& tree, const Mesh& mesh, const float* inlineRecords = nullptr,
                const NarrowTriangles* narrow = nullptr)
        : nodes(tree.nodes.data()), references(tree.references.data()), vertices(mesh.vertices.data()),
          triangles(mesh.triangles.data()), shading(mesh.shading.data()),
          records(inlineRecords), lo{tree.bounds.lo.x, tree.bounds.lo.y, tree.bounds.lo.z},
          hi{tree.bounds.hi.x, tree.bounds.hi.y, tree.bounds.hi.z}, size(coordinateSize(lo, hi)) {
        if (narrow == nullptr || narrow->bits.empty()) return;
        references = narrow->references.data();
        narrowBits = narrow->bits.data();
        noise = narrow->noise.data();
    }
    bool letsThrough(std::uint32_t triangle) const { return clear[shading[triangle].material] != 0; }

    const KdNode* nodes;
    const std::uint32_t* references;
    const Vertex* vertices;
    const Triangle* triangles;
    const ShadingTriangle* shading;
    /// Null, or copies of the corners in the order of the leaves (leaf_records.h).
    const float* records;
    /// As in NarrowTriangles; null where none is narrow. (Single rays need them not.)
    const std::uint32_t* narrowBits = nullptr;
    const float* noise = nullptr;
    /// For any hit: by material, 1 where light may pass, so that its triangles stop no ray; null: all stop
    /// rays.
    const std::uint8_t* clear = nullptr;
    CandidateFilter filter;
    float lo[3], hi[3]; ///< the root's cell; lo > hi: nothing to hit
    float size;         ///< coordinateSize() of it
};

} // namespace rtcore
