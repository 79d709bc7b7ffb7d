#include "rtcore/io/import/mesh/instance_graph.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 62U;

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return a != 0 && b > kMaxCount / a ? kMaxCount : a * b;
}

} // namespace

void ExpandedCount::add(const ExpandedCount& other) {
    parts = std::min(parts + other.parts, kMaxCount);
    vertices = std::min(vertices + other.vertices, kMaxCount);
    triangles = std::min(triangles + other.triangles, kMaxCount);
}

ExpandedCount ExpandedCount::times(std::uint64_t count) const {
    return {product(parts, count), product(vertices, count), product(triangles, count)};
}

std::size_t InstanceGraph::addNode(const ExpandedCount& own) {
    nodes_.push_back({own, {}, 0, State::New});
    return nodes_.size() - 1;
}

void InstanceGraph::addChild(std::size_t node, std::size_t child) { nodes_[node].children.push_back(child); }

/// Depth first; false for a cycle.
bool InstanceGraph::finish(std::size_t root) {
    std::vector<std::size_t> open{root};
    while (!open.empty()) {
        Node& at = nodes_[open.back()];
        at.state = State::Open;
        if (at.next == at.children.size()) {
            at.state = State::Done;
            open.pop_back();
            continue;
        }
        const std::size_t child = at.children[at.next];
        if (child >= nodes_.size()) {
            ++at.next;
            continue;
        }
        if (nodes_[child].state == State::Open) return false;
        if (nodes_[child].state == State::New) {
            open.push_back(child);
            continue;
        }
        at.count.add(nodes_[child].count);
        ++at.next;
    }
    return true;
}

std::optional<ExpandedCount> InstanceGraph::count(std::span<const std::size_t> roots) {
    ExpandedCount all;
    for (const std::size_t root : roots) {
        if (root >= nodes_.size()) continue;
        if (nodes_[root].state != State::Done && !finish(root)) return std::nullopt;
        all.add(nodes_[root].count);
    }
    return all;
}

} // namespace rtcore
