#include "bridge/control/requests.h"
#include "bridge/control/setting_value.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include "rtcore/scene/scene_note.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <set>

namespace {

using bridge::Limits;
using bridge::Refused;
using nlohmann::json;

const std::vector<std::string> kBookmarks{"altar", "a \"name\" \\ with; words"};
const std::vector<std::string> kFlights{"around", "to the altar"};
const std::vector<std::string> kVariants{"oak", "by night"};

bridge::PlannedCommand plannedIn(const json& request, const Limits& limits = {}) {
    return bridge::planRequest(request, {.limits = limits,
                                         .bookmarks = kBookmarks,
                                         .lights = 0,
                                         .sky = false,
                                         .flights = kFlights,
                                         .variants = kVariants});
}

std::string lineOf(const json& request, const Limits& limits = {}) { return plannedIn(request, limits).line; }

std::string refusalOf(const json& request, const Limits& limits = {}) {
    try {
        return "taken as " + lineOf(request, limits);
    } catch (const Refused& refused) {
        return refused.what();
    }
}

#define EXPECT_REFUSED(...) EXPECT_THROW(lineOf(__VA_ARGS__), Refused)

json request(const char* command, const json& arguments = json::array()) {
    return {{"do", command}, {"args", arguments}};
}

std::set<std::string_view> commandsFor(app::BrowserUse use) {
    std::set<std::string_view> names;
    for (const app::CommandSpec& command : app::commandTable())
        if (command.browser == use) names.insert(command.name);
    return names;
}

/// The commands that pages may give. A row of the table that permits more than this list is a mistake there,
/// or is put here on purpose.
TEST(BrowserUse, IsPermittedToTheseAlone) {
    using Names = std::set<std::string_view>;
    EXPECT_EQ(commandsFor(app::BrowserUse::Own),
              (Names{"also", "bindings", "by", "camera turn", "messages", "state", "visitor"}));
    EXPECT_EQ(commandsFor(app::BrowserUse::Look),
              (Names{"flight list", "material get", "materials", "measure angle", "measure distance",
                     "measure face", "measure hidden", "measure list", "measure point", "measure seen",
                     "measure volume", "note get", "note list", "parts", "plan outline", "sections", "seen",
                     "storeys", "variant list"}));
    EXPECT_EQ(commandsFor(app::BrowserUse::Move), (Names{"bookmark go",
                                                         "camera angle",
                                                         "camera approach",
                                                         "camera fit",
                                                         "camera lens",
                                                         "camera look-at",
                                                         "camera orbit",
                                                         "camera orthographic",
                                                         "camera pan",
                                                         "camera pivot",
                                                         "camera reset",
                                                         "camera set",
                                                         "camera view",
                                                         "camera zoom",
                                                         "flight go",
                                                         "flight play",
                                                         "fly",
                                                         "focus",
                                                         "measure light",
                                                         "note go",
                                                         "speed",
                                                         "storey go",
                                                         "walk"}));
    EXPECT_EQ(commandsFor(app::BrowserUse::Edit), (Names{"bloom",
                                                         "defaults",
                                                         "environment",
                                                         "environment none",
                                                         "environment rotation",
                                                         "environment strength",
                                                         "light",
                                                         "light add",
                                                         "light aim",
                                                         "light angles",
                                                         "light colour",
                                                         "light copy",
                                                         "light kind",
                                                         "light mirrored",
                                                         "light turn",
                                                         "light move",
                                                         "light power",
                                                         "light remove",
                                                         "light size",
                                                         "light temperature",
                                                         "look",
                                                         "material reset",
                                                         "material set",
                                                         "measure keep angle",
                                                         "measure keep chain",
                                                         "measure keep distance",
                                                         "measure keep face",
                                                         "measure keep height",
                                                         "measure keep seen",
                                                         "measure keep volume",
                                                         "measure remove",
                                                         "measure unit",
                                                         "note add",
                                                         "note at",
                                                         "note remove",
                                                         "note text",
                                                         "part hide",
                                                         "part isolate",
                                                         "part show",
                                                         "part show-all",
                                                         "pause",
                                                         "quality",
                                                         "redo",
                                                         "resolution",
                                                         "resume",
                                                         "section add",
                                                         "section at",
                                                         "section box",
                                                         "section caps",
                                                         "section clear",
                                                         "section colour",
                                                         "section cut",
                                                         "section hatching",
                                                         "section here",
                                                         "section leave",
                                                         "section light",
                                                         "section move",
                                                         "section plane",
                                                         "section remove",
                                                         "section through",
                                                         "section turn",
                                                         "set",
                                                         "sky",
                                                         "sky date",
                                                         "sky direction",
                                                         "sky ground",
                                                         "sky haze",
                                                         "sky hour",
                                                         "sky north",
                                                         "sky place",
                                                         "sky strength",
                                                         "sky turbidity",
                                                         "undo",
                                                         "variant go",
                                                         "variant leave"}));
    for (const app::CommandSpec& command : app::commandTable())
        EXPECT_TRUE(command.runner != app::Runner::Shell || command.browser == app::BrowserUse::Forbidden)
            << command.name;
}

TEST(BrowserUse, LetsNoTextAndNoPathThrough) {
    using enum app::ArgumentType;
    for (const app::CommandSpec& command : app::commandTable()) {
        if (!bridge::isRequest(command)) continue;
        for (const app::CommandArgument& argument : command.arguments)
            for (const app::ArgumentType type : {Path, Text, Key, Action})
                EXPECT_NE(argument.type, type) << command.name << " " << argument.name;
    }
}

TEST(Requests, BecomeLinesOfTheServersCommands) {
    EXPECT_EQ(lineOf(request("camera set", {0, 1.5, 2, 0, 0, -1})), "camera set 0 1.5 2 0 0 -1");
    EXPECT_EQ(lineOf(request("camera set", {0, 1, 2, 0, 0, -1, 70, 0, 1, 0})),
              "camera set 0 1 2 0 0 -1 70 0 1 0");
    json also = request("set", {"bloom.radius", 8});
    also["also"] = true;
    EXPECT_EQ(lineOf(also), "also set bloom.radius 8");
    EXPECT_EQ(lineOf(request("set", {"exposure.mode", "fixed"})), "set exposure.mode fixed");
    EXPECT_EQ(lineOf(request("light", {3, "off"})), "light 3 off");
    EXPECT_EQ(lineOf(request("light move", {3, "seen", 0.25, 0.5})), "light move 3 seen 0.25 0.5");
    EXPECT_EQ(lineOf(request("light aim", {3, "along", 0, -1, 0})), "light aim 3 along 0 -1 0");
    EXPECT_EQ(lineOf(request("light power", {3, 800, "lm"})), "light power 3 800 lm");
    EXPECT_EQ(lineOf(request("light power", {3, 5})), "light power 3 5");
    EXPECT_EQ(lineOf(request("light temperature", {3, "none"})), "light temperature 3 none");
    EXPECT_EQ(lineOf(request("environment none")), "environment none");
    EXPECT_EQ(lineOf(request("sky date", {"2026-06-01"})), "sky date 2026-06-01");
    EXPECT_EQ(lineOf(request("part hide", {1, 5})), "part hide 1 5");
    EXPECT_EQ(lineOf(request("camera fit")), "camera fit");
    EXPECT_EQ(lineOf(request("material set", {2, "diffuse", 1, 0.5, 0})), "material set 2 diffuse 1 0.5 0");
    EXPECT_EQ(lineOf(request("material set", {2, "textures", false})), "material set 2 textures false");
    EXPECT_EQ(lineOf({{"do", "undo"}}), "undo");
}

TEST(Requests, NameBookmarksByNumber) {
    EXPECT_EQ(lineOf(request("bookmark go", {1})), "bookmark go altar");
    const std::vector<std::string> words = app::splitWords(lineOf(request("bookmark go", {2})));
    ASSERT_EQ(words.size(), 3U);
    EXPECT_EQ(words[2], kBookmarks[1]);
    for (const json& wrong : {json(3), json(0), json(1.5), json("altar"), json(1e300)})
        EXPECT_REFUSED(request("bookmark go", {wrong})) << wrong;
    EXPECT_EQ(lineOf(request("flight play", {2})), "flight play \"to the altar\"");
    EXPECT_EQ(lineOf(request("flight go", {1, 2.5})), "flight go around 2.5");
    EXPECT_REFUSED(request("flight play", {3}));
    EXPECT_REFUSED(request("flight play", {"around"}));
    EXPECT_EQ(lineOf(request("variant go", {2})), "variant go \"by night\"");
    EXPECT_EQ(lineOf({{"do", "variant leave"}}), "variant leave");
    EXPECT_REFUSED(request("variant go", {3}));
    EXPECT_REFUSED(request("variant add", {"a"}));
    EXPECT_REFUSED(request("flight export", {1, "/tmp/x.lst"}));
}

TEST(Requests, TakeEachWordOfTheTables) {
    for (const app::CommandSpec& command : app::commandTable()) {
        if (!bridge::isRequest(command) || command.arguments.empty()) continue;
        const app::CommandArgument& last = command.arguments.back();
        if (command.arguments.size() > 2 || last.words.empty()) continue;
        for (const std::string_view word : app::wordsOf(last)) {
            json arguments = json::array({1});
            if (command.arguments.size() == 1) arguments.clear();
            arguments.push_back(word);
            EXPECT_TRUE(lineOf({{"do", command.name}, {"args", arguments}}).ends_with(word)) << word;
        }
    }
}

TEST(Requests, OutOfRangeOrOfAnotherTypeAreRefused) {
    const std::vector<json> wrong{json::array(),
                                  {{"do", 1}},
                                  {{"do", "exit"}},
                                  {{"do", "load scene"}},
                                  {{"do", "walk"}, {"args", 1}},
                                  {{"do", "walk"}, {"args", {1}}},
                                  {{"do", "set"}, {"args", {"maxDepth", 1}}, {"also", 1}},
                                  request("screenshot", {"/etc/passwd"}),
                                  request("light name", {1, "x"}),
                                  request("undo", {1}),
                                  request("camera set"),
                                  request("camera set", {0, 1, 0, 0, -1}),
                                  request("camera set", {0, 1, "x", 0, 0, -1}),
                                  request("camera set", {0, 1, 1e31, 0, 0, -1}),
                                  request("camera set", {0, 1, 0, 0, 0, -1, 180}),
                                  request("camera fit", {"roof*"}),
                                  request("set", {"nothing", 1}),
                                  request("set", {"maxDepth"}),
                                  request("set", {"maxDepth", 2.5}),
                                  request("set", {"maxDepth", true}),
                                  request("set", {"maxDepth", json::array({1})}),
                                  request("set", {"width", 30000}),
                                  request("set", {"path.samples", 4}),
                                  request("set", {"integrator", "path"}),
                                  request("set", {"exposure.mode", "fixed; exit"}),
                                  request("light", {0, "on"}),
                                  request("light", {1.5, "on"}),
                                  request("light", {1, true}),
                                  request("light", {1, "maybe"}),
                                  request("light add", {"torch"}),
                                  request("light move", {1, "here exit"}),
                                  request("look", {"night"}),
                                  request("sky date", {"2026-13-01"}),
                                  request("sky date", {"2026-06-01; exit"}),
                                  request("sky date", {20260601}),
                                  request("part hide"),
                                  request("part hide", {"*"}),
                                  request("part hide", {0}),
                                  request("part hide", std::vector<int>(65, 1)),
                                  request("material set", {"*", "opacity", 1}),
                                  request("material set", {1, "diffuseTexture", 1}),
                                  request("material set", {1, "diffuse", "1 1 1"}),
                                  request("focus", {2, 0}),
                                  request("speed", {0})};
    for (const json& each : wrong) EXPECT_REFUSED(each) << each;
}

TEST(Requests, StayWithinTheCaps) {
    EXPECT_EQ(lineOf(request("set", {"antialiasing", 4})), "set antialiasing 4");
    EXPECT_REFUSED(request("set", {"antialiasing", 5}));
    EXPECT_EQ(lineOf(request("resolution", {1920, 1080})), "resolution 1920 1080");
    EXPECT_REFUSED(request("resolution", {1921, 1080}));
    EXPECT_REFUSED(request("resolution", {0, 1080}));
}

TEST(Requests, OfWhatIsLockedAreRefused) {
    Limits some;
    some.locked = {"maxDepth", "width"};
    EXPECT_REFUSED(request("set", {"maxDepth", 1}), some);
    EXPECT_REFUSED(request("resolution", {64, 64}), some);
    EXPECT_REFUSED(request("defaults"), some);
    EXPECT_EQ(lineOf(request("light", {1, "on"}), some), "light 1 on");
    EXPECT_REFUSED(request("quality", {"final"}), some);
    some.locked = {"depthOfField.focus"};
    EXPECT_REFUSED(request("focus", {0.5, 0.5}), some);
    EXPECT_EQ(lineOf(request("seen", {0.5, 0.5}), some), "seen 0.5 0.5");
    some.locked = {"exposure.key"};
    EXPECT_REFUSED(request("look", {"sky"}), some);
    some.locked = {"skyLight.on"};
    EXPECT_REFUSED(request("look", {"studio"}), some);
    EXPECT_REFUSED(request("sky hour", {12}), some); // makes a sky, which lights
    EXPECT_REFUSED(request("sky", {"on"}), some);
    EXPECT_EQ(bridge::planRequest(request("sky hour", {12}), {some, {}, 0, true}).line, "sky hour 12");
}

/// Arguments that each command takes.
json usual(const app::CommandSpec& command) {
    json arguments = json::array();
    for (const app::CommandArgument& argument : command.arguments) {
        if (argument.optional) break;
        switch (argument.type) {
        case app::ArgumentType::Setting:
            arguments.push_back("maxDepth");
            break;
        case app::ArgumentType::MaterialKey:
            arguments.push_back("opacity");
            break;
        case app::ArgumentType::Note:
            arguments.push_back("too dark");
            break;
        case app::ArgumentType::Date:
            arguments.push_back("2026-01-01");
            break;
        case app::ArgumentType::Choice:
            arguments.push_back(app::wordsOf(argument).front());
            break;
        default:
            if (!argument.repeats) arguments.push_back(argument.minimum > -1e9 ? argument.minimum + 1 : 1);
        }
    }
    if (command.id == app::CommandId::CameraSet || command.id == app::CommandId::CameraLookAt)
        return json{0, 0, 0, 0, 0, -1};
    if (command.name == "seen" || command.id == app::CommandId::Focus) return json{0, 0};
    if (command.id == app::CommandId::CameraOrthographic) return json{0, 0, 0, 0, 0, -1, 2};
    return arguments;
}

TEST(Requests, ChangeNothingButTheViewWhereEditsAreLocked) {
    Limits edits;
    edits.locked = {"edits"};
    for (const app::CommandSpec& command : app::commandTable()) {
        if (!bridge::isRequest(command)) continue;
        const json each{{"do", command.name}, {"args", usual(command)}};
        EXPECT_EQ(refusalOf(each, edits) == "edits are locked here", command.browser == app::BrowserUse::Edit)
            << each << ": " << refusalOf(each, edits);
        ASSERT_TRUE(refusalOf(each).starts_with("taken as ")) << each << ": " << refusalOf(each);
        EXPECT_EQ(plannedIn(each).anyone, command.browser == app::BrowserUse::Look) << command.name;
    }
}

TEST(Requests, HoldTheTextsOfNotesAsOneWord) {
    EXPECT_EQ(lineOf(request("note add", {0, 1.5, -2, "too \"dark\"\\\r\nhere; exit", "Ada L"})),
              "note add 0 1.5 -2 \"too \\\"dark\\\"\\\\\nhere; exit\" \"Ada L\"");
    EXPECT_EQ(lineOf(request("note at", {0.5, 0.25, "a"})), "note at 0.5 0.25 a");
    EXPECT_EQ(lineOf(request("note text", {1, "\u001B[1m\u202Eb", ""})), "note text 1 [1mb \"\"");
    EXPECT_EQ(lineOf(request("note add", {0, 0, 0, "<b>=1</b>"})), "note add 0 0 0 <b>=1</b>");
    for (const json& text : {json(""), json(" \n"), json("\a"), json(7), json(true), json::array({"a"}),
                             json(), json(std::string(rtcore::kMaxNoteText + 1, 'x'))})
        EXPECT_REFUSED(request("note add", {0, 0, 0, text})) << text;
    std::string longest;
    for (std::size_t i = 0; i < rtcore::kMaxNoteText; ++i) longest += "\u20AC";
    EXPECT_EQ(lineOf(request("note add", {0, 0, 0, longest})), "note add 0 0 0 " + longest);
    EXPECT_LT(request("note add", {0, 0, 0, longest}).dump().size(), bridge::kMaxPageMessage);
    EXPECT_REFUSED(request("note add", {0, 0, 0, "a", std::string(65, 'x')}));
    EXPECT_REFUSED(request("note add", {0, 0, 0, "a", 7}));
    EXPECT_REFUSED(request("note add", {0, 0, 0, "a", "b", "c"}));
    EXPECT_REFUSED(request("note export", {"/tmp/x.csv"}));
}

TEST(Requests, OfAllPagesMayAddNotesWhereThatIsAllowed) {
    Limits visitors;
    visitors.visitorNotes = true;
    visitors.locked = {"edits"};
    const auto planned = [&](const json& each, const Limits& limits) { return plannedIn(each, limits); };
    EXPECT_FALSE(planned(request("note add", {0, 0, 0, "a", "Ada"}), {}).anyone);
    for (const json& each :
         {request("note add", {0, 0, 0, "a", "Ada"}), request("note at", {0, 0, "a", "Ada"})}) {
        EXPECT_TRUE(planned(each, visitors).anyone) << each;
        EXPECT_TRUE(planned(each, visitors).named) << each;
        EXPECT_TRUE(planned(each, visitors).edits) << each;
    }
    EXPECT_FALSE(planned(request("note at", {0, 0, "a"}), visitors).named);
    EXPECT_FALSE(planned(request("note at", {0, 0, "a", " "}), visitors).named);
    for (const json& each : {request("note remove", {1}), request("note remove", {"all"}),
                             request("note text", {1, "a", "Ada"})})
        EXPECT_EQ(refusalOf(each, visitors), "edits are locked here") << each;
    visitors.locked.clear();
    for (const json& each :
         {request("note remove", {1}), request("note text", {1, "a"}), request("note go", {1})})
        EXPECT_FALSE(planned(each, visitors).anyone) << each;
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
                                   "on",
                                   "maxDepth",
                                   "sky",
                                   "opacity",
                                   "\n quit",
                                   12,
                                   false,
                                   json::object(),
                                   "set",
                                   "2026-06-01",
                                   json::array({json::array()}),
                                   "bloom.radius",
                                   6,
                                   2,
                                   "also"};
    std::vector<std::string_view> names;
    for (const app::CommandSpec& command : app::commandTable()) names.push_back(command.name);
    int taken = 0;
    for (int i = 0; i < 100'000; ++i) {
        json each;
        each["do"] =
            random() % 20 == 0 ? values[random() % values.size()] : json(names[random() % names.size()]);
        each["args"] = json::array();
        for (auto count = random() % 5; count > 0; --count)
            each["args"].push_back(values[random() % values.size()]);
        if (random() % 3 == 0) each["also"] = values[random() % values.size()];
        try {
            const bridge::PlannedCommand planned = plannedIn(each);
            ++taken;
            std::vector<std::string> words = app::splitWords(planned.line);
            if (words.front() == "also") words.erase(words.begin());
            const app::FoundCommand found = app::findCommand(words);
            ASSERT_EQ(found.command->id, planned.id);
            ASSERT_TRUE(bridge::isRequest(*found.command)) << planned.line;
            app::checkArguments(*found.command, std::span(words).subspan(found.words));
            ASSERT_EQ(planned.line.find('\n'), std::string::npos);
        } catch (const Refused&) {
        }
    }
    EXPECT_GT(taken, 1000);
}

TEST(Answers, OfListsBecomeRows) {
    const json parts =
        bridge::answerContent(app::CommandId::Parts, "1 shown 480 house/front door\n2 hidden 12 ");
    EXPECT_EQ(parts["parts"][0],
              (json{{"number", 1}, {"shown", true}, {"triangles", 480}, {"name", "house/front door"}}));
    EXPECT_EQ(parts["parts"].size(), 2U);
    EXPECT_FALSE(parts.contains("next"));
    const json materials = bridge::answerContent(app::CommandId::Materials, "3 edited glass\n4 -");
    EXPECT_EQ(materials["materials"][0], (json{{"number", 3}, {"edited", true}, {"name", "glass"}}));
    const json seen = bridge::answerContent(app::CommandId::Seen, "part 12 house/door\nmaterial 3 oak");
    EXPECT_EQ(seen["part"]["number"], 12);
    EXPECT_EQ(seen["material"]["name"], "oak");
    EXPECT_EQ(bridge::answerContent(app::CommandId::LightAdd, "7")["light"], 7);
    EXPECT_EQ(bridge::answerContent(app::CommandId::NoteGet, "see /etc/x\n<b>")["note"], "see /etc/x\n<b>");
    for (const char* rubbish : {"", "x", "\n\n", "[[", "1"})
        for (const auto command : {app::CommandId::Parts, app::CommandId::MaterialGet, app::CommandId::Seen,
                                   app::CommandId::LightAdd})
            EXPECT_TRUE(bridge::answerContent(command, rubbish).is_object());
}

TEST(SettingsTable, HasTheRowsThatRequestsTake) {
    const json rows = bridge::settingsTableJson(Limits());
    EXPECT_GT(rows.size(), 30U);
    for (const json& row : rows) {
        const std::string line = lineOf(request("set", {row["name"], row["default"]}));
        EXPECT_TRUE(line.starts_with("set " + row["name"].get<std::string>())) << row;
        EXPECT_FALSE(row["help"].get<std::string>().empty());
        if (!row.contains("max")) continue;
        EXPECT_REFUSED(request("set", {row["name"], row["max"].get<double>() * 1.5 + 1})) << row;
    }
}

} // namespace
