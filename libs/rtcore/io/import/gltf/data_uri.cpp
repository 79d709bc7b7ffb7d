#include "rtcore/io/import/gltf/data_uri.h"

#include "rtcore/io/import/materials/texture_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace rtcore::gltf {

namespace {

constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> digitsOfBase64() {
    std::array<std::uint8_t, 256> digits{};
    digits.fill(kNoDigit);
    for (unsigned i = 0; i < 26; ++i) {
        digits['A' + i] = static_cast<std::uint8_t>(i);
        digits['a' + i] = static_cast<std::uint8_t>(26 + i);
    }
    for (unsigned i = 0; i < 10; ++i) digits['0' + i] = static_cast<std::uint8_t>(52 + i);
    digits['+'] = digits['-'] = 62; // the second of each is that of base64url
    digits['/'] = digits['_'] = 63;
    return digits;
}

std::vector<std::byte> decodedBase64(std::string_view text) {
    static constexpr std::array<std::uint8_t, 256> kDigits = digitsOfBase64();
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t word = 0;
    unsigned bits = 0;
    for (const char c : text) {
        const std::uint8_t digit = kDigits[static_cast<unsigned char>(c)];
        if (digit == kNoDigit) {
            if (c == '\n' || c == '\r' || c == ' ') continue;
            break;
        }
        word = word << 6U | digit;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::byte>(word >> bits & 0xFFU));
    }
    return bytes;
}

} // namespace

std::vector<std::byte> bytesOfDataUri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return {};
    const std::string_view kind = uri.substr(0, comma), data = uri.substr(comma + 1);
    if (kind.ends_with(";base64")) return decodedBase64(data);
    const std::string plain = percentDecoded(std::string(data));
    std::vector<std::byte> bytes(plain.size());
    std::ranges::transform(plain, bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
    return bytes;
}

} // namespace rtcore::gltf
