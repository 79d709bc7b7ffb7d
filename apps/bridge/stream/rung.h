/// The quality steps of moving frames. They are few and fixed, so that viewers share what is encoded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace bridge {

struct Rung {
    int divide;      ///< width and height are divided by it
    int quality;     ///< of the JPEG
    double relative; ///< bytes of a frame, about, as a multiple of those of kFirstRung
};

/// Finest first.
using RungTable = std::array<Rung, 6>;
inline constexpr RungTable kRungs{
    {{1, 88, 1.37}, {1, 75, 1}, {1, 60, 0.74}, {2, 80, 0.33}, {2, 60, 0.22}, {3, 60, 0.11}}};
inline constexpr int kRungCount = static_cast<int>(kRungs.size());
inline constexpr int kFirstRung = 1;     ///< which viewers begin with
inline constexpr int kFirstHalfRung = 3; ///< and those whose page is small
inline constexpr int kMaxRungs = 3;      ///< that are encoded of one frame

using RungMask = std::uint32_t; ///< bit i: kRungs[i]

/// At most kMaxRungs of them: where more are asked for, the finer one of two neighbours is left out, and its
/// viewers take the next coarser one.
constexpr RungMask mergedRungs(RungMask wanted) {
    const auto has = [&](int rung) { return (wanted >> rung & 1) != 0; };
    const auto count = [&] {
        int rungs = 0;
        for (int i = 0; i < kRungCount; ++i) rungs += has(i) ? 1 : 0;
        return rungs;
    };
    while (count() > kMaxRungs) {
        int before = -1, best = -1, bestGap = kRungCount;
        for (int i = 0; i < kRungCount; ++i) {
            if (!has(i)) continue;
            if (before >= 0 && i - before < bestGap) {
                best = before;
                bestGap = i - before;
            }
            before = i;
        }
        wanted &= ~(RungMask(1) << best);
    }
    return wanted;
}

} // namespace bridge
