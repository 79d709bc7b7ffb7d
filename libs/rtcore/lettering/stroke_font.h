/// Letters and digits as lines, for numbers and short words in images.
#pragma once

#include <optional>
#include <string_view>

namespace rtcore {

/// Grid units: letters stand on the height kBaseline, capitals and digits are kCapHeight high.
inline constexpr int kBaseline = 4, kCapHeight = 12;

/// Polylines with a blank between them. A point is two characters, x and y, each a digit of base 36: y
/// upwards from 0, the foot of a "g". A line from a point to itself is a dot.
struct Glyph {
    char letter;
    int width; ///< from the leftmost to the rightmost point; the next letter begins kLetterGap further
    std::string_view lines;
};
inline constexpr int kLetterGap = 4;

/// The glyph of an ASCII letter, a digit or one of " .,-+/:"; nothing for others.
std::optional<Glyph> glyphOf(char letter);

} // namespace rtcore
