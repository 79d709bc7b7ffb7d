// Luminance as colours: their scale, isolines and legend.
#include "rtcore/post/false_colours.h"

#include "rtcore/post/develop.h"
#include "rtcore/post/legend.h"
#include "rtcore/post/value_colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtcore {
namespace {

RenderSettings shownFalse(float from = 0, float to = 0) {
    RenderSettings settings;
    settings.falseColours = {.on = true, .from = from, .to = to, .isolines = true, .legend = false};
    return settings;
}

Frame frameOf(int width, int height, auto&& radianceAt) {
    Frame frame;
    frame.radiance = HdrImage(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) frame.radiance.at(x, y) = radianceAt(x, y);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    return frame;
}

struct Shown {
    LdrImage image;
    FalseColours how;
};

Shown show(const Frame& frame, const RenderSettings& settings, const LuminanceUnit& unit = {},
           int threads = 1) {
    PictureDeveloper developer;
    developer.useUnit(unit);
    Shown shown;
    developer.develop(frame, settings, 1, threads, shown.image);
    shown.how = *developer.falseColours();
    return shown;
}

/// CIE lightness, 0..100.
double lightness(Rgba8 colour) {
    const auto linear = [](std::uint8_t code) {
        const double c = code / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

TEST(ValueColours, GetLighterInEqualSteps) {
    EXPECT_EQ(valueColour(0), (Rgba8{0x44, 0x01, 0x54, 255}));
    EXPECT_EQ(valueColour(1), (Rgba8{0xFD, 0xE7, 0x25, 255}));
    EXPECT_EQ(valueColour(-3), valueColour(0));
    EXPECT_EQ(valueColour(7), valueColour(1));
    EXPECT_EQ(valueColour(std::nanf("")), valueColour(0));
    const double first = lightness(valueColour(0)), last = lightness(valueColour(1));
    for (int i = 1; i <= 20; ++i) {
        const float value = static_cast<float>(i) / 20;
        EXPECT_GT(lightness(valueColour(value)), lightness(valueColour(value - 0.05F)) + 2) << value;
        EXPECT_NEAR(lightness(valueColour(value)), first + (last - first) * double{value}, 3) << value;
    }
}

TEST(ValueScale, RoundNumbersAreOneTwoAndFive) {
    EXPECT_FLOAT_EQ(roundValue(1, true), 1);
    EXPECT_FLOAT_EQ(roundValue(1, false), 1);
    EXPECT_FLOAT_EQ(roundValue(1.01F, true), 2);
    EXPECT_FLOAT_EQ(roundValue(4.9F, false), 2);
    EXPECT_FLOAT_EQ(roundValue(0.03F, true), 0.05F);
    EXPECT_FLOAT_EQ(roundValue(999, true), 1000);
    EXPECT_FLOAT_EQ(roundValue(1000, false), 1000);
    EXPECT_EQ(roundValues({1, 100}, 13), (std::vector<float>{1, 2, 5, 10, 20, 50, 100}));
    EXPECT_EQ(roundValues({0.3F, 4}, 13), (std::vector<float>{0.5F, 1, 2}));
    EXPECT_EQ(roundValues({1, 1e5F}, 13), (std::vector<float>{1, 10, 100, 1000, 1e4F, 1e5F}));
    EXPECT_LE(roundValues({1e-30F, 1e30F}, 13).size(), 13U);
    EXPECT_GE(roundValues({1e-30F, 1e30F}, 13).size(), 5U);
}

ValueScale chosen(const Frame& frame, const FalseColourSettings& settings = {},
                  const LuminanceUnit& unit = {}) {
    return ScaleChoice().choose(frame.radiance, settings, unit, false);
}

TEST(ValueScale, SuitsTheImage) {
    const Frame two = frameOf(100, 100, [](int x, int) { return kWhite * (x < 50 ? 3.0F : 700.0F); });
    EXPECT_EQ(chosen(two), (ValueScale{2, 1000}));
    EXPECT_EQ(chosen(two, {}, {.ofOne = 10}), (ValueScale{20, 10000}));
    const Frame one = frameOf(100, 100, [](int, int) { return kWhite * 120.0F; });
    EXPECT_EQ(chosen(one), (ValueScale{50, 500})) << "at least a power of ten";
    const Frame spot = frameOf(100, 100, [](int x, int y) {
        return x == 50 && y < 20 ? kWhite * 1e9F : x == 3 && y < 20 ? Colour{} : kWhite * (3.0F + float(x));
    });
    EXPECT_EQ(chosen(spot), (ValueScale{2, 200})) << "few bright pixels, and black, do not count";
    const Frame wide = frameOf(100, 100, [](int x, int) { return kWhite * (x < 50 ? 1e-9F : 700.0F); });
    EXPECT_EQ(chosen(wide), (ValueScale{0.1F, 1000})) << "at most four powers of ten";
    const Frame black = frameOf(8, 8, [](int, int) { return Colour{}; });
    EXPECT_EQ(chosen(black), (ValueScale{1, 10}));
    const Frame nothing = frameOf(8, 8, [](int, int) { return kWhite * std::nanf(""); });
    EXPECT_EQ(chosen(nothing), (ValueScale{1, 10}));
}

TEST(ValueScale, HasTheEndsThatAreGiven) {
    const Frame two = frameOf(100, 100, [](int x, int) { return kWhite * (x < 50 ? 3.0F : 700.0F); });
    EXPECT_EQ(chosen(two, {.from = 7, .to = 40}), (ValueScale{7, 40}));
    EXPECT_EQ(chosen(two, {.from = 7}), (ValueScale{7, 1000}));
    EXPECT_EQ(chosen(two, {.to = 300}), (ValueScale{2, 300}));
    EXPECT_EQ(chosen(two, {.from = 5000}), (ValueScale{5000, 50000}));
    EXPECT_EQ(chosen(two, {.from = 40, .to = 7}), (ValueScale{2, 1000})) << "ends that contradict each other";
}

TEST(ValueScale, StaysWhileItSuitsRoughly) {
    ScaleChoice choice;
    const auto at = [&](float low, float high, bool hold) {
        const Frame frame = frameOf(10, 10, [&](int x, int) { return kWhite * (x < 5 ? low : high); });
        return choice.choose(frame.radiance, {}, {}, hold);
    };
    const ValueScale first = at(3, 700, true);
    EXPECT_EQ(first, (ValueScale{2, 1000}));
    EXPECT_EQ(at(1.9F, 1050, true), first) << "hardly beyond";
    EXPECT_EQ(at(6, 300, true), first) << "narrower";
    EXPECT_EQ(at(6, 300, false), (ValueScale{5, 500}));
    EXPECT_EQ(at(6, 30000, true), (ValueScale{5, 50000}));
    EXPECT_EQ(at(0.06F, 5, true), (ValueScale{0.05F, 5}));
}

TEST(FalseColours, OfAnEvenImageAreTheColourOfItsLuminance) {
    for (const float candela : {1.0F, 5.0F, 10.0F, 42.0F, 100.0F, 3000.0F, 0.01F}) {
        const LuminanceUnit unit{.ofOne = 683, .absolute = true};
        const Colour light{candela / 683, candela / 683, candela / 683};
        const Shown shown = show(frameOf(20, 30, [&](int, int) { return light; }), shownFalse(1, 1000), unit);
        const float value = std::log10(candela) / 3;
        for (const Rgba8& pixel : shown.image.pixels) {
            ASSERT_NEAR(pixel.r, valueColour(value).r, 1) << candela;
            ASSERT_NEAR(pixel.g, valueColour(value).g, 1) << candela;
            ASSERT_NEAR(pixel.b, valueColour(value).b, 1) << candela;
        }
    }
}

/// A line: colours that the scale has not.
bool isLine(const Shown& shown, float candela, int x, int y) {
    const float value =
        std::log2(candela / shown.how.scale.from) / std::log2(shown.how.scale.to / shown.how.scale.from);
    const Rgba8 plain = valueColour(value), pixel = shown.image.at(x, y);
    return std::abs(pixel.r - plain.r) + std::abs(pixel.g - plain.g) + std::abs(pixel.b - plain.b) > 60;
}

TEST(FalseColours, IsolinesLieWhereARampHasTheirValues) {
    constexpr int kRampWidth = 400, kRampHeight = 40;
    // From 1 to 1000 along a slanted direction.
    const auto logarithm = [](double x, double y) {
        return 3 * (x + 0.5 * y) / (kRampWidth + 0.5 * kRampHeight);
    };
    const auto candela = [&](int x, int y) {
        return static_cast<float>(std::pow(10, logarithm(x + 0.5, y + 0.5)));
    };
    const Shown shown =
        show(frameOf(kRampWidth, kRampHeight, [&](int x, int y) { return kWhite * candela(x, y); }),
             shownFalse(1, 1000));
    for (int y = 1; y < kRampHeight - 1; ++y) {
        int lines = 0;
        for (const float value : isovalues(shown.how.scale)) {
            const double across =
                std::log10(double{value}) * (kRampWidth + 0.5 * kRampHeight) / 3 - 0.5 * (y + 0.5);
            const int x = static_cast<int>(std::floor(across));
            if (x < 3 || x >= kRampWidth - 3) continue;
            ++lines;
            EXPECT_TRUE(isLine(shown, candela(x, y), x, y)) << value << " in row " << y;
            EXPECT_FALSE(isLine(shown, candela(x - 3, y), x - 3, y)) << value << " in row " << y;
            EXPECT_FALSE(isLine(shown, candela(x + 3, y), x + 3, y)) << value << " in row " << y;
        }
        EXPECT_GE(lines, 7);
    }
}

TEST(FalseColours, HaveNoIsolinesBesideTheirValuesOrWhereTheyAreOff) {
    const Frame between = frameOf(200, 20, [](int x, int) { return kWhite * (2.1F + 0.01F * float(x)); });
    for (int x = 0; x < 200; ++x)
        EXPECT_FALSE(isLine(show(between, shownFalse(1, 10)), 2.1F + 0.01F * float(x), x, 10)) << x;
    RenderSettings without = shownFalse(1, 1000);
    without.falseColours.isolines = false;
    const auto ramp = [](int x, int) { return kWhite * std::pow(10.0F, 0.01F * float(x)); };
    const Shown plain = show(frameOf(300, 9, ramp), without);
    for (int x = 0; x < 300; ++x) EXPECT_FALSE(isLine(plain, ramp(x, 0).r, x, 4)) << x;
}

TEST(FalseColours, HaveNoBunchOfIsolinesAtAnEdge) {
    const Frame edge = frameOf(60, 60, [](int x, int) { return kWhite * (x < 30 ? 1.3F : 700.0F); });
    const Shown shown = show(edge, shownFalse(1, 1000));
    for (int x = 0; x < 60; ++x) EXPECT_FALSE(isLine(shown, x < 30 ? 1.3F : 700.0F, x, 30)) << x;
}

RenderSettings illuminance(float from = 0, float to = 0) {
    RenderSettings settings = shownFalse(from, to);
    settings.falseColours.quantity = LightQuantity::Illuminance;
    return settings;
}

TEST(FalseColours, OfIlluminanceShowPiTimesTheLuminanceOfWhitePaper) {
    const LuminanceUnit unit{.ofOne = 683, .absolute = true};
    const Frame even = frameOf(20, 30, [](int, int) { return kWhite * 2.0F; });
    const Shown shown = show(even, illuminance(1000, 10000), unit);
    const Rgba8 expected = valueColour(std::log10(2 * 683 * 3.14159265F / 1000));
    for (const Rgba8& pixel : shown.image.pixels) {
        ASSERT_NEAR(pixel.r, expected.r, 1);
        ASSERT_NEAR(pixel.g, expected.g, 1);
        ASSERT_NEAR(pixel.b, expected.b, 1);
    }
    EXPECT_EQ(show(even, illuminance(), unit).how.scale, (ValueScale{1000, 10000})) << "4291 lx";
    EXPECT_EQ(show(even, shownFalse(), unit).how.scale, (ValueScale{500, 5000})) << "1366 cd/m2";
}

// Denoising has spread light to the right, where no surface is.
TEST(FalseColours, OfIlluminanceAreGreyWithoutLinesWhereNoSurfaceIs) {
    const auto ramp = [](int x, int y) {
        return kWhite * (x < 52 ? std::pow(10.0F, 0.03F * float(y)) : 50.0F);
    };
    Frame half = frameOf(100, 100, ramp);
    for (std::size_t i = 0; i < half.covered.size(); ++i) half.covered[i] = i % 100 < 50 ? 255 : 0;
    Frame all = half;
    all.covered.assign(all.covered.size(), 255);
    const Shown shown = show(half, illuminance(1, 10000)), whole = show(all, illuminance(1, 10000));
    for (int y = 0; y < 100; ++y) {
        for (int x = 50; x < 100; ++x) ASSERT_EQ(shown.image.at(x, y), kNoValue) << x << " " << y;
        for (int x = 0; x < 46; ++x) ASSERT_EQ(shown.image.at(x, y), whole.image.at(x, y)) << x << " " << y;
    }
    const auto grey = [](const Rgba8& pixel) { return pixel == kNoValue; };
    EXPECT_EQ(std::ranges::count_if(whole.image.pixels, grey), 0);
    const Frame black = frameOf(9, 9, [](int, int) { return Colour{}; });
    const Shown dark = show(black, illuminance());
    EXPECT_EQ(dark.image.at(4, 4), valueColour(0)) << "a surface without light";
    LdrImage part(9, 9);
    Development how;
    how.falseColours = &dark.how;
    developPart(black.radiance, how, {}, {0, 0, 9, 9}, part);
    EXPECT_EQ(std::ranges::count_if(part.pixels, grey), 81) << "of an image that is under way";
    how.falseColours = nullptr;
    Frame none = black;
    none.covered.assign(81, 0);
    EXPECT_EQ(std::ranges::count_if(show(none, shownFalse()).image.pixels, grey), 0) << "of luminance";
}

Frame varied() {
    return frameOf(333, 211, [](int x, int y) {
        return Colour{1 + std::abs(float(x % 97) - 40), 0.3F * float(y), 0.01F * float(x) * float(y)};
    });
}

TEST(FalseColours, AreTheSameForAnyNumberOfThreadsAndInParts) {
    const Frame frame = varied();
    const Shown one = show(frame, shownFalse());
    for (const int threads : {2, 3, 7}) {
        EXPECT_EQ(show(frame, shownFalse(), {}, threads).image.pixels, one.image.pixels) << threads;
    }
    LdrImage whole(333, 211);
    Development how;
    how.falseColours = &one.how;
    developPart(frame.radiance, how, {}, {0, 0, 333, 211}, whole);
    EXPECT_EQ(whole.pixels, one.image.pixels);
    // Without lines each pixel depends on itself alone.
    RenderSettings noLines = shownFalse();
    noLines.falseColours.isolines = false;
    const Shown plain = show(frame, noLines);
    how.falseColours = &plain.how;
    LdrImage parts(333, 211);
    for (int x = 0; x < 333; x += 50)
        for (int y = 0; y < 211; y += 40)
            developPart(frame.radiance, how, {}, {x, y, std::min(50, 333 - x), std::min(40, 211 - y)}, parts);
    EXPECT_EQ(parts.pixels, plain.image.pixels);
}

TEST(FalseColours, StandInPlaceOfBloomAndExposure) {
    const Frame frame = varied();
    RenderSettings all = shownFalse();
    all.bloom.radius = 9;
    all.exposure.local = 1;
    all.toneMapping = ToneMapping::AgX;
    EXPECT_EQ(show(frame, all).image.pixels, show(frame, shownFalse()).image.pixels);
    PictureDeveloper developer;
    LdrImage before, image;
    RenderSettings off = all;
    off.falseColours.on = false;
    developer.develop(frame, off, 1, 1, before);
    developer.develop(frame, all, 1, 1, image);
    EXPECT_NE(image.pixels, before.pixels);
    developer.develop(frame, off, 1, 1, image);
    EXPECT_EQ(image.pixels, before.pixels);
    EXPECT_EQ(developer.falseColours(), nullptr);
}

TEST(Legend, ShowsTheColoursFromDarkBelowToBrightAbove) {
    LdrImage image(640, 480);
    paintLegend({.scale = {1, 100}, .unit = {.absolute = true}}, 480, image);
    double last = -1;
    int found = 0;
    for (int y = 479; y >= 0; --y) {
        // The bar is all that has colours.
        for (int x = 0; x < 140; ++x) {
            const Rgba8 pixel = image.at(x, y);
            if (pixel.r == pixel.g && pixel.g == pixel.b) continue;
            EXPECT_GE(lightness(pixel), last - 0.5) << y;
            last = lightness(pixel);
            ++found;
            break;
        }
    }
    EXPECT_GT(found, 200);
    EXPECT_EQ(image.at(400, 100), LdrImage(1, 1).at(0, 0)) << "all else stays as it is";
}

TEST(Legend, TellsTheUnitAndTheNumbers) {
    const auto legend = [](const FalseColours& how) {
        LdrImage image(640, 480);
        paintLegend(how, 480, image);
        return image.pixels;
    };
    const auto absolute = legend({.scale = {1, 100}, .unit = {.absolute = true}});
    EXPECT_NE(absolute, legend({.scale = {1, 100}, .unit = {}}));
    EXPECT_NE(absolute, legend({.scale = {2, 200}, .unit = {.absolute = true}}));
    const FalseColours lux{
        .scale = {1, 100}, .quantity = LightQuantity::Illuminance, .unit = {.absolute = true}};
    EXPECT_NE(absolute, legend(lux));
    FalseColours relative = lux;
    relative.unit.absolute = false;
    EXPECT_NE(legend(lux), legend(relative));
    EXPECT_NE(legend({.scale = {1, 100}, .unit = {}}), legend(relative)) << "which names the quantity";
    EXPECT_EQ(legend({.scale = {1, 100}, .unit = {}, .legend = false}), LdrImage(640, 480).pixels);
}

TEST(Legend, OfSmallImagesIsAsLargeAsThatOfTheWholeOne) {
    LdrImage small(320, 240), tiny(64, 48);
    paintLegend({.scale = {1, 100}, .unit = {}}, 480, small);
    EXPECT_NE(small.pixels, LdrImage(320, 240).pixels);
    paintLegend({.scale = {1, 100}, .unit = {}}, 48, tiny);
    EXPECT_EQ(tiny.pixels, LdrImage(64, 48).pixels) << "there is no room for it";
}

} // namespace
} // namespace rtcore
