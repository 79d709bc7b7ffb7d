// Commands for storeys and drawings, on the room.
#include "command_room.h"

#include "common/commands/outline_text.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using PlanCommands = test::CommandRoom;

TEST_F(PlanCommands, DrawAndTellWhatWasFound) {
    EXPECT_EQ(refusal("plan DIR/a.svg").code, 1) << "the unit is a guess";
    EXPECT_NE(refusal("plan DIR/a.svg").text.find("'units'"), std::string::npos);
    answer("units 2"); // the box is 2 m high
    EXPECT_EQ(run("plan DIR/a.svg").when, ReplyWhen::Apart);
    EXPECT_NE(answer("plan DIR/a.svg above 100 A1 0 0.5").find("storey 1 of 1"), std::string::npos);
    EXPECT_TRUE(exists("a.svg"));
    answer("plan DIR/a.dxf front");
    EXPECT_TRUE(exists("a.dxf"));
    answer("section add 0 0.5 0 0 0 1");
    answer("plan DIR/a.pdf section 20");
    EXPECT_TRUE(exists("a.pdf"));
}

TEST_F(PlanCommands, ThatAreGivenUpWriteNothing) {
    answer("units m");
    const Result result = run("plan DIR/a.svg");
    ASSERT_TRUE(result.stop);
    result.stop->store(true);
    EXPECT_THROW(result.work()(), rtcore::Refusal);
    EXPECT_FALSE(exists("a.svg"));
}

TEST_F(PlanCommands, ThatCannotBeAreRefused) {
    answer("units m");
    EXPECT_EQ(refusal("plan a.svg").code, 2) << "no absolute path";
    EXPECT_EQ(refusal("plan DIR/a.jpg").code, 2);
    EXPECT_EQ(refusal("plan DIR/a.svg below").code, 2);
    EXPECT_EQ(refusal("plan DIR/a.svg above 0").code, 2);
    EXPECT_EQ(refusal("plan DIR/none/a.svg").code, 73);
    EXPECT_EQ(refusal("plan DIR/a.svg above 100 sheet 7").code, 1);
    EXPECT_EQ(refusal("storey go 7").code, 1);
}

TEST_F(PlanCommands, GoToAStorey) {
    EXPECT_EQ(answer("storeys"), "") << "nobody could stand below the top of the box";
    answer("units 2");
    const std::string all = answer("storeys");
    ASSERT_EQ(all.substr(0, 8), "1 0.000 ") << all;
    answer("storey go 1");
    EXPECT_FLOAT_EQ(document.camera().eye.y, 0.8F);
    EXPECT_FLOAT_EQ(document.camera().eye.z, 3) << "where it was";
    EXPECT_EQ(document.history().last()->label, "storey go 1");
}

// The unit is a guess, which a plan without a scale does not need.
TEST_F(PlanCommands, OutlineTheStoreyOfTheCamera) {
    EXPECT_EQ(app::parseOutline(answer("plan outline")).storey, 0) << "there is none";
    EXPECT_EQ(refusal("plan outline 1").code, 1);
    answer("units 2");
    const app::ToldOutline outline = app::parseOutline(answer("plan outline"));
    EXPECT_EQ(outline.storey, 1);
    EXPECT_EQ(outline.floors, std::vector<double>{0});
    EXPECT_DOUBLE_EQ(outline.top, 1);
    EXPECT_NEAR(outline.eyeHeight, 0.8, 1e-6);
    // The box is cut at 0.6 of its own height, and lower once more.
    ASSERT_EQ(outline.solids.size(), 1U);
    EXPECT_EQ(outline.solids[0].size(), 5U);
    EXPECT_EQ(outline.size, (std::array<int, 2>{2000, 2000}));
    EXPECT_NEAR(outline.step, 1.0 / 2000, 1e-9);
    EXPECT_NEAR(outline.corner[0], -0.5, 1e-6);
    EXPECT_NEAR(outline.corner[1], 0, 1e-6);
    EXPECT_NEAR(outline.corner[2], -2, 1e-6) << "nearest to the viewer";
    EXPECT_EQ(outline.right, (std::array<float, 3>{1, 0, 0}));
    EXPECT_EQ(outline.ahead, (std::array<float, 3>{0, 0, -1}));
    EXPECT_EQ(answer("plan outline 1"), app::formatOutline(outline));
}

TEST_F(PlanCommands, OutlinesAreOfWhatIsShown) {
    answer("units 2");
    EXPECT_FALSE(app::parseOutline(answer("plan outline")).solids.empty());
    answer("part hide box");
    const app::ToldOutline without = app::parseOutline(answer("plan outline"));
    EXPECT_TRUE(without.solids.empty() && without.light.empty());
    EXPECT_EQ(without.size, (std::array<int, 2>{0, 0}));
    answer("part show-all");
    EXPECT_FALSE(app::parseOutline(answer("plan outline")).solids.empty());
    answer("units 0.5");
    EXPECT_EQ(app::parseOutline(answer("plan outline")).storey, 0) << "too low to stand below its top";
}

TEST_F(PlanCommands, OutlinesAreGivenUpAndFoundAgain) {
    answer("units 2");
    const Result result = run("plan outline");
    EXPECT_EQ(result.when, ReplyWhen::Apart);
    result.stop->store(true);
    EXPECT_THROW(result.work()(), rtcore::Refusal);
    EXPECT_FALSE(app::parseOutline(answer("plan outline")).solids.empty());
}

} // namespace
} // namespace rtserver
