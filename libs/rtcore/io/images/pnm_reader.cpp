#include "rtcore/io/images/byte_reader.h"
#include "rtcore/io/images/codecs.h"

namespace rtcore {
namespace {

bool isBlank(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class PnmReader {
  public:
    PnmReader(ByteSpan bytes, const std::string& name) : in_(bytes, name), size_(bytes.size()) {}

    DecodedImage read() {
        in_.skip(1);
        kind_ = static_cast<unsigned>(in_.u8() - '0');
        const unsigned width = number(), height = number();
        checkImageSize(in_.name(), width, height);
        max_ = isBitmap() ? 1 : number();
        if (max_ < 1 || max_ > 65535) badImage(in_.name(), "the largest value of a PNM must lie in 1..65535");
        // number() has taken the one blank that stands before binary pixels.
        const std::size_t pixels = std::size_t{width} * height;
        checkPlausible(in_.name(), pixels, size_, isBitmap() ? 8 : 1);
        const int w = static_cast<int>(width), h = static_cast<int>(height);
        return max_ < 256 ? DecodedImage(readPixels<Rgba8, 255>(w, h))
                          : DecodedImage(readPixels<Rgba16, 65535>(w, h));
    }

  private:
    bool isText() const { return kind_ <= 3; }
    bool isBitmap() const { return kind_ == 1 || kind_ == 4; }
    bool isColour() const { return kind_ == 3 || kind_ == 6; }

    template <typename Pixel, unsigned full>
    Image<Pixel> readPixels(int w, int h) {
        Image<Pixel> image(w, h);
        const auto sample = [&](int x) {
            using Channel = decltype(Pixel{}.r);
            return static_cast<Channel>((next(x) * full + max_ / 2) / max_);
        };
        for (int y = 0; y < h; ++y) {
            for (int x = 0; x < w; ++x) {
                Pixel& p = image.at(x, y);
                p.r = p.g = p.b = sample(x);
                if (!isColour()) continue;
                p.g = sample(x);
                p.b = sample(x);
            }
        }
        return image;
    }

    /// The next sample, at most `max_`; x says where a row of packed bits starts anew.
    unsigned next(int x) {
        unsigned value = 0;
        if (kind_ == 1) {
            value = 1U - bitDigit();
        } else if (kind_ == 4) {
            if (x % 8 == 0) bits_ = in_.u8();
            value = 1U - (bits_ >> (7U - static_cast<unsigned>(x) % 8) & 1U);
        } else if (isText()) {
            value = number();
        } else {
            value = in_.u8();
            if (max_ > 255) value = value << 8U | in_.u8();
        }
        if (value > max_)
            badImage(in_.name(), "a sample is larger than the largest value that the PNM names");
        return value;
    }

    /// Digits of a plain bitmap need no blanks between them.
    unsigned bitDigit() {
        const unsigned digit = static_cast<unsigned>(skipBlanks() - '0');
        if (digit > 1) badImage(in_.name(), "a plain bitmap holds only 0 and 1");
        return digit;
    }

    /// The first byte that is neither blank nor part of a comment.
    std::uint8_t skipBlanks() {
        for (;;) {
            std::uint8_t c = in_.u8();
            if (c == '#') {
                while (c != '\n') c = in_.u8();
            }
            if (!isBlank(c)) return c;
        }
    }

    /// A number and the one blank after it; the file may end there.
    unsigned number() {
        std::uint8_t c = skipBlanks();
        unsigned value = 0;
        for (;;) {
            if (c < '0' || c > '9' || value > 100000)
                badImage(in_.name(), "damaged PNM: a number was expected");
            value = value * 10 + static_cast<unsigned>(c - '0');
            if (in_.remaining() == 0) return value;
            c = in_.u8();
            if (isBlank(c)) return value;
        }
    }

    ByteReader in_;
    std::size_t size_;
    unsigned kind_ = 0, max_ = 0, bits_ = 0;
};

} // namespace

DecodedImage decodePnm(ByteSpan bytes, const std::string& name) { return PnmReader(bytes, name).read(); }

} // namespace rtcore
