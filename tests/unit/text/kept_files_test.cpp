// Files as earlier versions wrote them say what they said then.
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/set.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

namespace fs = std::filesystem;
using rtcore::RenderSettings;
using rtcore::SettingAssignment;

const fs::path kKept = RT_KEPT_FILES;

RenderSettings settingsOf(const std::vector<SettingAssignment>& assignments) {
    RenderSettings settings;
    rtcore::applySettings(settings, assignments);
    return settings;
}

TEST(KeptFiles, SettingsWithoutADotAreThoseWithOne) {
    const rtcore::SettingsFile file = rtcore::readSettingsFile(kKept / "flat.set");
    const RenderSettings still = settingsOf(file.still);
    EXPECT_EQ(still.areaLights.samples, 16);
    EXPECT_EQ(still.denoise.passes, 2);
    EXPECT_EQ(still.bloom.radius, 24);
    EXPECT_EQ(still.bloom.kernel, rtcore::BloomKernel::Airy);
    EXPECT_EQ(still.bloom.share, 0.25F);
    EXPECT_EQ(still.exposure.local, 0.5F);
    EXPECT_EQ(still.toneMapping, rtcore::ToneMapping::Channels);
    EXPECT_EQ(settingsOf(file.live).areaLights.samples, 2);
    EXPECT_EQ(settingsOf(file.live).bloom.radius, 16);
}

// None of them has its default there, so each one was read.
TEST(KeptFiles, EverySettingOfThemIsRead) {
    const rtcore::SettingsFile file = rtcore::readSettingsFile(kKept / "flat.set");
    const auto changed = rtcore::settingAssignments(settingsOf(file.still), false);
    EXPECT_EQ(changed.size(), 36U);
    for (const SettingAssignment& each : changed)
        EXPECT_NE(std::find(file.still.begin(), file.still.end(), each), file.still.end()) << each.name;
}

TEST(KeptFiles, AreWrittenWithTheNamesOfToday) {
    const rtcore::SettingsFile file = rtcore::readSettingsFile(kKept / "flat.set");
    const std::string written = rtcore::formatSettingsFile(file);
    for (const rtcore::FormerName& each : rtcore::formerSettingNames()) {
        EXPECT_EQ(written.find("\n" + std::string(each.former) + " ="), std::string::npos) << each.former;
        EXPECT_NE(written.find("\n" + std::string(each.name) + " ="), std::string::npos) << each.name;
    }
    EXPECT_EQ(rtcore::parseSettingsFile(written, "x.set"), file);
}

TEST(KeptFiles, ScenesWithSuchSettingsAreRead) {
    const rtcore::SceneFile scene = rtcore::readSceneFile(kKept / "flat.scn");
    const std::vector<SettingAssignment> live{
        {"areaLights.samples", 1}, {"denoise.passes", 3}, {"bloom.radius", 12}};
    const std::vector<SettingAssignment> still{{"areaLights.samples", 64},
                                               {"denoise.passes", 1},
                                               {"bloom.radius", 40},
                                               {"bloom.kernel", std::string("airy")},
                                               {"bloom.share", 0.5F}};
    EXPECT_EQ(scene.live, live);
    EXPECT_EQ(scene.still, still);
}

TEST(KeptFiles, CamerasHaveTheirBloom) {
    const rtcore::CameraFile file = rtcore::readCameraFile(kKept / "flat.cam");
    EXPECT_EQ(file.bloom, 9);
    EXPECT_NE(rtcore::formatCameraFile(file).find("\nbloom = 9\n"), std::string::npos);
}

} // namespace
