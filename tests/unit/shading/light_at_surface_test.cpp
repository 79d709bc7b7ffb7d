// The light that one surface sends to the viewer: lobes, normals, vertex colours, both sides, ambient light.
#include "support/small_scene.h"
#include "support/steps.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::atAngle;
using test::SceneBuilder;
using test::TracedScene;

/// A floor whose front is up, lit from 60 degrees at distance 2.
SceneBuilder litFloor(const Material& material) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 5, b.material(material));
    b.scene.lights.push_back(test::pointLight(atAngle(60) * 2, 100));
    return b;
}

Material glossy(float albedo, float shininess) {
    Material m = test::matte(0);
    m.specular = {albedo, albedo, albedo};
    m.shininess = shininess;
    return m;
}

TEST(LightAtSurface, DiffuseUnderAPointLight) {
    const TracedScene s(litFloor(test::matte(0.5F)).finish());
    for (const double degrees : {-80, -40, 0, 30, 70}) {
        EXPECT_NEAR(s.see(atAngle(degrees) * 3, {}), 1.989437, 2e-5) << degrees;
    }
}

TEST(LightAtSurface, GlossyTwentyDegreesOffTheMirroredDirection) {
    const TracedScene s(litFloor(glossy(0.5F, 10)).finish());
    EXPECT_NEAR(s.see(atAngle(-40) * 3, {}), 6.408252, 1e-4);
    EXPECT_NEAR(s.see(atAngle(-80) * 3, {}), 6.408252, 1e-4);
    EXPECT_EQ(s.see(atAngle(50) * 3, {}), 0); // more than 90 degrees off
}

TEST(LightAtSurface, RoughMetalsHaveNoEdge) {
    for (const float shininess : {0.0F, 0.25F, 0.72F, 0.99F}) {
        const TracedScene s(litFloor(glossy(0.8F, shininess)).finish());
        // The whole way from side to side, past 90 degrees from the mirrored light.
        float before = s.see(atAngle(-89) * 3, {});
        for (const double degrees : test::steps(-88.8, 89.0, 0.2)) {
            const float now = s.see(atAngle(degrees) * 3, {});
            EXPECT_GT(now, 0);
            EXPECT_NEAR(now, before, 0.05F) << shininess << " at " << degrees;
            before = now;
        }
    }
}

TEST(LightAtSurface, ARoughMetalsLightFollowsItsExponentWithoutAStep) {
    const auto seen = [](float shininess, double degrees) {
        return TracedScene(litFloor(glossy(0.8F, shininess)).finish()).see(atAngle(degrees) * 3, {});
    };
    for (const double degrees : {-60, 0, 50, 80}) {
        EXPECT_NEAR(seen(0.9999F, degrees), seen(1, degrees), 2e-3) << degrees;
        EXPECT_NEAR(seen(1e-4F, degrees), seen(0, degrees), 2e-3) << degrees;
    }
    // Irradiance 25, cosine 1/2, GGX of roughness 1 straight on from there.
    EXPECT_NEAR(seen(0, 0), 0.8 * 25 * 0.5 / (2 * test::kPi * 1.5), 1e-4);
}

TEST(LightAtSurface, DiffuseAndGlossyAdd) {
    Material m = glossy(0.5F, 10);
    m.diffuse = {0.5F, 0.25F, 0};
    const TracedScene s(litFloor(m).finish());
    const Colour seen = s.trace(atAngle(-40) * 3, -atAngle(-40)).radiance;
    EXPECT_NEAR(seen.r, 6.408252 + 1.989437, 1e-4);
    EXPECT_NEAR(seen.g, 6.408252 + 1.989437 / 2, 1e-4);
    EXPECT_NEAR(seen.b, 6.408252, 1e-4);
}

TEST(LightAtSurface, LightsAddAndCanBeOff) {
    SceneBuilder b = litFloor(test::matte(0.5F));
    b.scene.lights.push_back(test::pointLight(atAngle(-60) * 4, 100));
    b.scene.lights.push_back(test::pointLight(atAngle(0) * 1, 100));
    b.scene.lights.back().light.on = 0;
    const TracedScene s(b.finish());
    EXPECT_NEAR(s.see({0, 3, 0}, {}), 1.989437 * 1.25, 2e-5);
}

TEST(LightAtSurface, FallsOffWithTheSquareOfTheDistance) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 5, b.material(test::matte(1)));
    b.scene.lights.push_back(test::pointLight({0, 1, 0}, 1));
    TracedScene s(b.finish());
    for (const float d : {0.01F, 1.0F, 7.0F, 3000.0F}) {
        s.scene.lights[0].light.position = {0, d, 0};
        EXPECT_NEAR(s.see({1, 1, 0}, {}) * d * d, 1 / test::kPi, 1e-5) << d;
    }
}

TEST(LightAtSurface, TheSideThatIsSeenIsLit) {
    TracedScene s(litFloor(test::matte(0.5F)).finish());
    EXPECT_EQ(s.see({0, -3, 0}, {}), 0);
    s.scene.lights[0].light.position = atAngle(120) * 2; // the same from below
    EXPECT_NEAR(s.see({0, -3, 0}, {}), 1.989437, 2e-5);
    EXPECT_EQ(s.see({0, 3, 0}, {}), 0);
}

TEST(LightAtSurface, InterpolatesNormals) {
    SceneBuilder b;
    b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, b.material(test::matte(1)));
    b.buffers.normals = {normalize({-0.3F, -0.3F, 1}), normalize({0.3F, 0, 1}), normalize({0, 0.3F, 1})};
    b.scene.lights.push_back(test::pointLight({1.0F / 3 + 10, 1.0F / 3, 10}, 200));
    const TracedScene s(b.finish());
    const Vec3 middle{1.0F / 3, 1.0F / 3, 0};
    const Vec3 n =
        normalize(s.scene.mesh().normals[0] + s.scene.mesh().normals[1] + s.scene.mesh().normals[2]);
    const double cosine = dot(n, normalize({1, 0, 1}));
    EXPECT_NEAR(s.see({1, 1, 5}, middle), cosine / test::kPi, 1e-5);
}

TEST(LightAtSurface, SmoothNormalsFadeBeforeTheRealSurfaceTurnsAway) {
    // The light grazes the triangle, but the normals lean towards it: without the terminator factor the edge
    // between this triangle and one turned away would be hard.
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 5, b.material(test::matte(1)));
    for (Vec3& n : b.buffers.normals) n = atAngle(45);
    TracedScene s(b.finish());
    s.scene.lights.push_back(test::pointLight(atAngle(89.9) * 10, 100));
    EXPECT_NEAR(s.see({0, 3, 0}, {}), 0, 0.01);
    s.scene.lights[0].light.position = atAngle(45) * 10;
    EXPECT_NEAR(s.see({0, 3, 0}, {}), 1 / test::kPi, 1e-5);
    s.scene.lights[0].light.position = atAngle(90.1) * 10;
    EXPECT_EQ(s.see({0, 3, 0}, {}), 0);
}

TEST(LightAtSurface, VertexColoursMultiplyTheAlbedo) {
    SceneBuilder b;
    Material m = test::matte(0.5F);
    m.diffuse = {0.5F, 1, 1};
    b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, b.material(m));
    b.buffers.colours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0.4F}};
    b.scene.ambient = {1, 1, 1};
    const TracedScene s(b.finish());
    const Colour seen = s.trace({0.25F, 0.5F, 1}, {0, 0, -1}).radiance;
    EXPECT_NEAR(seen.r, 0.25 * 0.5, 1e-6);
    EXPECT_NEAR(seen.g, 0.25, 1e-6);
    EXPECT_NEAR(seen.b, 0.5 * 0.4, 1e-6);
}

TEST(LightAtSurface, TexturesMultiplyAlbedoAndEmission) {
    SceneBuilder b;
    const auto texture = b.texture(2, 1, {{255, 0, 0, 255}, {0, 0, 255, 255}});
    Material m = test::matte(0.5F);
    m.diffuseTexture = texture;
    m.emission = {2, 2, 2};
    m.emissionTexture = texture;
    b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, b.material(m));
    b.scene.ambient = {1, 1, 1};
    const TracedScene s(b.finish());
    EXPECT_EQ(s.trace({0.25F, 0.3F, 1}, {0, 0, -1}).radiance, (Colour{2.5F, 0, 0}));
    EXPECT_EQ(s.trace({0.75F, 0.3F, 1}, {0, 0, -1}).radiance, (Colour{0, 0, 2.5F}));
    RenderSettings plain;
    plain.textures = false;
    EXPECT_EQ(s.trace({0.75F, 0.3F, 1}, {0, 0, -1}, plain).radiance, (Colour{2.5F, 2.5F, 2.5F}));
}

TEST(LightAtSurface, GivesBackAllOfAnEvenLightAndNoMore) {
    // All around is radiance 1: whatever the surface does with it, 1 comes back.
    Material m = glossy(0.3F, 20);
    m.diffuse = {0.7F, 0.7F, 0.7F};
    m.mirror = {0.4F, 0.4F, 0.4F};
    for (const std::uint32_t fresnel : {0U, 1U}) {
        m.fresnel = fresnel;
        SceneBuilder b;
        b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 5, b.material(m));
        b.scene.ambient = {1, 1, 1};
        b.scene.background = {1, 1, 1};
        const TracedScene s(b.finish());
        for (const double degrees : {0, 40, 85}) EXPECT_NEAR(s.see(atAngle(degrees) * 3, {}), 1, 1e-6);
    }
}

TEST(LightAtSurface, MissesShowTheBackground) {
    SceneBuilder b = litFloor(test::matte(0.5F));
    b.scene.background = {0.1F, 0.2F, 0.3F};
    const TracedScene s(b.finish());
    const auto seen = s.trace({0, 1, 0}, {0, 1, 0});
    EXPECT_EQ(seen.radiance, (Colour{0.1F, 0.2F, 0.3F}));
    EXPECT_FALSE(seen.hit);
    EXPECT_TRUE(s.trace({0, 1, 0}, {0, -1, 0}).hit);
}

TEST(LightAtSurface, MissesShowTheEnvironment) {
    HdrImage sky(4, 2, {1, 2, 3});
    SceneBuilder b = litFloor(test::mirror(0.5F));
    b.scene.background = {9, 9, 9};
    b.scene.environments.push_back(
        std::make_shared<const Environment>(Environment::fromEquirectangular(sky, "sky")));
    const TracedScene s(b.finish());
    EXPECT_NEAR(s.trace({0, 1, 0}, {0.1F, 1, 0}).radiance.b, 3, 1e-5);
    EXPECT_NEAR(s.trace({0, 1, 0}, {0.1F, -1, 0}).radiance.b, 1.5, 1e-5);
}

} // namespace
} // namespace rtcore
