// Drawings on paper: to scale, on sheets, and in files that are whole.
#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace {

using namespace rtcore;

/// A wall of 40 m, and a line of 3 m that is seen; far from zero.
Drawing wall() {
    Drawing drawing;
    drawing.solids = {{{1000, 500}, {1040, 500}, {1040, 500.3}, {1000, 500.3}}};
    drawing.seen = {{{1000, 510}, {1003, 510}}};
    drawing.rooms = {{{{1000, 500.3}, {1040, 500.3}, {1040, 510}, {1000, 510}}, {}, 388, {1020, 505}}};
    drawing.low = {1000, 500};
    drawing.high = {1040, 510};
    drawing.north = 0.5;
    return drawing;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

const SheetLayer& layer(const Sheet& sheet, std::string_view name) {
    for (const SheetLayer& one : sheet.layers)
        if (one.name == name) return one;
    throw std::out_of_range(std::string(name));
}

TEST(Sheet, IsToScale) {
    const Sheet sheet = sheetOf(wall(), {.scale = 100, .title = ""});
    const FlatLoop& outline = layer(sheet, "cut").lines.at(0).points;
    EXPECT_NEAR(std::hypot(outline[1][0] - outline[0][0], outline[1][1] - outline[0][1]), 400, 1e-9);
    EXPECT_GT(outline[0][1], layer(sheet, "seen").lines.at(0).points[0][1]) << "up is up";
    EXPECT_NEAR(sheet.width, 420, 1e-9);
    EXPECT_EQ(layer(sheet, "rooms").texts.at(1).text, "388.00 m\u00B2");
    EXPECT_FALSE(sheet.margin.areas.empty());
}

TEST(Sheet, ScaleBarsHaveTheirLength) {
    for (const double scale : {1.0, 20.0, 100.0, 250.0, 5000.0}) {
        const Sheet sheet = sheetOf(wall(), {.scale = scale, .title = ""});
        const FlatLoop& bar = sheet.margin.lines.at(0).points;
        const std::string words = sheet.margin.texts.at(1).text;
        EXPECT_NEAR((bar[1][0] - bar[0][0]) * scale / 1000, std::stod(words), 1e-9 * scale) << words;
        EXPECT_GT(bar[1][0] - bar[0][0], 20);
        EXPECT_LE(bar[1][0] - bar[0][0], 60);
    }
}

// 400 mm wide: two sheets of A4, whose frames are 277 mm wide, side by side.
TEST(Sheet, GoOnOnTheNext) {
    const PaperSize a4 = kPaperSizes[0];
    EXPECT_EQ(numberOfSheets(wall(), 100, a4), 2);
    const std::vector<Sheet> sheets = sheetsOf(wall(), {.scale = 100, .title = ""}, a4);
    ASSERT_EQ(sheets.size(), 2U);
    const double first = layer(sheets[0], "cut").lines.at(0).points[1][0];
    EXPECT_NEAR(first - layer(sheets[1], "cut").lines.at(0).points[1][0], 277, 1e-9);
    EXPECT_TRUE(layer(sheets[1], "seen").lines.empty()) << "it is on the first alone";
    EXPECT_EQ(numberOfSheets(wall(), 1, a4), 145 * 58);
}

TEST(Svg, HasMillimetresAndIsEscaped) {
    const std::string svg = svgOf(sheetOf(wall(), {.scale = 100, .title = "a<b>&\"c\"\n"}));
    EXPECT_NE(svg.find("width=\"420.00000mm\""), std::string::npos);
    EXPECT_NE(svg.find("a&lt;b>&amp;\"c\" 1:100"), std::string::npos) << svg;
    EXPECT_EQ(count(svg, "<g "), count(svg, "</g>"));
    EXPECT_NE(svg.find("inkscape:label=\"seen\""), std::string::npos);
}

TEST(Dxf, HasMetresOfTheFile) {
    const std::string dxf = dxfOf(wall());
    EXPECT_NE(dxf.find(" 10\n1040.000000000\n 20\n500.300000000\n"), std::string::npos);
    EXPECT_EQ(count(dxf, "\nVERTEX\n"), 4U);
    EXPECT_EQ(count(dxf, "\nLINE\n"), 1U);
    EXPECT_NE(dxf.find("1: 388.00 m2"), std::string::npos);
    EXPECT_EQ(dxf.substr(dxf.size() - 8), "  0\nEOF\n");
}

TEST(Pdf, HasAPageForEachSheet) {
    const std::string one = pdfOf({sheetOf(wall(), {.scale = 100, .title = "Z\u00FCrich \u4E2D"})});
    EXPECT_EQ(one.substr(0, 5), "%PDF-");
    EXPECT_EQ(count(one, "/Type /Page\n"), 1U);
    const std::string two = pdfOf(sheetsOf(wall(), {.scale = 100, .title = ""}, kPaperSizes[0]));
    EXPECT_EQ(count(two, "/Type /Page\n"), 2U);
    EXPECT_THROW(pdfOf({sheetOf(wall(), {.scale = 1, .title = ""})}), Refusal) << "40 m of paper";
}

TEST(DrawingFile, RefusesWhatCannotBe) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(writeDrawing(folder / "a.txt", wall(), {}, {}), Refusal);
    EXPECT_THROW(writeDrawing(folder / "a.svg", wall(), {}, kPaperSizes[0]), Refusal) << "two sheets";
    EXPECT_THROW(writeDrawing(folder / "a.pdf", wall(), {.scale = 1, .title = ""}, kPaperSizes[0]), Refusal);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    writeDrawing(folder / "a.SVG", wall(), {}, kPaperSizes[1]);
    EXPECT_EQ(readTextFile(folder / "a.SVG").substr(0, 5), "<?xml");
}

} // namespace
