// Portable float map: a text header, then rows of floats from the bottom; a negative scale means little
// endian.
#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

#include <fmt/core.h>

#include <bit>
#include <cstdio>

namespace rtcore {
namespace {

float toFloat(ByteSpan p, bool littleEndian) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        bits = bits << 8U | std::to_integer<std::uint32_t>(p[littleEndian ? 3 - i : i]);
    }
    return std::bit_cast<float>(bits);
}

void appendFloat(Bytes& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    append16(bytes, bits & 0xffffU);
    append16(bytes, bits >> 16U);
}

} // namespace

DecodedImage decodePfm(ByteSpan bytes, const std::string& name) {
    ByteReader in(bytes, name);
    const bool colour = in.line(8).rfind("PF", 0) == 0;
    int width = 0, height = 0;
    float scale = 0;
    if (std::sscanf(in.line(64).c_str(), "%9d %9d", &width, &height) != 2 ||
        std::sscanf(in.line(64).c_str(), "%f", &scale) != 1) {
        badImage(name, "damaged PFM: its header has lines for the kind, the size and the byte order");
    }
    checkImageSize(name, width, height);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (in.remaining() / (colour ? 12 : 4) < pixels) in.tooShort();
    HdrImage image(width, height);
    const bool littleEndian = scale < 0;
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            Colour& c = image.at(x, y);
            c.r = c.g = c.b = toFloat(in.take(4), littleEndian);
            if (!colour) continue;
            c.g = toFloat(in.take(4), littleEndian);
            c.b = toFloat(in.take(4), littleEndian);
        }
    }
    return image;
}

Bytes encodePfm(const HdrImage& image, const std::string& /*name*/) {
    Bytes bytes;
    bytes.reserve(image.pixels.size() * 12 + 64);
    append(bytes, fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height));
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x) {
            const Colour c = image.at(x, y);
            appendFloat(bytes, c.r);
            appendFloat(bytes, c.g);
            appendFloat(bytes, c.b);
        }
    }
    return bytes;
}

} // namespace rtcore
