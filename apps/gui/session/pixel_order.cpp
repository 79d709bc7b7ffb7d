#include "gui/session/pixel_order.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace gui {

static_assert(std::endian::native == std::endian::little, "a pixel is read as a whole");

// Simple enough for the compiler to take many pixels at once.
void toRgb32(std::span<std::byte> pixels) {
    std::byte* const bytes = pixels.data();
    const std::size_t count = pixels.size() / sizeof(std::uint32_t);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, bytes + sizeof(pixel) * i, sizeof(pixel));
        pixel = 0xff000000U | (pixel & 0x0000ff00U) | (pixel & 0xffU) << 16U | (pixel >> 16U & 0xffU);
        std::memcpy(bytes + sizeof(pixel) * i, &pixel, sizeof(pixel));
    }
}

} // namespace gui
