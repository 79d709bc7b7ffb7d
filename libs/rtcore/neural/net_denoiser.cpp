#include "rtcore/neural/net_denoiser.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

/// Pixels that are mirrored around the image: with zeros there, its border would be wrong by up to 30 %.
constexpr int kMargin = 16;
constexpr int kMaxPart = 4 * kBlockSquares; ///< pixels of a row that are read or written at once

constexpr int roundedUp(int x, int step) { return (x + step - 1) / step * step; }

/// The index of what lies at `i` where `count` pixels are mirrored at both ends, without these being
/// repeated.
int mirrored(int i, int count) {
    if (count == 1) return 0;
    const int period = 2 * count - 2;
    i = (i % period + period) % period;
    return i < count ? i : period - i;
}

float clamped(float value, float low, float high) {
    return value >= low ? std::min(value, high) : value < low ? low : 0;
}

const float* at(const PixelPlane& plane, int width, int x, int y) {
    return plane.first +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               plane.step;
}

/// A channel of a pixel in the margin: a bright dot beside the border would be two, which look like one
/// thing; so none is brighter than the pixels around the one that is mirrored.
float inMargin(const NoisyImage& image, int x, int y, std::size_t channel) {
    float around = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u)
            if (u != x || v != y) around = std::max(around, at(image.radiance, image.width, u, v)[channel]);
    const float own = at(image.radiance, image.width, x, y)[channel];
    const bool alone = image.width == 1 && image.height == 1;
    return alone ? own : std::min(own, around);
}

/// Of nets of Intel's the large one takes 242 bytes a pixel, and the others at most 161 (bench_net).
std::size_t usualMaxPixels(const UNet& net) { return net.large() ? 2'400'000 : std::size_t{3} << 20; }

/// Pixels from tile to tile.
struct TileSteps {
    int across, down;

    int tilesOf(int width, int height) const {
        return ((width + across - 1) / across) * ((height + down - 1) / down);
    }
};

/// Steps along a side of `parts` tiles: multiples of UNet::kSideStep, as even as can be.
int tileStep(int side, int parts) {
    return parts == 1 ? side : roundedUp((side + parts - 1) / parts, UNet::kSideStep);
}
/// The side of a tile with what it overlaps.
std::size_t tileSide(int side, int parts, int reach) {
    return static_cast<std::size_t>(parts == 1 ? side : tileStep(side, parts) + 2 * reach);
}

/// The tiles with the least work in all of those that are not larger than `maxPixels`, or nearly.
TileSteps planTiles(int width, int height, int reach, std::size_t maxPixels) {
    const auto smallest = static_cast<std::size_t>(2 * reach + 2 * UNet::kSideStep);
    maxPixels = std::max(maxPixels, smallest * smallest);
    const auto maxParts = [](int side) { return std::max(side / UNet::kSideStep, 1); };
    TileSteps best{UNet::kSideStep, UNet::kSideStep};
    std::size_t minWork = std::numeric_limits<std::size_t>::max();
    for (int down = 1; down <= maxParts(height); ++down) {
        for (int across = 1; across <= maxParts(width); ++across) {
            const std::size_t pixels = tileSide(width, across, reach) * tileSide(height, down, reach);
            const std::size_t work =
                pixels * static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
            if (pixels > maxPixels || work >= minWork) continue;
            minWork = work;
            best = {tileStep(width, across), tileStep(height, down)};
        }
    }
    return best;
}

void tell(const NetProgress& progress, int done, int tiles) {
    if (progress.fraction == nullptr) return;
    const float part = static_cast<float>(done) / static_cast<float>(tiles);
    *progress.fraction = progress.begin + (progress.end - progress.begin) * part;
}

} // namespace

/// A part of the image with its margin, and what the net needs around it; in pixels of both.
struct NetDenoiser::Tile {
    int left, top, right, bottom;                     ///< that the net works on
    int innerLeft, innerTop, innerRight, innerBottom; ///< that are kept
};

NetDenoiser::NetDenoiser(std::shared_ptr<const UNet> net, std::size_t maxPixels)
    : run_(std::move(net)), maxPixels_(maxPixels > 0 ? maxPixels : usualMaxPixels(run_.net())) {}

void NetDenoiser::readPixels(const NoisyImage& image, const Tile& tile, int y, int left, int count,
                             float* pixels) const {
    std::array<float, 3 * kMaxPart> coded{};
    const int v = tile.top + y - kMargin, row = mirrored(v, image.height);
    for (int i = 0; i < count; ++i) {
        const int u = tile.left + left + i - kMargin, column = mirrored(u, image.width);
        const float* const radiance = at(image.radiance, image.width, column, row);
        const bool inside = u == column && v == row;
        for (std::size_t c = 0; c < 3; ++c)
            coded[static_cast<std::size_t>(3 * i) + c] =
                inside ? radiance[c] : inMargin(image, column, row, c);
        float* const pixel = pixels + static_cast<std::size_t>(i) * UNetRun::kStride;
        std::fill(pixel, pixel + UNetRun::kStride, 0.0F);
        if (net().inputs() > 3) {
            const float* const albedo = at(image.albedo, image.width, column, row);
            for (std::size_t c = 0; c < 3; ++c) pixel[3 + c] = clamped(albedo[c], 0, 1);
        }
        if (net().inputs() > 6) {
            const float* const normal = at(image.normal, image.width, column, row);
            for (std::size_t c = 0; c < 3; ++c) pixel[6 + c] = clamped(normal[c], -1, 1) * 0.5F + 0.5F;
        }
    }
    encodeRadiance(coded.data(), coded.size(), scale_, coded.data());
    for (int i = 0; i < count; ++i)
        std::copy_n(&coded[static_cast<std::size_t>(3 * i)], 3,
                    pixels + static_cast<std::size_t>(i) * UNetRun::kStride);
}

void NetDenoiser::writePixels(const NoisyImage& image, const Tile& tile, int y, int left, int count,
                              const float* pixels, float* result) const {
    const int v = tile.top + y;
    if (v < std::max(tile.innerTop, kMargin) || v >= std::min(tile.innerBottom, image.height + kMargin))
        return;
    std::array<float, 3 * kMaxPart> values{};
    for (int i = 0; i < count; ++i)
        std::copy_n(pixels + static_cast<std::size_t>(i) * UNetRun::kStride, 3,
                    &values[static_cast<std::size_t>(3 * i)]);
    decodeRadiance(values.data(), values.size(), scale_, values.data());
    const int first = std::max({tile.left + left, tile.innerLeft, kMargin});
    const int last = std::min({tile.left + left + count, tile.innerRight, image.width + kMargin});
    if (first >= last) return;
    const auto from = static_cast<std::size_t>(3 * (first - tile.left - left));
    const auto pixel = static_cast<std::size_t>(v - kMargin) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(first - kMargin);
    std::copy_n(&values[from], static_cast<std::size_t>(3 * (last - first)), result + 3 * pixel);
}

bool NetDenoiser::run(const NoisyImage& image, float* result, int threads, const std::atomic<bool>* stop,
                      const NetProgress& progress) {
    scale_ = exposureForNet(image.radiance, image.width, image.height, threads);
    const int width = roundedUp(image.width + 2 * kMargin, UNet::kSideStep);
    const int height = roundedUp(image.height + 2 * kMargin, UNet::kSideStep);
    const int reach = net().reach();
    const TileSteps steps = planTiles(width, height, reach, maxPixels_);
    int done = 0;
    for (int top = 0; top < height; top += steps.down) {
        for (int left = 0; left < width; left += steps.across) {
            const int right = left + steps.across, bottom = top + steps.down;
            const Tile tile{std::max(left - reach, 0),
                            std::max(top - reach, 0),
                            std::min(right + reach, width),
                            std::min(bottom + reach, height),
                            left,
                            top,
                            right,
                            bottom};
            const UNetRun::Rows both{
                [&](int y, int x, int count, float* to) { readPixels(image, tile, y, x, count, to); },
                [&](int y, int x, int count, const float* from) {
                    writePixels(image, tile, y, x, count, from, result);
                }};
            if (!run_.run(tile.right - tile.left, tile.bottom - tile.top, both, threads, stop)) return false;
            tell(progress, ++done, steps.tilesOf(width, height));
        }
    }
    return true;
}

std::size_t NetDenoiser::bytes() const { return run_.bytes(); }

} // namespace rtcore
