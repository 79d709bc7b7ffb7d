// Text of lines in images.
#include "rtcore/lettering/stroke_text.h"

#include "rtcore/lettering/stroke_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace rtcore {
namespace {

constexpr Rgba8 kBlack{0, 0, 0, 255};

LdrImage blank(int width, int height) {
    LdrImage image(width, height);
    std::ranges::fill(image.pixels, kBlack);
    return image;
}

/// '#' where a pixel is more than half white.
std::string pattern(std::string_view text, float height, int below = 0) {
    const StrokeStyle style{.height = height, .weight = 1};
    LdrImage image =
        blank(static_cast<int>(strokeTextWidth(text, style)) + 1, static_cast<int>(height) + 1 + below);
    strokeText(image, text, style, 0.5F, height + 0.5F);
    std::string rows;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) rows += image.at(x, y).r > 127 ? '#' : '.';
        rows += '\n';
    }
    return rows;
}

TEST(StrokeText, PaintsLettersOfStraightLinesPixelByPixel) {
    EXPECT_EQ(pattern("L", 6), "#....\n"
                               "#....\n"
                               "#....\n"
                               "#....\n"
                               "#....\n"
                               "#....\n"
                               "#####\n");
    EXPECT_EQ(pattern("-", 6), "....\n"
                               "....\n"
                               "....\n"
                               "####\n"
                               "....\n"
                               "....\n"
                               "....\n");
}

TEST(StrokeText, EachLetterIsLikeNoOther) {
    const std::string letters = "0123456789.,-+/:ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    const auto of = [](char letter) { return pattern(std::string(1, letter), 24, 8); };
    for (const char a : letters) {
        ASSERT_TRUE(glyphOf(a)) << a;
        for (const char b : letters) {
            if (a < b) {
                EXPECT_NE(of(a), of(b)) << a << b;
            }
        }
    }
    EXPECT_FALSE(glyphOf('\n'));
}

TEST(StrokeText, LettersKeepToTheirWidth) {
    for (int code = ' '; code <= 'z'; ++code) {
        const auto glyph = glyphOf(static_cast<char>(code));
        if (!glyph) continue;
        for (std::size_t i = 0; i < glyph->lines.size(); i += 2) {
            if (glyph->lines[i] == ' ') ++i;
            const char x = glyph->lines[i];
            EXPECT_LE(x <= '9' ? x - '0' : x - 'a' + 10, glyph->width) << glyph->letter;
        }
    }
}

TEST(StrokeText, IsAsWideAsItsLetters) {
    const StrokeStyle style{.height = 12};
    EXPECT_FLOAT_EQ(strokeTextWidth("", style), 0);
    EXPECT_FLOAT_EQ(strokeTextWidth("0", style), 8);
    EXPECT_FLOAT_EQ(strokeTextWidth("00", style), 20);
    EXPECT_FLOAT_EQ(strokeTextWidth("00", {.height = 24}), 40);
    EXPECT_LT(strokeTextWidth("m^2", style), strokeTextWidth("m2", style)) << "a raised letter is smaller";
    EXPECT_FLOAT_EQ(strokeTextWidth("\xC2", style), strokeTextWidth(" ", style))
        << "unknown letters are blanks";
}

TEST(StrokeText, LeavesOutWhatLiesOutsideAndAlphaAsItIs) {
    LdrImage image = blank(8, 8);
    for (Rgba8& pixel : image.pixels) pixel.a = 7;
    strokeText(image, "88888", {.height = 30, .weight = 3, .colour = {200, 100, 50, 255}}, -20, 12);
    strokeText(image, "8", {.height = 30}, 1e6F, -1e6F);
    for (const Rgba8& pixel : image.pixels) {
        EXPECT_EQ(pixel.a, 7);
        EXPECT_LE(pixel.r, 200);
    }
}

} // namespace
} // namespace rtcore
