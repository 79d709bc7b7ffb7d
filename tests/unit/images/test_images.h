/// Images and hand-made files for the tests of this room.
#pragma once

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace test {

using Bytes = std::vector<std::byte>;

inline rtcore::LdrImage noiseImage(int w, int h, bool alpha = false, unsigned seed = 1) {
    std::mt19937 random(seed);
    rtcore::LdrImage image(w, h);
    for (rtcore::Rgba8& p : image.pixels) {
        const auto v = static_cast<std::uint32_t>(random());
        p = {static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v >> 8),
             static_cast<std::uint8_t>(v >> 16),
             alpha ? static_cast<std::uint8_t>(v >> 24) : std::uint8_t{255}};
    }
    // Whatever the noise: at least one pixel that is not opaque and one that is.
    if (alpha) image.pixels.front().a = 17;
    if (alpha && image.pixels.size() > 1) image.pixels.back().a = 255;
    return image;
}

/// Smooth, so that lossy formats keep it, with equal neighbours for run lengths.
inline rtcore::LdrImage smoothImage(int w, int h) {
    rtcore::LdrImage image(w, h);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            image.at(x, y) = {static_cast<std::uint8_t>(x / 8 * 255 / w),
                              static_cast<std::uint8_t>(y * 255 / h), 77, 255};
        }
    }
    return image;
}

inline rtcore::HdrImage hdrNoise(int w, int h) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> exponent(-20, 20);
    rtcore::HdrImage image(w, h);
    for (rtcore::Colour& c : image.pixels) {
        c = {std::exp2(exponent(random)), std::exp2(exponent(random)), std::exp2(exponent(random))};
    }
    return image;
}

inline void saveBytes(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline Bytes loadBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

/// Builds a file from numbers and text.
class FileMaker {
  public:
    FileMaker& text(const std::string& s) {
        for (const char c : s) bytes.push_back(static_cast<std::byte>(c));
        return *this;
    }
    FileMaker& u8(std::initializer_list<unsigned> values) {
        for (const unsigned v : values) bytes.push_back(static_cast<std::byte>(v));
        return *this;
    }
    FileMaker& u16(std::initializer_list<unsigned> values) {
        for (const unsigned v : values) u8({v & 255U, v >> 8U & 255U});
        return *this;
    }
    FileMaker& u32(std::initializer_list<std::uint32_t> values) {
        for (const std::uint32_t v : values) u16({v & 0xffffU, v >> 16U});
        return *this;
    }
    FileMaker& big32(std::uint32_t v) { return u8({v >> 24U, v >> 16U & 255U, v >> 8U & 255U, v & 255U}); }
    FileMaker& add(const Bytes& more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
        return *this;
    }

    Bytes bytes;
};

/// A PNG without compression. `rows` has one filter byte (0) before each row.
class PngMaker {
  public:
    PngMaker(std::uint32_t width, std::uint32_t height, unsigned depth, unsigned colourType) {
        file_.u8({0x89}).text("PNG\r\n\x1a\n");
        chunk("IHDR", FileMaker().big32(width).big32(height).u8({depth, colourType, 0, 0, 0}).bytes);
    }
    PngMaker& chunk(const std::string& type, const Bytes& data) {
        const Bytes body = FileMaker().text(type).add(data).bytes;
        file_.big32(static_cast<std::uint32_t>(data.size())).add(body).big32(crc(body));
        return *this;
    }
    Bytes finish(const Bytes& rows) {
        const auto n = static_cast<unsigned>(rows.size());
        chunk("IDAT",
              FileMaker().u8({0x78, 0x01, 0x01}).u16({n, ~n & 0xffffU}).add(rows).big32(adler(rows)).bytes);
        chunk("IEND", {});
        return file_.bytes;
    }

  private:
    static std::uint32_t crc(const Bytes& bytes) {
        std::uint32_t c = 0xffffffffU;
        for (const std::byte b : bytes) {
            c ^= std::to_integer<std::uint32_t>(b);
            for (int i = 0; i < 8; ++i) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
        }
        return ~c;
    }
    static std::uint32_t adler(const Bytes& bytes) {
        std::uint32_t a = 1, b = 0;
        for (const std::byte x : bytes) {
            a = (a + std::to_integer<std::uint32_t>(x)) % 65521;
            b = (b + a) % 65521;
        }
        return b << 16U | a;
    }

    FileMaker file_;
};

/// A little-endian TIFF of one uncompressed strip. `extra` adds (tag, type, count, value) entries, in order
/// of tags.
struct TiffTag {
    unsigned tag, type;
    std::uint32_t count, value;
};
inline Bytes tiffOf(std::uint32_t width, std::uint32_t height, unsigned bits, unsigned samples,
                    unsigned photometric, unsigned format, const Bytes& pixels,
                    const std::vector<unsigned>& colourMap = {}) {
    const auto strip = static_cast<std::uint32_t>(pixels.size());
    std::vector<TiffTag> tags = {{256, 4, 1, width},   {257, 4, 1, height},      {258, 3, 1, bits},
                                 {259, 3, 1, 1},       {262, 3, 1, photometric}, {273, 4, 1, 8},
                                 {277, 3, 1, samples}, {278, 4, 1, height},      {279, 4, 1, strip},
                                 {284, 3, 1, 1},       {339, 3, 1, format}};
    const std::uint32_t mapAt = 8 + strip, ifdAt = mapAt + static_cast<std::uint32_t>(colourMap.size()) * 2;
    const std::uint32_t bitsAt =
        ifdAt + 2 + 12 * static_cast<std::uint32_t>(tags.size() + (colourMap.empty() ? 0 : 1)) + 4;
    if (samples > 2) tags[2] = {258, 3, samples, bitsAt};
    if (samples > 2) tags[10] = {339, 3, samples, bitsAt + 8};
    if (!colourMap.empty()) {
        tags.insert(tags.begin() + 10, {320, 3, static_cast<std::uint32_t>(colourMap.size()), mapAt});
    }
    FileMaker file;
    file.text("II").u16({42}).u32({ifdAt}).add(pixels);
    for (const unsigned v : colourMap) file.u16({v});
    file.u16({static_cast<unsigned>(tags.size())});
    for (const TiffTag& t : tags) file.u16({t.tag, t.type}).u32({t.count, t.value});
    file.u32({0}).u16({bits, bits, bits, bits, format, format, format, format});
    return file.bytes;
}

} // namespace test
