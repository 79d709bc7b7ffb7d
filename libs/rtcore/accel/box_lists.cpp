#include "rtcore/accel/box_lists.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/accel/box_lists.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/simd/wide-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// A run of a sample.
constexpr std::size_t kRun = BoxLists::kPadding;
static_assert(kLanes <= kRun);

float minLane(Float values) {
    float lanesOf[kLanes];
    store(values, lanesOf);
    float result = lanesOf[0];
    for (std::size_t i = 1; i < lanes(); ++i) result = min(result, lanesOf[i]);
    return result;
}

void findBounds(const BoxLists& boxes, std::size_t count, Box3& bounds) {
    for (std::size_t a = 0; a < 3; ++a) {
        Float lo = Box3::kHuge;
        Float hi = -Box3::kHuge;
        for (std::size_t i = 0; i < count; i += lanes()) {
            lo = min(lo, load(boxes.lo[a] + i));
            hi = max(hi, load(boxes.hi[a] + i));
        }
        bounds.lo[static_cast<int>(a)] = minLane(lo);
        bounds.hi[static_cast<int>(a)] = -minLane(-hi);
    }
}

void countAtPlanes(const BoxLists& boxes, std::size_t count, std::size_t every, const Planes& planes,
                   PlaneCounts& counts) {
    for (std::size_t a = 0; a < 3; ++a) {
        std::array<std::size_t, kPlanes> below{};
        std::array<std::size_t, kPlanes> above{};
        for (std::size_t run = 0; run < count; run += every * kRun) {
            for (std::size_t i = run; i < run + kRun; i += lanes()) {
                const Float lo = load(boxes.lo[a] + i);
                for (std::size_t k = 0; k < kPlanes; ++k) below[k] += (lo < Float(planes[a][k])).count();
            }
        }
        for (std::size_t run = 0; run < count; run += every * kRun) {
            for (std::size_t i = run; i < run + kRun; i += lanes()) {
                const Float hi = load(boxes.hi[a] + i);
                for (std::size_t k = 0; k < kPlanes; ++k) above[k] += (hi > Float(planes[a][k])).count();
            }
        }
        for (std::size_t k = 0; k < kPlanes; ++k) {
            counts.lower[a][k] = static_cast<std::uint32_t>(below[k]);
            counts.upper[a][k] = static_cast<std::uint32_t>(above[k]);
        }
    }
}

void divideBoxes(const BoxLists& boxes, std::size_t count, const Split& split, const BoxLists& lower,
                 SideCounts& counts) {
    const auto axis = static_cast<std::size_t>(split.axis);
    const Float plane = split.position;
    SideCounts n{0, 0};
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Float first = load(boxes.lo[axis] + i);
        const Float last = load(boxes.hi[axis] + i);
        const Mask planar = (first == plane) & (last == plane);
        const Mask isLower = split.planarLower ? (first < plane) | planar : first < plane;
        const Mask isUpper = split.planarLower ? last > plane : (last > plane) | planar;
        const Compressor toLower(isLower);
        const Compressor toUpper(isUpper);
        for (std::size_t a = 0; a < 3; ++a) {
            const Float lo = load(boxes.lo[a] + i);
            const Float hi = load(boxes.hi[a] + i);
            toLower.store(lo, lower.lo[a] + n.lower);
            toLower.store(a == axis ? min(hi, plane) : hi, lower.hi[a] + n.lower);
            toUpper.store(a == axis ? max(lo, plane) : lo, boxes.lo[a] + n.upper);
            toUpper.store(hi, boxes.hi[a] + n.upper);
        }
        const Uint triangle = load(boxes.triangle + i);
        toLower.store(triangle, lower.triangle + n.lower);
        toUpper.store(triangle, boxes.triangle + n.upper);
        n.lower += toLower.count();
        n.upper += toUpper.count();
    }
    counts = n;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(findBounds);
HWY_EXPORT(countAtPlanes);
HWY_EXPORT(divideBoxes);

void endLists(const BoxLists& boxes, std::size_t count) {
    for (std::size_t a = 0; a < 3; ++a) {
        std::fill_n(boxes.lo[a] + count, BoxLists::kPadding, Box3::kHuge);
        std::fill_n(boxes.hi[a] + count, BoxLists::kPadding, -Box3::kHuge);
    }
}

Box3 boundsOf(const BoxLists& boxes, std::size_t count) {
    Box3 bounds;
    HWY_DYNAMIC_DISPATCH(findBounds)(boxes, count, bounds);
    return bounds;
}

PlaneCounts countAtPlanes(const BoxLists& boxes, std::size_t count, std::size_t every, const Planes& planes) {
    constexpr std::size_t kRun = BoxLists::kPadding;
    PlaneCounts counts;
    HWY_DYNAMIC_DISPATCH(countAtPlanes)(boxes, count, every, planes, counts);
    const std::size_t runs = (count + every * kRun - 1) / (every * kRun);
    const std::size_t lastRun = (runs - 1) * every * kRun;
    counts.boxes = static_cast<std::uint32_t>((runs - 1) * kRun + std::min(kRun, count - lastRun));
    return counts;
}

SideCounts divideBoxes(const BoxLists& boxes, std::size_t count, const Split& split, const BoxLists& lower) {
    SideCounts counts;
    HWY_DYNAMIC_DISPATCH(divideBoxes)(boxes, count, split, lower, counts);
    endLists(lower, counts.lower);
    endLists(boxes, counts.upper);
    return counts;
}

} // namespace rtcore
#endif
