// No request makes frames dearer than the caps, whatever setting there is.
#include "bridge/control/requests.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace {

using bridge::Limits;
using nlohmann::json;

/// Numbers whose size costs no time worth naming. A new setting is put here or among the caps.
const std::set<std::string_view> kCheap{
    "adaptive",
    "ambientOcclusion.distance",
    "ambientOcclusion.light",
    "depthOfField.fNumber",
    "depthOfField.focus",
    "depthOfField.blades",
    "denoise.passes",
    "bloom.share",
    "exposure.value",
    "exposure.key",
    "exposure.brighterSeconds",
    "exposure.darkerSeconds",
    "exposure.local",
    "falseColours.from",
    "falseColours.to",
    "toneContrast",
};

bool takes(std::string_view name, const json& value, const Limits& limits = {}) {
    try {
        bridge::planRequest({{"do", "set"}, {"args", {name, value}}}, {limits, {}});
        return true;
    } catch (const bridge::Refused&) {
        return false;
    }
}

bool isNumber(const rtcore::Setting& setting) {
    return setting.type == rtcore::SettingType::Integer || setting.type == rtcore::SettingType::Number;
}

bool isCapped(const rtcore::Setting& setting) {
    return setting.browser.maximum < rtcore::kUnlimited || setting.browser.minimum > -rtcore::kUnlimited;
}

TEST(Caps, DecideEachNumberOfTheTable) {
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (!setting.browser.offered || !isNumber(setting)) continue;
        EXPECT_NE(isCapped(setting), kCheap.contains(setting.name)) << setting.name;
    }
    for (const std::string_view name : kCheap) EXPECT_NE(rtcore::findSetting(name), nullptr) << name;
}

TEST(Caps, HoldForEachSettingOfTheTable) {
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (!setting.browser.offered || !isNumber(setting)) continue;
        const double max = bridge::maxOf(setting), min = bridge::minOf(setting);
        EXPECT_LE(max, setting.maximum) << setting.name;
        EXPECT_GE(min, setting.minimum) << setting.name;
        EXPECT_TRUE(takes(setting.name, min)) << setting.name;
        if (max < rtcore::kUnlimited) {
            EXPECT_TRUE(takes(setting.name, max)) << setting.name;
            EXPECT_FALSE(takes(setting.name, 1.01 * max + 1)) << setting.name;
            EXPECT_FALSE(takes(setting.name, std::to_string(1.01 * max + 1))) << setting.name << " as text";
        }
        EXPECT_FALSE(takes(setting.name, min - 1)) << setting.name;
    }
    EXPECT_FALSE(takes("minContribution", 0)) << "bounces would double without end";
    EXPECT_FALSE(takes("minContribution", 0.0009));
    EXPECT_TRUE(takes("minContribution", 0.001));
}

TEST(Caps, LeaveDefaultsWithinThem) {
    for (const rtcore::Setting& setting : rtcore::settingsTable())
        EXPECT_TRUE(!setting.browser.offered ||
                    takes(setting.name,
                          std::visit([](const auto& each) { return json(each); }, setting.defaultValue)))
            << setting.name;
}

TEST(Caps, LetNobodyChangeWhatIsForStills) {
    int found = 0;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (setting.name != "integrator" && !setting.name.starts_with("path.")) continue;
        ++found;
        for (const json& value : {json(1), json(0), json(4096), json("path"), json("whitted"), json(true)})
            EXPECT_FALSE(takes(setting.name, value)) << setting.name << " " << value;
    }
    EXPECT_GT(found, 5);
    for (const char* size : {"width", "height"}) EXPECT_FALSE(takes(size, 64)) << "by `resolution` only";
}

TEST(Caps, HoldByFormerNamesToo) {
    for (const char* name : {"lampSamples", "ambientOcclusion.rays"}) EXPECT_FALSE(takes(name, 1)) << name;
}

TEST(Caps, OfPixelsHoldForAnyTwoSides) {
    const auto taken = [](std::int64_t width, std::int64_t height) {
        const Limits limits;
        try {
            bridge::planRequest({{"do", "resolution"}, {"args", {width, height}}}, {limits, {}});
            return true;
        } catch (const bridge::Refused&) {
            return false;
        }
    };
    EXPECT_TRUE(taken(1920, 1080));
    for (const auto& [width, height] : {std::pair<std::int64_t, std::int64_t>{16384, 127},
                                        {1, 16385},
                                        {16384, 16384},
                                        {std::int64_t(1) << 32, std::int64_t(1) << 32},
                                        {-1920, -1080}})
        EXPECT_FALSE(taken(width, height)) << width << " x " << height;
}

TEST(Caps, OfLightsHoldForNewOnesAndCopies) {
    const Limits limits;
    const json add{{"do", "light add"}, {"args", {"sphere"}}}, copy{{"do", "light copy"}, {"args", {1}}};
    for (const json& request : {add, copy}) {
        EXPECT_NO_THROW(bridge::planRequest(request, {limits, {}, bridge::kMaxLights - 1})) << request;
        EXPECT_THROW(bridge::planRequest(request, {limits, {}, bridge::kMaxLights}), bridge::Refused)
            << request;
    }
}

} // namespace
