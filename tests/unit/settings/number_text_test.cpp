#include "rtcore/settings/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace rtcore {
namespace {

TEST(ShortestText, HasTheFewestDigitsInTheShorterForm) {
    EXPECT_EQ(shortestText(0.1F), "0.1");
    EXPECT_EQ(shortestText(0.1), "0.1");
    EXPECT_EQ(shortestText(70.0), "70");
    EXPECT_EQ(shortestText(-0.0), "-0");
    EXPECT_EQ(shortestText(123456.0F), "123456");
    EXPECT_EQ(shortestText(500000.0F), "5e+05");
    EXPECT_EQ(shortestText(1e-7F), "1e-07");
    EXPECT_EQ(shortestText(std::numeric_limits<float>::max()), "3.4028235e+38");
    EXPECT_EQ(shortestText(std::numeric_limits<float>::infinity()), "inf");
    EXPECT_EQ(shortestText(-std::numeric_limits<double>::denorm_min()), "-5e-324");
}

template <typename Number, typename Bits>
void expectSameBits() {
    std::mt19937_64 random(12);
    for (int i = 0; i < 100'000; ++i) {
        const auto bits = static_cast<Bits>(random());
        const auto value = std::bit_cast<Number>(bits);
        if (!std::isfinite(value)) continue;
        const std::string text = shortestText(value);
        Number back = 0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        ASSERT_EQ(std::bit_cast<Bits>(back), bits) << text;
    }
}

TEST(ShortestText, KeepsEveryBit) {
    expectSameBits<float, std::uint32_t>();
    expectSameBits<double, std::uint64_t>();
}

} // namespace
} // namespace rtcore
