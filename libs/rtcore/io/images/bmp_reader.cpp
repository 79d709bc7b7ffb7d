#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

#include <bit>

namespace rtcore {
namespace {

enum Compression : std::uint32_t { kPlain = 0, kRle8 = 1, kRle4 = 2, kBitFields = 3, kAlphaBitFields = 6 };

/// One channel of a 16- or 32-bit pixel.
struct Field {
    std::uint32_t mask = 0;

    std::uint8_t of(std::uint32_t pixel) const {
        if (mask == 0) return 0;
        const auto shift = static_cast<unsigned>(std::countr_zero(mask));
        const std::uint64_t max = mask >> shift, value = (pixel & mask) >> shift;
        return static_cast<std::uint8_t>((value * 255 + max / 2) / max);
    }
};

struct BmpHeader {
    std::int32_t width = 0, height = 0; ///< height > 0
    bool topDown = false;
    unsigned bits = 0;
    std::uint32_t compression = kPlain;
    Field red, green, blue, alpha;
    std::vector<Rgba8> palette; ///< 2^bits entries up to 8 bits
    std::size_t pixelOffset = 0;
};

void readPalette(ByteReader& in, BmpHeader& h, std::uint32_t used, std::size_t entryBytes) {
    const std::size_t full = std::size_t{1} << h.bits;
    const std::size_t count = used == 0 || used > full ? full : used;
    h.palette.resize(full);
    for (std::size_t i = 0; i < count && in.position() + entryBytes <= h.pixelOffset; ++i) {
        const ByteSpan entry = in.take(entryBytes);
        const auto at = [&](std::size_t k) { return std::to_integer<std::uint8_t>(entry[k]); };
        h.palette[i] = {at(2), at(1), at(0), 255};
    }
}

void readFields(ByteReader& in, BmpHeader& h, std::uint32_t headerSize) {
    if (h.compression != kBitFields && h.compression != kAlphaBitFields) {
        if (h.bits == 16) h.red.mask = 0x7c00, h.green.mask = 0x3e0, h.blue.mask = 0x1f;
        if (h.bits == 32) h.red.mask = 0xff0000, h.green.mask = 0xff00, h.blue.mask = 0xff;
        return;
    }
    // In the header itself from its third version on, after it before; both follow the 40 bytes.
    h.red.mask = in.u32();
    h.green.mask = in.u32();
    h.blue.mask = in.u32();
    if (h.compression == kAlphaBitFields || headerSize >= 56) h.alpha.mask = in.u32();
}

void readCoreHeader(ByteReader& in, BmpHeader& h) {
    h.width = in.u16();
    h.height = in.u16();
    in.skip(2);
    h.bits = in.u16();
}

/// Returns how many colours of the palette are used, 0 for all.
std::uint32_t readInfoHeader(ByteReader& in, BmpHeader& h) {
    h.width = in.i32();
    const std::int64_t height = in.i32();
    h.topDown = height < 0;
    checkImageSize(in.name(), h.width, height < 0 ? -height : height);
    h.height = static_cast<std::int32_t>(height < 0 ? -height : height);
    in.skip(2);
    h.bits = in.u16();
    h.compression = in.u32();
    in.skip(12);
    const std::uint32_t used = in.u32();
    in.skip(4);
    return used;
}

void checkKind(const BmpHeader& h, const std::string& name) {
    const bool indexed = h.bits == 1 || h.bits == 4 || h.bits == 8;
    const bool direct = h.bits == 16 || h.bits == 24 || h.bits == 32;
    bool fits = false;
    switch (h.compression) {
    case kPlain:
        fits = indexed || direct;
        break;
    case kRle8:
        fits = h.bits == 8;
        break;
    case kRle4:
        fits = h.bits == 4;
        break;
    case kBitFields:
    case kAlphaBitFields:
        fits = h.bits == 16 || h.bits == 32;
        break;
    default:
        break;
    }
    if (!fits) {
        badImage(name, say("BMP of an unknown kind ({0} bits, compression {1})", h.bits, h.compression));
    }
}

BmpHeader readBmpHeader(ByteReader& in) {
    BmpHeader h;
    in.skip(10);
    h.pixelOffset = in.u32();
    const std::uint32_t headerSize = in.u32();
    const bool core = headerSize == 12;
    if (!core && headerSize < 40) badImage(in.name(), "BMP with an unknown header");
    std::uint32_t used = 0;
    if (core) {
        readCoreHeader(in, h);
    } else {
        used = readInfoHeader(in, h);
    }
    checkImageSize(in.name(), h.width, h.height);
    checkKind(h, in.name());
    readFields(in, h, headerSize);
    if (h.bits <= 8) {
        in.seek(std::size_t{14} + headerSize);
        readPalette(in, h, used, core ? 3 : 4);
    }
    return h;
}

int rowOf(const BmpHeader& h, int y) { return h.topDown ? y : h.height - 1 - y; }

Rgba8 directPixel(const BmpHeader& h, const std::byte* p) {
    const auto at = [&](std::size_t k) { return std::to_integer<std::uint32_t>(p[k]); };
    if (h.bits == 24) {
        return {static_cast<std::uint8_t>(at(2)), static_cast<std::uint8_t>(at(1)),
                static_cast<std::uint8_t>(at(0)), 255};
    }
    const std::uint32_t v =
        h.bits == 16 ? at(0) | at(1) << 8U : at(0) | at(1) << 8U | at(2) << 16U | at(3) << 24U;
    const std::uint8_t alpha = h.alpha.mask == 0 ? std::uint8_t{255} : h.alpha.of(v);
    return {h.red.of(v), h.green.of(v), h.blue.of(v), alpha};
}

Rgba8 indexedPixel(const BmpHeader& h, ByteSpan row, unsigned x) {
    const unsigned bit = x * h.bits;
    const auto byte = std::to_integer<unsigned>(row[bit / 8]);
    const unsigned index = byte >> (8 - h.bits - bit % 8) & ((1U << h.bits) - 1);
    return h.palette[index];
}

void readPlain(ByteReader& in, const BmpHeader& h, LdrImage& image) {
    const std::size_t rowBytes = (static_cast<std::size_t>(h.width) * h.bits + 31) / 32 * 4;
    for (int y = 0; y < h.height; ++y) {
        const ByteSpan row = in.take(rowBytes);
        Rgba8* target = &image.at(0, rowOf(h, y));
        for (int x = 0; x < h.width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            target[x] = h.bits <= 8 ? indexedPixel(h, row, static_cast<unsigned>(x))
                                    : directPixel(h, row.data() + i * (h.bits / 8));
        }
    }
    if (h.alpha.mask != 0) makeOpaqueIfAllClear(image);
}

/// Run lengths: pairs of a count and a value; a count of 0 starts an end of line, an end, a jump or a literal
/// run.
class RleReader {
  public:
    RleReader(ByteReader& in, const BmpHeader& header, LdrImage& image)
        : in_(in), h_(header), image_(image) {}

    void read() {
        while (y_ < h_.height) {
            const unsigned count = in_.u8(), value = in_.u8();
            if (count > 0) {
                for (unsigned i = 0; i < count; ++i) put(h_.bits == 8 ? value : nibble(value, i));
            } else if (value == 0) {
                x_ = 0;
                ++y_;
            } else if (value == 1) {
                return;
            } else if (value == 2) {
                x_ += in_.u8();
                y_ += in_.u8();
            } else {
                literal(value);
            }
        }
    }

  private:
    static unsigned nibble(unsigned value, unsigned i) { return i % 2 == 0 ? value >> 4U : value & 15U; }

    void literal(unsigned count) {
        const ByteSpan run = in_.take(h_.bits == 8 ? count : (count + 1) / 2);
        for (unsigned i = 0; i < count; ++i) {
            put(h_.bits == 8 ? std::to_integer<unsigned>(run[i])
                             : nibble(std::to_integer<unsigned>(run[i / 2]), i));
        }
        if (run.size() % 2 == 1) in_.skip(1);
    }

    void put(unsigned index) {
        if (x_ < h_.width && y_ < h_.height) image_.at(x_, rowOf(h_, y_)) = h_.palette[index];
        if (x_ < h_.width) ++x_;
    }

    ByteReader& in_;
    const BmpHeader& h_;
    LdrImage& image_;
    int x_ = 0, y_ = 0;
};

} // namespace

DecodedImage decodeBmp(ByteSpan bytes, const std::string& name) {
    ByteReader in(bytes, name);
    const BmpHeader h = readBmpHeader(in);
    in.seek(h.pixelOffset);
    const bool runs = h.compression == kRle8 || h.compression == kRle4;
    // A run of 255 takes two bytes; jumps may leave most of an image out, but no real image does so.
    const std::size_t pixels = static_cast<std::size_t>(h.width) * static_cast<std::size_t>(h.height);
    checkPlausible(name, pixels, bytes.size(), runs ? 4096 : 8);
    LdrImage image(h.width, h.height, h.palette.empty() ? Rgba8{} : h.palette[0]);
    if (runs) {
        RleReader(in, h, image).read();
    } else {
        readPlain(in, h, image);
    }
    return image;
}

} // namespace rtcore
