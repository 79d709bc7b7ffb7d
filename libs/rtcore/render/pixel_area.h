/// A rectangle of an image.
#pragma once

#include <span>

namespace rtcore {

/// In pixels, from the upper left corner of the image.
struct PixelArea {
    int left = 0, top = 0, columns = 0, rows = 0;
    friend bool operator==(const PixelArea&, const PixelArea&) = default;
};

/// Number of pixels of areas that do not overlap.
inline double pixelsOf(std::span<const PixelArea> areas) {
    double pixels = 0;
    for (const PixelArea& area : areas) pixels += static_cast<double>(area.columns) * area.rows;
    return pixels;
}

} // namespace rtcore
