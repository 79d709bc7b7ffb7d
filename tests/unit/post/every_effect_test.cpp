// All effects at once: the image is the same for every number of threads, in every frame, on every
// instruction set.
#include "rtcore/post/develop.h"
#include "rtcore/simd/instruction_set.h"
#include "support/every_effect.h"
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
    RenderSettings settings = test::everyEffect(97, 61);
    settings.depthOfField.fNumber = 0.2F; // the scene is a few centimetres large
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
    for (const test::WithoutEffect& without : test::withoutEachEffect(everything()))
        EXPECT_NE(all.pixels, picture(traced, without.settings, 0).pixels) << without.setting;
}

} // namespace
} // namespace rtcore
