#include "rtcore/io/images/decoded_image.h"

#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtcore {
namespace {

constexpr float kLargestHalf = 65504;

/// sRGB to linear for every 16-bit value; 8-bit values are its every 257th.
const std::vector<float>& srgbTable() {
    static const std::vector<float> table = [] {
        std::vector<float> values(65536);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = srgbDecode(static_cast<float>(i) / 65535.0F);
        return values;
    }();
    return table;
}

std::uint8_t narrow(std::uint16_t v) { return static_cast<std::uint8_t>((v + 128U) / 257U); }

std::uint8_t quantise(float linear) {
    if (!(linear > 0)) return 0; // NaN, too
    return static_cast<std::uint8_t>(srgbEncode(std::min(linear, 1.0F)) * 255.0F + 0.5F);
}

float finite(float v) {
    if (std::isnan(v)) return 0;
    return std::isinf(v) ? std::copysign(kLargestHalf, v) : v;
}

template <typename To, typename From, typename Convert>
Image<To> convertPixels(const Image<From>& from, Convert convert) {
    Image<To> to(from.width, from.height);
    std::transform(from.pixels.begin(), from.pixels.end(), to.pixels.begin(), convert);
    return to;
}

LdrImage ldrOf(LdrImage&& image) { return std::move(image); }

LdrImage ldrOf(DeepImage&& image) {
    return convertPixels<Rgba8>(image, [](Rgba16 p) {
        return Rgba8{narrow(p.r), narrow(p.g), narrow(p.b), narrow(p.a)};
    });
}

LdrImage ldrOf(HdrImage&& image) {
    return convertPixels<Rgba8>(image, [](Colour c) {
        return Rgba8{quantise(c.r), quantise(c.g), quantise(c.b), 255};
    });
}

HdrImage hdrOf(LdrImage&& image) {
    const std::vector<float>& table = srgbTable();
    return convertPixels<Colour>(image, [&](Rgba8 p) {
        return Colour{table[p.r * 257U], table[p.g * 257U], table[p.b * 257U]};
    });
}

HdrImage hdrOf(DeepImage&& image) {
    const std::vector<float>& table = srgbTable();
    return convertPixels<Colour>(image, [&](Rgba16 p) { return Colour{table[p.r], table[p.g], table[p.b]}; });
}

HdrImage hdrOf(HdrImage&& image) {
    for (Colour& c : image.pixels) c = {finite(c.r), finite(c.g), finite(c.b)};
    return std::move(image);
}

} // namespace

LdrImage toLdr(DecodedImage image) {
    return std::visit([](auto& pixels) { return ldrOf(std::move(pixels)); }, image);
}

HdrImage toHdr(DecodedImage image) {
    return std::visit([](auto& pixels) { return hdrOf(std::move(pixels)); }, image);
}

bool hasAlpha(const LdrImage& image) {
    return std::any_of(image.pixels.begin(), image.pixels.end(), [](Rgba8 p) { return p.a != 255; });
}

void makeOpaqueIfAllClear(LdrImage& image) {
    const bool clear =
        std::all_of(image.pixels.begin(), image.pixels.end(), [](Rgba8 p) { return p.a == 0; });
    if (!clear) return;
    for (Rgba8& p : image.pixels) p.a = 255;
}

void badImage(const std::string& name, const Sentence& message) {
    throw FileError(FailureKind::BadData, name, message);
}

void cannotEncode(const std::string& name, const Sentence& message) {
    throw FileError(FailureKind::CannotWrite, name, message);
}

void checkImageSize(const std::string& name, std::int64_t width, std::int64_t height) {
    if (width < 1 || height < 1) badImage(name, say("the image is empty ({0} x {1} pixels)", width, height));
    if (width > kMaxImageSide || height > kMaxImageSide ||
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxImagePixels) {
        badImage(name,
                 say("the image is too large ({0} x {1} pixels); the most is {2} a side and {3} megapixels",
                     width, height, kMaxImageSide, kMaxImagePixels >> 20U));
    }
}

void checkPlausible(const std::string& name, std::size_t pixels, std::size_t bytes,
                    std::size_t maxPixelsPerByte) {
    if (pixels / maxPixelsPerByte > bytes) {
        badImage(name, say("the file is too short for the {0} pixels that its header names", pixels));
    }
}

} // namespace rtcore
