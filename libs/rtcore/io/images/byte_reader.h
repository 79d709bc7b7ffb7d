/// Numbers from unchecked bytes: reading past the end is a FileError, never an invalid access.
#pragma once

#include "rtcore/io/images/damage_forms.h"
#include "rtcore/io/images/decoded_image.h"

namespace rtcore {

class ByteReader {
  public:
    ByteReader(ByteSpan bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    std::size_t position() const { return position_; }
    std::size_t remaining() const { return bytes_.size() - position_; }

    /// Goes to an offset from the start.
    void seek(std::size_t offset) {
        if (offset > bytes_.size()) tooShort();
        position_ = offset;
    }
    void skip(std::size_t count) { take(count); }
    ByteSpan take(std::size_t count) {
        if (count > remaining()) tooShort();
        const ByteSpan part = bytes_.subspan(position_, count);
        position_ += count;
        return part;
    }
    std::uint8_t u8() { return std::to_integer<std::uint8_t>(take(1)[0]); }
    std::uint16_t u16() { // little endian
        const unsigned low = u8();
        return static_cast<std::uint16_t>(low | static_cast<unsigned>(u8()) << 8U);
    }
    std::uint32_t u32() { // little endian
        const std::uint32_t low = u16();
        return low | static_cast<std::uint32_t>(u16()) << 16U;
    }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    /// Up to and without the next line feed; no line is longer than `limit`.
    std::string line(std::size_t limit = 4096) {
        std::string text;
        for (;;) {
            const char c = static_cast<char>(u8());
            if (c == '\n') return text;
            if (text.size() == limit) badImage(name_, "a line of the header is too long");
            text += c;
        }
    }
    const std::string& name() const { return name_; }
    [[noreturn]] void tooShort() const { badImage(name_, damage::kEndsEarly); }

  private:
    ByteSpan bytes_;
    std::size_t position_ = 0;
    const std::string& name_;
};

inline void append(Bytes& bytes, const std::string& text) {
    for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
}
inline void append8(Bytes& bytes, unsigned value) { bytes.push_back(static_cast<std::byte>(value & 255U)); }
inline void append16(Bytes& bytes, unsigned value) { // little endian
    append8(bytes, value);
    append8(bytes, value >> 8U);
}

} // namespace rtcore
