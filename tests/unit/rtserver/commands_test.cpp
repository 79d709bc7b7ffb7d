/// Every command of the table by itself: its answer and its changes, or its refusal. Several commands
/// together: command_effects_test.cpp.
#include "command_room.h"

#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

namespace rtserver {
namespace {

using rtcore::Change;
using rtcore::Changes;

struct Case {
    std::string line;
    Changes changes = {};
    std::string answer = ""; ///< a part of it
    ReplyWhen when = ReplyWhen::Done;
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.line; }

constexpr auto kBeside = ReplyWhen::Beside;

const std::vector<Case> kCases = {
    {"ping", {}, "pong"},
    {"exit"},
    {"quit"},
    {"parent 17"},
    {"parent none"},
    {"pause"},
    {"resume"},
    {"idle off"},
    {"frame-time 20"},
    {"frame-time off"},
    {"rest-light walk"},
    {"rest-light view"},
    {"messages"},
    {"messages 3"},
    {"wait-idle", {}, "", ReplyWhen::WhenIdle},
    {"resolution 64 48", {Change::Setting}},
    {"resolution 32 24"},
    {"set antialiasing 2", {Change::Setting}},
    {"set antialiasing 1"},
    {"get antialiasing", {}, "1"},
    {"defaults"},
    {"quality", {}, "good"},
    {"quality good", {}, "good"},
    {"quality final", {Change::Setting}, "final"},
    {"quality draft", {Change::Setting}, "draft"},
    {"settings", {}, "antialiasing = 1\n"},
    {"state", {}, "scene = \"/rooms/room.scn\""},
    {"also set antialiasing 2", {Change::Setting}},
    {"by 7 also set antialiasing 3", {Change::Setting}},
    {"visitor note add 0 1 -2 dark Ada", {}, "1"},
    {"camera get", {}, "eye = [0.0, 1.8, 3.0]"},
    {"camera set 1 2 3 0 0 -1", {Change::View}},
    {"camera set 0 1.8 3 0 0 -1"},
    {"camera orthographic 0 2 3 0 0 -1 4", {Change::View}},
    {"camera look-at 0 2 3 0 0 0", {Change::View}},
    {"camera turn 10 5", {Change::View}},
    {"camera pivot 0.5 0.9", {}, "0 0.0679"},
    {"camera orbit 10 5", {Change::View}},
    {"camera pan 0.1 0", {Change::View}},
    {"camera approach 2", {Change::View}},
    {"camera fit", {Change::View}},
    {"camera view front", {Change::View}},
    {"camera reset"},
    {"camera paste \"version = 1\neye = [1, 2, 3]\nforward = [0, 0, -1]\"", {Change::View}},
    {"camera angle 80", {Change::View}},
    {"camera lens 50", {Change::View}},
    {"camera zoom 2", {Change::View}, "32.2"},
    {"up", {}, "+y is up ("},
    {"units", {}, "one unit is 1 m (guessed)"},
    {"up +y", {}, "+y is up (as you say); one unit is 1 m (guessed)"},
    {"units m", {}, "one unit is 1 m (as you say)"},
    {"plan outline", {}, "", ReplyWhen::Apart},
    {"storeys"},
    {"measure point 0.5 0.9", {}, "corner -0.5 0 -2"},
    {"measure seen 0.5 0.9 0.4 0.9", {}, "\ndistance "},
    {"measure distance 0 0 0 3 4 0", {}, "distance 5 m"},
    {"measure angle 1 0 0 0 0 0 0 1 0", {}, "angle 90 degrees"},
    {"measure face 0.5 0.9", {}, "area "},
    {"measure volume box", {}, "volume 1 m3"},
    {"measure list"},
    {"measure hidden"},
    {"measure keep distance 0 0 0 3 4 0", {}, "1 distance 5.000 m 0 0 0, 3 4 0"},
    {"measure keep chain 0 0 0 3 4 0 3 4 1", {}, "1 chain 6.000 m "},
    {"measure keep angle 1 0 0 0 0 0 0 1 0", {}, "1 angle 90.0 degrees"},
    {"measure keep height 0 3 -2.5", {}, "1 height 2.000 m 0 3 -2.5, 0 1 -2.5"},
    {"measure keep seen 0.5 0.9 0.4 0.9", {}, "1 distance "},
    {"measure keep face 0.5 0.9", {}, "1 area "},
    {"measure keep volume box", {}, "1 volume 1.000 m3 0 0.5 -2.5"},
    {"measure remove all"},
    {"measure unit cm 1"},
    {"measure export DIR/m.csv", {}, "m.csv", kBeside},
    {"note list"},
    {"note add 0 1 -2 \"too dark\" Ada", {}, "1"},
    {"note at 0.5 0.9 here", {}, "1"},
    {"note remove all"},
    {"note export DIR/n.csv", {}, "n.csv", kBeside},
    {"flight list"},
    {"flight key add a", {}, "1"},
    {"flight key add a 0", {}, "1"},
    {"flight through a 10", {}, ""},
    {"flight turntable a 8 -2"},
    {"flight from DIR/a.lst a", {}, "1", kBeside},
    {"variant list"},
    {"variant rebase"},
    {"variant leave"},
    {"focus 0.5 0.9", {Change::Setting}, "5"},
    {"speed 2"},
    {"walk"},
    {"fly"},
    {"load camera DIR/a.cam", {Change::View, Change::Light}, "", kBeside},
    {"load scene /rooms/other.scn", {}, "", ReplyWhen::WhenLoaded},
    {"load set DIR/a.set", {Change::Setting}, "", kBeside},
    {"save as DIR/b.scn", {}, "b.scn", kBeside},
    {"save as DIR/b.scn replace", {}, "b.scn", kBeside},
    {"pack progress", {}, "off"},
    {"pack stop"},
    {"export camera DIR/b.cam", {}, "", kBeside},
    {"export camera DIR/b.cam 640 480 4 2", {}, "", kBeside},
    {"export scene DIR/b.scn", {}, "", kBeside},
    {"export video start DIR/b.lst 25", {}, "", kBeside},
    {"export video", {}, "off"},
    {"play DIR/a.lst", {}, "", kBeside},
    {"play stop"},
    {"screenshot DIR/b.png", {}, "live frame, 32 x 24", kBeside},
    {"screenshot DIR/b.exr", {}, "live frame, 32 x 24", kBeside},
    {"bloom on", {Change::Setting}},
    {"bloom off"},
    {"light 1 off", {Change::Light}},
    {"light get 1", {}, "kind = \"point\""},
    {"light add point here", {Change::Light}, "3"},
    {"light copy 1 at 1 2 3", {Change::Light}, "3"},
    {"light remove 1", {Change::Light}},
    {"light move 1 here", {Change::Light}},
    {"light colour 1 1 0.5 0", {Change::Light}},
    {"light temperature 1 2700", {Change::Light}},
    {"light power 1 10", {Change::Light}},
    {"light kind 1 spot", {Change::Light}},
    {"light size 1 0.2", {Change::Light}},
    {"light mirrored 1 off"},  // a point has no surface
    {"light name 1 bulb", {}}, // the image stays
    {"light 2 toggle", {Change::Light}},
    {"light 2 on"},
    {"environment 2", {Change::Sky}},
    {"environment 1"},
    {"environment open DIR/a.pfm", {Change::Sky, Change::Setting}, "", kBeside},
    {"environment none", {Change::Sky}},
    {"environment rotation 30", {Change::Sky}},
    {"environment strength 2", {Change::Sky}},
    {"sky on", {Change::Sky, Change::Light, Change::Setting}},
    {"sky hour 17.5", {Change::Sky, Change::Light, Change::Setting}},
    {"sky date 2026-12-24", {Change::Sky, Change::Light, Change::Setting}},
    {"sky place 48.2 16.4 1", {Change::Sky, Change::Light, Change::Setting}},
    {"sky north 90", {Change::Sky, Change::Light, Change::Setting}},
    {"sky direction 1 2 3", {Change::Sky, Change::Light, Change::Setting}},
    {"sky turbidity 5", {Change::Sky, Change::Light, Change::Setting}},
    {"sky strength 0.5", {Change::Sky, Change::Light, Change::Setting}},
    {"sky ground on", {Change::Sky, Change::Light, Change::Setting}},
    {"sky haze on", {Change::Sky, Change::Light, Change::Setting}},
    {"look studio", {Change::Sky, Change::Light, Change::Setting}},
    {"look headlight", {Change::Sky, Change::Light}},
    {"look sky", {Change::Sky, Change::Light, Change::Setting}},
    {"lights", {}, "1 on left\n2 on"},
    {"environments", {}, "1 active noon\n2 - dusk"},
    {"scene", {}, "/rooms/room.scn"},
    {"bookmarks", {}, "door"},
    {"bookmark add here"},
    {"bookmark add aside DIR/a.cam", {}, "", kBeside},
    {"bookmark go door", {Change::View}},
    {"bookmark rename door gate"},
    {"bookmark move door 1"},
    {"bookmark remove door"},
    {"materials", {}, "1 - grey"},
    {"material get grey", {}, "[[material]]\nname = \"grey\"\ndiffuse = [0.5, 0.5, 0.5]"},
    {"material set 1 diffuse 1 0 0", {Change::Material}},
    {"also material set 1 diffuse 0 1 0", {Change::Material}},
    {"material presets", {}, "white-paint\ngrey-paint\n"},
    {"material preset gr* gold", {Change::Material}},
    {"material copy 1 gr*"},
    {"material reset gr*"},
    {"parts", {}, "1 shown 12 box"},
    {"part hide box", {Change::Visibility}},
    {"part show 1"},
    {"part isolate box"},
    {"part hide *", {Change::Visibility}},
    {"part show-all"},
    {"seen 0.95 0.95", {}, "part 0\nmaterial 1 grey"},
    {"mask part 1", {}, "32 24 "},
    {"section add 0 900 0 0 1 0", {Change::Section}},
    {"sections", {}, "light whole\ncaps own\ncolour 0.1 0.1 0.1\nhatching off"},
    {"section here 0.95 0.95", {Change::Section}},
    {"section through y", {Change::Section}},
    {"section box -900 -900 -900 900 900 900", {Change::Section}},
    {"section light cut", {Change::Section}},
    {"section caps one", {Change::Section}},
    {"section colour 1 0 0", {Change::Section}},
    {"section hatching on", {Change::Section}},
    {"section leave box", {Change::Section}},
    {"section cut box"},
    {"section clear"},
    {"measure light 0.95 0.95", {}, "", ReplyWhen::Apart},
    {"measure light at 1 0 2 0 1 0", {}, "", ReplyWhen::Apart},
    {"measure progress", {}, "off"},
    {"measure stop"},
    {"key press w"},
    {"key press w 50", {}, "", ReplyWhen::WhenReleased},
    {"key release w"},
    {"key release all"},
    {"key tap 1"},
    {"bindings", {}, "W forward\n"},
    {"bindings default"},
    {"bind k jump"},
    {"bind M+k toggleLight 2"},
    {"unbind w"},
};

std::string nameOf(const testing::TestParamInfo<Case>& info) {
    std::string name = std::to_string(info.index) + "_";
    for (const char c : info.param.line) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
    }
    return name;
}

bool isForPages(const app::CommandSpec& command) {
    return command.browser == app::BrowserUse::Move || command.browser == app::BrowserUse::Edit;
}

class ACommand : public test::CommandRoom, public testing::WithParamInterface<Case> {
  protected:
    void SetUp() override {
        CommandRoom::SetUp();
        drawFrame();
    }
};

TEST_P(ACommand, AnswersAndChangesWhatItSays) {
    const Case& expected = GetParam();
    Result result = run(expected.line);
    EXPECT_EQ(result.when, expected.when);
    if (result.when == kBeside) {
        EXPECT_EQ(changes(), Changes{}) << "only when the files are read";
        const Finish finish = result.work();
        EXPECT_EQ(changes(), Changes{}) << "not in a thread of its own";
        result.answer = finish().text;
    }
    EXPECT_EQ(result.answer.empty(), expected.answer.empty()) << result.answer;
    EXPECT_NE(result.answer.find(expected.answer), std::string::npos) << result.answer;
    EXPECT_EQ(changes(), expected.changes);
}

/// So that whoever may not change a setting cannot change it by another command: a row names what it sets.
TEST_P(ACommand, ChangesNoSettingButThoseOfItsRow) {
    const std::vector<std::string> words = app::splitWords(inFolder(GetParam().line));
    const app::FoundCommand found = app::findCommand(words);
    if (!isForPages(*found.command) || found.command->id == app::CommandId::Defaults) return;
    const rtcore::RenderSettings before = document.settings();
    run(GetParam().line);
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (setting.get(before) == setting.get(document.settings())) continue;
        const bool named = std::ranges::find(found.command->sets, setting.name) != found.command->sets.end();
        const bool given = found.words < words.size() && words[found.words] == setting.name;
        EXPECT_TRUE(named || given) << setting.name;
    }
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, ACommand, testing::ValuesIn(kCases), nameOf);

using Asking = test::CommandRoom;

TEST_F(Asking, IsNoStepOfUndo) {
    drawFrame();
    const std::string up = run("up -x").answer;
    EXPECT_EQ(run("up").answer, up);
    EXPECT_EQ(run("units").answer, up);
    run("undo");
    EXPECT_NE(run("up").answer, up);
    EXPECT_THROW(run("undo"), std::runtime_error);
}

struct Refusal {
    std::string line;
    int code;
    std::string text; ///< a part of it
};

const std::vector<Refusal> kRefusals = {
    {"", 2, ""},
    {"nonsense", 2, "nonsense"},
    {"status", 2, "status is what CUI does itself"},
    {"ping twice", 2, ""},
    {"parent 0", 2, ""},
    {"idle maybe", 2, ""},
    {"frame-time -1", 2, ""},
    {"rest-light both", 2, ""},
    {"messages some", 2, ""},
    {"resolution 0 48", 2, "WIDTH"},
    {"resolution 64", 2, ""},
    {"set antialiasing 99", 2, "antialiasing"},
    {"set nothing 1", 2, "nothing"},
    {"get nothing", 2, "nothing"},
    {"undo", 1, "nothing to undo"},
    {"redo", 1, "nothing to redo"},
    {"camera paste nonsense", 65, "the pasted text"},
    {"camera set 0 0 0 0 0 0", 2, "needs a direction"},
    {"camera set 0 0 0 0 0 -1 60 0 0 1", 2, "must be another one"},
    {"camera set 0 0 0 0 0 -1 180", 2, ""},
    {"camera orthographic 0 0 0 0 0 -1 0", 2, ""},
    {"camera look-at 1 1 1 1 1 1", 2, "needs a direction"},
    {"camera turn 400 0", 2, ""},
    {"camera angle 180", 2, ""},
    {"camera lens 0", 2, ""},
    {"camera zoom 0", 2, ""},
    {"focus 2 0", 2, ""},
    {"focus 0.5 0", 1, "nothing to focus on"},
    {"speed 0", 2, ""},
    {"load camera a.cam", 2, "not absolute"},
    {"load camera DIR/none.cam", 66, "none.cam"},
    {"load camera DIR/bad.cam", 65, "bad.cam"},
    {"load scene room.scn", 2, "not absolute"},
    {"load set DIR/none.set", 66, "none.set"},
    {"light file 1 DIR/none.ies", 66, "none.ies"},
    {"load set DIR/bad.cam", 65, "bad.cam"},
    {"save", 73, "/rooms/room.scn"},
    {"save now", 2, "replace"},
    {"save as b.scn", 2, "not absolute"},
    {"save as DIR/b.obj", 2, "saved as a .scn file, not as 'b.obj'"},
    {"save as DIR/none/b.scn", 73, "make its folder first"},
    {"measure light grid /rooms/a.csv", 1, "is a guess"},
    {"measure keep distance 0 0 0 2e12 0 0", 2, "beyond 1e12"},
    {"measure keep chain 0 0 0 1 0 0 2 0 0 3", 2, "three numbers"},
    {"measure keep angle 1 0 0 1 0 0 2 0 0", 2, "an angle needs two points"},
    {"measure keep height 0 -3 0", 1, "there is no floor below the point"},
    {"measure keep volume chair", 2, "no part of the model is 'chair'"},
    {"measure list 0", 2, ""},
    {"measure name 1 door", 1, "there is no measure 1"},
    {"measure remove 1", 1, "there is no measure 1"},
    {"measure unit mile", 2, "mm"},
    {"measure unit m 7", 2, ""},
    {"measure export m.csv", 2, "not absolute"},
    {"measure export DIR/none/m.csv", 73, "m.csv"},
    {"note add 0 0 2e12 far", 2, "beyond 1e12"},
    {"note add 0 0 0 \" \"", 2, "has no text"},
    {"note add 0 0 0 too many words", 2, ""},
    {"note at 0.5 1.5 there", 2, ""},
    {"note get 1", 1, "there is no note 1"},
    {"note text 1 other", 1, "there is no note 1"},
    {"note remove 1", 1, "there is no note 1"},
    {"note go 1", 1, "there is no note 1"},
    {"note list 0", 2, ""},
    {"note export n.csv", 2, "not absolute"},
    {"variant get a", 1, "the scene has no variant 'a'"},
    {"variant add a", 1, "nothing differs from the base"},
    {"variant add \"\"", 2, "name is empty"},
    {"variant update a", 1, "the scene has no variant 'a'"},
    {"variant update", 1, "no variant is active"},
    {"variant rename a b", 1, "the scene has no variant 'a'"},
    {"variant remove a", 1, "the scene has no variant 'a'"},
    {"variant go a", 1, "the scene has no variant 'a'"},
    {"flight get a", 1, "the scene has no flight 'a'"},
    {"flight through a 0", 2, ""},
    {"flight through a 10 nowhere", 2, "the scene has no bookmark 'nowhere'"},
    {"flight turntable a 8 0", 2, "other than 0"},
    {"flight from DIR/none.lst a", 66, "none.lst"},
    {"flight from DIR/a.lst a 0", 2, "above 0"},
    {"flight copy a b", 1, "the scene has no flight 'a'"},
    {"flight rename a b", 1, "the scene has no flight 'a'"},
    {"flight remove a", 1, "the scene has no flight 'a'"},
    {"flight seconds a 3", 1, "the scene has no flight 'a'"},
    {"flight trim a 1 2", 1, "the scene has no flight 'a'"},
    {"flight timing a times", 1, "the scene has no flight 'a'"},
    {"flight timing a odd", 2, "even"},
    {"flight closed a on", 1, "the scene has no flight 'a'"},
    {"flight target a", 1, "the scene has no flight 'a'"},
    {"flight target a 1 2", 2, "three coordinates"},
    {"flight key add a 1", 2, "the time of the first key frame is 0"},
    {"flight key add \"\"", 2, "name is empty"},
    {"flight key set a 1", 1, "the scene has no flight 'a'"},
    {"flight key move a 1 2", 1, "the scene has no flight 'a'"},
    {"flight key time a 1 2", 1, "the scene has no flight 'a'"},
    {"flight key exposure a 1 2", 1, "the scene has no flight 'a'"},
    {"flight key remove a 1", 1, "the scene has no flight 'a'"},
    {"flight go a 1", 1, "the scene has no flight 'a'"},
    {"flight play a", 1, "the scene has no flight 'a'"},
    {"flight export a DIR/f.lst", 1, "the scene has no flight 'a'"},
    {"note export DIR/none/n.csv", 73, "n.csv"},
    {"pack packed", 2, "not absolute"},
    {"pack DIR", 73, "it is there already, and not empty; name another folder"},
    {"pack DIR/none/b", 73, "there is no such folder to make it in"},
    {"pack DIR/b", 66, "room.obj"},
    {"pack DIR/b inside", 2, "outside"},
    {"export camera b.cam", 2, "not absolute"},
    {"export camera DIR/none/b.cam", 73, "b.cam"},
    {"export scene DIR/none/b.scn", 73, "b.scn"},
    {"export video start DIR/none/b.lst", 73, "b.lst"},
    {"export video start DIR/b.lst 0", 2, ""},
    {"export video stop", 1, "nothing is being recorded"},
    {"play DIR/none.lst", 66, "none.lst"},
    {"play DIR/bad.cam", 66, "bad.cam"},
    {"screenshot b.png", 2, "not absolute"},
    {"screenshot DIR/none/b.png", 73, "b.png"},
    {"bloom more", 2, ""},
    {"light 3 on", 2, "there is no light 3"},
    {"light 0 on", 2, ""},
    {"light get 3", 2, "there is no light 3"},
    {"light add bulb", 2, "rectangle"},
    {"light move 1 at 1 2", 2, ""},
    {"light aim 1 ahead", 1, "shines to all sides"},
    {"light angles 1 10 20", 1, "no cone"},
    {"light turn 1 15", 1, "turned about its direction"},
    {"light colour 1 0 0 0", 2, "black"},
    {"light temperature 1 500", 2, "1667"},
    {"light power 1 0", 2, "above 0"},
    {"light size 1 1 2", 2, "radius"},
    {"environment 3", 2, "there is no environment 3"},
    {"bookmark add \"\"", 2, "needs a name"},
    {"bookmark add \xFF", 2, "needs a name"},
    {"bookmark add b DIR/none.cam", 66, "none.cam"},
    {"bookmark go gate", 2, "the scene has no bookmark 'gate'"},
    {"bookmark remove gate", 2, "the scene has no bookmark 'gate'"},
    {"bookmark rename gate a", 2, "the scene has no bookmark 'gate'"},
    {"bookmark rename door \"\"", 2, "needs a name"},
    {"environment open DIR/wide.pfm", 65, "an environment is twice as wide as high, or a cross"},
    {"environment open DIR/bad.cam", 65, "bad.cam"},
    {"sky date 2026-02-30", 2, "'2026-02-30' is no day"},
    {"sky direction 0 0 0", 2, "not zero"},
    {"sky turbidity 1", 2, "2"},
    {"material set 1 roughness 2", 2, "roughness is 2"},
    {"material set blue roughness 1", 2, "no material of the model is 'blue'"},
    {"material get 2", 2, "no material"},
    {"material copy 1 blue", 2, "no material of the model is 'blue'"},
    {"material copy 1", 2, "material copy takes FROM TO TO..."},
    {"material preset 1 gildt", 2, "unknown preset 'gildt'; did you mean 'gold'?"},
    {"part hide 2", 2, "no part"},
    {"part isolate", 2, ""},
    {"seen 2 0", 2, ""},
    {"mask part 2", 2, "no such part"},
    {"plan DIR/a.jpg", 2, ".svg, .pdf, .dxf, .png or .tif"},
    {"plan DIR/a.pdf", 1, "the unit of room.obj is not known"},
    {"storey go 9", 1, "there is no storey 9"},
    {"section move 1 -1", 1, "there is no section 1; 'sections' lists them"},
    {"section at 2 0 0 0", 1, "there is no section 2"},
    {"section plane 2 0 0 0 0 1 0", 1, "there is no section 2"},
    {"section through up", 2, ""},
    {"section turn 6", 1, "there is no section 6"},
    {"section remove 1", 1, "there is no section 1"},
    {"section remove 7", 2, ""},
    {"key press nothing", 2, "unknown key"},
    {"key press w 0", 2, ""},
    {"key release nothing", 2, "unknown key"},
    {"key tap nothing", 2, "unknown key"},
    {"bind nothing jump", 2, "unknown key"},
    {"bind k jumps", 2, "jump"},
    {"bind k jump 2", 2, "takes no number"},
    {"bind k toggleLight", 2, "takes a number"},
    {"unbind k", 2, "is not bound"},
};

using Commands = test::CommandRoom;

TEST_F(Commands, AWrongOneIsRefusedWithItsCodeAndChangesNothing) {
    drawFrame();
    const auto scene = document.scene();
    for (const Refusal& expected : kRefusals) {
        const Failure failure = refusal(expected.line);
        EXPECT_EQ(failure.code, expected.code) << expected.line << ": " << failure.text;
        EXPECT_NE(failure.text.find(expected.text), std::string::npos)
            << expected.line << ": " << failure.text;
        EXPECT_EQ(changes(), Changes{}) << expected.line;
    }
    EXPECT_EQ(document.scene(), scene);
    EXPECT_TRUE(host.loads.empty());
}

TEST_F(Commands, OfTheTableAreAllTriedHere) {
    std::set<app::CommandId> tried;
    for (const Case& each : kCases) tried.insert(app::findCommand(app::splitWords(each.line)).command->id);
    for (const Refusal& each : kRefusals) {
        if (each.code != 2) tried.insert(app::findCommand(app::splitWords(each.line)).command->id);
    }
    for (const app::CommandSpec& command : app::commandTable())
        EXPECT_EQ(tried.contains(command.id), command.runner == app::Runner::Server) << command.name;
}

TEST(CommandsWithoutAScene, WaitForOneIfTheyNeedIt) {
    Options options;
    Messages messages;
    Workspace state(
        options, [](const rtcore::RenderSettings&) {}, messages);
    test::FakeHost host;
    EXPECT_EQ(runCommand("ping", state, host).answer, "pong");
    for (const char* line : {"camera turn 1 1", "lights", "screenshot /tmp/a.png", "wait-idle"})
        EXPECT_EQ(runCommand(line, state, host).when, ReplyWhen::Again) << line;
    EXPECT_THROW(runCommand("camera turn 1", state, host), app::UsageError) << "that is known at once";
}

} // namespace
} // namespace rtserver
