/// The exact builder for one small piece of the scene, by one thread, in memory of its own.
#pragma once

#include "rtcore/accel/build_options.h"
#include "rtcore/accel/cost_model.h"
#include "rtcore/accel/events.h"
#include "rtcore/accel/subtree.h"
#include "rtcore/scene/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rtcore {

/// What all pieces of one build share.
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

using AxisEvents = std::array<std::vector<Event>, 3>;

/// Sorted events along the three axes, their triangles numbered 0 .. triangles.size()-1 in ascending order.
struct EventLists {
    AxisEvents axis;
    std::vector<std::uint32_t> triangles; ///< of the mesh
};

/// Appends the events of the part of `triangle` (of the mesh) inside `cell`, as triangle `number`.
/// Returns false, and adds nothing, when no part is inside.
bool addClippedEvents(const BuildContext& context, std::uint32_t triangle, std::uint32_t number,
                      const Box3& cell, AxisEvents& events);

/// How many references the tree below a node may hold. Splits that cut triangles in two share it out by the
/// numbers of triangles on both sides; a node with more triangles than its share becomes a leaf. So a model
/// of long slivers, each of which every split would duplicate, takes memory in proportion to its size.
struct ReferenceBudget {
    static ReferenceBudget ofScene(std::size_t triangles) { return {16 * triangles + 4096}; }
    bool allows(std::size_t triangles) const { return triangles <= references; }
    ReferenceBudget share(std::size_t mine, std::size_t all) const {
        const double part = all > 0 ? static_cast<double>(mine) / static_cast<double>(all) : 0;
        return {static_cast<std::size_t>(static_cast<double>(references) * part)};
    }

    std::size_t references = 0;
};

/// Builds the tree below a node at `depth`. The result depends on nothing else.
std::unique_ptr<Subtree> buildExactSubtree(const BuildContext& context, EventLists lists, const Box3& cell,
                                           int depth, ReferenceBudget budget);

} // namespace rtcore
