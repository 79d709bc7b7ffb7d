/// Text painted into images, of any size and at any position, with smooth edges.
#pragma once

#include "rtcore/scene/image.h"

#include <string_view>

namespace rtcore {

struct StrokeStyle {
    float height = 12;   ///< of capitals and digits, pixels; above 0
    float weight = 1.5F; ///< width of the lines, pixels
    Rgba8 colour{255, 255, 255, 255};
};

/// Pixels from the first to the last line of the text. A '^' raises the next letter and makes it smaller:
/// "cd/m^2". Letters that the font has not (stroke_font.h) are blanks.
float strokeTextWidth(std::string_view text, const StrokeStyle& style);

/// Paints over `image`, whose alpha stays as it is; what lies outside is left out. `x` is the left edge, `y`
/// the line on which letters stand, both in pixels from the upper left corner. One thread; the same bits on
/// every processor.
void strokeText(LdrImage& image, std::string_view text, const StrokeStyle& style, float x, float y);

} // namespace rtcore
