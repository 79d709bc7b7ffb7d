#include "rtcore/accel/event_sweep.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/accel/event_sweep.cpp"
#include <hwy/foreach_target.h>

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

std::size_t sweepBlocks(const Event* events, std::size_t count, SweepState& state) {
    // Lanes name their block in 31 bits; at most eight, since one byte holds a bit for each.
    const hn::CappedTag<std::uint32_t, 8> du;
    const hn::RebindToSigned<decltype(du)> di;
    const hn::RebindToFloat<decltype(du)> df;
    const hn::Rebind<std::uint8_t, decltype(di)> d8;
    const std::size_t lanes = hn::Lanes(du);
    const unsigned allLanes = (1U << lanes) - 1;

    const auto traversal = hn::Set(df, state.traversal);
    const auto intersection = hn::Set(df, state.intersection);
    const auto face = hn::Set(df, state.area.face);
    const auto rim = hn::Set(df, state.area.rim);
    const auto lo = hn::Set(df, state.area.lo);
    const auto hi = hn::Set(df, state.area.hi);
    const auto signBit = hn::Set(du, 0x80000000U);
    const auto one = hn::Set(du, 1);
    const auto infinity = hn::Inf(df);

    auto bestCost = hn::Set(df, state.cost);
    auto bestBlock = hn::Set(di, -1);
    auto bestLower = hn::Zero(di);
    auto bestUpper = hn::Zero(di);
    std::uint32_t lower = state.lower;
    std::uint32_t upper = state.upper;

    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        hn::Vec<decltype(du)> low;
        hn::Vec<decltype(du)> high;
        hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(events + i), low, high);
        const auto planar = hn::Lt(hn::BitCast(di, hn::ShiftLeft<1>(low)), hn::Zero(di));
        std::uint8_t startBits[8] = {};
        std::uint8_t planarBits[8] = {};
        hn::StoreMaskBits(di, hn::Lt(hn::BitCast(di, low), hn::Zero(di)), startBits);
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
        const auto triangles = hn::Add(hn::Mul(lowerArea, hn::ConvertTo(df, below)),
                                       hn::Mul(upperArea, hn::ConvertTo(df, above)));
        auto cost = hn::Add(traversal, hn::Mul(intersection, triangles));
        if (const unsigned flat = planarBits[0] & allLanes; flat != 0) {
            cost = hn::IfThenElse(hn::RebindMask(df, planar), infinity, cost);
            for (unsigned lane = 0; lane < lanes; ++lane) {
                if ((flat >> lane & 1U) == 0) continue;
                considerPlanar(events + i + lane, lower + kBitCounts.before[begins][lane],
                               upper - kBitCounts.before[ends][lane], state);
            }
        }
        const auto better = hn::Lt(cost, bestCost);
        const auto betterInt = hn::RebindMask(di, better);
        bestCost = hn::IfThenElse(better, cost, bestCost);
        bestBlock = hn::IfThenElse(betterInt, hn::Set(di, static_cast<std::int32_t>(i / lanes)), bestBlock);
        bestLower = hn::IfThenElse(betterInt, below, bestLower);
        bestUpper = hn::IfThenElse(betterInt, above, bestUpper);
        lower += kBitCounts.upTo[begins][7];
        upper -= kBitCounts.upTo[ends][7];
    }
    state.lower = lower;
    state.upper = upper;

    float costs[8];
    std::int32_t blocks[8];
    std::int32_t lowers[8];
    std::int32_t uppers[8];
    hn::StoreU(bestCost, df, costs);
    hn::StoreU(bestBlock, di, blocks);
    hn::StoreU(bestLower, di, lowers);
    hn::StoreU(bestUpper, di, uppers);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (blocks[lane] < 0 || costs[lane] > state.cost) continue;
        const Event* const event = events + static_cast<std::size_t>(blocks[lane]) * lanes + lane;
        if (costs[lane] == state.cost && (state.cheapest == nullptr || event > state.cheapest)) continue;
        state.cost = costs[lane];
        state.cheapest = event;
        state.cheapestLower = static_cast<std::uint32_t>(lowers[lane]);
        state.cheapestUpper = static_cast<std::uint32_t>(uppers[lane]);
        state.planarLower = false;
    }
    return i;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(sweepBlocks);

std::size_t sweepBlocks(const Event* events, std::size_t count, SweepState& state) {
    return HWY_DYNAMIC_DISPATCH(sweepBlocks)(events, count, state);
}

} // namespace rtcore
#endif
