#include "rtcore/settings/settings_table.h"

#include "rtcore/platform/sentence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <type_traits>

namespace {

using rtcore::RenderSettings;
using rtcore::Setting;
using rtcore::SettingType;
using rtcore::SettingValue;

std::string refusal(std::string_view name, const SettingValue& value) {
    RenderSettings settings;
    try {
        rtcore::setSetting(settings, name, value);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

std::string textRefusal(std::string_view name, std::string_view text) {
    RenderSettings settings;
    try {
        rtcore::setSettingFromText(settings, name, text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

/// A value that the setting takes and that is not its default.
SettingValue otherValue(const Setting& setting) {
    switch (setting.type) {
    case SettingType::Boolean:
        return !std::get<bool>(setting.defaultValue);
    case SettingType::Integer:
        return std::get<int>(setting.defaultValue) + 1;
    case SettingType::Number:
        return std::get<float>(setting.defaultValue) + 0.1F;
    case SettingType::Choice:
        break;
    }
    return std::string(setting.choices.back());
}

/// Initialises members that are numbers, switches or choices, but no struct: of structs in a struct it takes
/// the braces for left out, and initialises their members.
struct AnyMember {
    template <typename T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    operator T() const;
};
template <typename... Given>
consteval std::size_t membersOf() {
    if constexpr (requires { RenderSettings{Given{}..., AnyMember{}}; })
        return membersOf<Given..., AnyMember>();
    else
        return sizeof...(Given);
}

TEST(SettingsTable, HasEveryMemberOfTheStructOnce) {
    std::set<std::string_view> names;
    for (const Setting& setting : rtcore::settingsTable()) {
        EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
        EXPECT_FALSE(setting.help.empty()) << setting.name;
    }
    EXPECT_EQ(names.size(), membersOf<>());
}

TEST(SettingsTable, DefaultsAreThoseOfTheStructAndInRange) {
    const RenderSettings defaults;
    for (const Setting& setting : rtcore::settingsTable()) {
        EXPECT_EQ(setting.get(defaults), setting.defaultValue) << setting.name;
        EXPECT_EQ(rtcore::checkSetting(setting, setting.defaultValue), setting.defaultValue) << setting.name;
    }
    EXPECT_EQ(std::get<int>(rtcore::getSetting(defaults, "width")), defaults.width);
    EXPECT_EQ(std::get<std::string>(rtcore::getSetting(defaults, "exposure.mode")), "automatic");
}

TEST(SettingsTable, SettingOneChangesThatOneAlone) {
    for (const Setting& setting : rtcore::settingsTable()) {
        RenderSettings settings;
        rtcore::setSetting(settings, setting.name, otherValue(setting));
        const auto changes = rtcore::settingAssignments(settings, false);
        ASSERT_EQ(changes.size(), 1U) << setting.name;
        EXPECT_EQ(changes[0].name, setting.name);
        EXPECT_EQ(changes[0].value, otherValue(setting));
    }
}

TEST(SettingsTable, ReachesTheMembersOfTheirNames) {
    RenderSettings s;
    rtcore::setSettingFromText(s, "height", "1080");
    rtcore::setSettingFromText(s, "ambientOcclusion.distance", "2.5");
    rtcore::setSettingFromText(s, "exposure.mode", "fixed");
    rtcore::setSettingFromText(s, "toneMapping", "channels");
    rtcore::setSettingFromText(s, "environmentFilter", "nearest");
    rtcore::setSettingFromText(s, "dithering", "off");
    EXPECT_EQ(s.height, 1080);
    EXPECT_EQ(s.ambientOcclusion.distance, 2.5F);
    EXPECT_EQ(s.exposure.mode, rtcore::ExposureMode::Fixed);
    EXPECT_EQ(s.toneMapping, rtcore::ToneMapping::Channels);
    EXPECT_EQ(s.environmentFilter, rtcore::TexelFilter::Nearest);
    EXPECT_FALSE(s.dithering);
}

TEST(SettingsTable, FormerNamesReachTheSameMembers) {
    RenderSettings s;
    rtcore::setSettingFromText(s, "lampSamples", "7");
    rtcore::setSettingFromText(s, "denoise", "2");
    rtcore::setSetting(s, "bloom", 10);
    rtcore::setSettingFromText(s, "bloomKernel", "airy");
    rtcore::setSettingFromText(s, "bloomShare", "0.5");
    EXPECT_EQ(s.areaLights.samples, 7);
    EXPECT_EQ(s.denoise.passes, 2);
    EXPECT_EQ(s.bloom.radius, 10);
    EXPECT_EQ(s.bloom.kernel, rtcore::BloomKernel::Airy);
    EXPECT_EQ(s.bloom.share, 0.5F);
    EXPECT_EQ(rtcore::getSetting(s, "bloom"), SettingValue(10));
    for (const auto& [name, value] : rtcore::settingAssignments(s, false))
        EXPECT_EQ(name, rtcore::requireSetting(name).name) << "written by a former name";
    EXPECT_EQ(textRefusal("bloom", "much"),
              "bloom.radius is 'much', but takes a whole number, 0 to 4096 pixels, or off");
}

TEST(SettingsTable, FormerNamesAreNoneOfToday) {
    std::set<std::string_view> names;
    for (const Setting& setting : rtcore::settingsTable()) names.insert(setting.name);
    for (const rtcore::FormerName& each : rtcore::formerSettingNames()) {
        EXPECT_TRUE(names.contains(each.name)) << each.name;
        EXPECT_TRUE(names.insert(each.former).second) << each.former;
    }
}

TEST(SettingsTable, TheGroupIsThePartBeforeTheDot) {
    for (const Setting& setting : rtcore::settingsTable()) {
        const std::size_t dot = setting.name.find('.');
        if (dot == std::string_view::npos) continue;
        EXPECT_EQ(setting.group, setting.name.substr(0, dot));
    }
    EXPECT_EQ(rtcore::requireSetting("shadows").group, "rays");
    EXPECT_EQ(rtcore::requireSetting("toneMapping").group, "exposure");
    EXPECT_EQ(rtcore::requireSetting("width").group, "");
}

TEST(SettingsTable, LimitsAreTakenAndWhatLiesBeyondIsRefused) {
    for (const Setting& setting : rtcore::settingsTable()) {
        if (setting.type == SettingType::Integer) {
            const int low = static_cast<int>(setting.minimum), high = static_cast<int>(setting.maximum);
            EXPECT_EQ(refusal(setting.name, low), "accepted");
            EXPECT_EQ(refusal(setting.name, high), "accepted");
            EXPECT_NE(refusal(setting.name, low - 1), "accepted");
            EXPECT_NE(refusal(setting.name, high + 1), "accepted");
        }
        if (setting.type == SettingType::Number) {
            const auto low = static_cast<float>(setting.minimum), high = static_cast<float>(setting.maximum);
            constexpr float infinity = std::numeric_limits<float>::infinity();
            EXPECT_EQ(refusal(setting.name, low), "accepted");
            EXPECT_EQ(refusal(setting.name, high), "accepted");
            EXPECT_NE(refusal(setting.name, std::nextafter(low, -infinity)), "accepted");
            EXPECT_NE(refusal(setting.name, std::nextafter(high, infinity)), "accepted");
            EXPECT_NE(refusal(setting.name, infinity), "accepted");
            EXPECT_NE(refusal(setting.name, std::numeric_limits<float>::quiet_NaN()), "accepted");
        }
    }
}

TEST(SettingsTable, RefusalsTellTheRangeOrTheChoices) {
    EXPECT_EQ(refusal("width", 0), "width is 0, but takes a whole number, 1 to 32768 pixels");
    EXPECT_EQ(refusal("width", 3.5F), "width is 3.5, but takes a whole number, 1 to 32768 pixels");
    EXPECT_EQ(refusal("shadows", 1), "shadows is 1, but takes true or false");
    EXPECT_EQ(refusal("ambientOcclusion.distance", -1),
              "ambientOcclusion.distance is -1, but takes at least 0 scene units, or automatic");
    EXPECT_EQ(refusal("exposure.mode", std::string("auto")),
              "exposure.mode is 'auto', but takes automatic or fixed or incident");
    EXPECT_EQ(refusal("toneMapping", true),
              "toneMapping is true, but takes luminance or channels or agx or neutral");
    EXPECT_EQ(textRefusal("bloom.radius", "much"),
              "bloom.radius is 'much', but takes a whole number, 0 to 4096 pixels, or off");
}

TEST(SettingsTable, UnknownNamesGetTheNearest) {
    EXPECT_EQ(refusal("widht", 1), "unknown setting 'widht'; did you mean 'width'?");
    EXPECT_EQ(textRefusal("samples", "3"),
              "unknown setting 'samples'; did you mean 'ambientOcclusion.samples'?");
    EXPECT_EQ(textRefusal("antiAliasing", "3"),
              "unknown setting 'antiAliasing'; did you mean 'antialiasing'?");
    EXPECT_THROW(rtcore::getSetting({}, "exposure"), std::invalid_argument);
}

TEST(SettingsTable, TextOfEachKindIsUnderstood) {
    RenderSettings s;
    for (const char* yes : {"true", "on", "yes", "1"}) {
        s.ambientOcclusion.on = false;
        rtcore::setSettingFromText(s, "ambientOcclusion.on", yes);
        EXPECT_TRUE(s.ambientOcclusion.on) << yes;
    }
    for (const char* no : {"false", "off", "no", "0"}) {
        s.shadows = true;
        rtcore::setSettingFromText(s, "shadows", no);
        EXPECT_FALSE(s.shadows) << no;
    }
    rtcore::setSettingFromText(s, "exposure.value", "2");
    EXPECT_EQ(s.exposure.value, 2.0F);
    rtcore::setSettingFromText(s, "exposure.value", "1e-3");
    EXPECT_EQ(s.exposure.value, 0.001F);
}

TEST(SettingsTable, TextThatIsNoValueIsRefused) {
    for (const char* text :
         {"", " 3", "3 ", "3x", "0x10", "nan", "inf", "99999999999999999999", "-1", "3.5", "true"})
        EXPECT_NE(textRefusal("width", text), "accepted") << text;
    for (const char* text : {"", "nan", "inf", "-inf", "1e39", "1e-50", "one", "0"})
        EXPECT_NE(textRefusal("exposure.value", text), "accepted") << text;
    for (const char* text : {"", "2", "TRUE ", "maybe"})
        EXPECT_NE(textRefusal("shadows", text), "accepted") << text;
}

TEST(SettingsTable, AWordMayStandForZero) {
    int words = 0;
    for (const Setting& setting : rtcore::settingsTable()) {
        if (setting.zero.empty()) continue;
        ++words;
        EXPECT_EQ(setting.minimum, 0) << setting.name;
        const SettingValue zero =
            setting.type == rtcore::SettingType::Integer ? SettingValue(0) : SettingValue(0.0F);
        EXPECT_EQ(rtcore::parseSetting(setting, setting.zero), zero) << setting.name;
        EXPECT_EQ(rtcore::checkSetting(setting, std::string(setting.zero)), zero) << setting.name;
    }
    EXPECT_GT(words, 5);
    EXPECT_EQ(refusal("maxDepth", std::string("off")),
              "maxDepth is 'off', but takes a whole number, 0 to 1000 bounces");
}

TEST(SettingsTable, TheLiveViewTakesAllButWhatIsForStills) {
    RenderSettings settings;
    EXPECT_NO_THROW(rtcore::checkLive(settings));
    for (const Setting& setting : rtcore::settingsTable()) {
        if (setting.liveChoice.empty()) {
            EXPECT_NO_THROW(rtcore::checkLive(setting, otherValue(setting))) << setting.name;
        } else {
            EXPECT_THROW(rtcore::checkLive(setting, otherValue(setting)), rtcore::BadValue) << setting.name;
        }
    }
    rtcore::setSettingFromText(settings, "integrator", "path");
    try {
        rtcore::checkLive(settings);
        ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "integrator is path, which is for stills, not for the live view; put it "
                                   "into [still], or use 'Renderer --setting integrator=path'");
    }
}

TEST(SettingsTable, TellsWhatAnIntegratorDoesNotUse) {
    using Names = std::vector<std::string_view>;
    const std::vector<rtcore::SettingAssignment> asked{
        {"skyLight.samples", 4},        {"path.samples", 16}, {"antialiasing", 3},
        {"ambientOcclusion.on", false}, {"antialiasing", 4},  {"shadows", false}};
    RenderSettings settings;
    EXPECT_EQ(rtcore::unusedSettings(settings, asked), (Names{"path.samples"}));
    settings.integrator = rtcore::Integrator::Path;
    EXPECT_EQ(rtcore::unusedSettings(settings, asked), (Names{"antialiasing", "skyLight.samples"}));
    EXPECT_EQ(rtcore::unusedSettings(settings, {}), Names{});
}

TEST(SettingsTable, WhatWhittedAloneUsesIsInTheTable) {
    RenderSettings settings;
    settings.integrator = rtcore::Integrator::Path;
    std::vector<rtcore::SettingAssignment> all;
    for (const Setting& setting : rtcore::settingsTable())
        all.push_back({std::string(setting.name), otherValue(setting)});
    EXPECT_EQ(rtcore::unusedSettings(settings, all).size(), 11U);
}

TEST(SettingsTable, FailureLeavesEverythingAsItWas) {
    RenderSettings settings;
    settings.width = 123;
    const std::vector<rtcore::SettingAssignment> assignments{{"width", 7}, {"height", 0}};
    EXPECT_THROW(rtcore::applySettings(settings, assignments), std::invalid_argument);
    EXPECT_EQ(settings.width, 123);
}

TEST(SettingsTable, LaterAssignmentsWin) {
    RenderSettings settings;
    const std::vector<rtcore::SettingAssignment> assignments{{"width", 7}, {"bloom.radius", 3}, {"width", 8}};
    rtcore::applySettings(settings, assignments);
    EXPECT_EQ(settings.width, 8);
    EXPECT_EQ(settings.bloom.radius, 3);
}

TEST(SettingsTable, AllAssignmentsMakeTheSameSettingsAgain) {
    RenderSettings settings;
    settings.exposure.key = 0.33F;
    settings.antialiasing = 5;
    settings.toneMapping = rtcore::ToneMapping::Channels;
    const auto everything = rtcore::settingAssignments(settings, true);
    EXPECT_EQ(everything.size(), rtcore::settingsTable().size());
    RenderSettings again;
    rtcore::applySettings(again, everything);
    EXPECT_EQ(rtcore::settingAssignments(again, true), everything);
}

TEST(SettingsTable, NumbersSurviveTheTripThroughText) {
    std::mt19937 random(5);
    const Setting& setting = rtcore::requireSetting("ambientOcclusion.distance");
    for (int i = 0; i < 10'000; ++i) {
        const float value =
            std::ldexp(static_cast<float>(random() >> 8U), static_cast<int>(random() % 200) - 140);
        EXPECT_EQ(rtcore::parseSetting(setting, rtcore::settingText(value)), SettingValue(value));
    }
}

} // namespace
