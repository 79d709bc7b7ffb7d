#include "rtcore/settings/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace {

using rtcore::editDistance;
using rtcore::nearestName;

constexpr std::array<std::string_view, 4> kNames{"eye", "forward", "exposure.mode",
                                                 "ambientOcclusion.samples"};

TEST(NearestName, EditDistanceCountsEditsAndSwaps) {
    EXPECT_EQ(editDistance("", ""), 0U);
    EXPECT_EQ(editDistance("", "abc"), 3U);
    EXPECT_EQ(editDistance("abc", ""), 3U);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
    EXPECT_EQ(editDistance("form", "from"), 1U);
    EXPECT_EQ(editDistance("WIDTH", "width"), 0U);
}

TEST(NearestName, FindsMisspeltNames) {
    EXPECT_EQ(nearestName("eey", kNames), "eye");
    EXPECT_EQ(nearestName("foward", kNames), "forward");
    EXPECT_EQ(nearestName("exposure.mod", kNames), "exposure.mode");
    EXPECT_EQ(nearestName("ambientocclusion.sampels", kNames), "ambientOcclusion.samples");
}

TEST(NearestName, FindsDottedNamesByTheirLastPart) { EXPECT_EQ(nearestName("samples", kNames), kNames[3]); }

TEST(NearestName, SuggestsNothingWhenNothingIsNear) {
    EXPECT_EQ(nearestName("qqqqqqqq", kNames), "");
    EXPECT_EQ(nearestName(std::string(100'000, 'e'), kNames), "");
    EXPECT_EQ(nearestName("eye", {}), "");
}

TEST(NearestName, MessagesListAllNamesWhenNoneIsNear) {
    EXPECT_EQ(rtcore::unknownNameMessage("key", "eey", kNames).english(),
              "unknown key 'eey'; did you mean 'eye'?");
    EXPECT_EQ(rtcore::unknownNameMessage("key", "qqqqqqqq", kNames).english(),
              "unknown key 'qqqqqqqq'; known: eye forward exposure.mode ambientOcclusion.samples");
}

TEST(NearestName, MessagesStayOnOneShortLine) {
    EXPECT_EQ(rtcore::inQuotes("a\nb\x1b[0m"), "'a\\x0ab\\x1b[0m'");
    EXPECT_LT(rtcore::inQuotes(std::string(1'000'000, 'x')).size(), 100U);
    // Cut between characters, not within one.
    EXPECT_EQ(rtcore::printable("ab\xC3\xA4", 3), "ab...");
}

TEST(Printable, NothingThatATerminalObeys) {
    EXPECT_EQ(rtcore::printable("\x1b]0;owned\x07.obj"), "\\x1b]0;owned\\x07.obj");
    EXPECT_EQ(rtcore::printable("a\nb\x7f"), "a\\x0ab\\x7f");
    EXPECT_EQ(rtcore::printable("kostel \xC5\xBElut\xC3\xBD"), "kostel \xC5\xBElut\xC3\xBD");
    EXPECT_EQ(rtcore::printable("\xC2\x9B"
                                "31m"),
              "\\xc2\\x9b31m")
        << "a control sequence of one character";
    EXPECT_EQ(rtcore::printable("\xC2\xA0"), "\xC2\xA0") << "a blank";
    EXPECT_EQ(rtcore::printable("\x9B"
                                "31m\xff"),
              "\\x9b31m\\xff")
        << "no UTF-8";
    EXPECT_EQ(rtcore::printable("cut \xE2\x82"), "cut \\xe2\\x82");
    const std::string once = rtcore::printable("\x1b\xff");
    EXPECT_EQ(rtcore::printable(once), once);
}

} // namespace
