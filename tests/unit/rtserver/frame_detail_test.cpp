#include "rtserver/frames/frame_detail.h"

#include "rtcore/live/live_renderer.h"
#include "rtcore/settings/settings_table.h"

#include <gtest/gtest.h>

namespace {

using rtserver::FrameDetail;
using rtserver::settingsAt;
using rtserver::workOf;

rtcore::RenderSettings dear() {
    rtcore::RenderSettings settings;
    settings.width = 1235;
    settings.height = 963;
    settings.antialiasing = 16;
    settings.adaptive = 0.05F;
    settings.maxDepth = 1000;
    settings.minContribution = 0;
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.samples = 4096;
    settings.depthOfField.on = true;
    settings.areaLights.samples = 64;
    settings.fog.shafts = 100;
    settings.denoise.passes = 5;
    settings.bloom.radius = 20;
    return settings;
}

TEST(FrameDetail, OfAWholeFrameIsAllThatIsAskedFor) {
    EXPECT_EQ(settingsAt(dear(), {}).width, 1235);
    EXPECT_EQ(settingsAt(dear(), {}).antialiasing, 16);
    EXPECT_EQ(settingsAt(dear(), {}).ambientOcclusion.samples, 4096);
    EXPECT_TRUE(FrameDetail{}.whole());
    EXPECT_FALSE((FrameDetail{1, true}).whole());
    EXPECT_FALSE((FrameDetail{0.5, false}).whole());
}

TEST(FrameDetail, TheCoarsestIsCheapWhateverTheSettings) {
    rtcore::Scene scene;
    scene.lights.resize(10);
    const rtcore::RenderSettings coarse = settingsAt(dear(), rtserver::kCoarsest);
    EXPECT_GE(coarse.width * 8, 1235) << "an eighth of the pixels at least";
    EXPECT_GE(coarse.height * 8, 963);
    EXPECT_LT(workOf(coarse, scene), 60.0 * coarse.width * coarse.height);
    EXPECT_EQ(coarse.antialiasing, 1);
    EXPECT_EQ(coarse.denoise.passes, 0);
    EXPECT_FALSE(coarse.depthOfField.on);
    EXPECT_EQ(coarse.ambientOcclusion.samples, 1);
    EXPECT_GT(settingsAt(dear(), {0.5, true}).ambientOcclusion.samples, 1);
    EXPECT_TRUE(coarse.ambientOcclusion.on) << "what it shows is there, with noise";
    EXPECT_EQ(coarse.bloom.radius, 20);
}

TEST(FrameDetail, OfALiveFrameHasTheLightOfTheWholeOneButOneSamplePerPixel) {
    rtcore::Scene scene;
    scene.lights.resize(2);
    rtcore::RenderSettings settings;
    settings.antialiasing = 3;
    settings.depthOfField.on = true;
    settings.ambientOcclusion.on = true;
    settings.maxDepth = 7;
    for (const double scale : {1.0, 0.5}) {
        const rtcore::RenderSettings live = rtserver::liveSettingsAt(settings, scene, scale);
        EXPECT_EQ(live.width, static_cast<int>(640 * scale));
        EXPECT_EQ(live.antialiasing, 1);
        EXPECT_FALSE(live.depthOfField.on);
        EXPECT_TRUE(rtcore::sameLight(live, settings));
    }
    EXPECT_FALSE((FrameDetail{1, true, 0.01}).whole());
    EXPECT_LT(rtserver::liveRays(dear(), scene), 100) << "or nothing would be seen";
}

TEST(FrameDetail, OfTheLightOfTheSkyHasFewRaysWhereItIsCoarse) {
    rtcore::RenderSettings settings = dear();
    settings.skyLight = {.on = true, .samples = 1000};
    EXPECT_EQ(settingsAt(settings, {}).skyLight.samples, 1000);
    EXPECT_EQ(settingsAt(settings, {0.5, true}).skyLight.samples, 4);
    EXPECT_EQ(settingsAt(settings, rtserver::kCoarsest).skyLight.samples, 1);
    EXPECT_TRUE(settingsAt(settings, rtserver::kCoarsest).skyLight.on);
    EXPECT_LT(workOf(settings, {}), workOf(dear(), {})) << "occlusion is not traced besides";
}

TEST(FrameDetail, LookingShadowsUpCostsLess) {
    rtcore::Scene scene;
    scene.lights.resize(9);
    EXPECT_LT(workOf(dear(), scene, true), workOf(dear(), scene));
    for (rtcore::SceneLight& each : scene.lights) each.light.kind = rtcore::LightKind::Sphere;
    rtcore::RenderSettings settings;
    const double soft = workOf(settings, scene);
    scene.lights.assign(9, {});
    EXPECT_LT(workOf(settings, scene), soft) << "one ray to a point light";
}

TEST(FrameDetail, OfOnePixelIsOnePixel) {
    rtcore::RenderSettings settings;
    settings.width = settings.height = 1;
    EXPECT_EQ(settingsAt(settings, rtserver::kCoarsest).width, 1);
    EXPECT_EQ(settingsAt(settings, rtserver::kCoarsest).height, 1);
}

} // namespace
