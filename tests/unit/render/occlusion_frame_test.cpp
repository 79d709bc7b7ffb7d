// Ambient occlusion and the light of the sky in whole images: the same bits whoever renders them, and little
// error.
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/occlusion_quality.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

struct Surroundings {
    OcclusionPattern pattern;
    bool sky; ///< its light in place of ambient light
};

RenderSettings occluded(Surroundings from, int antialiasing = 1) {
    RenderSettings settings = test::sampleSettings(101, 67, antialiasing);
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.samples = 7;
    settings.ambientOcclusion.pattern = from.pattern;
    settings.ambientOcclusion.light = 0.5F;
    settings.skyLight = {.on = from.sky, .samples = 7};
    return settings;
}

/// In fog, under a sky with a bright spot.
Scene outdoors() {
    Scene scene = test::foggyScene(FogKind::Exponential);
    HdrImage sky(32, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const auto u = static_cast<float>(x), v = static_cast<float>(y);
            sky.at(x, y) = {1 + 0.02F * u, 1 + 0.05F * v, 2 - 0.1F * v};
        }
    }
    sky.at(20, 4) = {900, 800, 700};
    scene.environments = {std::make_shared<Environment>(Environment::fromEquirectangular(sky, "sky"))};
    return scene;
}

std::uint64_t hashOf(const Frame& frame) {
    return test::hashOf(std::as_bytes(std::span(frame.radiance.pixels)));
}

class OcclusionFrame : public testing::TestWithParam<Surroundings> {
  protected:
    ~OcclusionFrame() override { useInstructionSet("auto"); }
};

TEST_P(OcclusionFrame, HasTheSameBitsForAnyNumberOfThreads) {
    const test::TracedScene traced(outdoors());
    for (const int antialiasing : {1, 2}) {
        const RenderSettings settings = occluded(GetParam(), antialiasing);
        const Frame one = test::render(traced, settings, 1);
        EXPECT_EQ(hashOf(one), hashOf(test::render(traced, settings, 2)));
        EXPECT_EQ(hashOf(one), hashOf(test::render(traced, settings, 5)));
        EXPECT_GT(one.statistics.rays[static_cast<std::size_t>(RayKind::Occlusion)], 0U);
    }
}

TEST_P(OcclusionFrame, HasTheSameBitsOnEveryInstructionSet) {
    const test::TracedScene traced(outdoors());
    const RenderSettings settings = occluded(GetParam());
    ASSERT_TRUE(useInstructionSet("scalar"));
    const std::uint64_t expected = hashOf(test::render(traced, settings));
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(hashOf(test::render(traced, settings)), expected) << name;
    }
}

// While the camera stands still nothing crawls: the second image of the same renderer, after another one,
// is the first.
TEST_P(OcclusionFrame, DoesNotCrawl) {
    const test::TracedScene traced(outdoors());
    const RenderSettings settings = occluded(GetParam());
    FrameRenderer renderer;
    RenderControl control{.threads = 2};
    const auto shoot = [&](const Camera& camera) {
        Frame frame;
        renderer.render({traced.scene, traced.tracer, camera, settings}, control, frame);
        return hashOf(frame);
    };
    Camera elsewhere = test::sampleCamera();
    elsewhere.eye.x += 0.1F;
    const std::uint64_t first = shoot(test::sampleCamera());
    EXPECT_NE(shoot(elsewhere), first);
    EXPECT_EQ(shoot(test::sampleCamera()), first);
    EXPECT_EQ(shoot(test::sampleCamera()), first);
}

INSTANTIATE_TEST_SUITE_P(Patterns, OcclusionFrame,
                         testing::Values(Surroundings{OcclusionPattern::Rotated, false},
                                         Surroundings{OcclusionPattern::Regular, false},
                                         Surroundings{OcclusionPattern::Random, false},
                                         Surroundings{OcclusionPattern::Rotated, true},
                                         Surroundings{OcclusionPattern::Random, true}));

// Without panes and masks, rays are only asked whether they escape.
TEST(SkyLightFrame, OfOpaqueSurfacesHasTheSameBitsOnEveryInstructionSet) {
    Scene scene = outdoors();
    for (Material& m : scene.materials) {
        m.opacity = 1;
        m.alphaTexture = kNoTexture;
    }
    const test::TracedScene traced(scene);
    const RenderSettings settings = occluded({OcclusionPattern::Rotated, true});
    ASSERT_TRUE(useInstructionSet("scalar"));
    const std::uint64_t expected = hashOf(test::render(traced, settings));
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(hashOf(test::render(traced, settings, 2)), expected) << name;
    }
    useInstructionSet("auto");
}

TEST(OcclusionFrameQuality, TheRotatedPatternIsBest) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    b.box({-4, -1, -4}, {4, 3, 8}, white);
    b.sphere({-1.2F, 0, 0}, 1, 24, white);
    b.box({0.4F, -1, -1}, {1.6F, 1, 0.4F}, white);
    b.box({-2, -1, 1.6F}, {2, -0.7F, 2.4F}, white);
    const test::TracedScene traced(b.finish());
    test::OcclusionQuality(traced.scene, traced.tracer, test::sampleCamera()).expectRotatedIsBest("a room");
}

} // namespace
} // namespace rtcore
