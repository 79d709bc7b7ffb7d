/// A rectangle of an image.
#pragma once

namespace rtcore {

/// In pixels, from the upper left corner of the image.
struct PixelArea {
    int left = 0, top = 0, columns = 0, rows = 0;
    friend bool operator==(const PixelArea&, const PixelArea&) = default;
};

} // namespace rtcore
