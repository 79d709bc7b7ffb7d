// Radiance RGBE: three mantissas that share an exponent (G. Ward, "Real Pixels", Graphics Gems II, 1991).
// CImg takes .hdr for Analyze 7.5, and ImageMagick without HDRI clamps at 1.
#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace rtcore {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr int kFewestForRuns = 8, kMaxForRuns = 32767;

Colour decodePixel(Rgbe p, float scale) {
    if (p[3] == 0) return {};
    const float unit = std::ldexp(1.0F, p[3] - (128 + 8)) * scale;
    const Colour c{p[0] * unit, p[1] * unit, p[2] * unit};
    return c;
}

Rgbe encodePixel(Colour c) {
    const auto positive = [](float v) {
        return v > 0 ? std::min(v, std::numeric_limits<float>::max()) : 0.0F;
    };
    const float r = positive(c.r), g = positive(c.g), b = positive(c.b), max = std::max({r, g, b});
    if (max < 1e-38F) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(max, &exponent);
    // Rounding may carry the largest mantissa to 256, which is 128 of the next exponent.
    if (std::ldexp(max, 8 - exponent) >= 255.5F) ++exponent;
    exponent = std::min(exponent, 127);
    const auto mantissa = [&](float v) {
        return static_cast<std::uint8_t>(std::min(std::ldexp(v, 8 - exponent) + 0.5F, 255.0F));
    };
    return {mantissa(r), mantissa(g), mantissa(b), static_cast<std::uint8_t>(exponent + 128)};
}

struct RadianceHeader {
    int width = 0, height = 0;
    bool bottomUp = false, rightToLeft = false;
    float scale = 1; ///< radiance of one unit in the file
};

void readSetting(const std::string& line, RadianceHeader& h, const std::string& name) {
    if (line.rfind("FORMAT=", 0) == 0 && line.find("32-bit_rle_rgbe") == std::string::npos) {
        badImage(name, say("Radiance image of an unknown kind ({0}); only 32-bit_rle_rgbe is read", line));
    }
    if (line.rfind("EXPOSURE=", 0) == 0) {
        float exposure = 0;
        if (std::sscanf(line.c_str() + 9, "%f", &exposure) == 1 && exposure > 1e-10F && exposure < 1e10F) {
            h.scale /= exposure;
        }
    }
}

void readResolution(const std::string& line, RadianceHeader& h, const std::string& name) {
    char signY = 0, signX = 0;
    if (std::sscanf(line.c_str(), "%cY %9d %cX %9d", &signY, &h.height, &signX, &h.width) != 4 ||
        (signY != '-' && signY != '+') || (signX != '-' && signX != '+')) {
        badImage(name, "Radiance image without a line such as \"-Y 512 +X 1024\"");
    }
    h.bottomUp = signY == '+';
    h.rightToLeft = signX == '-';
    checkImageSize(name, h.width, h.height);
}

RadianceHeader readRadianceHeader(ByteReader& in) {
    RadianceHeader h;
    for (std::string line = in.line(); !line.empty() && line != "\r"; line = in.line()) {
        readSetting(line, h, in.name());
    }
    if (!std::isfinite(h.scale)) badImage(in.name(), "Radiance image with an exposure out of all range");
    readResolution(in.line(), h, in.name());
    return h;
}

Rgbe takePixel(ByteReader& in) {
    const ByteSpan p = in.take(4);
    const auto at = [&](std::size_t i) { return std::to_integer<std::uint8_t>(p[i]); };
    return {at(0), at(1), at(2), at(3)};
}

/// One channel after the other, each as packets of up to 127 equal or 128 different bytes.
void readNewRuns(ByteReader& in, std::vector<Rgbe>& row) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
        for (std::size_t x = 0; x < row.size();) {
            const unsigned code = in.u8();
            const std::size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > row.size() - x)
                badImage(in.name(), "damaged Radiance image: a run too long");
            const ByteSpan values = in.take(code > 128 ? 1 : count);
            for (std::size_t i = 0; i < count; ++i) {
                row[x++][channel] = std::to_integer<std::uint8_t>(values[code > 128 ? 0 : i]);
            }
        }
    }
}

/// Pixel after pixel; (1, 1, 1, n) repeats the last one n times, and the next such one 256 n times.
void readOldRuns(ByteReader& in, std::vector<Rgbe>& row, Rgbe first) {
    unsigned shift = 0;
    Rgbe pixel = first;
    for (std::size_t x = 0;;) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && x > 0) {
            const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
            if (count > row.size() - x) badImage(in.name(), "damaged Radiance image: a run too long");
            std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
            x += count;
            shift = std::min(shift + 8, 24U);
        } else {
            row[x++] = pixel;
            shift = 0;
        }
        if (x == row.size()) return;
        pixel = takePixel(in);
    }
}

void readRow(ByteReader& in, std::vector<Rgbe>& row) {
    const Rgbe first = takePixel(in);
    const std::size_t named = static_cast<std::size_t>(first[2]) << 8U | first[3];
    const bool runs = first[0] == 2 && first[1] == 2 && first[2] < 128 && row.size() >= kFewestForRuns &&
                      row.size() <= kMaxForRuns;
    if (!runs) return readOldRuns(in, row, first);
    if (named != row.size()) badImage(in.name(), "damaged Radiance image: a row of another width");
    readNewRuns(in, row);
}

/// Runs of four and more equal bytes pay; shorter ones go with what differs.
void appendRuns(Bytes& bytes, const std::vector<Rgbe>& row, std::size_t channel) {
    const auto at = [&](std::size_t x) { return row[x][channel]; };
    const auto runAt = [&](std::size_t x) {
        std::size_t end = x + 1;
        while (end < row.size() && end - x < 127 && at(end) == at(x)) ++end;
        return end - x;
    };
    for (std::size_t x = 0; x < row.size();) {
        const std::size_t run = runAt(x);
        if (run >= 4) {
            append8(bytes, static_cast<unsigned>(128 + run));
            append8(bytes, at(x));
            x += run;
            continue;
        }
        std::size_t end = x;
        while (end < row.size() && end - x < 128 && runAt(end) < 4) ++end;
        append8(bytes, static_cast<unsigned>(end - x));
        for (; x < end; ++x) append8(bytes, at(x));
    }
}

void appendRow(Bytes& bytes, const std::vector<Rgbe>& row) {
    if (row.size() < kFewestForRuns || row.size() > kMaxForRuns) {
        for (const Rgbe& p : row) {
            for (const std::uint8_t v : p) append8(bytes, v);
        }
        return;
    }
    append8(bytes, 2);
    append8(bytes, 2);
    append8(bytes, static_cast<unsigned>(row.size() >> 8U));
    append8(bytes, static_cast<unsigned>(row.size()));
    for (std::size_t channel = 0; channel < 4; ++channel) appendRuns(bytes, row, channel);
}

} // namespace

DecodedImage decodeRadiance(ByteSpan bytes, const std::string& name) {
    ByteReader in(bytes, name);
    const RadianceHeader h = readRadianceHeader(in);
    // New runs: 127 pixels in eight bytes; old runs: a whole row in 12, were it all the same.
    const std::size_t pixels = static_cast<std::size_t>(h.width) * static_cast<std::size_t>(h.height);
    checkPlausible(name, pixels, bytes.size(), 1024);
    HdrImage image(h.width, h.height);
    std::vector<Rgbe> row(static_cast<std::size_t>(h.width));
    for (int i = 0; i < h.height; ++i) {
        readRow(in, row);
        const int y = h.bottomUp ? h.height - 1 - i : i;
        for (int j = 0; j < h.width; ++j) {
            const int x = h.rightToLeft ? h.width - 1 - j : j;
            image.at(x, y) = decodePixel(row[static_cast<std::size_t>(j)], h.scale);
        }
    }
    return image;
}

Bytes encodeRadiance(const HdrImage& image, const std::string& /*name*/) {
    Bytes bytes;
    append(bytes,
           fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width));
    std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        std::transform(&image.at(0, y), &image.at(0, y) + image.width, row.begin(), encodePixel);
        appendRow(bytes, row);
    }
    return bytes;
}

} // namespace rtcore
