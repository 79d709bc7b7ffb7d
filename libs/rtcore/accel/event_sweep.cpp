#include "rtcore/accel/event_sweep.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/accel/event_sweep.cpp"
#include "rtcore/simd/foreach_target.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Numbers of ones in the bits of a byte before each of them, and up to each of them.
struct BitCounts {
    std::uint8_t before[256][8];
    std::uint8_t upTo[256][8];

    constexpr BitCounts() : before{}, upTo{} {
        for (unsigned byte = 0; byte < 256; ++byte) {
            std::uint8_t count = 0;
            for (unsigned bit = 0; bit < 8; ++bit) {
                before[byte][bit] = count;
                count = static_cast<std::uint8_t>(count + (byte >> bit & 1U));
                upTo[byte][bit] = count;
            }
        }
    }
};
alignas(64) constexpr BitCounts kBitCounts;

/// The flat triangle of event `e`, with `lower` and `upper` triangles before it; it counts as upper. Only the
/// whole run of flat ones at a position may change sides: considers a plane before the first and after the
/// last.
void considerPlanar(const Event* e, const Event* begin, const Event* end, std::uint32_t lower,
                    std::uint32_t upper, const AreaOfParts& area, const CostModel& cost, SweptPlane& best) {
    const float p = eventPosition(*e);
    if (!(p > area.lo && p < area.hi)) return;
    const auto consider = [&](std::uint32_t below, std::uint32_t above, bool planarLower) {
        const float c = cost.split(area.lower(p), area.upper(p), below, above);
        if (c < best.cost) best = {c, e, below, above, planarLower};
    };
    if (e == begin || e[-1] >> 30U != *e >> 30U) consider(lower, upper, false);
    if (e + 1 == end || e[1] >> 30U != *e >> 30U) consider(lower + 1, upper - 1, true);
}

SweptPlane sweepEvents(const Event* events, std::size_t count, std::uint32_t triangles,
                       const AreaOfParts& area, const CostModel& cost) {
    // Eight lanes at most, since one byte holds a bit for each. They name their block in 31 bits.
    const hn::CappedTag<std::uint32_t, 8> du;
    const hn::RebindToSigned<decltype(du)> di;
    const hn::RebindToFloat<decltype(du)> df;
    const hn::Rebind<std::uint8_t, decltype(di)> d8;
    const std::size_t lanes = hn::Lanes(du);
    const unsigned allLanes = (1U << lanes) - 1;

    const auto traversal = hn::Set(df, cost.traversal);
    const auto intersection = hn::Set(df, cost.intersection);
    const auto emptyFactor = hn::Set(df, cost.emptyFactor);
    const auto face = hn::Set(df, area.face);
    const auto rim = hn::Set(df, area.rim);
    const auto lo = hn::Set(df, area.lo);
    const auto hi = hn::Set(df, area.hi);
    const auto signBit = hn::Set(du, 0x80000000U);
    const auto one = hn::Set(du, 1);
    const auto zero = hn::Zero(di);
    const auto infinity = hn::Inf(df);

    auto bestCost = infinity;
    auto bestBlock = hn::Set(di, -1);
    auto bestLower = zero;
    auto bestUpper = zero;
    SweptPlane best; // of those through flat triangles, and in the end of all
    std::uint32_t lower = 0;
    std::uint32_t upper = triangles;
    for (std::size_t i = 0; i < count; i += lanes) {
        const Event* block = events + i;
        Event rest[8];
        if (count - i < lanes) {
            // Filled with starts beyond the upper face, where no plane is.
            for (std::size_t k = 0; k < lanes; ++k) rest[k] = i + k < count ? block[k] : ~(Event{1} << 30U);
            block = rest;
        }
        hn::Vec<decltype(du)> low;
        hn::Vec<decltype(du)> high;
        hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(block), low, high);
        const auto planar = hn::Lt(hn::BitCast(di, hn::ShiftLeft<1>(low)), zero);
        std::uint8_t startBits[8] = {};
        std::uint8_t planarBits[8] = {};
        hn::StoreMaskBits(di, hn::Lt(hn::BitCast(di, low), zero), startBits);
        hn::StoreMaskBits(di, planar, planarBits);
        const unsigned begins = (startBits[0] | planarBits[0]) & allLanes;
        const unsigned ends = ~startBits[0] & allLanes;

        const auto below = hn::Add(hn::Set(di, static_cast<std::int32_t>(lower)),
                                   hn::PromoteTo(di, hn::LoadU(d8, kBitCounts.before[begins])));
        const auto above = hn::Sub(hn::Set(di, static_cast<std::int32_t>(upper)),
                                   hn::PromoteTo(di, hn::LoadU(d8, kBitCounts.upTo[ends])));
        const auto negative = hn::Sub(hn::ShiftRight<31>(high), one);
        const auto p = hn::BitCast(df, hn::Xor(high, hn::Or(negative, signBit)));
        const auto lowerArea = hn::Add(face, hn::Mul(hn::Sub(p, lo), rim));
        const auto upperArea = hn::Add(face, hn::Mul(hn::Sub(hi, p), rim));
        const auto tests = hn::Add(hn::Mul(lowerArea, hn::ConvertTo(df, below)),
                                   hn::Mul(upperArea, hn::ConvertTo(df, above)));
        const auto full = hn::Add(traversal, hn::Mul(intersection, tests));
        const auto empty = hn::Or(hn::Eq(below, zero), hn::Eq(above, zero));
        const auto c = hn::IfThenElse(hn::RebindMask(df, empty), hn::Mul(full, emptyFactor), full);
        auto better = hn::And(hn::Lt(c, bestCost), hn::And(hn::Gt(p, lo), hn::Lt(p, hi)));
        if (const unsigned flat = planarBits[0] & allLanes; flat != 0) {
            better = hn::AndNot(hn::RebindMask(df, planar), better);
            for (unsigned lane = 0; lane < lanes; ++lane) {
                if ((flat >> lane & 1U) == 0) continue;
                considerPlanar(events + i + lane, events, events + count,
                               lower + kBitCounts.before[begins][lane], upper - kBitCounts.before[ends][lane],
                               area, cost, best);
            }
        }
        const auto betterInt = hn::RebindMask(di, better);
        bestCost = hn::IfThenElse(better, c, bestCost);
        bestBlock = hn::IfThenElse(betterInt, hn::Set(di, static_cast<std::int32_t>(i / lanes)), bestBlock);
        bestLower = hn::IfThenElse(betterInt, below, bestLower);
        bestUpper = hn::IfThenElse(betterInt, above, bestUpper);
        lower += kBitCounts.upTo[begins][7];
        upper -= kBitCounts.upTo[ends][7];
    }

    float costs[8];
    std::int32_t blocks[8];
    std::int32_t lowers[8];
    std::int32_t uppers[8];
    hn::StoreU(bestCost, df, costs);
    hn::StoreU(bestBlock, di, blocks);
    hn::StoreU(bestLower, di, lowers);
    hn::StoreU(bestUpper, di, uppers);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (blocks[lane] < 0 || costs[lane] > best.cost) continue;
        const Event* const event = events + static_cast<std::size_t>(blocks[lane]) * lanes + lane;
        if (costs[lane] == best.cost && event > best.event) continue;
        best = {costs[lane], event, static_cast<std::uint32_t>(lowers[lane]),
                static_cast<std::uint32_t>(uppers[lane]), false};
    }
    return best;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(sweepEvents);

SweptPlane sweepEvents(const Event* events, std::size_t count, std::uint32_t triangles,
                       const AreaOfParts& area, const CostModel& cost) {
    return HWY_DYNAMIC_DISPATCH(sweepEvents)(events, count, triangles, area, cost);
}

} // namespace rtcore
#endif
