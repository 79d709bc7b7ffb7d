// All effects at once: the image is the same for every number of threads, in every frame, on every
// instruction set.
#include "rtcore/post/develop.h"
#include "rtcore/simd/instruction_set.h"
#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

Scene sceneOfEverything() {
    Scene scene = test::softlyLitScene();
    scene.fog = test::foggyScene(FogKind::Exponential).fog;
    return scene;
}

RenderSettings everything() {
    RenderSettings settings = test::sampleSettings(97, 61, 2);
    settings.sampling = SamplingPattern::Poisson;
    settings.adaptive = 0.05F;
    settings.ambientOcclusion = {.on = true, .samples = 5};
    settings.depthOfField = {.on = true, .fNumber = 0.2F, .blades = 6};
    settings.fog.shafts = 3;
    settings.areaLights.samples = 3;
    settings.denoise.passes = 3;
    settings.bloom.radius = 4;
    settings.bloom.kernel = BloomKernel::Airy;
    settings.exposure.local = 0.5F;
    return settings;
}

LdrImage picture(const test::TracedScene& traced, const RenderSettings& settings, int threads) {
    const Frame frame = test::render(traced, settings, threads);
    PictureDeveloper developer;
    LdrImage image;
    developer.develop(frame, settings, developer.exposure(frame, settings.exposure, threads), threads, image);
    return image;
}

TEST(EveryEffect, TheSameBitsForAnyNumberOfThreadsAndInEveryFrame) {
    const test::TracedScene traced(sceneOfEverything());
    const LdrImage one = picture(traced, everything(), 1);
    for (const int threads : {1, 2, 7})
        EXPECT_EQ(one.pixels, picture(traced, everything(), threads).pixels) << threads;
}

TEST(EveryEffect, TheSameBitsOnEveryInstructionSet) {
    const test::TracedScene traced(sceneOfEverything());
    ASSERT_TRUE(useInstructionSet("scalar"));
    const LdrImage expected = picture(traced, everything(), 1);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(expected.pixels, picture(traced, everything(), 1).pixels) << name;
    }
    useInstructionSet("auto");
}

TEST(EveryEffect, ShowsInThePicture) {
    const test::TracedScene traced(sceneOfEverything());
    const LdrImage all = picture(traced, everything(), 0);
    using Change = void (*)(RenderSettings&);
    for (const Change without : {
             Change([](RenderSettings& s) { s.sampling = SamplingPattern::Grid; }),
             Change([](RenderSettings& s) { s.ambientOcclusion.on = false; }),
             Change([](RenderSettings& s) { s.depthOfField.on = false; }),
             Change([](RenderSettings& s) { s.fog.on = false; }),
             Change([](RenderSettings& s) { s.fog.shafts = 0; }),
             Change([](RenderSettings& s) { s.areaLights.samples = 0; }),
             Change([](RenderSettings& s) { s.denoise.passes = 0; }),
             Change([](RenderSettings& s) { s.bloom.radius = 0; }),
             Change([](RenderSettings& s) { s.bloom.kernel = BloomKernel::Gaussian; }),
             Change([](RenderSettings& s) { s.exposure.local = 0; }),
         }) {
        RenderSettings settings = everything();
        without(settings);
        EXPECT_NE(all.pixels, picture(traced, settings, 0).pixels);
    }
}

} // namespace
} // namespace rtcore
