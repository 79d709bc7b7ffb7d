#include "bridge/stream/jpeg_strips.h"

#include <algorithm>
#include <stdexcept>

namespace bridge {

namespace {

constexpr int kBlockRows = 16, kStripPixels = 1 << 19;
// Markers (ITU-T T.81, table B.1).
constexpr std::uint8_t kFrame = 0xC0, kFirstRestart = 0xD0, kEnd = 0xD9, kScan = 0xDA, kInterval = 0xDD;

unsigned word(std::span<const std::uint8_t> bytes, std::size_t at) {
    return bytes[at] * 256U + bytes[at + 1];
}

struct Layout {
    std::size_t frame = 0;   ///< where its segment begins
    std::size_t scan = 0;    ///< the same
    std::size_t content = 0; ///< where the coded image begins; it ends 2 bytes before the end
};

Layout layoutOf(std::span<const std::uint8_t> jpeg) {
    Layout layout;
    for (std::size_t at = 2; at + 4 <= jpeg.size(); at += 2 + word(jpeg, at + 2)) {
        if (jpeg[at + 1] == kFrame) layout.frame = at;
        if (jpeg[at + 1] != kScan) continue;
        layout.scan = at;
        layout.content = at + 2 + word(jpeg, at + 2);
        break;
    }
    if (layout.frame == 0 || layout.content == 0 || layout.content + 2 > jpeg.size())
        throw std::runtime_error("the JPEG encoder wrote no baseline image");
    return layout;
}

/// Blocks of all components that are coded together, in a strip.
unsigned unitsIn(std::span<const std::uint8_t> frame) {
    const unsigned height = word(frame, 5), width = word(frame, 7), components = frame[9];
    unsigned across = 1, down = 1;
    for (unsigned i = 0; i < components; ++i) {
        const unsigned factors = frame[11 + 3 * static_cast<std::size_t>(i)];
        across = std::max(across, factors >> 4U);
        down = std::max(down, factors & 15U);
    }
    const auto parts = [](unsigned length, unsigned each) { return (length + each - 1) / each; };
    return parts(width, 8 * across) * parts(height, 8 * down);
}

} // namespace

int stripHeight(int width) {
    return std::max(1, kStripPixels / kBlockRows / std::max(1, width)) * kBlockRows;
}

std::vector<std::uint8_t> joinStrips(std::span<const std::span<const std::uint8_t>> strips, int height) {
    const std::span<const std::uint8_t> first = strips.front();
    if (strips.size() == 1) return {first.begin(), first.end()};
    const Layout layout = layoutOf(first);
    const unsigned units = unitsIn(first.subspan(layout.frame));
    std::vector<std::uint8_t> joined(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(layout.scan));
    joined[layout.frame + 5] = static_cast<std::uint8_t>(height / 256);
    joined[layout.frame + 6] = static_cast<std::uint8_t>(height % 256);
    joined.insert(joined.end(), {0xFF, kInterval, 0, 4, static_cast<std::uint8_t>(units / 256),
                                 static_cast<std::uint8_t>(units % 256)});
    joined.insert(joined.end(), first.begin() + static_cast<std::ptrdiff_t>(layout.scan),
                  first.begin() + static_cast<std::ptrdiff_t>(layout.content));
    for (std::size_t i = 0; i < strips.size(); ++i) {
        if (i > 0)
            joined.insert(joined.end(), {0xFF, static_cast<std::uint8_t>(kFirstRestart + (i - 1) % 8)});
        const auto content = strips[i].subspan(layoutOf(strips[i]).content);
        joined.insert(joined.end(), content.begin(), content.end() - 2);
    }
    joined.insert(joined.end(), {0xFF, kEnd});
    return joined;
}

} // namespace bridge
