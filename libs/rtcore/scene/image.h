/// Images in memory: rows from the top, pixels from the left, no padding.
#pragma once

#include "rtcore/math/colour.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

template <typename Pixel>
struct Image {
    int width = 0, height = 0;
    std::vector<Pixel> pixels; ///< width * height

    Image() = default;
    Image(int w, int h, Pixel fill = {})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    bool empty() const { return pixels.empty(); }
    Pixel& at(int x, int y) { return pixels[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Eight bits a channel, colour encoded as sRGB, alpha linear (255 = opaque).
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend bool operator==(const Rgba8&, const Rgba8&) = default;
};
static_assert(sizeof(Rgba8) == 4);

using HdrImage = Image<Colour>; ///< linear, unbounded
using LdrImage = Image<Rgba8>;

/// The largest side and pixel count that any reader accepts, so that a lying header cannot ask for all
/// memory.
inline constexpr int kMaxImageSide = 32768;
inline constexpr std::size_t kMaxImagePixels = std::size_t{1} << 28;

} // namespace rtcore
