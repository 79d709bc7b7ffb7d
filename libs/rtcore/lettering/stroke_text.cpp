#include "rtcore/lettering/stroke_text.h"

#include "rtcore/lettering/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtcore {

namespace {

constexpr float kRaisedSize = 0.65F, kRaisedBy = 5; ///< grid units above the baseline

struct Point {
    float x, y;
};
struct Line {
    Point from, to;
};

int gridNumber(char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; }

/// One letter, and where in the grid of the text it stands.
struct Letter {
    Glyph glyph;
    float left, size, lift;
};

/// All letters; `width` gets the right edge of the last one.
std::vector<Letter> lettersOf(std::string_view text, float& width) {
    std::vector<Letter> letters;
    float left = 0;
    bool raised = false;
    width = 0;
    for (const char each : text) {
        if (each == '^') {
            raised = true;
            continue;
        }
        const Glyph glyph = glyphOf(each).value_or(*glyphOf(' '));
        const float size = raised ? kRaisedSize : 1;
        letters.push_back({glyph, left, size, raised ? kRaisedBy : 0});
        width = left + size * static_cast<float>(glyph.width);
        left = width + size * kLetterGap;
        raised = false;
    }
    return letters;
}

/// The lines of a letter in pixels of the image, where the text begins at `begin`.
std::vector<Line> linesOf(const Letter& letter, float unit, Point begin) {
    std::vector<Line> lines;
    const std::string_view points = letter.glyph.lines;
    const auto at = [&](std::size_t i) -> Point {
        const auto x = static_cast<float>(gridNumber(points[i]));
        const auto y = static_cast<float>(gridNumber(points[i + 1]) - kBaseline);
        return {begin.x + unit * (letter.left + letter.size * x),
                begin.y - unit * (letter.lift + letter.size * y)};
    };
    for (std::size_t i = 0; i + 3 < points.size(); i += 2) {
        if (points[i + 2] == ' ')
            ++i; // the blank; the next point begins a line
        else
            lines.push_back({at(i), at(i + 2)});
    }
    return lines;
}

float distanceTo(const Line& line, Point p) {
    const float dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
    const float squared = dx * dx + dy * dy;
    const float along = (p.x - line.from.x) * dx + (p.y - line.from.y) * dy;
    const float t = squared > 0 ? std::clamp(along / squared, 0.0F, 1.0F) : 0;
    const float x = p.x - line.from.x - t * dx, y = p.y - line.from.y - t * dy;
    return std::sqrt(x * x + y * y);
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, float coverage) {
    const float value = static_cast<float>(below) * (1 - coverage) + static_cast<float>(above) * coverage;
    return static_cast<std::uint8_t>(value + 0.5F);
}

/// Pixels from the first to before the last, within the image.
struct PixelRange {
    int first, last;

    PixelRange(float from, float to, int size)
        : first(bounded(std::floor(from), size)), last(bounded(std::ceil(to), size)) {}

  private:
    static int bounded(float value, int size) {
        return static_cast<int>(std::clamp(value, 0.0F, static_cast<float>(size)));
    }
};

void paintLetter(LdrImage& image, const std::vector<Line>& lines, const StrokeStyle& style) {
    const float reach = style.weight / 2 + 0.5F;
    Point low = lines[0].from, high = low;
    for (const Line& line : lines) {
        low = {std::min({low.x, line.from.x, line.to.x}), std::min({low.y, line.from.y, line.to.y})};
        high = {std::max({high.x, line.from.x, line.to.x}), std::max({high.y, line.from.y, line.to.y})};
    }
    const PixelRange rows(low.y - reach, high.y + reach, image.height);
    const PixelRange columns(low.x - reach, high.x + reach, image.width);
    for (int row = rows.first; row < rows.last; ++row) {
        for (int column = columns.first; column < columns.last; ++column) {
            const Point p{static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F};
            float nearest = reach;
            for (const Line& line : lines) nearest = std::min(nearest, distanceTo(line, p));
            const float coverage = std::min(reach - nearest, 1.0F);
            Rgba8& pixel = image.at(column, row);
            pixel = {mixed(pixel.r, style.colour.r, coverage), mixed(pixel.g, style.colour.g, coverage),
                     mixed(pixel.b, style.colour.b, coverage), pixel.a};
        }
    }
}

} // namespace

float strokeTextWidth(std::string_view text, const StrokeStyle& style) {
    float width = 0;
    lettersOf(text, width);
    return width * style.height / kCapHeight;
}

void strokeText(LdrImage& image, std::string_view text, const StrokeStyle& style, float x, float y) {
    float width = 0;
    for (const Letter& letter : lettersOf(text, width)) {
        const std::vector<Line> lines = linesOf(letter, style.height / kCapHeight, {x, y});
        if (!lines.empty()) paintLetter(image, lines, style);
    }
}

} // namespace rtcore
