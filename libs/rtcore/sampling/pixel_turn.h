/// Turns in which some pixels of an image are worked on, and then others.
#pragma once

#include <cstdint>

namespace rtcore {

/// 0..kTurns-1: the turn of a pixel among its neighbours, which are far apart in time. (Bayer 1973)
constexpr std::uint32_t turnOf(int x, int y) {
    std::uint32_t turn = 0;
    for (int bit = 0; bit < 6; ++bit) {
        const std::uint32_t a = static_cast<std::uint32_t>(x) >> bit & 1U;
        const std::uint32_t b = static_cast<std::uint32_t>(y) >> bit & 1U;
        turn = turn << 2 | (a ^ b) << 1 | b;
    }
    return turn;
}
inline constexpr int kTurnsSide = 64; ///< pixels after which turns repeat
inline constexpr std::uint32_t kTurns = kTurnsSide * kTurnsSide;

} // namespace rtcore
