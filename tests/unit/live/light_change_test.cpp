#include "rtcore/live/light_change.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace rtcore {
namespace {

TEST(LightChange, OfTheSameLightsIsNone) {
    const std::vector<Light> lights = {test::pointLight({0, 4, 0}, 20), test::pointLight({3, 4, 0}, 20)};
    EXPECT_FALSE(LightChange(lights, lights).any());
    std::vector<Light> off = lights;
    off[1].on = 0;
    std::vector<Light> moved = off;
    moved[1].position = {9, 9, 9};
    EXPECT_FALSE(LightChange(off, moved).any()) << "it shines neither there nor here";
    EXPECT_TRUE(LightChange(lights, off).any());
}

TEST(LightChange, ReachesAsFarAsAThousandthOfTheLight) {
    const std::vector<Light> none, one = {test::pointLight({0, 0, 0}, 4)};
    for (const LightChange& change : {LightChange(none, one), LightChange(one, none)}) {
        // Irradiance 4 / d^2 of radiance 0.1.
        EXPECT_TRUE(change.reaches({199, 0, 0}, 0.1F));
        EXPECT_FALSE(change.reaches({0, 201, 0}, 0.1F));
        EXPECT_TRUE(change.reaches({0, 201, 0}, 0)) << "any light shows in the dark";
    }
}

TEST(LightChange, OfAPlaceReachesWhereTheLightWasAndIs) {
    const std::vector<Light> before = {test::pointLight({0, 0, 0}, 1)},
                             now = {test::pointLight({99, 0, 0}, 1)};
    const LightChange change(before, now);
    EXPECT_TRUE(change.reaches({0, 1, 0}, 1));
    EXPECT_TRUE(change.reaches({99, 1, 0}, 1));
    EXPECT_FALSE(change.reaches({50, 0, 0}, 1));
}

TEST(LightChange, OfASpotReachesItsCone) {
    std::vector<Light> spot = {test::pointLight({0, 0, 0}, 1)};
    spot[0].kind = LightKind::Spot;
    spot[0].direction = {0, -1, 0};
    spot[0].cosInner = 0.9F;
    spot[0].cosOuter = 0.8F;
    const LightChange change({}, spot);
    EXPECT_TRUE(change.reaches({0, -2, 0}, 1));
    EXPECT_FALSE(change.reaches({0, 2, 0}, 1));
}

TEST(LightChange, OfALightWithASizeOrWithoutAPlaceReachesAll) {
    std::vector<Light> light = {test::pointLight({0, 0, 0}, 1e-6F)};
    light[0].kind = LightKind::Sphere;
    light[0].radius = 0.1F;
    EXPECT_TRUE(LightChange(light, {}).reaches({1e4F, 0, 0}, 1));
    light[0].kind = LightKind::Directional;
    light[0].intensity = {1, 1, 1};
    EXPECT_TRUE(LightChange(light, {}).reaches({1e4F, 0, 0}, 1));
}

} // namespace
} // namespace rtcore
