/// Characters that are taken out of text of others before it is shown.
#include "rtcore/settings/plain_text.h"

#include <gtest/gtest.h>

#include <string>

namespace {

/// A code point as UTF-8.
std::string utf8(char32_t point) {
    const auto byte = [](char32_t value) { return static_cast<char>(value); };
    if (point < 0x80) return {byte(point)};
    if (point < 0x800) return {byte(0xC0 | point >> 6), byte(0x80 | (point & 0x3F))};
    if (point < 0x10000)
        return {byte(0xE0 | point >> 12), byte(0x80 | (point >> 6 & 0x3F)), byte(0x80 | (point & 0x3F))};
    return {byte(0xF0 | point >> 18), byte(0x80 | (point >> 12 & 0x3F)), byte(0x80 | (point >> 6 & 0x3F)),
            byte(0x80 | (point & 0x3F))};
}

bool isListed(char32_t point) {
    return point < 0x20 || (point >= 0x7F && point < 0xA0) || point == 0x061C || point == 0x200E ||
           point == 0x200F || (point >= 0x2028 && point <= 0x202E) || (point >= 0x2066 && point <= 0x2069);
}

TEST(PlainText, AllOfUnicodeButControlsStaysAsItIs) {
    for (char32_t point = 0; point < 0x110000; ++point) {
        if (point >= 0xD800 && point < 0xE000) continue; // no characters
        const std::string character = utf8(point), around = "a" + character + "z";
        if (isListed(point)) {
            ASSERT_EQ(rtcore::controlCode(character), static_cast<unsigned>(point));
            ASSERT_EQ(rtcore::withoutControls(around, 9), "az") << static_cast<unsigned>(point);
            ASSERT_EQ(rtcore::printable(around).substr(0, 3), "a\\x") << static_cast<unsigned>(point);
            ASSERT_EQ(rtcore::printable(around).find(character), std::string::npos);
        } else {
            ASSERT_FALSE(rtcore::controlCode(character)) << static_cast<unsigned>(point);
            ASSERT_EQ(rtcore::withoutControls(around, 9), around);
            ASSERT_EQ(rtcore::printable(around), around);
        }
    }
}

TEST(PlainText, ADirectionCannotBeTurned) {
    EXPECT_EQ(rtcore::printable("a\u202Egpj.exe"), "a\\xe2\\x80\\xaegpj.exe");
    EXPECT_EQ(rtcore::inQuotes("\u2066x\u2069"), "'\\xe2\\x81\\xa6x\\xe2\\x81\\xa9'");
    EXPECT_EQ(rtcore::printable("\u05D0\u200Cb\u200D"), "\u05D0\u200Cb\u200D") << "joiners are letters' own";
}

TEST(PlainText, WhatIsNoTextIsLeftOutAndCharactersAreCounted) {
    EXPECT_EQ(rtcore::withoutControls("a\xFF\xC3(\xE2\x80", 9), "a(");
    EXPECT_EQ(rtcore::withoutControls("\u00e4\u202e\u00f6\u00fc", 2), "\u00e4\u00f6");
    EXPECT_EQ(rtcore::withoutControls("", 5), "");
    EXPECT_EQ(rtcore::withoutControls("abc", 0), "");
}

} // namespace
