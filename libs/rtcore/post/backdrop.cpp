#include "rtcore/post/backdrop.h"

#include "rtcore/math/colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace rtcore {

namespace {

constexpr std::uint8_t kLight = 204, kDark = 153;
constexpr int kChequer = 8; ///< pixels a side

const std::array<float, 256>& decoded() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = srgbDecode(static_cast<float>(i) / 255);
        return values;
    }();
    return table;
}

std::uint8_t mixed(std::uint8_t before, std::uint8_t behind, float alpha) {
    const float light = decoded()[before] * alpha + decoded()[behind] * (1 - alpha);
    return static_cast<std::uint8_t>(std::lround(255 * srgbEncode(light)));
}

std::uint8_t between(std::uint8_t top, std::uint8_t bottom, float t) {
    return static_cast<std::uint8_t>(
        std::lround(static_cast<float>(top) * (1 - t) + static_cast<float>(bottom) * t));
}

std::optional<Rgba8> parseColour(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data() + 1, end, number, 16);
    if (error != std::errc() || stopped != end) return std::nullopt;
    const auto channel = [number](int shift) { return static_cast<std::uint8_t>(number >> shift); };
    return Rgba8{channel(16), channel(8), channel(0)};
}

/// The pixels of an image that one of another scale has its pixel `i` of, along one axis.
struct Span {
    int first, last; ///< last - first >= 1
};
Span spanOf(int i, double scale, double start, int size) {
    const double from = start + i * scale, to = start + (i + 1) * scale;
    const int first = std::clamp(static_cast<int>(from), 0, size - 1);
    return {first, std::clamp(static_cast<int>(std::ceil(to)), first + 1, size)};
}

/// The mean light of a rectangle.
Rgba8 meanOf(const LdrImage& image, const Span& columns, const Span& rows) {
    Colour sum;
    for (int y = rows.first; y < rows.last; ++y) {
        for (int x = columns.first; x < columns.last; ++x) {
            const Rgba8 pixel = image.at(x, y);
            sum += {decoded()[pixel.r], decoded()[pixel.g], decoded()[pixel.b]};
        }
    }
    const auto count = static_cast<float>((columns.last - columns.first) * (rows.last - rows.first));
    const auto encoded = [count](float channel) {
        return static_cast<std::uint8_t>(std::lround(255 * srgbEncode(channel / count)));
    };
    return {encoded(sum.r), encoded(sum.g), encoded(sum.b)};
}

} // namespace

Backdrop Backdrop::chequers() {
    Backdrop made({kLight, kLight, kLight}, {kDark, kDark, kDark});
    made.chequered_ = true;
    return made;
}

void Backdrop::paintBehind(LdrImage& image) {
    if (!image_.empty() && (scaled_.width != image.width || scaled_.height != image.height))
        scaleTo(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        fillRow(y, image.width, image.height);
        for (int x = 0; x < image.width; ++x) {
            Rgba8& pixel = image.at(x, y);
            const Rgba8 behind = row_[static_cast<std::size_t>(x)];
            const float alpha = static_cast<float>(pixel.a) / 255;
            if (pixel.a < 255)
                pixel = {mixed(pixel.r, behind.r, alpha), mixed(pixel.g, behind.g, alpha),
                         mixed(pixel.b, behind.b, alpha)};
        }
    }
}

void Backdrop::fillRow(int y, int width, int height) {
    row_.resize(static_cast<std::size_t>(width));
    if (!image_.empty()) {
        for (int x = 0; x < width; ++x) row_[static_cast<std::size_t>(x)] = scaled_.at(x, y);
        return;
    }
    const float t = height > 1 ? static_cast<float>(y) / static_cast<float>(height - 1) : 0;
    const Rgba8 colour{between(top_.r, bottom_.r, t), between(top_.g, bottom_.g, t),
                       between(top_.b, bottom_.b, t)};
    for (int x = 0; x < width; ++x) {
        const bool odd = ((x / kChequer + y / kChequer) & 1) != 0;
        row_[static_cast<std::size_t>(x)] = !chequered_ ? colour : odd ? bottom_ : top_;
    }
}

void Backdrop::scaleTo(int width, int height) {
    const double scale =
        std::min(static_cast<double>(image_.width) / width, static_cast<double>(image_.height) / height);
    const double left = (image_.width - scale * width) / 2, top = (image_.height - scale * height) / 2;
    scaled_ = LdrImage(width, height);
    for (int y = 0; y < height; ++y) {
        const Span rows = spanOf(y, scale, top, image_.height);
        for (int x = 0; x < width; ++x)
            scaled_.at(x, y) = meanOf(image_, spanOf(x, scale, left, image_.width), rows);
    }
}

std::optional<Backdrop> parseBackdropColours(std::string_view text) {
    const std::size_t comma = text.find(',');
    const auto top = parseColour(text.substr(0, comma));
    const auto bottom = comma == std::string_view::npos ? top : parseColour(text.substr(comma + 1));
    if (!top || !bottom) return std::nullopt;
    return Backdrop(*top, *bottom);
}

} // namespace rtcore
