// Light that commands measure.
#include "command_room.h"

#include "rtserver/document/light_grid.h"
#include "rtserver/document/measuring.h"

#include "rtcore/platform/error.h"

#include "support/rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {
namespace {

/// By the two lights of the room, straight below the first, W/m^2; what the box sends back is little.
const double kBelow = 20.0 / 16 + 20.0 * 4 / 125;

class MeasureCommands : public test::CommandRoom {
  protected:
    std::vector<std::string> lines(const std::string& command) {
        std::vector<std::string> all;
        std::istringstream text(answer(command));
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    }
    /// 12 x 4 x 8 around the origin, with a cupboard, a table and a piece of wall up to the ceiling, and one
    /// light.
    void showFurnishedRoom() {
        test::SceneBuilder b = test::room();
        const std::uint32_t wood = b.material(test::matte(0.3F));
        b.box({1, -2, 1}, {2, -0.5F, 2}, wood);
        b.box({-3, -2, 1}, {-2, -1.3F, 2}, wood);
        b.box({-5.5F, -2, -4}, {-5, 2, -1}, wood);
        constexpr float kX0 = 3.1F, kX1 = 3.9F, kZ0 = -2.9F, kZ1 = -2.1F; // a pillar without ends
        b.quad({kX0, -2, kZ0}, {kX0, -2, kZ1}, {kX0, 2, kZ1}, {kX0, 2, kZ0}, wood);
        b.quad({kX1, -2, kZ1}, {kX1, -2, kZ0}, {kX1, 2, kZ0}, {kX1, 2, kZ1}, wood);
        b.quad({kX0, -2, kZ1}, {kX1, -2, kZ1}, {kX1, 2, kZ1}, {kX0, 2, kZ1}, wood);
        b.quad({kX1, -2, kZ0}, {kX0, -2, kZ0}, {kX0, 2, kZ0}, {kX1, 2, kZ0}, wood);
        b.scene.lights = {{test::pointLight({0, 1, 0}, 2), "bulb"}};
        rtcore::LoadedScene room;
        room.scene = b.finish();
        room.scene.ambient = room.scene.background = {};
        room.tree = rtcore::buildKdTree(room.scene.mesh(), {});
        room.camera.eye = {0, -0.4F, 0};
        room.camera.forward = {0, 0, -1};
        room.modelPath = "/rooms/furnished.obj";
        document.show(test::worldOf(std::move(room)));
    }
};

/// The number behind the first word.
double numberIn(const std::string& line) { return std::strtod(line.c_str() + line.find(' '), nullptr); }

TEST_F(MeasureCommands, LightAtAPointIsInLux) {
    answer("environment none");
    const auto all = lines("measure light at 0 0 0");
    ASSERT_EQ(all.size(), 1U) << "lights of a scene are in watts";
    EXPECT_TRUE(all[0].starts_with("illuminance ")) << all[0];
    EXPECT_NE(all[0].find(" lx, standard error "), std::string::npos) << all[0];
    EXPECT_NEAR(numberIn(all[0]), 683 * kBelow, 0.03 * 683 * kBelow);
    EXPECT_NEAR(numberIn(lines("measure light at 0 0 0 0 1 0")[0]), numberIn(all[0]), 0.01);
    EXPECT_LT(numberIn(lines("measure light at 0 0 0 0 -1 0")[0]), 1) << "below the floor";
    EXPECT_EQ(refusal("measure light at 0 0 0 0 0 0").text, "the normal is not zero");
    EXPECT_EQ(refusal("measure light at 0 0 0 1").code, 2);
}

TEST_F(MeasureCommands, PathsAreCounted) {
    answer("camera set 0 2 0 0 -1 0 60 0 0 -1");
    const auto errorIn = [](const std::string& line) {
        return std::strtod(line.c_str() + line.rfind(' '), nullptr);
    };
    const auto few = lines("measure light 0.3 0.3 8192"), all = lines("measure light 0.3 0.3 65536");
    EXPECT_GT(errorIn(few[0]), errorIn(all[0]));
    EXPECT_NEAR(numberIn(few[0]), numberIn(all[0]), 5 * errorIn(few[0]));
    EXPECT_EQ(refusal("measure light 0.3 0.3 0").code, 2);
}

TEST_F(MeasureCommands, LightOnWhatIsSeenHasALuminance) {
    answer("camera set 0 2 0 0 -1 0 60 0 0 -1");
    answer("environment none");
    const auto all = lines("measure light 0.5 0.5");
    ASSERT_EQ(all.size(), 3U);
    EXPECT_TRUE(all[1].starts_with("luminance ")) << all[1];
    EXPECT_NEAR(numberIn(all[1]), numberIn(all[0]) * 0.5 / test::kPi, 0.02 * numberIn(all[1]))
        << "the floor scatters half";
    EXPECT_TRUE(all[2].starts_with("at ")) << all[2];
    answer("camera set 0 2 0 0 1 0 60 0 0 -1");
    const auto sky = lines("measure light 0.5 0.5");
    ASSERT_EQ(sky.size(), 1U);
    EXPECT_EQ(sky[0], "luminance 0.00 cd/m2, standard error 0.00");
}

TEST_F(MeasureCommands, WhatHasNoUnitIsNamed) {
    EXPECT_EQ(lines("measure light at 0 0 0").back(),
              "of the light of this scene this has no absolute unit: the environment noon");
    answer("light 1 off");
    answer("light 2 off");
    EXPECT_EQ(lines("measure light at 0 0 0").back(),
              "the light of this scene has no absolute unit: the environment noon");
}

TEST_F(MeasureCommands, SkyAndOtherLightAreApart) {
    answer("sky direction 1 2 1");
    const auto all = lines("measure light at 0 0 0");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_TRUE(all[1].ends_with(" lx of other light")) << all[1];
    const std::size_t comma = all[1].find(", ");
    ASSERT_NE(comma, std::string::npos);
    const double other = std::strtod(all[1].c_str() + comma + 2, nullptr), sky = numberIn(all[1]);
    EXPECT_NEAR(other, 683 * kBelow, 0.03 * 683 * kBelow) << "whatever the sky's unit is";
    EXPECT_GT(sky, 50'000) << "the sun shines";
    EXPECT_LT(sky, 130'000);
    EXPECT_NEAR(numberIn(all[0]), sky + other, 1);
}

TEST_F(MeasureCommands, OneAtATimeWhichIsGivenUp) {
    Result first = run("measure light at 0 0 0");
    EXPECT_EQ(first.when, ReplyWhen::Apart);
    EXPECT_EQ(answer("measure progress"), "on 0 %");
    EXPECT_EQ(refusal("measure light 0.5 0.9").code, 75);
    answer("measure stop");
    EXPECT_TRUE(*first.stop);
    const Finish finish = first.work();
    EXPECT_THROW(finish(), rtcore::FileError);
    EXPECT_EQ(answer("measure progress"), "off");
    EXPECT_FALSE(answer("measure light at 0 0 0").empty()) << "the next one may begin";
    answer("measure stop");
}

TEST_F(MeasureCommands, AGridIsATable) {
    showFurnishedRoom();
    EXPECT_EQ(refusal("measure light grid DIR/b.csv").text,
              "HEIGHT and SPACING are metres, but the unit of the model is a guess; say it first, as by "
              "'units m'");
    answer("units m");
    EXPECT_TRUE(answer("measure light grid DIR/b.csv 0.85 1.5").starts_with("38 points, mean "));
    std::ifstream file(folder / "b.csv");
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "x,y,z,lux,standard_error");
    int points = 0;
    while (std::getline(file, line)) {
        std::vector<double> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        ASSERT_EQ(row.size(), 5U) << line;
        EXPECT_NEAR(row[1], -1.15, 1e-5);
        const double direct = 683 * 2 * 2.15 / std::pow(row[0] * row[0] + 2.15 * 2.15 + row[2] * row[2], 1.5);
        EXPECT_GT(row[3], row[0] < 0 ? direct : 0) << line << ": walls add to it, but beside the cupboard";
        EXPECT_LT(row[4], 0.021 * row[3]);
        ++points;
    }
    EXPECT_EQ(points, 38);
}

TEST_F(MeasureCommands, AGridIsWrittenWhereItMay) {
    showFurnishedRoom();
    answer("units m");
    document.addInput(folder / "a.cam");
    EXPECT_EQ(refusal("measure light grid DIR/a.cam 0.85 4").code, 2);
    EXPECT_EQ(refusal("measure light grid b.csv").text, "the path 'b.csv' is not absolute");
    EXPECT_NE(refusal("measure light grid DIR/none/b.csv 0.85 4").code, 0);
    Result given = run("measure light grid DIR/c.csv 0.85 4");
    answer("measure stop");
    EXPECT_THROW(given.work()(), rtcore::FileError);
    EXPECT_FALSE(exists("c.csv"));
}

TEST_F(MeasureCommands, PointsOfAGridAreOverTheFloorAndInNoSolid) {
    showFurnishedRoom();
    const auto points = gridPoints(measuredScene(document), {.eye = {0, -0.4F, 0}});
    EXPECT_EQ(points.size(), 24U * 16 - 4 - 6 - 4)
        << "cupboard and pillar have four each, the wall six, and the table is below";
    for (const rtcore::WhitePoint& point : points) {
        EXPECT_FLOAT_EQ(point.position.y, -1.15F);
        EXPECT_EQ(point.normal, (rtcore::Vec3{0, 1, 0}));
        const bool inCupboard =
            std::fabs(point.position.x - 1.5F) < 0.5F && point.position.z > 1 && point.position.z < 2;
        EXPECT_FALSE(inCupboard);
    }
    EXPECT_EQ(gridPoints(measuredScene(document), {.eye = {-2.5F, -0.4F, 1.5F}, .height = 0.1}).size(), 4U)
        << "on the table, whose top is no storey of the room";
    const auto problem = [&](const GridRequest& request) {
        try {
            gridPoints(measuredScene(document), request);
        } catch (const rtcore::Refusal& refusal) {
            return std::string(refusal.what());
        }
        return std::string();
    };
    EXPECT_EQ(problem({.eye = {0, -5, 0}}), "there is no floor below the viewpoint");
    EXPECT_EQ(problem({.eye = {0, 0, 0}, .height = 5}),
              "no point of the grid lies over the floor below the viewpoint");
    EXPECT_EQ(problem({.eye = {0, 0, 0}, .spacing = 0.01}),
              "the grid would have more than 20000 points; give a larger SPACING");
}

} // namespace
} // namespace rtserver
