#include "rtcore/io/import/pose/vertex_joints.h"

#include <cmath>

namespace rtcore {

VertexJoints::VertexJoints(std::span<const JointWeight> weights, std::size_t vertices)
    : begins_(vertices + 1, 0) {
    const auto counts = [&](const JointWeight& w) {
        return w.vertex < vertices && w.weight > 0 && std::isfinite(w.weight);
    };
    // Sort by vertex, by counting: `begins_` are the ends of the vertices before, then move back.
    for (const JointWeight& w : weights)
        if (counts(w)) ++begins_[w.vertex + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    entries_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for (const JointWeight& w : weights)
        if (counts(w)) entries_[next[w.vertex]++] = {w.joint, w.weight};
}

Affine VertexJoints::of(std::size_t vertex, std::span<const Affine> joints, const Affine& otherwise) const {
    Affine sum;
    sum.m = {};
    double weights = 0;
    for (std::uint32_t i = begins_[vertex]; i < begins_[vertex + 1]; ++i) {
        sum.add(joints[entries_[i].joint], double{entries_[i].weight});
        weights += double{entries_[i].weight};
    }
    if (!(weights > 0)) return otherwise;
    sum.scale(1 / weights);
    return sum;
}

} // namespace rtcore
