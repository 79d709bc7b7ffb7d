// The contents of tables are told nowhere else: no source of a program repeats a list that another one reads
// from its table. The programs' folder is searched, page and all.
#include "common/commands/command_table.h"

#include "rtcore/look/lighting_preset_name.h"
#include "rtcore/math/blackbody.h"
#include "rtcore/scene/light.h"
#include "rtcore/settings/settings_table.h"

#include "ipc/layout/limits.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Source {
    std::string name, text;
};

const std::vector<Source>& sources() {
    static const std::vector<Source> all = [] {
        std::vector<Source> found;
        for (const auto& each : fs::recursive_directory_iterator(RT_PROGRAM_SOURCES)) {
            const std::set<std::string> kinds{".cpp", ".h", ".js", ".py", ".html"};
            if (!each.is_regular_file() || !kinds.contains(each.path().extension().string())) continue;
            std::ifstream file(each.path());
            found.push_back({fs::relative(each.path(), RT_PROGRAM_SOURCES).generic_string(),
                             {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}});
        }
        return found;
    }();
    return all;
}

/// Sources that have `max` words of the list between quotation marks, or more.
std::vector<std::string> tellers(const std::set<std::string_view>& list, std::size_t max) {
    std::vector<std::string> names;
    for (const Source& source : sources()) {
        std::size_t told = 0;
        for (const std::string_view word : list)
            told += source.text.find(fmt::format("\"{}\"", word)) != std::string::npos ? 1U : 0U;
        if (told >= max) names.push_back(source.name);
    }
    return names;
}

using Names = std::vector<std::string>;

TEST(ToldOnce, SourcesAreThere) { EXPECT_GT(sources().size(), 500U); }

TEST(ToldOnce, KindsOfLight) {
    std::set<std::string_view> names;
    for (const rtcore::LightTraits& kind : rtcore::kLightTraits) names.insert(kind.name);
    EXPECT_EQ(tellers(names, 3), Names{});
}

TEST(ToldOnce, Looks) {
    EXPECT_EQ(tellers({rtcore::kLightingPresetNames.begin(), rtcore::kLightingPresetNames.end()},
                      rtcore::kLightingPresetNames.size()),
              Names{});
}

TEST(ToldOnce, LabelsOfSteps) {
    std::set<std::string_view> labels;
    for (const app::CommandSpec& command : app::commandTable())
        if (command.step.find(' ') != std::string_view::npos) labels.insert(command.step);
    ASSERT_GT(labels.size(), 10U);
    for (const std::string& name : tellers(labels, 2))
        EXPECT_TRUE(name.starts_with("common/commands/") && name.ends_with("_rows.cpp")) << name;
}

TEST(ToldOnce, LabelsAndCapsOfSettings) {
    std::set<std::string_view> labels, capped;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (!setting.label.empty()) labels.insert(setting.label);
        if (setting.browser.maximum < rtcore::kUnlimited) capped.insert(setting.name);
    }
    EXPECT_EQ(tellers(labels, 3), Names{});
    for (const std::string& name : tellers(capped, 3)) EXPECT_FALSE(name.starts_with("bridge/")) << name;
}

TEST(ToldOnce, Ranges) {
    for (const double limit : {double{ipc::kMaxFrameSide}, rtcore::requireSetting("width").maximum,
                               rtcore::kMinTemperature, rtcore::kMaxTemperature})
        for (const Source& source : sources()) {
            const std::string number = fmt::format("{:.0f}", limit);
            const bool part = source.name == "bridge/stream/rate_control.cpp"; // bytes of one
            const std::size_t at = source.text.find(number);
            EXPECT_TRUE(part || at == std::string::npos) << number << " in " << source.name;
        }
}

} // namespace
