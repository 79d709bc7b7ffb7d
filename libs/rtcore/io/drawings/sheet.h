/// A drawing on paper: lines, areas and words in millimetres.
#pragma once

#include "rtcore/plans/drawing.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

struct PaperSize {
    std::string_view name;
    double width, height; ///< mm, lying
};
/// ISO 216.
inline constexpr std::array<PaperSize, 5> kPaperSizes{
    {{"A4", 297, 210}, {"A3", 420, 297}, {"A2", 594, 420}, {"A1", 841, 594}, {"A0", 1189, 841}}};

/// All positions are millimetres from the upper left corner of the sheet, down.
struct SheetLayer {
    struct Line {
        FlatLoop points;
        bool closed;
        double width;
    };
    struct Text {
        FlatPoint at;     ///< the middle of its base line; of `left` its beginning
        double height;    ///< of the letters
        std::string text; ///< UTF-8
        bool left;
    };

    std::string_view name;
    std::vector<FlatLoop> areas; ///< filled together by the even-odd rule
    double grey = 0;             ///< of them: 0 black, 1 white
    std::vector<Line> lines;     ///< black
    std::vector<Text> texts;     ///< black
};

struct Sheet {
    double width = 0, height = 0;
    std::string label;                 ///< of one of several: A1 at the upper left, A2 right of it, B1 below
    std::vector<SheetLayer> layers;    ///< of the drawing, the lowest first
    FlatPoint frameLow{}, frameHigh{}; ///< where they are; with `paper` what is outside is to be clipped
    FlatPoint corner{};                ///< where the upper left corner of the drawing's bounds is
    SheetLayer margin;                 ///< below: scale bar, north arrow, title
};

struct SheetOptions {
    double scale = 100; ///< 1 to that, above 0
    std::string title;  ///< UTF-8
    double dpi = 300;   ///< of images, above 0
};

/// Of so many to an inch.
inline double pixelsOfMillimetre(double dpi) { return dpi / 25.4; }

/// The whole drawing on one sheet that is as large as it must be. Lines of cuts are half a millimetre wide,
/// those of visible edges a sixth.
Sheet sheetOf(const Drawing& drawing, const SheetOptions& options);

/// Of sheetsOf(); 2^30 at most.
int numberOfSheets(const Drawing& drawing, double scale, const PaperSize& paper);

/// The same on as many sheets of that paper as it takes, row by row from the upper left: each has what its
/// frame shows.
std::vector<Sheet> sheetsOf(const Drawing& drawing, const SheetOptions& options, const PaperSize& paper);

} // namespace rtcore
