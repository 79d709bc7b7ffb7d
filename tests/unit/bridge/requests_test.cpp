#include "bridge/control/command_use.h"
#include "bridge/control/requests.h"
#include "bridge/control/setting_value.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <set>

namespace {

using bridge::Limits;
using bridge::Refused;
using nlohmann::json;

const std::vector<std::string> kBookmarks{"altar", "a \"name\" \\ with; words"};

std::string lineOf(const json& request, const Limits& limits = {}) {
    return bridge::planRequest(request, {limits, kBookmarks}).line;
}

std::string refusalOf(const json& request, const Limits& limits = {}) {
    try {
        return "taken as " + lineOf(request, limits);
    } catch (const Refused& refused) {
        return refused.what();
    }
}

#define EXPECT_REFUSED(...) EXPECT_THROW(lineOf(__VA_ARGS__), Refused)

TEST(CommandUse, DecidesEachCommandOfTheServer) {
    std::set<app::CommandId> asked;
    for (const bridge::RequestName& row : bridge::requestNames()) asked.insert(row.command);
    for (const app::CommandSpec& command : app::commandTable()) {
        const bool request = bridge::commandUse(command.id) == bridge::CommandUse::Request;
        const bool byPrefix = command.id == app::CommandId::Also;
        EXPECT_EQ(request && !byPrefix, asked.contains(command.id)) << command.name;
        if (command.runner == app::Runner::Shell) {
            EXPECT_EQ(bridge::commandUse(command.id), bridge::CommandUse::Forbidden) << command.name;
        }
    }
}

TEST(CommandUse, LetsNothingWithAPathThrough) {
    for (const app::CommandSpec& command : app::commandTable()) {
        for (const app::CommandArgument& argument : command.arguments) {
            if (argument.type != app::ArgumentType::Path) continue;
            EXPECT_EQ(bridge::commandUse(command.id), bridge::CommandUse::Forbidden) << command.name;
        }
    }
    for (const auto id : {app::CommandId::Exit, app::CommandId::Quit, app::CommandId::Parent,
                          app::CommandId::Bind, app::CommandId::KeyPress, app::CommandId::Scene,
                          app::CommandId::ExportVideoStart, app::CommandId::Save})
        EXPECT_EQ(bridge::commandUse(id), bridge::CommandUse::Forbidden) << app::commandOf(id).name;
}

TEST(Requests, BecomeLinesOfTheServersCommands) {
    EXPECT_EQ(lineOf({{"do", "camera"}, {"eye", {0, 1.5, 2}}, {"forward", {0, 0, -1}}}),
              "camera set 0 1.5 2 0 0 -1");
    EXPECT_EQ(
        lineOf(
            {{"do", "camera"}, {"eye", {0, 1, 2}}, {"forward", {0, 0, -1}}, {"fov", 70}, {"up", {0, 1, 0}}}),
        "camera set 0 1 2 0 0 -1 70 0 1 0");
    EXPECT_EQ(lineOf({{"do", "set"}, {"name", "bloom.radius"}, {"value", 8}, {"also", true}}),
              "also set bloom.radius 8");
    EXPECT_EQ(lineOf({{"do", "set"}, {"name", "exposure.mode"}, {"value", "fixed"}}),
              "set exposure.mode fixed");
    EXPECT_EQ(lineOf({{"do", "light"}, {"light", 3}, {"on", false}}), "light 3 off");
    EXPECT_EQ(lineOf({{"do", "lightMove"}, {"light", 3}, {"to", "seen"}, {"x", 0.25}, {"y", 0.5}}),
              "light move 3 seen 0.25 0.5");
    EXPECT_EQ(lineOf({{"do", "lightAim"}, {"light", 3}, {"along", {0, -1, 0}}}), "light aim 3 along 0 -1 0");
    EXPECT_EQ(lineOf({{"do", "lightPower"}, {"light", 3}, {"lumens", 800}}), "light power 3 800 lm");
    EXPECT_EQ(lineOf({{"do", "lightPower"}, {"light", 3}, {"lux", 5000}}), "light power 3 5000 lx");
    EXPECT_EQ(lineOf({{"do", "lightPower"}, {"light", 3}, {"watts", 5}}), "light power 3 5");
    EXPECT_EQ(lineOf({{"do", "lightSize"}, {"light", 3}, {"angle", 0.53}}), "light size 3 0.53");
    EXPECT_EQ(lineOf({{"do", "lightMirrored"}, {"light", 3}, {"on", true}}), "light mirrored 3 on");
    EXPECT_EQ(lineOf({{"do", "lightTemperature"}, {"light", 3}, {"kelvin", nullptr}}),
              "light temperature 3 none");
    EXPECT_EQ(lineOf({{"do", "environment"}, {"number", nullptr}}), "environment none");
    EXPECT_EQ(lineOf({{"do", "skyDate"}, {"year", 2026}, {"month", 6}, {"day", 1}}), "sky date 2026-06-01");
    EXPECT_EQ(lineOf({{"do", "partHide"}, {"parts", {1, 5}}}), "part hide 1 5");
    EXPECT_EQ(lineOf({{"do", "materialSet"}, {"number", 2}, {"key", "diffuse"}, {"value", {1, 0.5, 0}}}),
              "material set 2 diffuse 1 0.5 0");
    EXPECT_EQ(lineOf({{"do", "undo"}}), "undo");
}

TEST(Requests, NameBookmarksByNumber) {
    EXPECT_EQ(lineOf({{"do", "bookmark"}, {"number", 1}}), "bookmark go altar");
    const std::vector<std::string> words = app::splitWords(lineOf({{"do", "bookmark"}, {"number", 2}}));
    ASSERT_EQ(words.size(), 3U);
    EXPECT_EQ(words[2], kBookmarks[1]);
    EXPECT_REFUSED({{"do", "bookmark"}, {"number", 3}});
    EXPECT_REFUSED({{"do", "bookmark"}, {"number", 0}});
}

TEST(Requests, OutOfRangeOrOfAnotherTypeAreRefused) {
    const std::vector<json> wrong{
        json::array(),
        {{"do", 1}},
        {{"do", "exit"}},
        {{"do", "load scene"}},
        {{"do", "screenshot"}, {"file", "/etc/passwd"}},
        {{"do", "camera"}},
        {{"do", "camera"}, {"eye", {0, 1}}, {"forward", {0, 0, -1}}},
        {{"do", "camera"}, {"eye", {0, 1, "x"}}, {"forward", {0, 0, -1}}},
        {{"do", "camera"}, {"eye", {0, 1, 1e31}}, {"forward", {0, 0, -1}}},
        {{"do", "camera"}, {"eye", {0, 1, 0}}, {"forward", {0, 0, -1}}, {"fov", 180}},
        {{"do", "set"}, {"name", "nothing"}, {"value", 1}},
        {{"do", "set"}, {"name", "maxDepth"}, {"value", 2.5}},
        {{"do", "set"}, {"name", "maxDepth"}, {"value", true}},
        {{"do", "set"}, {"name", "maxDepth"}, {"value", {1}}},
        {{"do", "set"}, {"name", "width"}, {"value", 30000}},
        {{"do", "set"}, {"name", "path.samples"}, {"value", 4}},
        {{"do", "set"}, {"name", "integrator"}, {"value", "path"}},
        {{"do", "set"}, {"name", "exposure.mode"}, {"value", "fixed; exit"}},
        {{"do", "light"}, {"light", 0}, {"on", true}},
        {{"do", "light"}, {"light", 1.5}, {"on", true}},
        {{"do", "light"}, {"light", 1}, {"on", "toggle"}},
        {{"do", "lightAdd"}, {"kind", "torch"}},
        {{"do", "lightMove"}, {"light", 1}, {"to", "here exit"}},
        {{"do", "look"}, {"name", "night"}},
        {{"do", "skyDate"}, {"year", 2026}, {"month", 13}, {"day", 1}},
        {{"do", "partHide"}, {"parts", json::array()}},
        {{"do", "partHide"}, {"parts", {"*"}}},
        {{"do", "partHide"}, {"parts", std::vector<int>(65, 1)}},
        {{"do", "materialSet"}, {"number", 1}, {"key", "diffuseTexture"}, {"value", 1}},
        {{"do", "materialSet"}, {"number", 1}, {"key", "diffuse"}, {"value", "1 1 1"}},
        {{"do", "focus"}, {"x", 2}, {"y", 0}},
        {{"do", "speed"}, {"factor", 0}}};
    for (const json& request : wrong) EXPECT_REFUSED(request) << request;
}

TEST(Requests, StayWithinTheCaps) {
    EXPECT_EQ(lineOf({{"do", "set"}, {"name", "antialiasing"}, {"value", 4}}), "set antialiasing 4");
    EXPECT_REFUSED({{"do", "set"}, {"name", "antialiasing"}, {"value", 5}});
    EXPECT_EQ(lineOf({{"do", "resolution"}, {"width", 1920}, {"height", 1080}}), "resolution 1920 1080");
    EXPECT_REFUSED({{"do", "resolution"}, {"width", 1921}, {"height", 1080}});
    EXPECT_REFUSED({{"do", "resolution"}, {"width", 0}, {"height", 1080}});
    for (const bridge::SettingCap& cap : bridge::kCaps) {
        const rtcore::Setting* const setting = rtcore::findSetting(cap.name);
        ASSERT_NE(setting, nullptr) << cap.name;
        const int* const whole = std::get_if<int>(&setting->defaultValue);
        EXPECT_LE(whole != nullptr ? *whole : 0, cap.most) << "the default fits: " << cap.name;
    }
}

TEST(Requests, OfWhatIsLockedAreRefused) {
    Limits some;
    some.locked = {"maxDepth", "width"};
    EXPECT_REFUSED({{"do", "set"}, {"name", "maxDepth"}, {"value", 1}}, some);
    EXPECT_REFUSED({{"do", "resolution"}, {"width", 64}, {"height", 64}}, some);
    EXPECT_REFUSED({{"do", "defaults"}}, some);
    EXPECT_EQ(lineOf({{"do", "light"}, {"light", 1}, {"on", true}}, some), "light 1 on");
    some.locked = {"depthOfField.focus"};
    EXPECT_REFUSED({{"do", "focus"}, {"x", 0.5}, {"y", 0.5}}, some);
    EXPECT_EQ(lineOf({{"do", "seen"}, {"x", 0.5}, {"y", 0.5}}, some), "seen 0.5 0.5");
    some.locked = {"exposure.key"};
    EXPECT_REFUSED({{"do", "look"}, {"name", "sky"}}, some);
    some.locked = {"skyLight.on"};
    EXPECT_REFUSED({{"do", "look"}, {"name", "studio"}}, some);
    EXPECT_REFUSED({{"do", "skyHour"}, {"hour", 12}}, some); // makes a sky, which lights
    EXPECT_REFUSED({{"do", "sky"}, {"on", true}}, some);
    EXPECT_EQ(bridge::planRequest(json{{"do", "skyHour"}, {"hour", 12}}, {some, {}, 0, true}).line,
              "sky hour 12");
}

TEST(Requests, ChangeNothingButTheViewWhereEditsAreLocked) {
    Limits edits;
    edits.locked = {"edits"};
    const json any{{"eye", {0, 0, 0}},
                   {"forward", {0, 0, -1}},
                   {"target", {0, 0, 1}},
                   {"width", 2},
                   {"height", 2},
                   {"degrees", 20},
                   {"mm", 20},
                   {"factor", 2},
                   {"x", 0},
                   {"y", 0},
                   {"number", 1},
                   {"on", true},
                   {"light", 1},
                   {"kind", "point"},
                   {"name", "maxDepth"},
                   {"value", 1},
                   {"to", {0, 0, 0}},
                   {"colour", {1, 1, 1}},
                   {"kelvin", 2700},
                   {"watts", 1},
                   {"radius", 1},
                   {"inner", 1},
                   {"outer", 2},
                   {"hour", 2},
                   {"year", 2026},
                   {"month", 1},
                   {"day", 1},
                   {"latitude", 1},
                   {"longitude", 1},
                   {"direction", {0, 1, 0}},
                   {"turbidity", 3},
                   {"parts", {1}},
                   {"key", "opacity"}};
    const std::set<std::string_view> stay{
        "parts", "materials", "material", "seen",     "camera", "orthographic", "lookAt", "reset",
        "pivot", "orbit",     "pan",      "approach", "fit",    "side",         "angle",  "lens",
        "zoom",  "focus",     "speed",    "walk",     "fly",    "bookmark"};
    for (const bridge::RequestName& row : bridge::requestNames()) {
        json request = any;
        request["do"] = row.name;
        if (row.name == "look") request["name"] = "sky";
        if (row.name == "orbit" || row.name == "pan") request["right"] = request["up"] = 1;
        if (row.name == "side") request["side"] = "front";
        EXPECT_EQ(refusalOf(request, edits) != "edits are locked here", stay.contains(row.name))
            << row.name << ": " << refusalOf(request, edits);
        EXPECT_TRUE(refusalOf(request).starts_with("taken as ")) << row.name << ": " << refusalOf(request);
        const std::set<std::string_view> look{"parts", "materials", "material", "seen"};
        EXPECT_EQ(bridge::planRequest(request, {Limits(), kBookmarks}).anyone, look.contains(row.name))
            << row.name;
    }
}

/// Whatever a page writes: each line that comes out is one of a command that is allowed, with arguments that
/// fit.
TEST(Requests, NeverBecomeOtherCommands) {
    std::mt19937 random(3);
    const std::vector<json> values{1,
                                   -1,
                                   0.5,
                                   1e30,
                                   "exit",
                                   "\"; exit",
                                   "a b",
                                   nullptr,
                                   true,
                                   json::array({1, 2, 3}),
                                   "seen",
                                   "here",
                                   "point",
                                   "maxDepth",
                                   "sky",
                                   "opacity",
                                   "\n quit",
                                   12,
                                   false,
                                   json::array({1, "x", 2}),
                                   json::object(),
                                   "set",
                                   2026,
                                   json::array({json::array()}),
                                   "bloom.radius",
                                   6};
    const std::vector<const char*> keys{"eye",   "forward", "fov",    "up",     "light",  "on",      "number",
                                        "name",  "value",   "kind",   "to",     "x",      "y",       "key",
                                        "parts", "also",    "width",  "height", "factor", "degrees", "year",
                                        "month", "day",     "colour", "kelvin", "watts",  "from"};
    const std::vector<bridge::RequestName> names = bridge::requestNames();
    int taken = 0;
    for (int i = 0; i < 20'000; ++i) {
        json request;
        request["do"] =
            random() % 20 == 0 ? values[random() % values.size()] : json(names[random() % names.size()].name);
        for (const char* key : keys)
            if (random() % 3 != 0) request[key] = values[random() % values.size()];
        try {
            const bridge::PlannedCommand planned = bridge::planRequest(request, {Limits(), kBookmarks});
            ++taken;
            std::vector<std::string> words = app::splitWords(planned.line);
            if (words.front() == "also") words.erase(words.begin());
            const app::FoundCommand found = app::findCommand(words);
            ASSERT_EQ(found.command->id, planned.id);
            ASSERT_EQ(bridge::commandUse(planned.id), bridge::CommandUse::Request) << planned.line;
            app::checkArguments(*found.command, std::span(words).subspan(found.words));
            ASSERT_EQ(planned.line.find('\n'), std::string::npos);
        } catch (const Refused&) {
        }
    }
    EXPECT_GT(taken, 1000);
}

TEST(Answers, OfListsBecomeRows) {
    const json parts =
        bridge::answerContent(bridge::AnswerShape::Parts, "1 shown 480 house/front door\n2 hidden 12 ");
    EXPECT_EQ(parts["parts"][0],
              (json{{"number", 1}, {"shown", true}, {"triangles", 480}, {"name", "house/front door"}}));
    EXPECT_EQ(parts["parts"].size(), 2U);
    EXPECT_FALSE(parts.contains("next"));
    const json materials = bridge::answerContent(bridge::AnswerShape::Materials, "3 edited glass\n4 -");
    EXPECT_EQ(materials["materials"][0], (json{{"number", 3}, {"edited", true}, {"name", "glass"}}));
    const json seen = bridge::answerContent(bridge::AnswerShape::Seen, "part 12 house/door\nmaterial 3 oak");
    EXPECT_EQ(seen["part"]["number"], 12);
    EXPECT_EQ(seen["material"]["name"], "oak");
    EXPECT_EQ(bridge::answerContent(bridge::AnswerShape::Light, "7")["light"], 7);
    for (const char* rubbish : {"", "x", "\n\n", "[[", "1"})
        for (const auto shape : {bridge::AnswerShape::Parts, bridge::AnswerShape::Material,
                                 bridge::AnswerShape::Seen, bridge::AnswerShape::Light})
            EXPECT_TRUE(bridge::answerContent(shape, rubbish).is_object());
}

TEST(SettingsTable, HasTheRowsThatRequestsTake) {
    const json rows = bridge::settingsTableJson(Limits());
    EXPECT_GT(rows.size(), 30U);
    for (const json& row : rows) {
        const std::string line = lineOf({{"do", "set"}, {"name", row["name"]}, {"value", row["default"]}});
        EXPECT_TRUE(line.starts_with("set " + row["name"].get<std::string>())) << row;
        EXPECT_FALSE(row["help"].get<std::string>().empty());
        if (!row.contains("max")) continue;
        EXPECT_REFUSED({{"do", "set"}, {"name", row["name"]}, {"value", row["max"].get<double>() * 1.5 + 1}})
            << row;
    }
}

} // namespace
