#include "rtcore/look/fill_lights.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

TEST(FillLights, AreThoseThatAreOnAndSaySo) {
    Scene scene;
    for (const char* name :
         {"fill light west", "window", "Bounce", "filling station", "sky-fill", "", "fill"})
        scene.lights.emplace_back(Light{}, name);
    scene.lights.emplace_back(Light{}, "FILL");
    scene.lights.back().light.on = 0;
    scene.lights.emplace_back(Light{}, "fill");
    scene.lights.back().ofSky = true;
    const std::vector<const SceneLight*> found = fillLights(scene);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0]->name, "fill light west");
    EXPECT_EQ(found[1]->name, "Bounce");
    EXPECT_EQ(found[2]->name, "sky-fill");
}

} // namespace
} // namespace rtcore
