#include "rtcore/io/drawings/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

constexpr double kMargin = 10, kFooter = 16; // mm; the footer has the scale bar
constexpr double kHeavy = 0.5, kLight = 0.18;
constexpr double kLetters = 2.5;

/// From metres of the drawing to a sheet.
class Projection {
  public:
    Projection(const Drawing& drawing, double scale, FlatPoint corner)
        : factor_(1000 / scale), left_(drawing.low[0]), top_(drawing.high[1]), corner_(corner) {}

    FlatPoint operator()(const FlatPoint& p) const {
        return {corner_[0] + (p[0] - left_) * factor_, corner_[1] + (top_ - p[1]) * factor_};
    }
    FlatLoop operator()(const FlatLoop& loop) const {
        FlatLoop moved;
        for (const FlatPoint& p : loop) moved.push_back((*this)(p));
        return moved;
    }

  private:
    double factor_, left_, top_;
    FlatPoint corner_;
};

SheetLayer cutSolids(const Drawing& drawing, const Projection& paper) {
    SheetLayer layer{.name = "cut", .areas = {}, .grey = 0.75, .lines = {}, .texts = {}};
    for (const FlatLoop& loop : drawing.solids) {
        layer.areas.push_back(paper(loop));
        layer.lines.push_back({layer.areas.back(), true, kHeavy});
    }
    return layer;
}

SheetLayer cutSurfaces(const Drawing& drawing, const Projection& paper) {
    SheetLayer layer{.name = "cut-open", .areas = {}, .lines = {}, .texts = {}};
    for (const FlatLoop& loop : drawing.loops) layer.lines.push_back({paper(loop), true, kHeavy});
    for (const FlatLoop& chain : drawing.chains) layer.lines.push_back({paper(chain), false, kHeavy});
    return layer;
}

SheetLayer seenLines(const Drawing& drawing, const Projection& paper) {
    SheetLayer layer{.name = "seen", .areas = {}, .lines = {}, .texts = {}};
    for (const FlatLine& line : drawing.seen)
        layer.lines.push_back({{paper(line.a), paper(line.b)}, false, kLight});
    return layer;
}

SheetLayer roomLabels(const Drawing& drawing, const Projection& paper) {
    SheetLayer layer{.name = "rooms", .areas = {}, .lines = {}, .texts = {}};
    for (std::size_t i = 0; i < drawing.rooms.size(); ++i) {
        const FlatPoint at = paper(drawing.rooms[i].label);
        layer.texts.push_back({{at[0], at[1] - 0.3 * kLetters}, kLetters, fmt::format("{}", i + 1), false});
        layer.texts.push_back({{at[0], at[1] + 1.1 * kLetters},
                               kLetters,
                               fmt::format("{:.2f} m\u00B2", drawing.rooms[i].area),
                               false});
    }
    return layer;
}

/// A length of 1, 2 or 5 times a power of ten metres that takes at most `room` mm.
double barOf(double scale, double room) {
    const double metres = room * scale / 1000, power = std::pow(10, std::floor(std::log10(metres)));
    for (const double times : {5, 2})
        if (times * power <= metres) return times * power;
    return power;
}

/// Black and white in turns, with the numbers of its ends.
void addScaleBar(SheetLayer& margin, double scale, FlatPoint at, double room) {
    constexpr int kPieces = 4;
    constexpr double kHeight = 1.5;
    const double metres = barOf(scale, room), length = metres * 1000 / scale;
    const auto box = [&](double from, double to) {
        return FlatLoop{{at[0] + from * length, at[1]},
                        {at[0] + to * length, at[1]},
                        {at[0] + to * length, at[1] + kHeight},
                        {at[0] + from * length, at[1] + kHeight}};
    };
    for (int i = 0; i < kPieces; i += 2)
        margin.areas.push_back(box(double(i) / kPieces, double(i + 1) / kPieces));
    margin.lines.push_back({box(0, 1), true, kLight});
    margin.texts.push_back({{at[0], at[1] - 1}, kLetters, "0", false});
    margin.texts.push_back({{at[0] + length, at[1] - 1}, kLetters, fmt::format("{:g} m", metres), false});
}

void addNorthArrow(SheetLayer& margin, double north, FlatPoint middle) {
    constexpr double kLength = 5;
    const double s = std::sin(north), c = std::cos(north);
    const auto at = [&](double right, double up) {
        return FlatPoint{middle[0] + kLength * (right * c + up * s),
                         middle[1] - kLength * (up * c - right * s)};
    };
    margin.areas.push_back({at(0, 1), at(0.35, -0.8), at(0, -0.45)});
    margin.lines.push_back({{at(0, 1), at(0.35, -0.8), at(0, -0.45), at(-0.35, -0.8)}, true, kLight});
    const FlatPoint letter = at(0, 1.45);
    margin.texts.push_back({{letter[0], letter[1] + kLetters / 2}, kLetters, "N", false});
}

/// Of a sheet of that size, with a remark behind the title.
SheetLayer marginOf(const Drawing& drawing, const SheetOptions& options, double width, double height,
                    const std::string& remark) {
    SheetLayer margin{.name = "sheet", .areas = {}, .lines = {}, .texts = {}};
    const double line = height - kMargin;
    addScaleBar(margin, options.scale, {kMargin, line - 7}, std::min(60.0, width - 4 * kMargin));
    margin.texts.push_back(
        {{kMargin, line}, kLetters, fmt::format("{}1:{:g}{}", options.title, options.scale, remark), true});
    if (drawing.north) addNorthArrow(margin, *drawing.north, {width - kMargin - 5, line - 5});
    return margin;
}

/// Nothing of the line is in the box.
bool isOutside(const FlatLoop& line, const FlatPoint& low, const FlatPoint& high) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [min, max] = std::ranges::minmax(line, {}, [&](const FlatPoint& p) { return p[axis]; });
        if (max[axis] < low[axis] || min[axis] > high[axis]) return true;
    }
    return false;
}

/// Layers without what the frame does not show.
void cull(Sheet& sheet) {
    const FlatPoint low{sheet.frameLow[0] - 1, sheet.frameLow[1] - 1};
    const FlatPoint high{sheet.frameHigh[0] + 1, sheet.frameHigh[1] + 1};
    for (SheetLayer& layer : sheet.layers) {
        std::erase_if(layer.areas, [&](const FlatLoop& area) { return isOutside(area, low, high); });
        std::erase_if(layer.lines,
                      [&](const SheetLayer::Line& line) { return isOutside(line.points, low, high); });
    }
}

/// Frames side by side and below each other that show all of it.
struct SheetGrid {
    double wide, high; ///< a frame, mm
    int columns, rows;

    SheetGrid(const FlatPoint& size, const PaperSize& paper)
        : wide(paper.width - 2 * kMargin), high(paper.height - 2 * kMargin - kFooter),
          columns(countOf(size[0] / wide)), rows(countOf(size[1] / high)) {}

  private:
    static int countOf(double frames) {
        return static_cast<int>(std::clamp(std::ceil(frames), 1.0, 32768.0));
    }
};

std::vector<SheetLayer> layersOf(const Drawing& drawing, const Projection& paper) {
    return {seenLines(drawing, paper), cutSolids(drawing, paper), cutSurfaces(drawing, paper),
            roomLabels(drawing, paper)};
}

/// Rows by letters, as the columns of a spreadsheet: A to Z, AA and so on.
std::string labelOf(int row, int column) {
    constexpr int kLettersOfAlphabet = 26;
    std::string letters;
    for (int rest = row; rest >= 0; rest = rest / kLettersOfAlphabet - 1)
        letters.insert(letters.begin(), static_cast<char>('A' + rest % kLettersOfAlphabet));
    return letters + std::to_string(column + 1);
}

FlatPoint sizeOf(const Drawing& drawing, double scale) {
    return {(drawing.high[0] - drawing.low[0]) * 1000 / scale,
            (drawing.high[1] - drawing.low[1]) * 1000 / scale};
}

} // namespace

Sheet sheetOf(const Drawing& drawing, const SheetOptions& options) {
    constexpr double kNarrowest = 100; // for the margin
    const FlatPoint size = sizeOf(drawing, options.scale);
    Sheet sheet;
    sheet.width = std::max(size[0], kNarrowest) + 2 * kMargin;
    sheet.height = size[1] + 2 * kMargin + kFooter;
    sheet.frameLow = {0, 0};
    sheet.frameHigh = {sheet.width, sheet.height};
    sheet.corner = {kMargin, kMargin};
    sheet.layers = layersOf(drawing, Projection(drawing, options.scale, sheet.corner));
    sheet.margin = marginOf(drawing, options, sheet.width, sheet.height, "");
    return sheet;
}

int numberOfSheets(const Drawing& drawing, double scale, const PaperSize& paper) {
    const SheetGrid grid(sizeOf(drawing, scale), paper);
    return grid.columns * grid.rows;
}

std::vector<Sheet> sheetsOf(const Drawing& drawing, const SheetOptions& options, const PaperSize& paper) {
    const auto [wide, high, columns, rows] = SheetGrid(sizeOf(drawing, options.scale), paper);
    // In the middle of them.
    const FlatPoint size = sizeOf(drawing, options.scale);
    const FlatPoint spare{(columns * wide - size[0]) / 2, (rows * high - size[1]) / 2};
    std::vector<Sheet> sheets;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Sheet sheet{
                .width = paper.width, .height = paper.height, .label = {}, .layers = {}, .margin = {}};
            if (rows * columns > 1) sheet.label = labelOf(row, column);
            const std::string remark =
                sheet.label.empty() ? "" : fmt::format("  {} ({} x {})", sheet.label, columns, rows);
            sheet.frameLow = {kMargin, kMargin};
            sheet.frameHigh = {kMargin + wide, kMargin + high};
            sheet.corner = {kMargin - column * wide + spare[0], kMargin - row * high + spare[1]};
            sheet.layers = layersOf(drawing, Projection(drawing, options.scale, sheet.corner));
            cull(sheet);
            sheet.margin = marginOf(drawing, options, paper.width, paper.height, remark);
            if (!sheet.label.empty())
                sheet.margin.lines.push_back({{{kMargin, kMargin},
                                               {kMargin + wide, kMargin},
                                               {kMargin + wide, kMargin + high},
                                               {kMargin, kMargin + high}},
                                              true,
                                              kLight / 2});
            sheets.push_back(std::move(sheet));
        }
    }
    return sheets;
}

} // namespace rtcore
