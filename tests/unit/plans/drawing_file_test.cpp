// Drawings on paper: to scale, on sheets, and in files that are whole.
#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
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

bool isDark(Rgba8 pixel) { return pixel.r < 100; }

/// From the first dark pixel of the row to the last, both counted.
int darkPixels(const LdrImage& image, int row) {
    int first = image.width, last = -1;
    for (int x = 0; x < image.width; ++x) {
        if (!isDark(image.at(x, row))) continue;
        first = std::min(first, x);
        last = x;
    }
    return last - first + 1;
}

constexpr double kMillimetre = 300 / 25.4; // pixels

TEST(SheetImage, HasTheLengthsOfThePaper) {
    const Sheet sheet = sheetOf(wall(), {.scale = 100, .title = "wall "});
    const LdrImage image = sheetImage(sheet, 300, nullptr);
    EXPECT_EQ(image.width, std::lround(420 * kMillimetre));
    const auto& outline = layer(sheet, "cut").lines.at(0);
    const int row = static_cast<int>(0.5 * (outline.points[0][1] + outline.points[2][1]) * kMillimetre);
    EXPECT_NEAR(darkPixels(image, row), (400 + outline.width) * kMillimetre, 1);
    EXPECT_EQ(image.at(image.width / 2, row).r, 191) << "what is cut is grey";
    EXPECT_EQ(image.at(3, 3), (Rgba8{255, 255, 255, 255}));
    const auto letters = [&](int x, int y) { return isDark(image.at(x, image.height - y)); };
    int dark = 0;
    for (int y = 60; y < 200; ++y)
        for (int x = 118; x < 400; ++x) dark += letters(x, y) ? 1 : 0;
    EXPECT_GT(dark, 100) << "the title";
}

TEST(SheetImage, LiesOverLight) {
    const Drawing drawing = wall();
    const Rgba8 red{200, 10, 20, 255};
    const LdrImage light(4725, 1182, red); // 400 x 100 mm
    const test::TemporaryFolder folder;
    DrawingOrder order{
        .drawing = drawing, .options = {.scale = 100, .title = {}}, .paper = {}, .light = &light};
    const auto darkOnes = [&](const char* name) {
        writeDrawing(folder / name, order);
        const LdrImage image = readLdrImage(folder / name);
        EXPECT_EQ(image.at(image.width / 2, 200), red);
        EXPECT_EQ(image.at(image.width / 2, 110), (Rgba8{255, 255, 255, 255}));
        return std::ranges::count_if(image.pixels, [](Rgba8 p) { return p.r < 100 && p.g < 5; });
    };
    const auto both = darkOnes("both.png");
    order.lines = false;
    const auto alone = darkOnes("alone.tif");
    EXPECT_GT(both - alone, 20000) << "the outline of the wall";
    EXPECT_GT(alone, 0) << "the scale bar";
}

TEST(SheetImage, OfSeveralSheetsIsSeveralFiles) {
    const test::TemporaryFolder folder;
    const Drawing drawing = wall();
    const DrawingOrder order{
        .drawing = drawing, .options = {.scale = 100, .title = {}, .dpi = 50}, .paper = kPaperSizes[0]};
    const auto files = drawingFiles(folder / "plan.png", order);
    EXPECT_EQ(files, (std::vector<std::filesystem::path>{folder / "plan-A1.png", folder / "plan-A2.png"}));
    writeDrawing(folder / "plan.png", order);
    for (const auto& file : files) EXPECT_EQ(readLdrImage(file).width, std::lround(297 * 50 / 25.4));
    EXPECT_FALSE(std::filesystem::exists(folder / "plan.png"));
}

TEST(DrawingFile, RefusesWhatCannotBe) {
    const test::TemporaryFolder folder;
    const Drawing drawing = wall();
    const auto write = [&](const char* name, double scale, std::optional<PaperSize> paper) {
        writeDrawing(folder / name,
                     {.drawing = drawing, .options = {.scale = scale, .title = {}}, .paper = paper});
    };
    EXPECT_THROW(write("a.txt", 100, {}), Refusal);
    EXPECT_THROW(write("a.svg", 100, kPaperSizes[0]), Refusal) << "two sheets";
    EXPECT_THROW(write("a.pdf", 1, kPaperSizes[0]), Refusal);
    EXPECT_THROW(write("a.png", 10, {}), Refusal) << "47,244 pixels";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    write("a.SVG", 100, kPaperSizes[1]);
    EXPECT_EQ(readTextFile(folder / "a.SVG").substr(0, 5), "<?xml");
}

} // namespace
