/// How much a model is with all instances, counted before any is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// Sums stop at 2^62.
struct ExpandedCount {
    std::uint64_t parts = 0; ///< nodes, meshes or objects, whichever are more
    std::uint64_t vertices = 0, triangles = 0;

    void add(const ExpandedCount& other);
    /// So many of them.
    ExpandedCount times(std::uint64_t count) const;
};

/// Nodes that show others, each as often as these are named. Takes time and memory by nodes and names, not by
/// what they stand for.
class InstanceGraph {
  public:
    /// `own`: without those below it. Returns its number; they count from 0.
    std::size_t addNode(const ExpandedCount& own = {});
    ExpandedCount& own(std::size_t node) { return nodes_[node].count; }
    /// A child may come before it is added; one that never is counts nothing.
    void addChild(std::size_t node, std::size_t child);
    /// Of these nodes with all below them; nothing where one holds itself. Call it once.
    std::optional<ExpandedCount> count(std::span<const std::size_t> roots);

  private:
    enum class State : std::uint8_t { New, Open, Done };
    struct Node {
        ExpandedCount count;
        std::vector<std::size_t> children;
        std::size_t next = 0; ///< the first child that is not counted
        State state = State::New;
    };
    bool finish(std::size_t root);

    std::vector<Node> nodes_;
};

} // namespace rtcore
