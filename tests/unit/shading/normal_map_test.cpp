// A square seen from its front; its texture lies so that `right` and `up` are the directions of u and v.
#include "rtcore/shading/surface/normal_map.h"

#include "support/small_scene.h"

#include "rtcore/shading/surface/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

constexpr float kHalf = 0.5F, kRoot3 = 0.8660254F;

/// The texel that tells a normal.
Rgba8 stored(Vec3 n) {
    const auto code = [](float x) { return static_cast<std::uint8_t>(std::lround((x + 1) / 2 * 255)); };
    return {code(n.x), code(n.y), code(n.z), 255};
}

/// The shading normal in the middle of a square around the origin, with a texture of one texel.
Vec3 bent(Vec3 right, Vec3 up, Vec3 texel, Vec3 from) {
    test::SceneBuilder scene;
    Material m = test::matte(1);
    m.normalTexture = scene.texture(1, 1, {stored(texel)});
    const std::uint32_t material = scene.material(m);
    scene.quad(-right - up, right - up, right + up, up - right, material);
    Scene built;
    built.model = makeModel(scene.buffers);
    built.materials.assign(built.model.materials.begin(), built.model.materials.end());
    Hit hit;
    hit.triangle = 0;
    hit.u = 0.25F;
    hit.v = 0.5F;
    return surfaceAt(built, true, -from, hit).shadingNormal;
}

void expectNear(Vec3 a, Vec3 b) {
    constexpr float kCode = 0.01F; // a normal of eight bits
    EXPECT_NEAR(a.x, b.x, kCode);
    EXPECT_NEAR(a.y, b.y, kCode);
    EXPECT_NEAR(a.z, b.z, kCode);
}

TEST(NormalMap, BlueAloneChangesNothing) {
    expectNear(bent({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}), {0, 0, 1});
}

TEST(NormalMap, RedLeansToTheRightAndGreenUpwards) {
    expectNear(bent({1, 0, 0}, {0, 1, 0}, {kHalf, 0, kRoot3}, {0, 0, 1}), {kHalf, 0, kRoot3});
    expectNear(bent({1, 0, 0}, {0, 1, 0}, {0, kHalf, kRoot3}, {0, 0, 1}), {0, kHalf, kRoot3});
    expectNear(bent({0, 0, -3}, {0, 3, 0}, {kHalf, 0, kRoot3}, {1, 0, 0}), {kRoot3, 0, -kHalf});
}

TEST(NormalMap, TheBackSideIsTheFrontTurnedOver) {
    expectNear(bent({1, 0, 0}, {0, 1, 0}, {kHalf, 0, kRoot3}, {0, 0, -1}), {-kHalf, 0, -kRoot3});
}

TEST(NormalMap, StretchedTexturesBendAsFar) {
    expectNear(bent({100, 0, 0}, {0, 0.01F, 0}, {0, kHalf, kRoot3}, {0, 0, 1}), {0, kHalf, kRoot3});
}

TEST(NormalMap, MirroredTextureBendsTheOtherWay) {
    test::SceneBuilder scene;
    Material m = test::matte(1);
    m.normalTexture = scene.texture(1, 1, {stored({kHalf, 0, kRoot3})});
    const std::uint32_t material = scene.material(m);
    scene.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, material);
    for (Vec2& t : scene.buffers.texcoords) t.x = 1 - t.x;
    Scene built;
    built.model = makeModel(scene.buffers);
    expectNear(mapNormal(built, built.model.textures[0], 0, {0.5F, 0.5F}, {0, 0, 1}), {-kHalf, 0, kRoot3});
}

TEST(NormalMap, WithoutAreaInTheTextureNothingChanges) {
    test::SceneBuilder scene;
    Material m = test::matte(1);
    m.normalTexture = scene.texture(1, 1, {stored({kHalf, 0, kRoot3})});
    const std::uint32_t material = scene.material(m);
    scene.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, material);
    for (Vec2& t : scene.buffers.texcoords) t = {0.5F, 0.5F};
    Scene built;
    built.model = makeModel(scene.buffers);
    EXPECT_EQ(mapNormal(built, built.model.textures[0], 0, {0.5F, 0.5F}, {0, 0, 1}), (Vec3{0, 0, 1}));
}

TEST(NormalMap, NeverPointsBehindTheSurface) {
    expectNear(bent({1, 0, 0}, {0, 1, 0}, {kRoot3, 0, -kHalf}, {0, 0, 1}), {0, 0, 1});
}

} // namespace
} // namespace rtcore
