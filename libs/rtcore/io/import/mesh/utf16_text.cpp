#include "rtcore/io/import/mesh/utf16_text.h"

#include <iconv.h>

#include <utility>

namespace rtcore {

namespace {

class Utf16Decoder {
  public:
    Utf16Decoder() : state_(iconv_open("UTF-8", "UTF-16")) {}
    ~Utf16Decoder() {
        if (isOpen()) iconv_close(state_);
    }
    Utf16Decoder(const Utf16Decoder&) = delete;
    Utf16Decoder& operator=(const Utf16Decoder&) = delete;

    std::optional<std::string> decode(std::span<const std::byte> bytes) {
        if (!isOpen()) return std::nullopt;
        std::string text(bytes.size() / 2 * 3, '\0'); // two bytes become three at most
        char* from =
            const_cast<char*>(reinterpret_cast<const char*>(bytes.data())); // which iconv() only reads
        char* to = text.data();
        std::size_t left = bytes.size(), room = text.size();
        if (iconv(state_, &from, &left, &to, &room) == static_cast<std::size_t>(-1)) return std::nullopt;
        text.resize(text.size() - room);
        return text;
    }

  private:
    bool isOpen() const { return state_ != reinterpret_cast<iconv_t>(-1); }
    iconv_t state_;
};

} // namespace

bool beginsAsUtf16(std::span<const std::byte> bytes) {
    if (bytes.size() < 2) return false;
    const auto mark = std::pair(std::to_integer<int>(bytes[0]), std::to_integer<int>(bytes[1]));
    return mark == std::pair(0xFF, 0xFE) || mark == std::pair(0xFE, 0xFF);
}

std::optional<std::string> utf8OfUtf16(std::span<const std::byte> bytes) {
    if (!beginsAsUtf16(bytes)) return std::nullopt;
    return Utf16Decoder().decode(bytes);
}

} // namespace rtcore
