/// Texts cut between characters of UTF-8.
#include "rtcore/settings/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using rtcore::utf8Beginning;

TEST(Utf8Beginning, HasWholeCharactersOfAtMostSoManyBytes) {
    const std::string text = "a\u00E9\u20AC\U0001F600z"; // 1, 2, 3, 4 and 1 bytes
    const std::size_t ends[] = {0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 11};
    for (std::size_t max = 0; max < 12; ++max)
        EXPECT_EQ(utf8Beginning(text, max), text.substr(0, ends[max])) << max;
    EXPECT_EQ(utf8Beginning(text, 1000), text);
    EXPECT_EQ(utf8Beginning("", 0), "");
}

TEST(Utf8Beginning, EndsWithWhatIsNoUtf8) {
    EXPECT_EQ(utf8Beginning("\x80\x80\x80", 2), "");
    EXPECT_EQ(utf8Beginning("ab\xFF\xFF", 3), "ab\xFF");
}

} // namespace
