/// docs/bridge.md says what the tables of the program say. RT_RENEW_DOCS=1 in the environment writes its
/// options anew.
#include "bridge/bridge_options.h"
#include "bridge/control/requests.h"
#include "bridge/report/metrics.h"
#include "bridge/report/status.h"
#include "bridge/stream/rung.h"

#include "common/cli/command_names.h"
#include "support/document_section.h"

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

TEST(BridgeDocument, HasEveryRequest) {
    const std::string page = pageText();
    for (const bridge::RequestName& row : bridge::requestNames())
        EXPECT_NE(page.find("`" + std::string(row.name) + "`"), std::string::npos) << row.name;
}

TEST(BridgeDocument, HasTheCapsThatItNames) {
    const auto most = [](std::string_view name) {
        return std::ranges::find(bridge::kCaps, name, &bridge::SettingCap::name)->most;
    };
    EXPECT_EQ(most("antialiasing"), 4);
    EXPECT_EQ(most("areaLights.samples"), 64);
    EXPECT_EQ(bridge::kMostLights, 64U);
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
