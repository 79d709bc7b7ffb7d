/// Numbers in the form in which nearly all files of text write them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Reads a sign, which only '-' is, and digits with or without a point: up to 19 of them, below 2^53. The end
/// of the number, or null for any other form (exponents, more digits) and for the few that take more care.
/// The bits are those of std::from_chars. Behind the text stands a character that is neither digit nor point.
inline const char* readPlainFloat(const char* at, float& value) {
    constexpr std::array<double, 20> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                             1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
    constexpr std::uint64_t kExact = std::uint64_t{1} << 53U;
    const auto isDigit = [](char c) { return static_cast<unsigned char>(c - '0') < 10; };
    const bool negative = *at == '-';
    const char* const first = at + (negative ? 1 : 0);
    std::uint64_t digits = 0;
    for (at = first; isDigit(*at); ++at) digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
    auto count = static_cast<std::size_t>(at - first);
    std::size_t fraction = 0;
    if (*at == '.') {
        const char* const point = at;
        for (++at; isDigit(*at); ++at) digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
        fraction = static_cast<std::size_t>(at - point) - 1;
        count += fraction;
    }
    if (count == 0 || count >= kPowers.size() || digits > kExact || *at == 'e' || *at == 'E') return nullptr;
    // Both are exact, so that the quotient is rounded once; then to float, which is the same as at once but
    // for a quotient in the middle between two floats.
    const double number = static_cast<double>(digits) / kPowers[fraction];
    constexpr std::uint64_t kBelowFloat = (std::uint64_t{1} << 29U) - 1, kMiddle = std::uint64_t{1} << 28U;
    if ((std::bit_cast<std::uint64_t>(number) & kBelowFloat) == kMiddle) return nullptr;
    value = static_cast<float>(negative ? -number : number);
    return at;
}

} // namespace rtcore
