// Pixels of a moving camera under many lights: some of these are traced, and the light of all is shown.
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
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

// Of very many lights points are lit in turns, since what is kept of each light and point has a bound.
TEST(VeryManyLights, LightAPointAsIfItWereAlone) {
    constexpr std::size_t kTimes = 150; // each of the 60
    Scene scene = underManyLights();
    const std::vector<SceneLight> once = scene.lights;
    for (std::size_t i = 1; i < kTimes; ++i)
        scene.lights.insert(scene.lights.end(), once.begin(), once.end());
    const test::TracedScene few(underManyLights()), many(std::move(scene));
    RenderSettings settings = test::sampleSettings(96, 64);
    settings.reflections = settings.refractions = false;
    settings.areaLights.samples = 1;
    std::vector<SampleId> pixels;
    for (std::uint16_t i = 0; i < 512; ++i)
        pixels.push_back(
            {static_cast<std::uint16_t>(16 + i % 64), static_cast<std::uint16_t>(56 + i / 64), 0});
    const auto lit = [&](const test::TracedScene& traced, std::size_t first, std::size_t count, bool moves) {
        std::vector<Colour> light(count);
        std::vector<LightVisibility> visibility(moves ? count : 0);
        RenderControl control{.threads = 1};
        RayStatistics statistics;
        FrameRenderer().renderPixels({traced.scene, traced.tracer, test::sampleCamera(), settings},
                                     std::span(pixels).subspan(first, count), control, {light, visibility},
                                     statistics);
        return light;
    };
    const auto sum = [](const std::vector<Colour>& light) {
        double all = 0;
        for (const Colour& each : light) all += luminance(each);
        return all;
    };
    const std::vector<Colour> together = lit(many, 0, 512, true);
    for (const std::size_t first : {0U, 128U, 256U, 384U}) {
        const std::vector<Colour> apart = lit(many, first, 128, true);
        for (std::size_t i = 0; i < apart.size(); ++i) ASSERT_EQ(apart[i], together[first + i]) << first + i;
    }
    const double all = kTimes * sum(lit(few, 0, 512, false));
    EXPECT_GT(all, 0);
    EXPECT_NEAR(sum(together), all, 0.02 * all);
}

} // namespace
} // namespace rtcore
