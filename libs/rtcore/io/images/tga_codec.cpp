#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

#include <string_view>

namespace rtcore {
namespace {

constexpr unsigned kRightToLeft = 0x10, kTopDown = 0x20;
constexpr std::string_view kFooter{"TRUEVISION-XFILE.\0", 18};

struct TgaHeader {
    unsigned idLength, mapType, type, mapStart, mapLength, mapBits, width, height, bits, descriptor;

    bool runs() const { return (type & 8U) != 0; }
    unsigned kind() const { return type & 7U; } ///< 1 palette, 2 colour, 3 grey
    std::size_t pixelBytes() const { return (bits + 7) / 8; }
};

TgaHeader readTgaHeader(ByteReader& in) {
    TgaHeader h{};
    h.idLength = in.u8();
    h.mapType = in.u8();
    h.type = in.u8();
    h.mapStart = in.u16();
    h.mapLength = in.u16();
    h.mapBits = in.u8();
    in.skip(4);
    h.width = in.u16();
    h.height = in.u16();
    h.bits = in.u8();
    h.descriptor = in.u8();
    checkImageSize(in.name(), h.width, h.height);
    in.skip(h.idLength);
    return h;
}

Rgba8 colourOf(ByteSpan p, unsigned bits, bool attribute) {
    const auto at = [&](std::size_t i) { return std::to_integer<std::uint8_t>(p[i]); };
    if (bits == 8) return {at(0), at(0), at(0), 255};
    if (bits >= 24) return {at(2), at(1), at(0), bits == 32 ? at(3) : std::uint8_t{255}};
    const unsigned v = at(0) | static_cast<unsigned>(at(1)) << 8U;
    const auto widen = [](unsigned five) { return static_cast<std::uint8_t>((five * 255 + 15) / 31); };
    const bool clear = attribute && bits == 16 && (v & 0x8000U) == 0;
    return {widen(v >> 10U & 31U), widen(v >> 5U & 31U), widen(v & 31U),
            clear ? std::uint8_t{0} : std::uint8_t{255}};
}

std::vector<Rgba8> readPalette(ByteReader& in, const TgaHeader& h) {
    std::vector<Rgba8> palette;
    if (h.mapType == 0) return palette;
    const bool fits = h.mapBits == 15 || h.mapBits == 16 || h.mapBits == 24 || h.mapBits == 32;
    if (!fits && h.mapLength > 0) badImage(in.name(), "TGA with an unknown kind of palette");
    palette.reserve(h.mapLength);
    for (unsigned i = 0; i < h.mapLength; ++i) {
        palette.push_back(colourOf(in.take((h.mapBits + 7) / 8), h.mapBits, false));
    }
    return palette;
}

class TgaReader {
  public:
    TgaReader(ByteSpan bytes, const std::string& name) : in_(bytes, name), size_(bytes.size()) {}

    DecodedImage read() {
        h_ = readTgaHeader(in_);
        palette_ = readPalette(in_, h_);
        // A run of 128 pixels takes two bytes.
        checkPlausible(in_.name(), std::size_t{h_.width} * h_.height, size_, h_.runs() ? 64 : 1);
        LdrImage image(static_cast<int>(h_.width), static_cast<int>(h_.height));
        for (int i = 0; i < image.height; ++i) {
            const int y = (h_.descriptor & kTopDown) != 0 ? i : image.height - 1 - i;
            for (int j = 0; j < image.width; ++j) {
                const int x = (h_.descriptor & kRightToLeft) != 0 ? image.width - 1 - j : j;
                image.at(x, y) = next();
            }
        }
        makeOpaqueIfAllClear(image);
        return image;
    }

  private:
    Rgba8 next() {
        if (!h_.runs()) return one();
        if (left_ == 0) {
            const unsigned packet = in_.u8();
            left_ = (packet & 127U) + 1;
            repeats_ = (packet & 128U) != 0;
            if (repeats_) repeated_ = one();
        }
        --left_;
        return repeats_ ? repeated_ : one();
    }

    Rgba8 one() {
        const ByteSpan p = in_.take(h_.pixelBytes());
        if (h_.kind() != 1) return colourOf(p, h_.bits, (h_.descriptor & 15U) != 0);
        const unsigned index = std::to_integer<unsigned>(p[0]);
        if (index < h_.mapStart || index - h_.mapStart >= palette_.size()) {
            badImage(in_.name(), "damaged TGA: a pixel lies outside of the palette");
        }
        return palette_[index - h_.mapStart];
    }

    ByteReader in_;
    std::size_t size_;
    TgaHeader h_{};
    std::vector<Rgba8> palette_;
    unsigned left_ = 0;
    bool repeats_ = false;
    Rgba8 repeated_;
};

} // namespace

DecodedImage decodeTga(ByteSpan bytes, const std::string& name) { return TgaReader(bytes, name).read(); }

Bytes encodeTga(const LdrImage& image, const std::string& /*name*/) {
    const bool alpha = hasAlpha(image);
    Bytes bytes;
    bytes.reserve(image.pixels.size() * (alpha ? 4 : 3) + 44);
    for (const unsigned v : {0U, 0U, 2U}) append8(bytes, v); // no text, no palette, colours without runs
    for (int i = 0; i < 9; ++i) append8(bytes, 0);           // palette and origin
    append16(bytes, static_cast<unsigned>(image.width));
    append16(bytes, static_cast<unsigned>(image.height));
    append8(bytes, alpha ? 32 : 24);
    append8(bytes, kTopDown | (alpha ? 8U : 0U));
    for (const Rgba8 p : image.pixels) {
        append8(bytes, p.b);
        append8(bytes, p.g);
        append8(bytes, p.r);
        if (alpha) append8(bytes, p.a);
    }
    for (int i = 0; i < 8; ++i) append8(bytes, 0); // no extension area, no developer area
    append(bytes, std::string(kFooter));
    return bytes;
}

} // namespace rtcore
