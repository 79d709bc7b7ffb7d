/// Poses: which are asked for, values between keys, and vertices that joints move, against closed forms.
#include "rtcore/io/import/pose/animation_choice.h"
#include "rtcore/io/import/pose/key_frames.h"
#include "rtcore/io/import/pose/vertex_joints.h"
#include "rtcore/platform/error.h"
#include "rtcore/scene/pose_choice.h"
#include "unit/import/import_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using rtcore::Affine;
using rtcore::JointWeight;
using rtcore::KeyInterval;
using rtcore::PoseChoice;
using rtcore::readPose;
using rtcore::Rotation;
using rtcore::Vec3;
using test::near;

constexpr double kQuarter = std::numbers::pi / 2;

TEST(PoseChoice, IsReadAndWritten) {
    EXPECT_EQ(readPose("rest"), PoseChoice{});
    EXPECT_EQ(readPose("first")->kind, PoseChoice::Kind::First);
    const PoseChoice moment{PoseChoice::Kind::Moment, "a@b", -0.25};
    EXPECT_EQ(readPose("a@b@-0.25"), moment);
    EXPECT_EQ(readPose(poseText(moment)), moment);
    for (const char* const none :
         {"", "Rest", "walk", "@1", "walk@", "walk@x", "walk@1s", "walk@inf", "walk@nan"})
        EXPECT_FALSE(readPose(none)) << none;
}

std::string refusalOf(const std::string& pose, const std::vector<std::string>& names) {
    rtcore::ImportReport report;
    try {
        rtcore::animationOf(*readPose(pose), names, report);
    } catch (const rtcore::FileError& error) {
        return error.what();
    }
    return "";
}

TEST(AnimationChoice, IsByNameThenByNumber) {
    const std::vector<std::string> names{"Walk", "", "1"};
    rtcore::ImportReport report;
    const auto chosen = [&](const char* pose) { return rtcore::animationOf(*readPose(pose), names, report); };
    EXPECT_EQ(chosen("rest"), std::nullopt);
    EXPECT_EQ(chosen("first"), 0U);
    EXPECT_EQ(chosen("Walk@3"), 0U);
    EXPECT_EQ(chosen("2@0"), 1U);
    EXPECT_EQ(chosen("1@0"), 2U) << "a name goes first";
    EXPECT_TRUE(report.warnings.empty());
    const std::string text = refusalOf("Run@0", names);
    EXPECT_NE(text.find("'Run'"), std::string::npos) << text;
    EXPECT_NE(text.find("1 'Walk', 2, 3 '1'"), std::string::npos) << text;
    EXPECT_NE(refusalOf("0@0", names), "");
    EXPECT_NE(refusalOf("4@0", names), "");
    EXPECT_NE(refusalOf("1@0", {}), "");
    EXPECT_EQ(rtcore::animationOf(*readPose("first"), {}, report), std::nullopt);
    EXPECT_EQ(report.warnings.size(), 1U);
}

KeyInterval intervalAt(const std::vector<double>& times, double time) {
    return rtcore::keyInterval(times.size(), time, [&](std::size_t i) { return times[i]; });
}

TEST(KeyFrames, HoldAtTheirEnds) {
    const std::vector<double> times{1, 2, 2, 4};
    EXPECT_EQ(intervalAt(times, 0).to, 0U);
    EXPECT_EQ(intervalAt(times, 9).from, 3U);
    EXPECT_EQ(intervalAt(times, 2).from, 2U) << "the last of equal ones";
    const KeyInterval between = intervalAt(times, 3.5);
    EXPECT_EQ(between.from, 2U);
    EXPECT_EQ(between.to, 3U);
    EXPECT_DOUBLE_EQ(between.part, 0.75);
    EXPECT_DOUBLE_EQ(between.length, 2);
    EXPECT_EQ(intervalAt({5}, 5).from, 0U);
}

TEST(KeyFrames, TurnAlongTheShorterArc) {
    const auto about = [](double angle) { return Rotation{0, 0, std::sin(angle / 2), std::cos(angle / 2)}; };
    for (const double sign : {1.0, -1.0}) {
        Rotation to = about(kQuarter);
        for (double& v : to) v *= sign;
        const Rotation third = rtcore::slerp(about(0), to, 1 / 3.0);
        EXPECT_NEAR(third[2], std::sin(kQuarter / 6), 1e-12);
        EXPECT_NEAR(third[3], std::cos(kQuarter / 6), 1e-12);
    }
    EXPECT_EQ(rtcore::slerp(about(1), about(1), 0.5), about(1));
}

TEST(KeyFrames, SplinesAreTheCubicOfTheirEnds) {
    // x^3 - 2 x + 1 from x = 1 to x = 3, which a cubic meets exactly.
    const auto value = [](double x) { return x * x * x - 2 * x + 1; };
    const auto slope = [](double x) { return 3 * x * x - 2; };
    for (const double part : {0.0, 0.2, 0.5, 0.9, 1.0})
        EXPECT_NEAR(rtcore::hermite(value(1), slope(1), slope(3), value(3), part, 2), value(1 + 2 * part),
                    1e-12);
}

Affine turnAboutZ(double angle, double height) {
    Affine a;
    a.m = {{{std::cos(angle), -std::sin(angle), 0, 0},
            {std::sin(angle), std::cos(angle), 0, height},
            {0, 0, 1, 0}}};
    return a;
}

TEST(VertexJoints, MeanTheirMatricesByWeight) {
    const std::vector<Affine> joints{turnAboutZ(0, 0), turnAboutZ(kQuarter, 1)};
    const std::vector<JointWeight> weights{{2, 0, 1}, {0, 1, 4}, {2, 1, 3}, {1, 0, 2}};
    const rtcore::VertexJoints list(weights, 4);
    const Affine other = turnAboutZ(0, 9);
    EXPECT_TRUE(near(list.of(0, joints, other).point({1, 0, 0}), {0, 2, 0}));
    EXPECT_TRUE(near(list.of(1, joints, other).point({1, 0, 0}), {1, 0, 0}));
    EXPECT_TRUE(near(list.of(2, joints, other).point({1, 0, 0}), {0.25F, 1.5F, 0})) << "a quarter and three";
    EXPECT_TRUE(near(list.of(3, joints, other).point({1, 0, 0}), {1, 9, 0})) << "without a joint";
}

TEST(VertexJoints, PassOverWhatIsNoWeight) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<JointWeight> weights{{0, 0, nan}, {0, 0, inf}, {0, 0, -1},
                                           {0, 0, 0},   {7, 0, 1},   {0, 1, 1}};
    const std::vector<Affine> joints{turnAboutZ(0, 5), turnAboutZ(0, 1)};
    const rtcore::VertexJoints list(weights, 1);
    EXPECT_TRUE(near(list.of(0, joints, {}).point({0, 0, 0}), {0, 1, 0}));
    const rtcore::VertexJoints none({}, 1);
    EXPECT_TRUE(none.of(0, joints, {}).identity());
}

} // namespace
