#include "rtcore/io/text/pattern.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using rtcore::matchesPattern;

TEST(Pattern, PlainNamesFitThemselvesAlone) {
    EXPECT_TRUE(matchesPattern("glass", "glass"));
    EXPECT_FALSE(matchesPattern("glass", "Glass"));
    EXPECT_FALSE(matchesPattern("glass", "glasses"));
    EXPECT_FALSE(matchesPattern("glasses", "glass"));
    EXPECT_TRUE(matchesPattern("", ""));
    EXPECT_FALSE(matchesPattern("", "a"));
    EXPECT_FALSE(matchesPattern("a", ""));
    EXPECT_TRUE(matchesPattern("a[b]", "a[b]"));
}

TEST(Pattern, StarsFitAnything) {
    EXPECT_TRUE(matchesPattern("*", ""));
    EXPECT_TRUE(matchesPattern("**", "abc"));
    EXPECT_TRUE(matchesPattern("glass*", "glass"));
    EXPECT_TRUE(matchesPattern("glass*", "glass_green"));
    EXPECT_TRUE(matchesPattern("*glass", "green glass"));
    EXPECT_TRUE(matchesPattern("*a*b*", "xxaxxbxx"));
    EXPECT_TRUE(matchesPattern("*ab", "aab"));
    EXPECT_FALSE(matchesPattern("*a*b*", "xxbxxaxx"));
    EXPECT_FALSE(matchesPattern("a*b", "abc"));
}

TEST(Pattern, QuestionMarksFitOneCharacter) {
    EXPECT_TRUE(matchesPattern("wall?", "wall1"));
    EXPECT_FALSE(matchesPattern("wall?", "wall"));
    EXPECT_FALSE(matchesPattern("wall?", "wall12"));
    EXPECT_TRUE(matchesPattern("t?r", "t\u00fcr"));
    EXPECT_TRUE(matchesPattern("?*?", "ab"));
    EXPECT_FALSE(matchesPattern("?*?", "a"));
}

/// The definition, for comparison.
bool fits(std::string_view pattern, std::string_view name) {
    if (pattern.empty()) return name.empty();
    if (pattern[0] == '*')
        return fits(pattern.substr(1), name) || (!name.empty() && fits(pattern, name.substr(1)));
    return !name.empty() && (pattern[0] == '?' || pattern[0] == name[0]) &&
           fits(pattern.substr(1), name.substr(1));
}

TEST(Pattern, AgreesWithTheDefinition) {
    std::mt19937 random(3);
    const auto word = [&](std::string_view letters, std::size_t longest) {
        std::string text;
        for (std::size_t n = random() % (longest + 1); n > 0; --n) text += letters[random() % letters.size()];
        return text;
    };
    for (int i = 0; i < 50'000; ++i) {
        const std::string pattern = word("ab*?", 6), name = word("ab", 8);
        ASSERT_EQ(matchesPattern(pattern, name), fits(pattern, name)) << pattern << " " << name;
    }
}

TEST(Pattern, ManyStarsTakeNoTime) {
    std::string pattern;
    for (int i = 0; i < 500; ++i) pattern += "a*";
    EXPECT_FALSE(matchesPattern(pattern + "b", std::string(20'000, 'a')));
}

} // namespace
