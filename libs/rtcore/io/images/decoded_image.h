/// The result of a decoder: pixels in the depth in which the file holds them.
#pragma once

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/image.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rtcore {

using Bytes = std::vector<std::byte>;
using ByteSpan = std::span<const std::byte>;

/// Sixteen bits a channel, colour encoded as sRGB.
struct Rgba16 {
    std::uint16_t r = 0, g = 0, b = 0, a = 65535;
};
static_assert(sizeof(Rgba16) == 8);
using DeepImage = Image<Rgba16>;

using DecodedImage = std::variant<LdrImage, DeepImage, HdrImage>;

LdrImage toLdr(DecodedImage image);
HdrImage toHdr(DecodedImage image);

/// True when a pixel is not opaque, so that alpha is worth writing.
bool hasAlpha(const LdrImage& image);
/// Some programs leave the fourth byte 0 throughout: such an image is opaque.
void makeOpaqueIfAllClear(LdrImage& image);

/// Throws FileError BadData.
[[noreturn]] void badImage(const std::string& name, const Sentence& message);
/// Throws FileError CannotWrite.
[[noreturn]] void cannotEncode(const std::string& name, const Sentence& message);
/// Throws FileError BadData unless an image of that size is acceptable.
void checkImageSize(const std::string& name, std::int64_t width, std::int64_t height);
/// Throws FileError BadData when `pixels` cannot come out of `bytes`: a header that lies.
void checkPlausible(const std::string& name, std::size_t pixels, std::size_t bytes,
                    std::size_t maxPixelsPerByte);

} // namespace rtcore
