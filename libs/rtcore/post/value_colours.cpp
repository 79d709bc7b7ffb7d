#include "rtcore/post/value_colours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rtcore {

namespace {

constexpr std::array<std::uint32_t, 16> kViridis{0x440154, 0x481A6C, 0x472F7D, 0x414487, 0x39568C, 0x31688E,
                                                 0x2A788E, 0x23888E, 0x1F988B, 0x22A884, 0x35B779, 0x54C568,
                                                 0x7AD151, 0xA5DB36, 0xD2E21B, 0xFDE725};

constexpr std::size_t kColourSteps = 1024;

std::array<Rgba8, kColourSteps + 1> makeColours() {
    std::array<Rgba8, kColourSteps + 1> colours;
    for (std::size_t i = 0; i <= kColourSteps; ++i) {
        const float along = static_cast<float>(i) / kColourSteps * (kViridis.size() - 1);
        const std::size_t before = std::min(static_cast<std::size_t>(along), kViridis.size() - 2);
        const float rest = along - static_cast<float>(before);
        const auto channel = [&](unsigned shift) {
            const auto a = static_cast<float>(kViridis[before] >> shift & 0xFFU),
                       b = static_cast<float>(kViridis[before + 1] >> shift & 0xFFU);
            return static_cast<std::uint8_t>(a + (b - a) * rest + 0.5F);
        };
        colours[i] = {channel(16), channel(8), channel(0), 255};
    }
    return colours;
}

} // namespace

Rgba8 valueColour(float value) {
    static const std::array<Rgba8, kColourSteps + 1> colours = makeColours();
    const float bounded = value > 0 ? std::min(value, 1.0F) : 0;
    return colours[static_cast<std::size_t>(bounded * kColourSteps + 0.5F)];
}

} // namespace rtcore
