#include "rtcore/settings/main_settings.h"
#include "rtcore/settings/quality.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;

constexpr std::array kAll{Quality::Draft, Quality::Good, Quality::Final};

TEST(Qualities, HaveValuesThatTheirSettingsTake) {
    for (const QualityRow& row : qualityTable()) {
        const Setting& setting = requireSetting(row.setting);
        EXPECT_EQ(setting.name, row.setting) << "no former name";
        for (const Quality each : kAll) {
            const SettingValue value = parseSetting(setting, row.of(each));
            EXPECT_EQ(settingText(value), row.of(each)) << row.setting;
            EXPECT_NO_THROW(checkLive(setting, value)) << row.setting;
        }
    }
}

TEST(Qualities, GoodIsTheDefault) {
    EXPECT_EQ(qualityOf(RenderSettings{}), Quality::Good);
    RenderSettings settings;
    applySettings(settings, settingsOf(Quality::Good));
    EXPECT_EQ(settings, RenderSettings{});
}

TEST(Qualities, AreKnownByTheSettingsThatTheyMake) {
    for (const Quality each : kAll) {
        RenderSettings settings;
        settings.shadows = false; // a matter of taste
        applySettings(settings, settingsOf(each));
        EXPECT_EQ(qualityOf(settings), each);
        EXPECT_EQ(qualityNamed(kQualityNames.at(static_cast<std::size_t>(each))), each);
        EXPECT_FALSE(settings.shadows);
    }
    EXPECT_EQ(qualityNamed("best"), std::nullopt);
    RenderSettings own;
    own.antialiasing = 4;
    EXPECT_EQ(qualityOf(own), std::nullopt);
}

TEST(Qualities, NeverAskForMoreWorkThanPagesMay) {
    for (const SettingAssignment& each : settingsOf(Quality::Final)) {
        const Setting& setting = requireSetting(each.name);
        const int* const whole = std::get_if<int>(&each.value);
        if (whole != nullptr && setting.browser.offered) {
            EXPECT_LE(*whole, setting.browser.maximum) << each.name;
        }
    }
}

TEST(MainSettings, AreOnesOfTheTable) {
    EXPECT_GE(mainSettings().size(), 3U);
    for (const MainSetting& each : mainSettings()) {
        EXPECT_EQ(requireSetting(each.name).name, each.name);
        EXPECT_EQ(findMainSetting(each.name), &each);
    }
    EXPECT_EQ(findMainSetting("width"), nullptr);
}

} // namespace
