/// Stills of the bridge, as pixels.
#pragma once

#include "process/bridge/web_client.h"

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// "" and what is no PNG: none.
inline std::vector<std::uint8_t> rgbOf(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) return {};
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> out(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, out.data(), 0, nullptr);
    return out;
}

/// All parts of the next still that is finished; "" when none comes.
inline std::string stillOf(WebClient& client) {
    std::string bytes;
    for (;;) {
        const auto part = client.binary(2);
        if (!part) return {};
        const FrameHeader header = headerOf(part->payload);
        client.acknowledge(*part);
        if (header.offset == 0) bytes.clear(); // the one before was given up
        if (header.offset != bytes.size()) return {};
        bytes += part->payload.substr(40);
        if ((header.flags & 4) != 0) return bytes.size() == header.total ? bytes : std::string();
    }
}

/// Whether they are the same pixels.
inline bool areSame(const std::vector<std::uint8_t>& rgb, const std::vector<std::uint8_t>& rgba) {
    if (rgb.size() / 3 != rgba.size() / 4) return false;
    for (std::size_t i = 0; i < rgb.size(); ++i)
        if (rgb[i] != rgba[i / 3 * 4 + i % 3]) return false;
    return true;
}

} // namespace test
