// Holes that alpha textures cut, for what is seen and for shadows.
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

/// A leaf from (0,0) to (1,1) at z = 0 whose left half has the texel `left`, its right half `right`. Behind
/// it is radiance 1, itself it gives off 10.
class Leaf {
  public:
    Leaf(Rgba8 left, Rgba8 right, bool fromAlpha = false, float cutoff = 0) {
        Material m = test::emitter({10, 10, 10});
        m.alphaTexture = b_.texture(2, 1, {left, right});
        m.alphaFromAlpha = fromAlpha ? 1 : 0;
        m.alphaCutoff = cutoff;
        b_.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, b_.material(m));
        b_.square({0.5F, 0.5F, -1}, {0, 0, 1}, 1, b_.material(test::emitter({1, 1, 1})));
    }
    TracedScene::Result at(float x, const RenderSettings& settings = test::exactSettings()) {
        return TracedScene(SceneBuilder(b_).finish()).trace({x, 0.3F, 2}, {0, 0, -1}, settings);
    }

  private:
    SceneBuilder b_;
};

constexpr Rgba8 kSolid{255, 255, 255, 255}, kHole{0, 0, 0, 255};

TEST(AlphaTexture, CutsHoles) {
    Leaf leaf(kHole, kSolid);
    EXPECT_EQ(leaf.at(0.25F).radiance.r, 1);
    EXPECT_EQ(leaf.at(0.75F).radiance.r, 10);
    EXPECT_EQ(leaf.at(0.5F).radiance.r, 5.5F); // half way between the texels
}

TEST(AlphaTexture, IsANumberNotLight) {
    Leaf leaf({51, 0, 0, 255}, {128, 0, 0, 255});
    EXPECT_NEAR(leaf.at(0.25F).radiance.r, 0.2 * 10 + 0.8, 1e-5);
    EXPECT_NEAR(leaf.at(0.75F).radiance.r, 128 / 255.0 * 10 + 127 / 255.0, 1e-5);
}

TEST(AlphaTexture, MayBeTheAlphaChannel) {
    Leaf leaf({255, 255, 255, 0}, {0, 0, 0, 255}, true);
    EXPECT_EQ(leaf.at(0.25F).radiance.r, 1);
    EXPECT_EQ(leaf.at(0.75F).radiance.r, 10);
}

TEST(AlphaTexture, CutoffMakesItAllOrNothing) {
    Leaf leaf({100, 0, 0, 255}, {200, 0, 0, 255}, false, 0.5F);
    EXPECT_EQ(leaf.at(0.25F).radiance.r, 1);
    EXPECT_EQ(leaf.at(0.75F).radiance.r, 10);
    EXPECT_EQ(leaf.at(0.38F).radiance.r, 1); // 1/2 lies at 0.3875
    EXPECT_EQ(leaf.at(0.395F).radiance.r, 10);
}

TEST(AlphaTexture, SwitchedOffWithTextures) {
    RenderSettings settings;
    settings.textures = false;
    EXPECT_EQ(Leaf(kHole, kSolid).at(0.25F, settings).radiance.r, 10);
}

TEST(AlphaTexture, AHoleIsNotAHit) {
    SceneBuilder b;
    Material m = test::matte(1);
    m.alphaTexture = b.texture(1, 1, {kHole});
    b.square({0, 0, 0}, {0, 0, 1}, 1, b.material(m));
    b.scene.background = {3, 3, 3};
    const auto seen = TracedScene(b.finish()).trace({0.1F, 0.2F, 2}, {0, 0, -1}, test::exactSettings(0));
    EXPECT_FALSE(seen.hit);
    EXPECT_EQ(seen.radiance.r, 3);
}

TEST(AlphaTexture, ShadowsHaveTheSameHoles) {
    SceneBuilder b;
    Material m = test::matte(1);
    m.alphaTexture = b.texture(4, 1, {{51, 0, 0, 255}, {51, 0, 0, 255}, kSolid, kSolid});
    b.quad({0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}, b.material(m)); // u along z
    b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(test::matte(1)));
    Light sun;
    sun.kind = LightKind::Directional;
    b.scene.lights = {sun};
    const TracedScene s(b.finish());
    const auto lit = [&](float z) { return s.see({-3, 0.5F, z}, {0.4F, 0, z}) * test::kPi; };
    EXPECT_NEAR(lit(0.25F), 0.8, 1e-5);
    EXPECT_NEAR(lit(0.75F), 0, 1e-5);
    EXPECT_EQ(lit(0.7F), 0);
    EXPECT_NEAR(lit(0.5F), 0.4, 1e-5);
    EXPECT_NEAR(lit(1.5F), 1, 1e-5);
}

} // namespace
} // namespace rtcore
