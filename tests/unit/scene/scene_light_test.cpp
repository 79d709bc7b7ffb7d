/// Ids of lights.
#include "rtcore/scene/scene.h"
#include "rtcore/scene/scene_light.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

rtcore::Scene sceneOf(const std::vector<int>& ids) {
    rtcore::Scene scene;
    for (const int id : ids) scene.lights.emplace_back().notes.id = id;
    return scene;
}

std::vector<int> idsOf(const rtcore::Scene& scene) {
    std::vector<int> ids;
    for (const rtcore::SceneLight& each : scene.lights) ids.push_back(each.notes.id);
    return ids;
}

std::vector<int> numbered(const std::vector<int>& ids) {
    rtcore::Scene scene = sceneOf(ids);
    numberLights(scene);
    return idsOf(scene);
}

TEST(LightIds, AreTheOrderWhereNoneIsGiven) {
    rtcore::Scene scene;
    scene.lights.resize(3);
    numberLights(scene);
    EXPECT_EQ(idsOf(scene), (std::vector<int>{1, 2, 3}));
}

TEST(LightIds, OfFilesStay) {
    EXPECT_EQ(numbered({7, 3}), (std::vector<int>{7, 3}));
    EXPECT_EQ(numbered({0, 9, 0}), (std::vector<int>{1, 9, 3}));
}

TEST(LightIds, AreNeverTheSameTwice) {
    EXPECT_EQ(numbered({2, 0, 0, 4, 0}), (std::vector<int>{2, 3, 5, 4, 6}));
    EXPECT_EQ(numbered({0, 1}), (std::vector<int>{2, 1}));
}

TEST(LightIds, FindTheirLight) {
    const rtcore::Scene scene = sceneOf({7, 3});
    EXPECT_EQ(lightWithId(scene, 3), 1U);
    EXPECT_FALSE(lightWithId(scene, 1));
    EXPECT_FALSE(lightWithId(scene, 0));
}

TEST(LightIds, OfNewLightsAreAboveAll) {
    EXPECT_EQ(nextLightId(sceneOf({})), 1);
    EXPECT_EQ(nextLightId(sceneOf({7, 3})), 8);
    EXPECT_EQ(nextLightId(sceneOf({rtcore::kMaxLightId, 1})), 2);
    rtcore::Scene scene = sceneOf({7, 3});
    scene.removedLightId = 9;
    EXPECT_EQ(nextLightId(scene), 10);
}

TEST(SceneLights, ShineAlikeWhateverTheyAreCalled) {
    rtcore::Light bright;
    bright.intensity = {2, 2, 2};
    const std::vector<rtcore::SceneLight> lights{{bright, "bulb"}, rtcore::Light()};
    std::vector<rtcore::SceneLight> others{bright, {{}, "sun"}};
    others[1].notes.id = 7;
    others[1].ofSky = true;
    EXPECT_NE(lights, others);
    EXPECT_TRUE(shineAlike(lights, others));
    EXPECT_EQ(rtcore::lightsOf(others), (std::vector<rtcore::Light>{bright, {}}));
    others[1].light.on = 0;
    EXPECT_FALSE(shineAlike(lights, others));
    others.pop_back();
    EXPECT_FALSE(shineAlike(lights, others));
}

} // namespace
