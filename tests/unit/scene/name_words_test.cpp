// How names of materials and parts are split.
#include "rtcore/scene/name_words.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rtcore {
namespace {

using Words = std::vector<std::string>;

TEST(NameWords, AreRunsOfLettersInLowerCase) {
    EXPECT_EQ(nameWords("Wall_02.Brick"), (Words{"wall", "brick"}));
    EXPECT_EQ(nameWords("groundFloor"), (Words{"ground", "floor"}));
    EXPECT_EQ(nameWords("GLASS"), (Words{"glass"}));
}

TEST(NameWords, HaveNoMarks) {
    EXPECT_EQ(nameWords("Fen\xC3\xAAtre_\xC3\x89tage2").front(), "fenetre");
    EXPECT_EQ(nameWords("p\xC5\x99\xC3\xAD\xC4\x8Dka"), (Words{"pricka"}));
}

TEST(NameWords, AreAtLeastOne) {
    EXPECT_EQ(nameWords("").size(), 1U);
    EXPECT_GE(nameWords("\xE6\xB0\xB4\xC3").size(), 1U) << "other letters, and one that is cut off";
}

} // namespace
} // namespace rtcore
