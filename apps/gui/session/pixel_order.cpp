#include "gui/session/pixel_order.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace gui {

static_assert(std::endian::native == std::endian::little, "a pixel is read as a whole");

namespace {

constexpr std::uint32_t kOpaque = 0xff000000U;

std::uint32_t turned(std::uint32_t pixel) {
    return kOpaque | (pixel & 0x0000ff00U) | (pixel & 0xffU) << 16U | (pixel >> 16U & 0xffU);
}

std::uint32_t load(const std::byte* from) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, from, sizeof(pixel));
    return pixel;
}

} // namespace

// Simple enough for the compiler to take many pixels at once.
void toRgb32(std::span<std::byte> pixels) {
    std::byte* const bytes = pixels.data();
    const std::size_t count = pixels.size() / sizeof(std::uint32_t);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t pixel = turned(load(bytes + sizeof(pixel) * i));
        std::memcpy(bytes + sizeof(pixel) * i, &pixel, sizeof(pixel));
    }
}

void toRgb32Over(std::span<std::byte> pixels, std::span<const std::byte> below) {
    std::byte* const bytes = pixels.data();
    const std::size_t count = std::min(pixels.size(), below.size()) / sizeof(std::uint32_t);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t above = load(bytes + sizeof(above) * i);
        const std::uint32_t pixel =
            (above & kOpaque) == 0 ? load(below.data() + sizeof(above) * i) : turned(above);
        std::memcpy(bytes + sizeof(pixel) * i, &pixel, sizeof(pixel));
    }
}

} // namespace gui
