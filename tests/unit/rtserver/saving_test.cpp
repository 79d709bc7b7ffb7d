/// Saving what is shown, and the mark that tells whether there is something to save.
#include "command_room.h"

#include "common/commands/state_report.h"
#include "rtcore/io/text/scn.h"
#include "rtserver/commands/state_report_of.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/resource.h>

namespace rtserver {
namespace {

class Saving : public test::CommandRoom {
  protected:
    rtcore::SceneFile saved(const std::string& name = "b.scn") {
        return rtcore::readSceneFile(folder / name);
    }
    std::string text(const std::string& name) const {
        std::ifstream in(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    bool modified() const { return stateReportOf(document).modified; }
    bool nothingLeftBeside() const {
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
            if (entry.path().filename().string().starts_with(".")) return false;
        }
        return true;
    }
};

TEST_F(Saving, TheSceneHasWhatEditsMadeOfIt) {
    answer("light 1 off");
    answer("environment 2");
    answer("units cm");
    answer("camera set 1 2 3 0 0 -1 40");
    answer("bookmark add here");
    EXPECT_EQ(answer("save as DIR/b.scn"), inFolder("DIR/b.scn"));
    const rtcore::SceneFile file = saved();
    EXPECT_EQ(file.model, "/rooms/room.obj");
    ASSERT_EQ(file.lights.size(), 2U);
    EXPECT_EQ(file.lights[0].name, "left");
    EXPECT_EQ(file.lights[0].light.on, 0U);
    EXPECT_EQ(file.lights[1].light, document.scene()->lights[1].light);
    EXPECT_FALSE(file.modelLights);
    EXPECT_FALSE(file.defaultLight) << "without lights it stays without";
    EXPECT_EQ(file.activeEnvironment, 1);
    EXPECT_EQ(file.environments.size(), 2U);
    EXPECT_EQ(file.metresPerUnit, 0.01F);
    EXPECT_EQ(file.camera, document.camera());
    ASSERT_EQ(file.bookmarks.size(), 2U);
    EXPECT_EQ(file.bookmarks[0].name, "door");
    EXPECT_EQ(file.bookmarks[1].camera, document.camera());
}

TEST_F(Saving, BookmarksHaveAnOrder) {
    answer("bookmark add here");
    answer("bookmark add there");
    answer("bookmark move there 1");
    EXPECT_EQ(answer("bookmarks"), "there\ndoor\nhere");
    answer("bookmark move there 99");
    EXPECT_EQ(answer("bookmarks"), "door\nhere\nthere");
    document.undo();
    EXPECT_EQ(answer("bookmarks"), "there\ndoor\nhere");
    EXPECT_EQ(refusal("bookmark move gate 1").code, 2);
    EXPECT_EQ(refusal("bookmark move door 0").code, 2);
}

TEST_F(Saving, StillsKeepWhatTheyHaveOfTheirOwnButForWhatWasChanged) {
    rtcore::LoadedScene room = test::makeRoom();
    room.live = {{"maxDepth", 2}, {"width", 640}, {"height", 480}, {"exposure.key", 0.3F}};
    room.still = {{"maxDepth", 6}, {"antialiasing", 4}, {"exposure.key", 0.3F}};
    options.settings.clear();
    document.show(test::worldOf(std::move(room)));
    answer("set exposure.key 0.18");
    answer("set shadows false");
    answer("resolution 48 36");
    answer("save as DIR/b.scn");
    const auto with = [](const std::vector<rtcore::SettingAssignment>& assignments) {
        rtcore::RenderSettings settings;
        rtcore::applySettings(settings, assignments);
        return settings;
    };
    const rtcore::RenderSettings live = with(saved().live), still = with(saved().still);
    EXPECT_EQ(live.maxDepth, 2);
    EXPECT_EQ(live.width, 640) << "that of the window is none of the scene's";
    EXPECT_EQ(live.exposure.key, 0.18F);
    EXPECT_FALSE(live.shadows);
    EXPECT_EQ(still.maxDepth, 6) << "its own";
    EXPECT_EQ(still.antialiasing, 4);
    EXPECT_EQ(still.exposure.key, 0.18F) << "changed, back to what it is by default";
    EXPECT_FALSE(still.shadows) << "changed";
    EXPECT_EQ(still.width, rtcore::RenderSettings().width);
}

TEST_F(Saving, TheMarkFollowsEditsUndoAndRedo) {
    EXPECT_FALSE(modified());
    answer("light 1 off");
    EXPECT_TRUE(modified());
    answer("save as DIR/b.scn");
    EXPECT_FALSE(modified());
    answer("undo");
    EXPECT_TRUE(modified());
    answer("redo");
    EXPECT_FALSE(modified());
    answer("undo");
    answer("light 2 off");
    EXPECT_TRUE(modified()) << "as many steps as when it was saved, but another one";
    answer("undo");
    EXPECT_TRUE(modified());
    answer("save");
    EXPECT_FALSE(modified());
    answer("resolution 40 30");
    answer("camera get");
    EXPECT_FALSE(modified()) << "no edits";
    answer("bookmark rename door gate");
    EXPECT_TRUE(modified());
    answer("undo");
    EXPECT_FALSE(modified());
    EXPECT_EQ(answer("bookmarks"), "door");
}

TEST_F(Saving, TheMarkSeesAGestureThatGoesOn) {
    answer("set maxDepth 3");
    answer("save as DIR/b.scn");
    answer("also set maxDepth 4");
    EXPECT_TRUE(modified());
    answer("save");
    answer("set antialiasing 2");
    answer("also set antialiasing 1");
    EXPECT_FALSE(modified()) << "all as it was saved";
}

TEST_F(Saving, TheCameraLeavesTheMarkAlone) {
    for (const char* line : {"camera set 1 2 3 0 0 -1", "also camera set 1 2 4 0 0 -1", "camera turn 10 5",
                             "camera angle 80", "bookmark go door", "undo", "redo"}) {
        answer(line);
        EXPECT_FALSE(modified()) << line;
    }
    answer("light 1 off");
    EXPECT_TRUE(modified());
    answer("save as DIR/b.scn");
    answer("camera reset");
    EXPECT_FALSE(modified());
    answer("undo");
    EXPECT_FALSE(modified());
    answer("undo");
    EXPECT_TRUE(modified()) << "the light";
    answer("camera set 1 2 3 0 0 -1");
    EXPECT_TRUE(modified());
}

TEST_F(Saving, TheMarkOutlivesForgottenSteps) {
    answer("light 1 off");
    answer("save as DIR/b.scn");
    for (int i = 0; i < 5000; ++i) answer("set maxDepth " + std::to_string(3 + i % 2));
    while (document.history().last() != nullptr) answer("undo");
    EXPECT_FALSE(modified()) << "the step before those that are kept";
    answer("redo");
    EXPECT_TRUE(modified());
}

TEST_F(Saving, ASunThatWasRemovedDoesNotComeBackOn) {
    answer("sky on");
    answer("light remove 3");
    answer("save as DIR/b.scn");
    EXPECT_TRUE(saved().sky);
    EXPECT_FALSE(saved().sun.on);
    answer("sky off");
    answer("save");
    EXPECT_EQ(saved().sun, rtcore::SunDescription{});
}

TEST_F(Saving, MapsThatAreShownAreNotWrittenOver) {
    answer("environment open DIR/a.pfm");
    EXPECT_NE(refusal("save as DIR/a.pfm").text.find("a.pfm"), std::string::npos);
}

TEST_F(Saving, EditsMeanwhileAreNotInTheFile) {
    const Result save = run("save as DIR/b.scn");
    answer("light 1 off");
    const Finish finish = save.work();
    finish();
    EXPECT_EQ(saved().lights[0].light.on, 1U);
    EXPECT_TRUE(modified());
    answer("undo");
    EXPECT_FALSE(modified());
}

TEST_F(Saving, AnotherSceneThatIsShownMeanwhileKeepsItsName) {
    answer("light 1 off");
    const Finish finish = run("save as DIR/b.scn").work();
    document.show(test::worldOf(test::makeRoom()));
    answer("light 2 off");
    finish();
    EXPECT_EQ(answer("scene"), "/rooms/room.scn");
    EXPECT_TRUE(modified());
}

TEST_F(Saving, AsMakesItTheScenesFile) {
    answer("save as DIR/b.scn");
    EXPECT_EQ(answer("scene"), inFolder("DIR/b.scn"));
    answer("light 1 off");
    EXPECT_EQ(answer("save"), inFolder("DIR/b.scn")) << "nobody has to agree: it is of ours";
    EXPECT_EQ(saved().lights[0].light.on, 0U);
    EXPECT_FALSE(exists("b.scn~"));
    drawFrame();
    EXPECT_NE(refusal("screenshot DIR/b.scn").code, 0);
}

TEST_F(Saving, AModelIsNoScene) {
    rtcore::LoadedScene room = test::makeRoom();
    room.sceneFile.reset();
    room.scene.environments.clear();
    document.show(std::make_unique<World>(std::move(room), "/rooms/room.obj", rtcore::ImportOptions()));
    EXPECT_EQ(refusal("save").code, 1);
    EXPECT_NE(refusal("save").text.find("save as"), std::string::npos);
    answer("save as DIR/b.scn");
    answer("light 1 off");
    EXPECT_EQ(refusal("save").code, 0);
    EXPECT_EQ(saved().lights.size(), 2U);
}

TEST_F(Saving, WhatWasWrittenByHandIsAskedForAndKept) {
    const std::string hand = "# my best one\nversion = 1\nmodel = 'a.obj'\n";
    std::ofstream(folder / "b.scn") << hand;
    const Failure failure = refusal("save as DIR/b.scn");
    EXPECT_EQ(failure.code, 73);
    EXPECT_NE(failure.text.find("its comments and its layout would be lost"), std::string::npos)
        << failure.text;
    EXPECT_NE(failure.text.find("'b.scn~'"), std::string::npos) << failure.text;
    EXPECT_EQ(text("b.scn"), hand);
    EXPECT_EQ(answer("scene"), "/rooms/room.scn");
    answer("save as DIR/b.scn replace");
    EXPECT_EQ(text("b.scn~"), hand);
    EXPECT_EQ(saved().model, "/rooms/room.obj");
    const std::string changed = text("b.scn") + "# and a word\n";
    std::ofstream(folder / "b.scn") << changed;
    EXPECT_EQ(refusal("save").code, 73) << "changed by hand since";
    answer("save replace");
    EXPECT_EQ(text("b.scn~"), hand);
    EXPECT_EQ(text("b.scn~2"), changed);
    EXPECT_TRUE(nothingLeftBeside());
}

TEST_F(Saving, OldVersionsStayPrivateAndGoThroughNoLink) {
    std::ofstream(folder / "b.scn") << "by hand";
    std::ofstream(folder / "precious") << "somebody's";
    const auto mine = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    std::filesystem::permissions(folder / "b.scn", mine);
    std::filesystem::create_symlink("precious", folder / "b.scn~");
    answer("save as DIR/b.scn replace");
    EXPECT_EQ(text("precious"), "somebody's");
    EXPECT_EQ(text("b.scn~2"), "by hand");
    for (const char* name : {"b.scn", "b.scn~2"})
        EXPECT_EQ(std::filesystem::status(folder / name).permissions(), mine) << name;
}

TEST_F(Saving, OverTheModelIsRefused) {
    std::ofstream(folder / "model.scn") << "v 0 0 0";
    rtcore::LoadedScene room = test::makeRoom();
    room.files = {folder / "a.set"};
    document.show(test::worldOf(std::move(room)));
    std::filesystem::create_hard_link(folder / "a.set", folder / "link.scn");
    EXPECT_EQ(refusal("save as DIR/link.scn replace").code, 2);
    EXPECT_EQ(text("a.set"), "version = 1\n[live]\nantialiasing = 3\n");
}

/// Files may not grow beyond a few bytes, as on a full disk.
class FullDisk {
  public:
    FullDisk() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit full{64, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(Saving, AFullDiskLeavesTheOldFile) {
    answer("save as DIR/b.scn");
    const std::string before = text("b.scn");
    answer("light 1 off");
    Failure failure{0, ""};
    {
        const FullDisk disk;
        failure = refusal("save");
    }
    EXPECT_EQ(failure.code, 73);
    EXPECT_NE(failure.text.find("b.scn: cannot be written"), std::string::npos) << failure.text;
    EXPECT_EQ(text("b.scn"), before);
    EXPECT_TRUE(modified());
    EXPECT_TRUE(nothingLeftBeside());
    answer("save");
    EXPECT_FALSE(modified());
    std::ofstream(folder / "c.scn") << "by hand";
    {
        const FullDisk disk;
        EXPECT_EQ(refusal("save as DIR/c.scn replace").code, 73);
    }
    EXPECT_EQ(text("c.scn"), "by hand");
    EXPECT_FALSE(exists("c.scn~")) << "it is there under its own name";
}

} // namespace
} // namespace rtserver
