/// The texts of image files, read by the letter of their formats.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace test {

using Texts = std::map<std::string, std::string>;

namespace detail {

inline std::uint32_t number(const std::string& bytes, std::size_t at, bool bigEndian) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << 8U * (bigEndian ? 3 - i : i);
    return value;
}

/// The chunks tEXt of a PNG file (ISO/IEC 15948, 5.3).
inline Texts pngTexts(const std::string& bytes) {
    Texts texts;
    for (std::size_t at = 8; at < bytes.size();) {
        const std::size_t size = number(bytes, at, true);
        const std::string content = bytes.substr(at + 8, size);
        if (bytes.substr(at + 4, 4) == "tEXt") {
            const std::size_t end = content.find('\0');
            texts[content.substr(0, end)] = content.substr(end + 1);
        }
        at += size + 12;
    }
    return texts;
}

/// The attributes of type string of an EXR file (OpenEXR File Layout).
inline Texts exrTexts(const std::string& bytes) {
    Texts texts;
    for (std::size_t at = 8; bytes.at(at) != 0;) {
        const std::string name = bytes.c_str() + at;
        const std::string type = bytes.c_str() + at + name.size() + 1;
        at += name.size() + type.size() + 2;
        const std::size_t size = number(bytes, at, false);
        if (type == "string") texts[name] = bytes.substr(at + 4, size);
        at += size + 4;
    }
    return texts;
}

} // namespace detail

/// The texts in a PNG or EXR file.
inline Texts imageTexts(const std::string& bytes) {
    if (bytes.starts_with("\x89PNG")) return detail::pngTexts(bytes);
    if (bytes.starts_with("\x76\x2f\x31\x01")) return detail::exrTexts(bytes);
    throw std::runtime_error("neither PNG nor EXR");
}

} // namespace test
