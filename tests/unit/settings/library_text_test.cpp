#include "rtcore/settings/library_text.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace {

using rtcore::LibraryText;

constexpr std::array kKnown{LibraryText{"{0}: CRC error", "the checksum of {0} is wrong"},
                            LibraryText{"expected '{0}', saw '{1}'", "{1} is no {0}"},
                            LibraryText{"saw {0}", "something is wrong"}};

std::string meaning(const std::string& text) { return rtcore::meaningOf(text, kKnown).english(); }

TEST(LibraryText, IsSaidInOurWords) {
    EXPECT_EQ(meaning("IDAT: CRC error"), "the checksum of IDAT is wrong");
    EXPECT_EQ(meaning("expected 'a', saw 'b'"), "b is no a");
    EXPECT_EQ(meaning("saw nothing"), "something is wrong");
    EXPECT_TRUE(rtcore::meaningOf("saw nothing", kKnown).isForm());
}

TEST(LibraryText, IsQuotedWhereItIsNotKnown) {
    EXPECT_EQ(meaning("line 3\nis odd"), "a library says \"line 3\\x0ais odd\"");
    EXPECT_EQ(meaning(""), "a library says \"\"");
    EXPECT_EQ(rtcore::meaningOf("saw nothing", {}).english(), "a library says \"saw nothing\"");
}

TEST(LibraryText, IsBounded) {
    EXPECT_LT(meaning(std::string(100'000, 'x') + ": CRC error").size(), 200U);
    EXPECT_LT(meaning(std::string(100'000, 'x')).size(), 400U);
}

} // namespace
