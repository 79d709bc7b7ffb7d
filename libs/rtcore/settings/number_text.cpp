#include "rtcore/settings/number_text.h"

#include <array>
#include <charconv>

namespace rtcore {

namespace {

// fmt finds the same digits but writes 500000 for 5e+05 and fills up large floats with zeros: one in ten
// floats would look different in files.
template <typename Number>
std::string shortest(Number value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

} // namespace

std::string shortestText(float value) { return shortest(value); }
std::string shortestText(double value) { return shortest(value); }

} // namespace rtcore
