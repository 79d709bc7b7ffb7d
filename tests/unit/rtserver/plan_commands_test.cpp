// Commands for storeys and drawings, on the room.
#include "command_room.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

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

} // namespace
} // namespace rtserver
