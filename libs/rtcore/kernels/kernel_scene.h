/// What kernels trace rays against: plain pointers into a tree and a mesh.
#pragma once

#include "rtcore/accel/kd_node.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/leaf_noise.h"
#include "rtcore/kernels/precise_hit.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>

namespace rtcore {

/// Valid as long as the arrays behind the tree, the mesh, the records and the noise.
struct KernelScene {
    KernelScene(const KdTree& tree, const Mesh& mesh, const float* inlineRecords = nullptr,
                const LeafNoise* leafNoise = nullptr)
        : nodes(tree.nodes.data()), references(tree.references.data()), vertices(mesh.vertices.data()),
          triangles(mesh.triangles.data()), records(inlineRecords), noise(leafNoise),
          reach(distanceReach(tree.bounds)), lo{tree.bounds.lo.x, tree.bounds.lo.y, tree.bounds.lo.z},
          hi{tree.bounds.hi.x, tree.bounds.hi.y, tree.bounds.hi.z} {}

    const KdNode* nodes;
    const std::uint32_t* references;
    const Vertex* vertices;
    const Triangle* triangles;
    /// Null, or copies of the corners in the order of the leaves (leaf_records.h).
    const float* records;
    const LeafNoise* noise; ///< vector kernels need it
    float reach;            ///< distanceReach()
    float lo[3], hi[3];     ///< the root's cell; lo > hi: nothing to hit
};

} // namespace rtcore
