/// The exact builder for one small piece of the scene, by one thread, in memory of its own.
#pragma once

#include "rtcore/accel/bounded_triangle.h"
#include "rtcore/accel/build_options.h"
#include "rtcore/accel/cost_model.h"
#include "rtcore/accel/event_sort.h"
#include "rtcore/accel/events.h"
#include "rtcore/accel/subtree.h"
#include "rtcore/accel/triangle_clip.h"
#include "rtcore/scene/mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

/// Data shared by all pieces of one build.
struct BuildContext {
    const Mesh& mesh;
    CostModel cost;
    int maxDepth = 0;
    int lookAhead = 0;
    float margin = 0; ///< clipMargin() of the scene
    BuildProgress* progress = nullptr;

    /// Throws BuildCancelled when the user asked for it.
    void checkCancelled() const;
};

/// The events of one node along the three axes.
struct EventLists {
    std::array<EventList, 3> axis;
    std::uint32_t triangles = 0; ///< how many they are of
};

using AxisEvents = std::array<std::vector<Event>, 3>;

inline std::array<Vec3, 3> corners(const Mesh& mesh, std::uint32_t triangle) {
    return {mesh.position(triangle, 0), mesh.position(triangle, 1), mesh.position(triangle, 2)};
}

/// Appends the events of the parts of triangles inside `cell` to the empty `added`, and sorts them.
/// `meshTriangle(number)` is the index in the mesh of a triangle in the events. Returns how many have a part
/// inside.
template <typename MeshTriangle>
std::uint32_t clipEvents(const BuildContext& context, const std::vector<std::uint32_t>& numbers,
                         const MeshTriangle& meshTriangle, const Box3& cell, AxisEvents& added) {
    for (auto& list : added) list.resize(2 * numbers.size());
    std::array<Event*, 3> end{added[0].data(), added[1].data(), added[2].data()};
    std::uint32_t inside = 0;
    for (const std::uint32_t number : numbers) {
        const Box3 box = clippedBounds(corners(context.mesh, meshTriangle(number)), cell, context.margin);
        if (box.empty()) continue;
        ++inside;
        for (std::size_t a = 0; a < 3; ++a) end[a] = writeEvents(box, static_cast<int>(a), number, end[a]);
    }
    for (std::size_t a = 0; a < 3; ++a) {
        added[a].resize(static_cast<std::size_t>(end[a] - added[a].data()));
        sortFewEvents(added[a].data(), added[a].size());
    }
    return inside;
}

/// How many references the tree below a node may hold. Splits that cut triangles in two share it out by the
/// numbers of triangles on both sides; a node with more triangles than its part of the budget becomes a leaf.
/// So a model of long slivers, each of which every split would duplicate, takes memory in proportion to its
/// size.
struct ReferenceBudget {
    static ReferenceBudget ofScene(std::size_t triangles) { return {16 * triangles + 4096}; }
    bool allows(std::size_t triangles) const { return triangles <= references; }
    ReferenceBudget portion(std::size_t mine, std::size_t all) const {
        const double part = all > 0 ? static_cast<double>(mine) / static_cast<double>(all) : 0;
        return {static_cast<std::size_t>(static_cast<double>(references) * part)};
    }

    std::size_t references = 0;
};

/// Builds the trees of small pieces one after another, in memory that it keeps. For one thread at a time.
class ExactSubtreeBuilder {
  public:
    /// `context` must outlive the builder.
    explicit ExactSubtreeBuilder(const BuildContext& context) : context_(context) {}

    /// The tree below a node at `depth`, of events that are numbered as the mesh's triangles. `numbers` is
    /// scratch for as many as the mesh has. The tree depends on nothing else.
    std::unique_ptr<Subtree> build(EventLists lists, std::uint32_t* numbers, const Box3& cell, int depth,
                                   ReferenceBudget budget);

    /// The same below node `index` of `tree`, of `count` triangles; all that is new is appended.
    void build(const BoundedTriangle* triangles, std::size_t count, const Box3& cell, int depth,
               ReferenceBudget budget, Subtree& tree, std::uint32_t index);

  private:
    /// The three event lists of a node inside the arena.
    struct NodeEvents {
        std::array<std::size_t, 3> first{};
        std::array<std::size_t, 3> count{};
    };
    /// Triangles on each side of a split, and the part of the arena that holds the upper side's events.
    struct Division {
        std::uint32_t lower, upper;
        std::size_t keep;
    };

    NodeEvents load(EventLists lists, std::uint32_t* numbers);
    NodeEvents load(const BoundedTriangle* triangles, std::size_t count);
    float buildNode(std::uint32_t index, const NodeEvents& events, std::uint32_t count, const Box3& cell,
                    int depth, int failures, ReferenceBudget budget);
    Split findSplit(const NodeEvents& events, std::uint32_t count, const Box3& cell) const;
    float minCost(const Split& split, const Box3& cell) const;
    Division divide(const Split& split, std::uint32_t count, NodeEvents& upper, NodeEvents& lower,
                    const Box3& lowerCell, const Box3& upperCell);
    std::uint32_t clipStraddling(const Box3& cell, AxisEvents& added);
    void makeLeaf(std::uint32_t index, const NodeEvents& events);
    void undo(std::uint32_t index, std::size_t firstReference);
    void makeRoom(std::size_t events);
    Event* at(std::size_t offset) { return arena_.data() + offset; }
    const Event* at(std::size_t offset) const { return arena_.data() + offset; }

    const BuildContext& context_;
    Subtree* tree_ = nullptr;
    std::vector<std::uint32_t> triangles_; ///< of the mesh, by number in the piece
    std::vector<Side> sides_;

    EventList arena_; ///< event lists of the nodes that wait, as a stack
    std::size_t top_ = 0;
    EventList scratch_;
    std::vector<std::uint32_t> straddling_;
    AxisEvents addedLower_, addedUpper_;
};

} // namespace rtcore
