/// A plain kd-tree for tests that need one but not the builder: split in the middle of the longest axis.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace test {

struct SampleTree {
    std::vector<rtcore::KdNode> nodes;
    std::vector<std::uint32_t> references;
    rtcore::Box3 bounds;

    /// Valid while this object lives and its vectors stay as they are.
    rtcore::KdTree view() const { return {nodes, references, bounds, nullptr}; }
};

class SampleTreeBuilder {
  public:
    SampleTreeBuilder(const rtcore::Mesh& mesh, std::size_t leafSize, int maxDepth)
        : mesh_(mesh), leafSize_(leafSize), maxDepth_(maxDepth) {}

    SampleTree build() {
        std::vector<std::uint32_t> all(mesh_.triangles.size());
        std::iota(all.begin(), all.end(), 0U);
        tree_.bounds = mesh_.bounds();
        tree_.nodes.resize(1);
        divide(0, tree_.bounds, all, 0);
        return std::move(tree_);
    }

  private:
    void divide(std::uint32_t node, const rtcore::Box3& box, const std::vector<std::uint32_t>& triangles,
                int depth) {
        if (triangles.size() <= leafSize_ || depth == maxDepth_) {
            tree_.nodes[node] = rtcore::KdNode::leaf(static_cast<std::uint32_t>(tree_.references.size()),
                                                     static_cast<std::uint32_t>(triangles.size()));
            tree_.references.insert(tree_.references.end(), triangles.begin(), triangles.end());
            return;
        }
        const rtcore::Vec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const float split = box.centre()[axis];
        const auto pair = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.resize(tree_.nodes.size() + 2);
        tree_.nodes[node] = rtcore::KdNode::inner(axis, split, pair);
        const rtcore::Halves boxes(box, axis, split);
        divide(pair, boxes.lower, touching(triangles, axis, boxes.lower), depth + 1);
        divide(pair + 1, boxes.upper, touching(triangles, axis, boxes.upper), depth + 1);
    }

    std::vector<std::uint32_t> touching(const std::vector<std::uint32_t>& triangles, int axis,
                                        const rtcore::Box3& box) const {
        std::vector<std::uint32_t> kept;
        for (const std::uint32_t t : triangles) {
            rtcore::Box3 own;
            for (int corner = 0; corner < 3; ++corner) own.extend(mesh_.position(t, corner));
            if (own.lo[axis] <= box.hi[axis] && own.hi[axis] >= box.lo[axis]) kept.push_back(t);
        }
        return kept;
    }

    const rtcore::Mesh& mesh_;
    std::size_t leafSize_;
    int maxDepth_;
    SampleTree tree_;
};

inline SampleTree sampleTree(const rtcore::Mesh& mesh, std::size_t leafSize = 4, int maxDepth = 16) {
    return SampleTreeBuilder(mesh, leafSize, maxDepth).build();
}

} // namespace test
