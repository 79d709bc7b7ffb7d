#include "rtcore/sky/sky_light.h"
#include "rtcore/sky/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using rtcore::Colour;
using rtcore::Environment;
using rtcore::Sky;
using rtcore::SkyLight;
using rtcore::TexelFilter;
using rtcore::Vec3;

/// On a summer day at 45 degrees north, at an hour of the sun's own time.
Sky skyAt(int hour) {
    Sky sky;
    sky.date = rtcore::SunDate{.second = hour * 3600};
    return sky;
}

Sky skyTowards(Vec3 direction) {
    Sky sky;
    sky.date.reset();
    sky.direction = direction;
    return sky;
}

/// By a grid of directions.
Vec3 brightestDirection(const Environment& environment) {
    Vec3 best{};
    float max = -1;
    for (float y = -0.995F; y < 1; y += 0.01F) {
        for (float angle = 0; angle < 6.283F; angle += 0.01F) {
            const float ring = std::sqrt(1 - y * y);
            const Vec3 direction{ring * std::cos(angle), y, ring * std::sin(angle)};
            const float seen = rtcore::luminance(environment.radiance(direction, TexelFilter::Bilinear));
            if (seen > max) {
                max = seen;
                best = direction;
            }
        }
    }
    return best;
}

TEST(SkyLightOf, TheLightComesFromWhereTheSkyIsBrightest) {
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}) {
        const Vec3 sun = rtcore::normalize(up * 0.6F + Vec3{0.3F, 0.4F, 0.5F});
        const SkyLight light = skyLightOf(skyTowards(sun * 7.0F), up);
        EXPECT_EQ(light.sun->kind, rtcore::LightKind::Directional);
        EXPECT_GT(dot(light.sun->direction * -1.0F, sun), 0.99999F);
        EXPECT_GT(dot(brightestDirection(*light.environment), sun), 0.999F);
    }
}

TEST(SkyLightOf, TheSunIsInTheEastInTheMorning) {
    const Vec3 up{0, 1, 0}; // north is -z, east +x
    EXPECT_LT(skyLightOf(skyAt(8), up).sun->direction.x, -0.5F);
    EXPECT_GT(skyLightOf(skyAt(16), up).sun->direction.x, 0.5F);
    EXPECT_LT(skyLightOf(skyAt(12), up).sun->direction.z, -0.3F); // from the south
    EXPECT_NEAR(skyLightOf(skyAt(12), up).sun->direction.x, 0, 0.02F);
}

// The sun's irradiance and the sky's are those of one day: a level plane has 4 to 12 times as much of a high
// sun through clear air.
TEST(SkyLightOf, SunAndSkyAreInProportion) {
    const SkyLight light = skyLightOf(skyTowards({0, 3, 1}), {0, 1, 0});
    const float sky =
        rtcore::luminance(light.environment->light().open({0, 1, 0})) * std::numbers::pi_v<float>;
    const float sun = rtcore::luminance(light.sun->intensity) * -light.sun->direction.y;
    EXPECT_GT(sun, 4 * sky);
    EXPECT_LT(sun, 12 * sky);
    EXPECT_GT(sun, 3); // a white wall: radiance 1 and more
    EXPECT_LT(sun, 7);
}

TEST(SkyLightOf, TheGroundScattersBackAFifth) {
    const SkyLight light = skyLightOf(skyTowards({0, 3, 1}), {0, 1, 0});
    const Colour ground = light.environment->radiance({0.3F, -1, 0.1F}, TexelFilter::Bilinear);
    const float sky =
        rtcore::luminance(light.environment->light().open({0, 1, 0})) * std::numbers::pi_v<float>;
    const float sun = rtcore::luminance(light.sun->intensity) * -light.sun->direction.y;
    EXPECT_NEAR(rtcore::luminance(ground) / (0.2F * (sun + sky) / std::numbers::pi_v<float>), 1, 0.01F);
    const Colour far = light.environment->radiance({1, -0.02F, 0}, TexelFilter::Bilinear);
    EXPECT_NEAR(rtcore::luminance(far) / rtcore::luminance(ground), 1, 1e-5F);
}

TEST(SkyLightOf, HazeMakesTheHorizonLightByDayAndFadesTheGround) {
    const auto seen = [](const SkyLight& light, Vec3 direction) {
        return rtcore::luminance(light.environment->radiance(direction, TexelFilter::Bilinear));
    };
    for (const Vec3 sun : {Vec3{0, 3, 1}, Vec3{0.2F, 1, 1}}) {
        Sky sky = skyTowards(sun);
        const SkyLight clear = skyLightOf(sky, {0, 1, 0});
        sky.haze = true;
        const SkyLight hazy = skyLightOf(sky, {0, 1, 0});
        EXPECT_EQ(hazy.sun->intensity, clear.sun->intensity);
        for (const Vec3 across : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, -1}}) {
            const Vec3 horizon = across + Vec3{0, 0.01F, 0};
            EXPECT_GT(seen(hazy, horizon), 1.5F * seen(hazy, {0.1F, 1, -0.3F}));
            EXPECT_NEAR(seen(hazy, across - Vec3{0, 0.004F, 0}) / seen(hazy, horizon), 1, 0.25F);
            const Colour white = hazy.environment->radiance(horizon, TexelFilter::Bilinear);
            EXPECT_NEAR(white.b / white.r, 1, 0.2F);
        }
        EXPECT_NEAR(seen(hazy, {0.1F, 1, -0.3F}) / seen(clear, {0.1F, 1, -0.3F}), 1.05F, 0.05F);
        EXPECT_NEAR(seen(hazy, {0, -1, 0}) / seen(clear, {0, -1, 0}), 0.35F / 0.2F, 0.1F);
    }
}

/// To the light at the horizon: the same sky, upright for each up.
TEST(SkyLightOf, StandsUprightForEachUp) {
    const Vec3 up{0, 1, 0};
    Sky sky = skyTowards({0.3F, 0.8F, 0.5F});
    sky.haze = true;
    const SkyLight upright = skyLightOf(sky, up);
    for (const Vec3 other : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, -1, 0}}) {
        // Turns y to the other axis, and keeps what is right of it.
        const Vec3 right = other.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, back = cross(right, other);
        const auto turned = [&](Vec3 v) { return right * v.x + other * v.y + back * v.z; };
        Sky turnedSky = sky;
        turnedSky.direction = turned(sky.direction);
        const SkyLight light = skyLightOf(turnedSky, other);
        for (const float height : {-0.9F, -0.3F, -0.02F, 0.03F, 0.2F, 0.9F}) {
            for (float angle = 0; angle < 6.2F; angle += 0.7F) {
                const float ring = std::sqrt(1 - height * height);
                const Vec3 to{ring * std::cos(angle), height, ring * std::sin(angle)};
                const float expected =
                    rtcore::luminance(upright.environment->radiance(to, TexelFilter::Bilinear));
                EXPECT_NEAR(
                    rtcore::luminance(light.environment->radiance(turned(to), TexelFilter::Bilinear)) /
                        expected,
                    1, 0.03F)
                    << "up " << other.x << other.y << other.z << " height " << height << " angle " << angle;
            }
        }
    }
}

TEST(SkyLightOf, AStudioIsWhiteBelowADarkCeiling) {
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}}) {
        Sky studio{.strength = 2, .studio = true};
        const SkyLight light = skyLightOf(studio, up);
        EXPECT_FALSE(light.sun);
        const Vec3 across{up.y, up.z, up.x};
        const auto seen = [&](Vec3 to) { return light.environment->radiance(to, TexelFilter::Bilinear); };
        EXPECT_EQ(seen(-up), rtcore::kWhite * 2.0F);
        EXPECT_NEAR(seen(across).g, 2, 0.01F) << "no corner between floor and wall";
        EXPECT_LT(seen(up).g, 0.5F);
        EXPECT_NEAR(seen(up + across).g, seen(up - across).g, 1e-3F);
    }
}

TEST(SkyLightOf, StrengthScalesBoth) {
    Sky sky = skyAt(10);
    const SkyLight one = skyLightOf(sky, {0, 1, 0});
    sky.strength = 2;
    const SkyLight two = skyLightOf(sky, {0, 1, 0});
    EXPECT_EQ(two.sun->intensity, 2 * one.sun->intensity);
    const Vec3 direction{0.3F, 0.5F, 0.2F};
    EXPECT_EQ(two.environment->radiance(direction, TexelFilter::Nearest),
              2 * one.environment->radiance(direction, TexelFilter::Nearest));
}

TEST(SkyLightOf, AtNightThereIsNoSun) {
    const SkyLight night = skyLightOf(skyAt(0), {0, 1, 0});
    EXPECT_TRUE(rtcore::isBlack(night.sun->intensity));
    const SkyLight noon = skyLightOf(skyAt(12), {0, 1, 0});
    EXPECT_LT(rtcore::luminance(night.environment->meanRadiance()),
              1e-4F * rtcore::luminance(noon.environment->meanRadiance()));
}

} // namespace
