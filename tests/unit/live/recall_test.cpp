#include "rtcore/live/recall.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

struct Asked {
    Vec3 position, normal;
    float depth = 0;
};

/// A wall across the view, 10 before the eye, each pixel with light of its own.
class Wall : public testing::Test {
  protected:
    static constexpr int kWidth = 40, kHeight = 30;

    Wall() {
        past.plane = planeFrom({});
        past.points.resize(kWidth * kHeight);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) past.at(x, y) = pointOf(x, y);
        }
    }
    static ImagePlane planeFrom(Vec3 eye) {
        Camera camera;
        camera.eye = eye;
        return {CameraRays(camera, kWidth, kHeight), kWidth, kHeight};
    }
    static std::uint32_t lightOf(int x, int y) {
        return packLight({static_cast<float>(x), static_cast<float>(y), 1});
    }
    static LivePoint pointOf(int x, int y) {
        LivePoint point;
        point.depth = 10;
        point.normal = packNormal({0, 0, 1});
        point.light = lightOf(x, y);
        point.flags = LivePoint::kLit;
        return point;
    }
    /// Of the pixel as a camera there would see the wall.
    Asked seenFrom(Vec3 eye, float x, float y) const {
        const ImagePlane plane = planeFrom(eye);
        const Vec3 towards = plane.towards(x, y);
        const float depth = (-10 - eye.z) / towards.z;
        return {eye + towards * depth, {0, 0, 1}, dot(plane.axis, towards * depth)};
    }

    bool recallLight(const LiveImage& from, const Asked& asked, LivePoint& to) {
        ask(from, asked);
        return recalled.takeLight(from, 0, to);
    }
    bool wasSeen(const LiveImage& from, const Asked& asked) {
        ask(from, asked);
        return recalled.wasSeen(0);
    }

    LiveImage past;
    LivePoint point;

  private:
    void ask(const LiveImage& from, const Asked& asked) {
        points.clear();
        points.push(asked.position, asked.normal, asked.depth);
        recalled.recall(from, points);
    }
    AskedPoints points;
    RecalledPoints recalled;
};

TEST_F(Wall, AStillCameraRecallsEachPixelsOwnLight) {
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            point = {};
            const Asked asked = seenFrom({}, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            ASSERT_TRUE(recallLight(past, asked, point));
            EXPECT_EQ(point.light, lightOf(x, y));
            EXPECT_EQ(point.across, 0);
            EXPECT_EQ(point.down, 0);
            EXPECT_EQ(point.age, 1);
        }
    }
}

TEST_F(Wall, LightKeepsWhereItIsFrom) {
    ASSERT_TRUE(recallLight(past, seenFrom({}, 10.75F, 7.25F), point));
    EXPECT_EQ(point.light, lightOf(10, 7));
    EXPECT_NEAR(point.across / kOffsetSteps, -0.25F, 0.02F);
    EXPECT_NEAR(point.down / kOffsetSteps, 0.25F, 0.02F);
    // A neighbour whose light is from here is nearer than the pixel's own.
    past.at(11, 7).across = static_cast<std::int8_t>(-0.75F * kOffsetSteps);
    past.at(11, 7).down = static_cast<std::int8_t>(-0.25F * kOffsetSteps);
    ASSERT_TRUE(recallLight(past, seenFrom({}, 10.75F, 7.25F), point));
    EXPECT_EQ(point.light, lightOf(11, 7));
    EXPECT_NEAR(point.across, 0, 1);
}

TEST_F(Wall, OfAMovingCameraTheWorldStandsStill) {
    const Vec3 eye{0.4F, -0.2F, -1};
    const Asked asked = seenFrom(eye, 20.5F, 15.5F);
    ASSERT_TRUE(recallLight(past, asked, point));
    const ImagePlane::Position at = past.plane.find(asked.position);
    EXPECT_EQ(point.light, lightOf(static_cast<int>(at.x), static_cast<int>(at.y)));
    EXPECT_TRUE(wasSeen(past, asked));
}

TEST_F(Wall, AnotherSurfaceKnowsNothing) {
    Asked asked = seenFrom({}, 20.5F, 15.5F);
    asked.position = asked.position * 0.5F; // before the wall
    EXPECT_FALSE(recallLight(past, asked, point));
    EXPECT_FALSE(wasSeen(past, asked));
    asked = seenFrom({}, 20.5F, 15.5F);
    asked.normal = {1, 0, 0}; // where two walls meet
    EXPECT_FALSE(recallLight(past, asked, point));
    asked = {past.plane.towards(20.5F, 15.5F), {}, LivePoint::kFar};
    EXPECT_FALSE(recallLight(past, asked, point)) << "the background is not a wall";
    EXPECT_FALSE(recallLight(past, seenFrom({}, -3, 15), point)) << "outside the image";
    EXPECT_EQ(point.flags, 0);
}

TEST_F(Wall, TheBackgroundIsRecalledByItsDirection) {
    for (LivePoint& p : past.points) p.depth = LivePoint::kFar;
    const Asked asked{past.plane.towards(20.5F, 15.5F), {}, LivePoint::kFar};
    ASSERT_TRUE(recallLight(past, asked, point));
    EXPECT_EQ(point.light, lightOf(20, 15));
}

TEST_F(Wall, WhatIsNotLitIsNotRecalled) {
    for (LivePoint& p : past.points) p.flags = 0;
    EXPECT_FALSE(recallLight(past, seenFrom({}, 20.5F, 15.5F), point));
    EXPECT_TRUE(wasSeen(past, seenFrom({}, 20.5F, 15.5F)));
}

TEST_F(Wall, AgeEndsAtItsMost) {
    past.at(20, 15).age = 255;
    ASSERT_TRUE(recallLight(past, seenFrom({}, 20.5F, 15.5F), point));
    EXPECT_EQ(point.age, 255);
}

} // namespace
} // namespace rtcore
