#include "rtcore/post/upsample.h"

#include "rtcore/platform/threads.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rtcore {

namespace {

/// Red, green and blue side by side in one number, each in parts of 1/256 of a code and with 16 bits: what
/// adds or scales the number does so with all three.
using Channels = std::uint64_t;

Channels spread(Rgba8 c) { return Channels{c.r} | Channels{c.g} << 16U | Channels{c.b} << 32U; }

Rgba8 rounded(Channels c) {
    constexpr Channels kHalf = 0x8000800080;
    c += kHalf;
    return {static_cast<std::uint8_t>(c >> 8U), static_cast<std::uint8_t>(c >> 24U),
            static_cast<std::uint8_t>(c >> 40U)};
}

/// Between the rows of small pixels above and below the row `y` of large ones: each small pixel of that row,
/// in parts of 256 / (2 * block).
void mixRows(const LdrImage& small, int y, int block, std::vector<Channels>& mixed) {
    const int twice = 2 * (y % block) + 1 - block; // from the middle of its square, in half pixels
    const int upper = twice < 0 ? y / block - 1 : y / block;
    const auto down = static_cast<Channels>(twice < 0 ? twice + 2 * block : twice);
    const Channels whole = 2 * static_cast<Channels>(block);
    const Channels scale = 256 / (whole * whole);
    const Rgba8* const above = &small.at(0, std::max(upper, 0));
    const Rgba8* const below = &small.at(0, std::min(upper + 1, small.height - 1));
    for (std::size_t x = 0; x < mixed.size(); ++x) {
        mixed[x] = ((whole - down) * spread(above[x]) + down * spread(below[x])) * scale;
    }
}

/// From the middle of one small pixel to the middle of the next, `columns` large pixels at most.
void fill(Channels left, Channels right, int block, int columns, Rgba8* to) {
    // Half a large pixel is one part of 2 * block. Differences may be negative: they wrap, and back again.
    const Channels half = right - left;
    Channels value = left * (2 * static_cast<Channels>(block)) + half;
    for (int i = 0; i < columns; ++i) {
        to[i] = rounded(value);
        value += 2 * half;
    }
}

void upsampleRow(const std::vector<Channels>& mixed, int block, int width, Rgba8* row) {
    const int before = block / 2; // large pixels left of the first middle
    fill(mixed.front(), mixed.front(), block, std::min(before, width), row);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const int x = static_cast<int>(i) * block + before;
        if (x >= width) break;
        const Channels right = mixed[std::min(i + 1, mixed.size() - 1)];
        fill(mixed[i], right, block, std::min(block, width - x), row + x);
    }
}

} // namespace

void upsample(const LdrImage& small, int block, int threads, LdrImage& image) {
    const int team = threadsFor(threads);
    std::vector<std::vector<Channels>> rows(static_cast<std::size_t>(team),
                                            std::vector<Channels>(static_cast<std::size_t>(small.width)));
#pragma omp parallel for schedule(static) num_threads(team)
    for (int y = 0; y < image.height; ++y) {
        std::vector<Channels>& mixed = rows[static_cast<std::size_t>(threadNumber())];
        mixRows(small, y, block, mixed);
        upsampleRow(mixed, block, image.width, &image.at(0, y));
    }
}

} // namespace rtcore
