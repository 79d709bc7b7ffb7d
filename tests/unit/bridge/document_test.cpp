/// docs/bridge.md says what the tables of the program say. RT_RENEW_DOCS=1 in the environment writes its
/// options anew.
#include "bridge/bridge_options.h"
#include "bridge/control/requests.h"
#include "bridge/report/metrics.h"
#include "bridge/report/status.h"
#include "bridge/stream/rung.h"
#include "bridge/stream/wire.h"

#include "common/cli/command_names.h"
#include "support/document_section.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace {

const std::string kPage = RT_DOCUMENTS "/bridge.md";

std::string pageText() {
    std::ifstream file(kPage);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(BridgeDocument, HasTheOptions) {
    for (const app::OptionGroup& group : bridge::bridgeSpec().groups) {
        std::string rows = test::tableRow({"option", ""}) + "|---|---|\n";
        for (const app::Option& option : group.options) {
            std::string label = "`";
            for (const std::string& spelling : app::optionSpellings(option))
                label += (label.size() > 1 ? ", " : "") + spelling;
            label += (option.argument.empty() ? "" : "=" + option.argument) + "`";
            rows += test::tableRow({label, option.help + (option.more.empty() ? "" : ". " + option.more)});
        }
        test::expectSection(kPage, "RTBridge: " + group.title, rows);
    }
}

/// Arguments as the manual shows them, with ranges.
std::string argumentText(const app::CommandSpec& command) {
    std::string text;
    const nlohmann::json commands = bridge::commandTableJson();
    for (const nlohmann::json& row : commands[std::string(command.name)]) {
        if (!row.contains("min") && !row.contains("max")) continue;
        const auto limit = [&](const char* key) { return fmt::format("{:g}", row[key].get<double>()); };
        text += fmt::format("{}{}: {}{}", text.empty() ? "" : ", ", row["name"].get<std::string>(),
                            row.contains("min") ? limit("min") : "",
                            row.contains("max") ? (row.contains("min") ? " to " : "up to ") + limit("max")
                                                : " or more");
    }
    return text;
}

TEST(BridgeDocument, HasTheCommands) {
    const std::pair<app::BrowserUse, const char*> kinds[] = {{app::BrowserUse::Look, "looking"},
                                                             {app::BrowserUse::Move, "moving"},
                                                             {app::BrowserUse::Edit, "editing"}};
    for (const auto& [use, title] : kinds) {
        std::string rows = test::tableRow({"`do`", "`args`", "ranges"}) + "|---|---|---|\n";
        for (const app::CommandSpec& command : app::commandTable()) {
            if (command.browser != use) continue;
            const std::string arguments = app::argumentsLabel(command);
            rows += test::tableRow({fmt::format("`{}`", command.name),
                                    arguments.empty() ? "" : fmt::format("`{}`", arguments),
                                    argumentText(command)});
        }
        test::expectSection(kPage, std::string("Commands for ") + title, rows);
    }
}

TEST(BridgeDocument, HasTheCaps) {
    std::string rows = test::tableRow({"setting", "from", "to"}) + "|---|---|---|\n";
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        const bool above = setting.browser.minimum > -rtcore::kUnlimited;
        const bool below = setting.browser.maximum < rtcore::kUnlimited;
        if (above || below)
            rows += test::tableRow({fmt::format("`{}`", setting.name),
                                    above ? fmt::format("{:g}", setting.browser.minimum) : "",
                                    below ? fmt::format("{:g}", setting.browser.maximum) : ""});
    }
    test::expectSection(kPage, "Caps of settings", rows);
    EXPECT_NE(pageText().find(fmt::format("{} lights", bridge::kMaxLights)), std::string::npos);
}

TEST(BridgeDocument, HasTheVersion) {
    EXPECT_NE(pageText().find(fmt::format("This is protocol version {}.", bridge::kPageVersion)),
              std::string::npos);
}

TEST(BridgeDocument, HasEveryMetric) {
    const std::string page = pageText();
    std::istringstream lines(bridge::metricsText(std::vector<bridge::RoomFigures>(1), {}, 0));
    int metrics = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string hash, what, name;
        words >> hash >> what >> name;
        if (what != "TYPE") continue;
        ++metrics;
        EXPECT_NE(page.find("`" + name), std::string::npos) << name;
    }
    EXPECT_GT(metrics, 8);
}

TEST(BridgeDocument, HasEveryKeyOfStatus) {
    const std::string page = pageText();
    bridge::RoomFigures room;
    room.sessions.resize(1);
    const nlohmann::json status = bridge::statusOf(room);
    const auto expectKeys = [&](const nlohmann::json& object) {
        for (const auto& [key, value] : object.items())
            EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
    };
    for (const nlohmann::json& each :
         {status, status["cpuSeconds"], status["encode"][0], status["sessions"][0]})
        expectKeys(each);
}

} // namespace
