// Pixels of a moving camera under many lights: some of these are traced, and the light of all is shown.
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace rtcore {
namespace {

/// 60 lights of four kinds above the sample scene.
Scene underManyLights() {
    Scene scene = test::sampleScene();
    scene.ambient = {};
    scene.lights.clear();
    for (int i = 0; i < 60; ++i) {
        const auto turn = static_cast<float>(i) * 2.4F, far = 0.5F + 0.05F * static_cast<float>(i);
        Light light = test::pointLight({far * std::cos(turn), 2.5F, far * std::sin(turn)}, 0.8F);
        if (i % 4 == 1) {
            light.kind = LightKind::Spot;
            light.direction = {0, -1, 0};
            light.cosInner = 0.9F;
            light.cosOuter = 0.5F;
        }
        if (i % 4 == 2) {
            light.kind = LightKind::Sphere;
            light.radius = 0.1F;
        }
        if (i % 10 == 3) light.on = 0;
        scene.lights.emplace_back(light, "");
    }
    return scene;
}

class ManyLights : public testing::Test {
  protected:
    static constexpr int kWidth = 96, kHeight = 64;

    ManyLights() {
        for (std::uint16_t y = 0; y < kHeight; ++y)
            for (std::uint16_t x = 0; x < kWidth; ++x) pixels.push_back({x, y, 0});
    }
    ~ManyLights() override { useInstructionSet("auto"); }

    /// As live frames draw them.
    std::vector<Colour> moving(int threads = 1) {
        std::vector<Colour> light(pixels.size());
        std::vector<LightVisibility> visibility(pixels.size());
        RenderControl control{.threads = threads};
        statistics = {};
        FrameRenderer().renderPixels({traced.scene, traced.tracer, test::sampleCamera(), settings}, pixels,
                                     control, {light, visibility}, statistics);
        return light;
    }
    std::uint64_t shadowRays() const { return statistics.rays[static_cast<std::size_t>(RayKind::Shadow)]; }

    const test::TracedScene traced{underManyLights()};
    RenderSettings settings = test::sampleSettings(kWidth, kHeight);
    std::vector<SampleId> pixels;
    RayStatistics statistics;
};

TEST_F(ManyLights, AreAsBrightAsAllOfThemForFarLessRays) {
    const Frame whole = test::render(traced, settings);
    const std::vector<Colour> some = moving();
    EXPECT_LT(shadowRays(),
              0.5 * static_cast<double>(whole.statistics.rays[static_cast<std::size_t>(RayKind::Shadow)]));
    double all = 0, shown = 0, squares = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        const double there = luminance(whole.radiance.pixels[i]), here = luminance(some[i]);
        all += there;
        shown += here;
        squares += (here - there) * (here - there) / (there * there + 1e-3);
    }
    EXPECT_NEAR(shown, all, 0.005 * all);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(some.size())), 0.15) << "relative error";
}

TEST_F(ManyLights, AreAllTracedWhereNothingMoves) {
    const Frame whole = test::render(traced, settings);
    std::vector<Colour> still(pixels.size());
    RenderControl control{.threads = 1};
    FrameRenderer().renderPixels({traced.scene, traced.tracer, test::sampleCamera(), settings}, pixels,
                                 control, {still}, statistics);
    EXPECT_EQ(shadowRays(), whole.statistics.rays[static_cast<std::size_t>(RayKind::Shadow)]);
}

TEST_F(ManyLights, AreTheSameForThreadsAndInstructionSets) {
    const std::vector<Colour> first = moving();
    EXPECT_TRUE(moving(3) == first);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_TRUE(moving() == first) << name;
    }
}

TEST_F(ManyLights, WithoutShadowsAreExact) {
    settings.shadows = false;
    const std::vector<Colour> light = moving();
    const Frame whole = test::render(traced, settings);
    for (std::size_t i = 0; i < light.size(); ++i)
        ASSERT_NEAR(luminance(light[i]), luminance(whole.radiance.pixels[i]),
                    1e-4F * luminance(whole.radiance.pixels[i]) + 1e-6F);
}

} // namespace
} // namespace rtcore
