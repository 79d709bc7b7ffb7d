/// A text that goes into an image file beside the pixels.
#pragma once

#include <string>

namespace rtcore {

/// An attribute of an EXR file, a text (tEXt) of a PNG file. Printable ASCII; the name has 1 to 79
/// characters.
struct ImageText {
    std::string name, text;
    friend bool operator==(const ImageText&, const ImageText&) = default;
};

} // namespace rtcore
