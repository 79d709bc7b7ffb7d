#include "rtcore/look/room_lights.h"

#include "support/rooms.h"

#include "rtcore/kernels/single_ray.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using rtcore::Light;
using rtcore::Vec3;

std::vector<Light> lightsOf(const test::TracedScene& s) {
    return rtcore::roomLights(s.tree, s.scene.mesh(),
                              rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes({0, 1, 0})));
}

TEST(RoomLights, HangBelowTheCeilingAndReachTheFloor) {
    const test::TracedScene s(test::room().finish());
    const std::vector<Light> lights = lightsOf(s);
    ASSERT_GE(lights.size(), 1U);
    EXPECT_LE(lights.size(), static_cast<std::size_t>(rtcore::kMaxRoomLights));
    for (const Light& light : lights) {
        EXPECT_EQ(light.kind, rtcore::LightKind::Sphere);
        EXPECT_GT(light.position.y, 0) << "in the upper half";
        EXPECT_LT(light.position.y + light.radius, 2);
        EXPECT_FALSE(rtcore::occluded(
            s.tree, s.scene.mesh(),
            {light.position, 0, Vec3{light.position.x, -1.99F, light.position.z} - light.position, 1}));
    }
}

TEST(RoomLights, LightTheFloorOfEachPlaceToAboutOne) {
    const test::TracedScene s(test::room().finish());
    const std::vector<Light> lights = lightsOf(s);
    float sum = 0;
    int count = 0;
    for (float x = -4; x <= 4; x += 2) {
        for (float z = -2; z <= 2; z += 2, ++count) {
            for (const Light& light : lights) {
                const Vec3 toLight = light.position - Vec3{x, -2, z};
                sum += light.intensity.r / dot(toLight, toLight);
            }
        }
    }
    EXPECT_GT(sum / static_cast<float>(count), 0.5F);
    EXPECT_LT(sum / static_cast<float>(count), 2.5F);
}

TEST(RoomLights, AreNotForObjectsNorForCourts) {
    EXPECT_TRUE(lightsOf(test::TracedScene(test::block().finish())).empty());
    EXPECT_TRUE(lightsOf(test::TracedScene(test::room(true).finish())).empty());
}

TEST(RoomLights, AreMoreInALongHallThanInAShortOne) {
    test::SceneBuilder rooms = test::room();
    const test::TracedScene shortOne(rooms.finish());
    test::SceneBuilder hall;
    const std::uint32_t white = hall.material(test::matte(0.7F));
    const float l = 60;
    hall.quad({-l, -2, 4}, {l, -2, 4}, {l, -2, -4}, {-l, -2, -4}, white);
    hall.quad({-l, 2, -4}, {l, 2, -4}, {l, 2, 4}, {-l, 2, 4}, white);
    hall.quad({-l, -2, -4}, {l, -2, -4}, {l, 2, -4}, {-l, 2, -4}, white);
    hall.quad({l, -2, 4}, {-l, -2, 4}, {-l, 2, 4}, {l, 2, 4}, white);
    hall.quad({-l, -2, 4}, {-l, -2, -4}, {-l, 2, -4}, {-l, 2, 4}, white);
    hall.quad({l, -2, -4}, {l, -2, 4}, {l, 2, 4}, {l, 2, -4}, white);
    const test::TracedScene longOne(hall.finish());
    EXPECT_EQ(lightsOf(longOne).size(), static_cast<std::size_t>(rtcore::kMaxRoomLights));
    EXPECT_LT(lightsOf(shortOne).size(), lightsOf(longOne).size());
}

} // namespace
