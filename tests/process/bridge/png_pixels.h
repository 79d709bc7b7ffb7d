/// Pixels of PNG bytes, by libpng.
#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// Three bytes a pixel; empty: no PNG.
inline std::vector<std::uint8_t> rgbOf(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) return {};
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> out(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, out.data(), 0, nullptr);
    return out;
}

} // namespace test
