#include "cui/argument_order.h"
#include "cui/cui_spec.h"

#include "common/cli/command_line.h"

#include <gtest/gtest.h>

namespace {

using Words = std::vector<std::string>;

Words ordered(const Words& words) { return cui::optionsFirst(cui::cuiSpec(), words); }

TEST(ArgumentOrder, NegativeNumbersAreArguments) {
    EXPECT_EQ(ordered({"camera", "turn", "-5", "-.5e1"}), (Words{"--", "camera", "turn", "-5", "-.5e1"}));
}

TEST(ArgumentOrder, OptionsMayStandAnywhere) {
    EXPECT_EQ(ordered({"-i", "cow", "status", "--json", "--timeout", "3"}),
              (Words{"-i", "cow", "--json", "--timeout", "3", "--", "status"}));
    EXPECT_EQ(ordered({"--instance=cow", "ping"}), (Words{"--instance=cow", "--", "ping"}));
    EXPECT_EQ(ordered({"--help"}), Words{"--help"});
    EXPECT_EQ(ordered({}), Words{});
}

TEST(ArgumentOrder, AfterTwoDashesNothingIsAnOption) {
    EXPECT_EQ(ordered({"--json", "--", "screenshot", "--instance"}),
              (Words{"--json", "--", "screenshot", "--instance"}));
}

TEST(ArgumentOrder, AloneADashIsAnArgument) {
    EXPECT_EQ(ordered({"script", "-"}), (Words{"--", "script", "-"}));
}

} // namespace
