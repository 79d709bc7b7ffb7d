// Commands that measure the room: a floor of 20 x 20, and a box from (-0.5, 0, -3) to (0.5, 1, -2).
#include "command_room.h"

#include <gtest/gtest.h>

#include <string>

namespace rtserver {
namespace {

class DimensionCommands : public test::CommandRoom {
  protected:
    void SetUp() override {
        CommandRoom::SetUp();
        answer("units m");
        answer("camera orthographic 0 0.5 3 0 0 -1 4"); // 4 m wide, upright to the front of the box
    }
    /// Of an image of four thirds, as RIGHT and DOWN.
    static std::string at(double x, double y) {
        return std::to_string(0.5 + x / 4) + " " + std::to_string(0.5 - (y - 0.5) / 3);
    }
    std::string beginning(const std::string& command, std::size_t size) {
        return answer(command).substr(0, size);
    }
};

TEST_F(DimensionCommands, CatchCornersMiddlesEdgesAndFaces) {
    answer("resolution 400 300");
    EXPECT_EQ(answer("measure point " + at(0.49, 0.98)), "corner 0.5 1 -2");
    EXPECT_EQ(answer("measure point " + at(0.01, 0.99)), "middle 0 1 -2");
    EXPECT_EQ(beginning("measure point " + at(0.49, 0.8), 9), "edge 0.5 ");
    EXPECT_EQ(beginning("measure point " + at(0.2, 0.4), 5), "face ");
    EXPECT_EQ(refusal("measure point " + at(1.5, 1.5)).code, 1);
}

TEST_F(DimensionCommands, TellDistances) {
    answer("resolution 400 300");
    EXPECT_EQ(answer("measure seen " + at(-0.5, 1) + " " + at(0.5, 0)),
              "corner -0.5 1 -2\ncorner 0.5 0 -2\ndistance 1.41421 m\nlevel 1 m\nheight -1 m");
    EXPECT_EQ(answer("measure distance 0 0 0 3 4 0"), "distance 5 m\nlevel 3 m\nheight 4 m");
    answer("units mm");
    EXPECT_EQ(answer("measure distance 0 0 0 3 4 0"), "distance 0.005 m\nlevel 0.003 m\nheight 0.004 m");
    answer("units auto");
    EXPECT_NE(answer("measure distance 0 0 0 3 4 0").find("\nthe unit is a guess"), std::string::npos);
}

TEST_F(DimensionCommands, TellAngles) {
    EXPECT_EQ(answer("measure angle 1 0 0 0 0 0 0 2 0"), "angle 90 degrees");
    EXPECT_EQ(answer("measure angle 1 0 0 0 0 0 1 0 1"), "angle 45 degrees");
    EXPECT_EQ(answer("measure angle 1 0 0 0 0 0 -7 0 0"), "angle 180 degrees");
    EXPECT_EQ(refusal("measure angle 1 0 0 1 0 0 2 0 0").code, 1);
}

TEST_F(DimensionCommands, TellFaces) {
    answer("resolution 400 300");
    EXPECT_EQ(answer("measure face " + at(0.2, 0.4)).substr(0, 9), "area 1 m2");
    EXPECT_NE(answer("measure face " + at(0.2, 0.4)).find("\nabove 0.4"), std::string::npos)
        << answer("measure face " + at(0.2, 0.4));
}

TEST_F(DimensionCommands, TellVolumesOfClosedParts) {
    EXPECT_EQ(answer("measure volume box"), "volume 1 m3");
    EXPECT_EQ(answer("measure volume 1"), "volume 1 m3");
    EXPECT_EQ(refusal("measure volume chair").code, 2);
}

} // namespace
} // namespace rtserver
