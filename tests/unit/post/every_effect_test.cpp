// All effects at once: the image is the same for every number of threads, in every frame, on every
// instruction set.
#include "rtcore/post/develop.h"
#include "rtcore/simd/instruction_set.h"
#include "support/every_effect.h"
#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

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

/// Another value that the setting takes.
SettingValue otherValue(const Setting& setting, const SettingValue& value) {
    switch (setting.type) {
    case SettingType::Boolean:
        return !std::get<bool>(value);
    case SettingType::Integer:
        return std::get<int>(value) + (std::get<int>(value) < setting.maximum ? 1 : -1);
    case SettingType::Number:
        return std::get<float>(value) == static_cast<float>(setting.minimum)
                   ? static_cast<float>(std::min(setting.maximum, setting.minimum + 0.5))
                   : static_cast<float>(setting.minimum);
    case SettingType::Choice:
        break;
    }
    return std::string(setting.choices[setting.choices.front() == std::get<std::string>(value) ? 1 : 0]);
}

/// Settings that are said to change only how an image is shown, or only the pace, leave radiance as it is.
TEST(SettingChanges, KeepWhatTheySay) {
    const test::TracedScene traced(sceneOfEverything());
    RenderSettings before = everything();
    before.adaptive = 0; // goes by what is shown
    const Frame frame = test::render(traced, before, 0);
    int kept = 0;
    for (const Setting& setting : settingsTable()) {
        if (setting.isOfImage()) continue;
        RenderSettings after = before;
        setSetting(after, setting.name, otherValue(setting, setting.get(before)));
        EXPECT_EQ(frame.radiance.pixels, test::render(traced, after, 0).radiance.pixels) << setting.name;
        EXPECT_TRUE(sameLight(before, after)) << setting.name;
        ++kept;
    }
    EXPECT_GT(kept, 10);
}

} // namespace
} // namespace rtcore
