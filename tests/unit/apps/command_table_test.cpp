/// The table of commands: sound in itself, and known to all who read it. RT_RENEW_DOCS=1 in the environment
/// writes the table of docs/manual.md anew.
#include "common/cli/command_line.h"
#include "common/cli/command_names.h"
#include "common/cli/completion.h"
#include "common/cli/help_text.h"
#include "common/cli/man_page.h"
#include "common/commands/command_lines.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"
#include "cui/cui_spec.h"
#include "rtserver/commands/commands.h"
#include "support/document_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using Words = std::vector<std::string>;

Words wordsOf(std::string_view text) { return app::splitWords(text); }

const app::CommandSpec& found(const std::string& line) { return *app::findCommand(wordsOf(line)).command; }

void check(const std::string& line) {
    const Words words = wordsOf(line);
    const app::FoundCommand command = app::findCommand(words);
    app::checkArguments(*command.command, std::span(words).subspan(command.words));
}

std::string refusal(const std::string& line) {
    try {
        check(line);
    } catch (const app::UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(CommandTable, HasARowForEachIdInItsPlace) {
    ASSERT_EQ(app::commandTable().size(), app::kCommands);
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < app::kCommands; ++i) {
        const app::CommandSpec& command = app::commandTable()[i];
        EXPECT_EQ(static_cast<std::size_t>(command.id), i) << command.name;
        EXPECT_TRUE(names.insert(command.name).second) << command.name << " stands twice";
        EXPECT_FALSE(command.help.empty()) << command.name;
        EXPECT_FALSE(command.help.ends_with('.') || command.more.ends_with('.')) << command.name;
        EXPECT_EQ(app::parseCommandLabel(app::commandLabel(command)).command(), command.name);
    }
}

TEST(CommandTable, EachOfTheServersHasAFunctionThere) {
    for (const app::CommandSpec& command : app::commandTable())
        EXPECT_EQ(rtserver::hasFunction(command.id), command.runner == app::Runner::Server) << command.name;
}

TEST(CommandTable, EachIsInHelpManualPageAndCompletion) {
    const std::string help = app::helpText(cui::cuiSpec()), page = app::manPage(cui::cuiSpec());
    for (const app::CommandSpec& command : app::commandTable()) {
        EXPECT_NE(help.find("\n  " + app::commandLabel(command)), std::string::npos) << command.name;
        std::string dashed;
        for (const char c : command.name) dashed += c == '-' ? std::string("\\-") : std::string(1, c);
        EXPECT_NE(page.find("\\fB" + dashed.substr(0, dashed.find(' '))), std::string::npos) << command.name;
        Words typed = wordsOf(command.name);
        const std::string last = typed.back();
        typed.back() = "";
        const Words offered = app::completeWords(cui::cuiSpec(), typed).words;
        EXPECT_NE(std::find(offered.begin(), offered.end(), last), offered.end()) << command.name;
    }
}

TEST(CommandTable, FilesAreCompletedWhereAPathStands) {
    for (const app::CommandSpec& command : app::commandTable()) {
        Words typed = wordsOf(command.name);
        for (const app::CommandArgument& argument : command.arguments) {
            typed.emplace_back("x");
            if (argument.type != app::ArgumentType::Path) continue;
            const app::Completion completion = app::completeWords(cui::cuiSpec(), typed);
            EXPECT_TRUE(completion.files) << command.name;
            EXPECT_EQ(completion.extensions, argument.files) << command.name;
        }
    }
}

TEST(CommandLookup, TakesTheLongestName) {
    EXPECT_EQ(found("export video stop a.lst").id, app::CommandId::ExportVideoStop);
    EXPECT_EQ(found("export video").id, app::CommandId::ExportVideo);
    EXPECT_EQ(found("play stop").id, app::CommandId::PlayStop);
    EXPECT_EQ(found("play stop.lst").id, app::CommandId::Play);
    EXPECT_EQ(app::findCommand(wordsOf("camera get x")).words, 2U);
}

TEST(CommandLookup, NamesTheNearest) {
    EXPECT_EQ(refusal("camera"),
              "'camera' is the beginning of several commands: camera get, camera set, "
              "camera orthographic, camera look-at, camera turn, camera pivot, camera orbit, "
              "camera pan, camera approach, camera fit, camera view, camera reset, "
              "camera paste, camera angle, camera lens, camera zoom");
    EXPECT_EQ(refusal("camera trun 1 2"), "unknown command 'camera trun'; did you mean 'camera turn'?");
    EXPECT_EQ(refusal("pong"), "unknown command 'pong'; did you mean 'ping'?");
    EXPECT_EQ(refusal(""), "the command is empty");
}

TEST(CommandArguments, AreCounted) {
    EXPECT_EQ(refusal("ping 1"), "ping takes no arguments");
    EXPECT_EQ(refusal("set bloom"), "set takes NAME VALUE");
    EXPECT_EQ(refusal("focus 1"), "focus takes X Y");
    EXPECT_EQ(refusal("camera set 1 2 3"), "camera set takes EX EY EZ FX FY FZ [FOV [UX UY UZ [ASPECT]]]");
    for (const char* line :
         {"camera set 1 2 3 0 0 1", "camera set 1 2 3 0 0 1 60", "camera set 1 2 3 0 0 1 60 0 1 0",
          "camera set 1 2 3 0 0 1 60 0 1 0 1.5", "export camera /a.cam 640", "script -", "render a.png",
          "render a.png -- -a 4", "render a.png -a", "key press w", "key press w 100"})
        EXPECT_EQ(refusal(line), "") << line;
    EXPECT_NE(refusal("camera set 1 2 3 0 0 1 60 0 1"), "");
}

TEST(CommandArguments, HaveTypesAndRanges) {
    EXPECT_EQ(refusal("speed 5000"), "speed takes a number from 0.001 to 1000 for FACTOR, not '5000'");
    EXPECT_EQ(refusal("light x on"), "light takes a whole number, at least 1 for N, not 'x'");
    EXPECT_EQ(refusal("light 1 maybe"), "light takes on or off or toggle, not 'maybe'");
    EXPECT_EQ(refusal("parent me"), "parent takes a whole number, at least 1 or none for PID, not 'me'");
    EXPECT_EQ(refusal("camera set 0 0 0 0 0 1 180"),
              "camera set takes a number above 0 and below 180 for FOV, not '180'");
    EXPECT_EQ(refusal("camera set inf 0 0 0 0 1"), "camera set takes a number for EX, not 'inf'");
    for (const char* line : {"parent none", "frame-time off", "frame-time 0", "light 1 toggle", "speed 0.001",
                             "focus 0 1", "camera turn -360 360"})
        EXPECT_EQ(refusal(line), "") << line;
}

TEST(CommandLines, SuitTheTable) {
    using namespace app;
    const std::string path = "/a b/c\"d.cam";
    const std::pair<CommandId, std::string> lines[] = {
        {CommandId::Ping, command::ping()},
        {CommandId::Exit, command::exit()},
        {CommandId::Parent, command::parent(77)},
        {CommandId::Parent, command::noParent()},
        {CommandId::Pause, command::pause()},
        {CommandId::Resume, command::resume()},
        {CommandId::FrameTime, command::frameTime(0)},
        {CommandId::FrameTime, command::frameTime(30)},
        {CommandId::Messages, command::messages(4)},
        {CommandId::Defaults, command::defaults()},
        {CommandId::Quality, command::quality("good")},
        {CommandId::Undo, command::undo()},
        {CommandId::Redo, command::redo()},
        {CommandId::Undo, command::undo(3)},
        {CommandId::Redo, command::redo(3)},
        {CommandId::Also, command::also(command::set("maxDepth", "3"))},
        {CommandId::By, command::by(7, command::also(command::set("maxDepth", "3")))},
        {CommandId::Visitor, command::visitor("note add 0 0 0 dark Ada")},
        {CommandId::CameraAngle, command::cameraAngle(62.5)},
        {CommandId::CameraZoom, command::cameraZoom(1.05)},
        {CommandId::CameraPaste, command::cameraPaste("version = 1\neye = [0, 0, 0]")},
        {CommandId::Resolution, command::resolution(640, 480)},
        {CommandId::Set, command::set("bloom", "3")},
        {CommandId::State, command::state()},
        {CommandId::Light, command::light(2, true)},
        {CommandId::Environment, command::environment(1)},
        {CommandId::CameraSet, command::camera({.forward = {0, 0, 1}, .width = 60, .up = {0, 1, 0}})},
        {CommandId::CameraSet,
         command::camera({.forward = {0, 0, 1}, .width = 60, .up = {0, 1, 0}, .aspect = 2})},
        {CommandId::CameraOrthographic,
         command::camera({.forward = {0, 0, 1}, .width = 500, .orthographic = true, .up = {0, 1, 0}})},
        {CommandId::CameraSet, command::cameraSet({1, 2, 3}, {0, 0, 1})},
        {CommandId::CameraSet, command::cameraSet({1, 2, 3}, {0, 0, 1}, 70.0F)},
        {CommandId::CameraTurn, command::cameraTurn(-1.5, 1e-4)},
        {CommandId::CameraPivot, command::cameraPivot()},
        {CommandId::CameraPivot, command::cameraPivot(0.25, 1)},
        {CommandId::CameraOrbit, command::cameraOrbit(-1.5, 1e-4)},
        {CommandId::CameraPan, command::cameraPan(0.5, -0.125)},
        {CommandId::CameraApproach, command::cameraApproach(1.1)},
        {CommandId::CameraFit, command::cameraFit()},
        {CommandId::CameraView, command::cameraView("three-quarter")},
        {CommandId::CameraReset, command::cameraReset()},
        {CommandId::SectionHere, command::sectionHere(0.5, 1)},
        {CommandId::SectionThrough, command::sectionThrough("-z")},
        {CommandId::SectionAt, command::sectionAt(6, {1e6, -2.5, 0})},
        {CommandId::SectionPlane, command::sectionPlane(6, {1e6, -2.5, 0}, {0, 0.5, -1})},
        {CommandId::SectionTurn, command::sectionTurn(1)},
        {CommandId::SectionRemove, command::sectionRemove(1)},
        {CommandId::SectionClear, command::sectionClear()},
        {CommandId::SectionLight, command::sectionLight("cut")},
        {CommandId::SectionCaps, command::sectionCaps("one")},
        {CommandId::SectionColour, command::sectionColour({1, 0.5F, 0})},
        {CommandId::SectionHatching, command::sectionHatching(true)},
        {CommandId::SectionLeave, command::sectionLeave({"3", "a b*"})},
        {CommandId::SectionCut, command::sectionCut({"3"})},
        {CommandId::Plan, command::plan("/plan.pdf", "above", 50, "A3", 2, 1.2, 300)},
        {CommandId::PlanOutline, command::planOutline()},
        {CommandId::PlanOutline, command::planOutline(2)},
        {CommandId::Storeys, command::storeys()},
        {CommandId::StoreyGo, command::storeyGo(2)},
        {CommandId::CameraGet, command::cameraGet()},
        {CommandId::Up, command::up("-x")},
        {CommandId::Units, command::units(0.0254F)},
        {CommandId::Focus, command::focus(0.5, 1)},
        {CommandId::Speed, command::speed(2.5)},
        {CommandId::Walk, command::walk()},
        {CommandId::LoadCamera, command::loadCamera(path)},
        {CommandId::LoadScene, command::loadScene(path)},
        {CommandId::LoadScene, command::loadScene(path, "/b.bsp")},
        {CommandId::LoadSet, command::loadSet(path)},
        {CommandId::Save, command::save(false)},
        {CommandId::Save, command::save(true)},
        {CommandId::SaveAs, command::saveAs(path, false)},
        {CommandId::SaveAs, command::saveAs(path, true)},
        {CommandId::Pack, command::pack("/a b")},
        {CommandId::Pack, command::pack("/a b", true)},
        {CommandId::PackProgress, command::packProgress()},
        {CommandId::PackStop, command::packStop()},
        {CommandId::MeasureLight, command::measureLight(0.5, 0.25, 8192)},
        {CommandId::MeasureProgress, command::measureProgress()},
        {CommandId::MeasureStop, command::measureStop()},
        {CommandId::MeasurePoint, command::measurePoint(0.5, 1)},
        {CommandId::MeasureHidden, command::measureHidden()},
        {CommandId::MeasureKeepDistance, command::measureKeepDistance({1, 2, 3}, {4, 5, 6})},
        {CommandId::MeasureKeepChain,
         command::measureKeepChain({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}})},
        {CommandId::MeasureKeepAngle, command::measureKeepAngle({1, 2, 3}, {4, 5, 6}, {7, 8, 9})},
        {CommandId::MeasureKeepHeight, command::measureKeepHeight({1, 2, 3})},
        {CommandId::MeasureKeepFace, command::measureKeepFace(0, 0.5)},
        {CommandId::MeasureKeepVolume, command::measureKeepVolume("a b")},
        {CommandId::MeasureName, command::measureName(3, "by the \"door\"")},
        {CommandId::MeasureRemove, command::measureRemove(3)},
        {CommandId::MeasureRemove, command::measureRemoveAll()},
        {CommandId::MeasureUnit, command::measureUnit("cm", 1)},
        {CommandId::MeasureExport, command::measureExport(path)},
        {CommandId::NoteGet, command::noteGet(3)},
        {CommandId::NoteAdd, command::noteAdd({1, 2, 3}, "a \"b\"\nc", "")},
        {CommandId::NoteText, command::noteText(3, "a", "Ada Lovelace")},
        {CommandId::NoteRemove, command::noteRemove(3)},
        {CommandId::NoteGo, command::noteGo(3)},
        {CommandId::NoteExport, command::noteExport(path)},
        {CommandId::FlightThrough, command::flightThrough("a \"b\"", 12.5)},
        {CommandId::FlightTurntable, command::flightTurntable("a", 8)},
        {CommandId::FlightRename, command::flightRename("a", "b c")},
        {CommandId::FlightRemove, command::flightRemove("a b")},
        {CommandId::FlightSeconds, command::flightSeconds("a b", 0.1)},
        {CommandId::FlightTiming, command::flightTiming("a", "times")},
        {CommandId::FlightClosed, command::flightClosed("a", true)},
        {CommandId::FlightKeyAdd, command::flightKeyAdd("--a")},
        {CommandId::FlightKeySet, command::flightKeySet("a", 2)},
        {CommandId::FlightKeyMove, command::flightKeyMove("a", 2, 1)},
        {CommandId::FlightKeyTime, command::flightKeyTime("a", 2, 2.5)},
        {CommandId::FlightKeyRemove, command::flightKeyRemove("a", 3)},
        {CommandId::FlightGo, command::flightGo("a", 2.5)},
        {CommandId::FlightPlay, command::flightPlay("a", 0)},
        {CommandId::MaterialPresets, command::materialPresets()},
        {CommandId::MaterialCopy, command::materialCopy(3, {"7", "a b"})},
        {CommandId::MaterialPreset, command::materialPreset(3, "clear-glass")},
        {CommandId::VariantAdd, command::variantAdd("oak \"floor\"")},
        {CommandId::VariantUpdate, command::variantUpdate("a b")},
        {CommandId::VariantRename, command::variantRename("a", "b c")},
        {CommandId::VariantRemove, command::variantRemove("a b")},
        {CommandId::VariantRebase, command::variantRebase()},
        {CommandId::VariantGo, command::variantGo("a b")},
        {CommandId::VariantLeave, command::variantLeave()},
        {CommandId::PlayStop, command::playStop()},
        {CommandId::BookmarkAdd, command::bookmarkAdd("by the \"door\"", path)},
        {CommandId::BookmarkAdd, command::bookmarkAdd("a b")},
        {CommandId::BookmarkMove, command::bookmarkMove("a b", 2)},
        {CommandId::BookmarkGo, command::bookmarkGo("a b")},
        {CommandId::BookmarkRename, command::bookmarkRename("a b", "c d")},
        {CommandId::BookmarkRemove, command::bookmarkRemove("a b")},
        {CommandId::ExportCamera, command::exportCamera(path)},
        {CommandId::ExportCamera, command::exportCamera(path, 640, 480, 2, 0)},
        {CommandId::ExportScene, command::exportScene(path)},
        {CommandId::Screenshot, command::screenshot(path)},
        {CommandId::Play, command::play(path)},
        {CommandId::ExportVideo, command::exportVideo()},
        {CommandId::ExportVideoStart, command::exportVideoStart(path)},
        {CommandId::ExportVideoStop, command::exportVideoStop()},
        {CommandId::Scene, command::scene()},
        {CommandId::Bindings, command::bindings()},
        {CommandId::Bind, command::bind("M+3", "toggleLight", 3)},
        {CommandId::Bind, command::bind("k", "jump")},
        {CommandId::Unbind, command::unbind("k")},
    };
    for (const auto& [id, line] : lines) {
        EXPECT_EQ(found(line).id, id) << line;
        EXPECT_EQ(refusal(line), "") << line;
    }
    EXPECT_EQ(wordsOf(command::screenshot(path)).back(), path);
}

TEST(CommandTable, IsThatOfTheManual) {
    std::string table = test::tableRow({"command", ""}) + "|---|---|\n";
    for (const app::CommandSpec& command : app::commandTable()) {
        std::string text(command.help);
        if (!command.more.empty()) text += (text.ends_with('?') ? " " : ". ") + std::string(command.more);
        table += test::tableRow({"`" + app::commandLabel(command) + "`", text});
    }
    test::expectSection(RT_DOCUMENTS "/manual.md", "commands", table);
}

} // namespace
