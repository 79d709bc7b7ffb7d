#include "common/commands/quoting.h"

#include "common/cli/command_line.h"

#include <gtest/gtest.h>

namespace {

using Words = std::vector<std::string>;

TEST(Words, ArePartedByBlanks) {
    EXPECT_EQ(app::splitWords("  set\tbloom 3\r\n"), (Words{"set", "bloom", "3"}));
    EXPECT_EQ(app::splitWords(""), Words{});
    EXPECT_EQ(app::splitWords(R"(a "b c" d\ e "" f"g h"i)"), (Words{"a", "b c", "d e", "", "fg hi"}));
}

TEST(Words, UnfinishedTextIsRefused) {
    EXPECT_THROW(app::splitWords("a \"b"), app::UsageError);
    EXPECT_THROW(app::splitWords("a \\"), app::UsageError);
}

TEST(Words, SurviveTheRoundTrip) {
    const Words words{"", "a b", "\"", "\\", "a\\\"b", "tab\tline\n", "plain", "/tmp/\xC3\xA4 b.png"};
    EXPECT_EQ(app::splitWords(app::joinWords(words)), words);
    EXPECT_EQ(app::joinWords(Words{"set", "bloom", "3"}), "set bloom 3");
}

} // namespace
