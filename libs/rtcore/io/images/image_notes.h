/// Content of an image file beside the pixels.
#pragma once

#include <span>
#include <string>

namespace rtcore {

/// An attribute of an EXR file, a text (tEXt) of a PNG file. Printable ASCII; the name has 1 to 79
/// characters.
struct ImageText {
    std::string name, text;
    friend bool operator==(const ImageText&, const ImageText&) = default;
};

struct ImageNotes {
    std::span<const ImageText> texts = {}; ///< kept by PNG and EXR
    double dpi = 0;                        ///< pixels to an inch of paper, kept by PNG and TIFF; 0: not said
    bool panorama = false; ///< it is equirectangular and shows all directions; kept by PNG and JPEG
};

} // namespace rtcore
