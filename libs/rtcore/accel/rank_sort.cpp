#include "rtcore/accel/rank_sort.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/accel/rank_sort.cpp"
#include "rtcore/simd/foreach_target.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The position of each event is the number of smaller ones.
void rankSort(Event* events, std::size_t count) {
    // Signed numbers, which older instruction sets compare faster, in the same order.
    const hn::CappedTag<std::int64_t, 8> d;
    const std::size_t lanes = hn::Lanes(d);
    alignas(64) std::int64_t keys[kMaxRanked + 8];
    alignas(64) std::int64_t ranks[kMaxRanked + 8];
    const std::size_t whole = (count + lanes - 1) / lanes * lanes;
    for (std::size_t i = 0; i < count; ++i) keys[i] = static_cast<std::int64_t>(events[i] ^ Event{1} << 63U);
    for (std::size_t i = count; i < whole; ++i) keys[i] = 0;
    for (std::size_t i = 0; i < whole; i += lanes) {
        const auto mine = hn::Load(d, keys + i);
        auto rank = hn::Zero(d);
        for (std::size_t k = 0; k < count; ++k) {
            rank = hn::Sub(rank, hn::VecFromMask(d, hn::Lt(hn::Set(d, keys[k]), mine)));
        }
        hn::Store(rank, d, ranks + i);
    }
    for (std::size_t i = 0; i < count; ++i) {
        events[ranks[i]] = static_cast<Event>(keys[i]) ^ Event { 1 } << 63U;
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(rankSort);

void rankSort(Event* events, std::size_t count) { HWY_DYNAMIC_DISPATCH(rankSort)(events, count); }

} // namespace rtcore
#endif
