#include "rtcore/post/legend.h"

#include "rtcore/lettering/stroke_text.h"
#include "rtcore/post/quick_log.h"
#include "rtcore/post/value_colours.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rtcore {

namespace {

/// Pixels of a whole image, of which `scale` times as many are in the one at hand.
struct LegendLayout {
    float scale, letters;
    float bar, gap, tick;

    LegendLayout(int wholeHeight, const LdrImage& image)
        : scale(static_cast<float>(image.height) / static_cast<float>(wholeHeight)),
          letters(std::clamp(static_cast<float>(wholeHeight) / 48, 8.0F, 40.0F) * scale), bar(1.4F * letters),
          gap(0.6F * letters), tick(0.4F * letters) {}
};

std::string legendText(float value) { return fmt::format("{:g}", value); }

struct PixelBox {
    float left, top, right, bottom;
};

/// Whole pixels alone: the rectangle is rounded to them.
template <typename Paint>
void fillArea(LdrImage& image, const PixelBox& area, Paint&& paint) {
    const auto bounded = [](float value, int size) {
        return static_cast<int>(std::clamp(std::floor(value + 0.5F), 0.0F, static_cast<float>(size)));
    };
    for (int y = bounded(area.top, image.height); y < bounded(area.bottom, image.height); ++y) {
        for (int x = bounded(area.left, image.width); x < bounded(area.right, image.width); ++x)
            paint(image.at(x, y), static_cast<float>(y) + 0.5F);
    }
}

void darken(Rgba8& pixel) {
    const auto quarter = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel / 4); };
    pixel = {quarter(pixel.r), quarter(pixel.g), quarter(pixel.b), pixel.a};
}

} // namespace

void paintLegend(const FalseColours& how, int height, LdrImage& image) {
    constexpr int kMinWidth = 120, kMinHeight = 90;
    if (!how.legend || image.empty() || height < kMinHeight) return;
    if (static_cast<long>(image.width) * height < static_cast<long>(kMinWidth) * image.height) return;
    const LegendLayout at(height, image);
    const StrokeStyle style{.height = at.letters, .weight = std::max(at.letters / 8, 0.5F)};
    const bool lux = how.quantity == LightQuantity::Illuminance;
    const std::string unit = !how.unit.absolute ? "relative" : lux ? "lux" : "cd/m^2";
    const std::string name = lux ? "illuminance" : "";
    const std::vector<float> values = isovalues(how.scale);
    float texts = 0;
    for (const float value : values) texts = std::max(texts, strokeTextWidth(legendText(value), style));
    const float inner = std::max({texts + at.tick + at.gap / 2 + at.bar, strokeTextWidth(unit, style),
                                  lux ? strokeTextWidth(name, style) : 0.0F});

    const float left = 2 * at.gap, middle = static_cast<float>(image.height) / 2;
    const float barTop = middle - 0.3F * static_cast<float>(image.height), barBottom = 2 * middle - barTop;
    const float title = barTop - 1.2F * at.letters;
    const float top = lux ? title - 1.6F * at.letters : title;
    fillArea(image, {left - at.gap, top - at.letters - at.gap, left + inner + at.gap, barBottom + at.letters},
             [](Rgba8& pixel, float) { darken(pixel); });
    if (lux) strokeText(image, name, style, left, top);
    strokeText(image, unit, style, left, title);

    const float right = left + at.bar;
    fillArea(image, {left, barTop, right, barBottom}, [&](Rgba8& pixel, float y) {
        const Rgba8 colour = valueColour((barBottom - y) / (barBottom - barTop));
        pixel = {colour.r, colour.g, colour.b, pixel.a};
    });
    const float range = quickLog2(how.scale.to / how.scale.from);
    for (const float value : values) {
        const float y = barBottom - (barBottom - barTop) * quickLog2(value / how.scale.from) / range;
        fillArea(image, {right, y - style.weight / 2, right + at.tick, y + style.weight / 2},
                 [&](Rgba8& pixel, float) {
                     pixel = {255, 255, 255, pixel.a};
                 });
        strokeText(image, legendText(value), style, right + at.tick + at.gap / 2, y + at.letters / 2);
    }
}

} // namespace rtcore
