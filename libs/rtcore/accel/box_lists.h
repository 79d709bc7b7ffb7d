/// The boxes of a node's triangles as lists of numbers, for vector code.
#pragma once

#include "rtcore/accel/cost_model.h"
#include "rtcore/math/box.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Views of memory that others own. Behind the last box there is room for a whole vector of any processor,
/// and what stands there is no box: endLists() sees to it.
struct BoxLists {
    static constexpr std::size_t kPadding = 16;

    std::array<float*, 3> lo, hi; ///< by axis
    std::uint32_t* triangle;

    /// Without the first ones.
    BoxLists from(std::size_t first) const {
        BoxLists rest = *this;
        for (std::size_t a = 0; a < 3; ++a) {
            rest.lo[a] += first;
            rest.hi[a] += first;
        }
        rest.triangle += first;
        return rest;
    }
};

/// Candidates along each axis, ascending.
inline constexpr std::size_t kPlanes = 7;
using Planes = std::array<std::array<float, kPlanes>, 3>;

/// How many boxes reach below and above each plane.
struct PlaneCounts {
    std::array<std::array<std::uint32_t, kPlanes>, 3> lower, upper;
    std::uint32_t boxes; ///< that were counted
};

struct SideCounts {
    std::size_t lower, upper;
};

/// The results of all are the same with every instruction set.
void endLists(const BoxLists& boxes, std::size_t count);
Box3 boundsOf(const BoxLists& boxes, std::size_t count);
/// Counts all boxes, or with `every` > 1 only one run in `every`, in short runs.
PlaneCounts countAtPlanes(const BoxLists& boxes, std::size_t count, std::size_t every, const Planes& planes);
/// Moves each box to its side or, cut in two, to both. The upper ones stay in `boxes`; `lower` has room for
/// all and the padding. Both keep their order, and are ended.
SideCounts divideBoxes(const BoxLists& boxes, std::size_t count, const Split& split, const BoxLists& lower);

} // namespace rtcore
