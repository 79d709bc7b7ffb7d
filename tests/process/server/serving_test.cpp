/// RTServer as its clients meet it: commands, keys, errors, ends.
#include "process/server/live_server.h"

#include "ipc/endpoint/client.h"
#include "ipc/endpoint/viewer.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <thread>

namespace {

using namespace test;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class Serving : public LiveServer {
  protected:
    nlohmann::json status() const { return nlohmann::json::parse(ask({"status", "--json"})); }

    static bool eventually(const std::function<bool()>& condition, Clock::duration within = 10s) {
        for (const auto deadline = Clock::now() + within; !condition(); std::this_thread::sleep_for(5ms)) {
            if (Clock::now() > deadline) return false;
        }
        return true;
    }
    std::uint64_t frameNumber(ipc::Viewer& viewer) {
        viewer.readFrame(frame_);
        return frame_.info.number;
    }
    ipc::Frame frame_;
};

TEST_F(Serving, AnswersAndEnds) {
    start();
    EXPECT_EQ(ask({"ping"}), "pong\n");
    const nlohmann::json now = status();
    EXPECT_EQ(now["width"], 64);
    EXPECT_EQ(now["height"], 48);
    EXPECT_EQ(now["polygons"], 14 * 12);
    EXPECT_NE(ask({"list"}).find(instance.name() + "  process "), std::string::npos);
    ask({"exit"});
    EXPECT_EQ(server->wait().exitCode, 0);
    EXPECT_TRUE(instance.segments().empty());
    refused({"ping"}, 75, "no server '" + instance.name() + "'");
}

// CUI prints what people read; other clients get the form, too, and say it in their language.
TEST_F(Serving, RefusalsComeWithTheirForm) {
    start();
    refused({"light", "7", "on"}, 2, "there is no light 7; the scene has");
    ipc::Client client(instance.name());
    const ipc::Reply refusal = client.request("light 7 on");
    EXPECT_EQ(refusal.status, ipc::ReplyStatus::Failed);
    const auto said = nlohmann::json::parse(refusal.detail, nullptr, false);
    ASSERT_TRUE(said.is_array()) << refusal.detail;
    EXPECT_EQ(said[0], "there is no light {0}; the scene has {1}");
    EXPECT_EQ(said[1], "7");
    EXPECT_TRUE(said[2].is_array());
    const ipc::Reply missing = client.request("load camera \"/nowhere/a\\\"b\x1e.cam\"");
    EXPECT_EQ(nlohmann::json::parse(missing.detail, nullptr, false)[0], "{0}: {1}") << missing.detail;
    EXPECT_EQ(client.request("ping").detail, "");
}

// Other tests may have servers of the same user, so "the only one that runs" is not tried here.
TEST_F(Serving, NoServerIsCommandedByAccident) {
    start();
    const auto withoutName = [&](const Names& words, const std::string& variable) {
        return runProgram(programPath("CUI"), words,
                          {.folder = folder().path(), .environment = {{"RT_INSTANCE", variable}}});
    };
    EXPECT_EQ(withoutName({"ping"}, instance.name()).output, "pong\n");
    EXPECT_EQ(withoutName({"--instance=" + instance.name(), "ping"}, "another").output, "pong\n");
    RunningProgram second(programPath("RTServer"), {"room.obj", "--resolution=64x48"},
                          {.folder = folder().path(), .environment = {{"RT_INSTANCE", ""}}});
    ASSERT_TRUE(second.waitForError("ready: instance 'default")) << second.wait().error;
    const ProgramResult unsure = withoutName({"ping"}, "");
    EXPECT_EQ(unsure.exitCode, 2);
    EXPECT_NE(unsure.error.find("servers run: "), std::string::npos) << unsure.error;
    EXPECT_NE(unsure.error.find("'" + instance.name() + "'"), std::string::npos) << unsure.error;
    EXPECT_EQ(withoutName({"list"}, "").exitCode, 0);
    second.send(SIGTERM);
    EXPECT_EQ(second.wait().exitCode, 143);
}

TEST_F(Serving, SignalsEndItCleanly) {
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
        start();
        EXPECT_EQ(end(signal).exitCode, code);
        EXPECT_TRUE(instance.segments().empty());
    }
}

TEST_F(Serving, WithoutItsParentItEndsWithItsLastClient) {
    RunningProgram parent("/bin/sleep", {"1000"});
    start({"--parent=" + std::to_string(parent.process())});
    std::optional<ipc::Client> client(std::in_place, instance.name());
    parent.send(SIGKILL); // and not waited for: a zombie is gone, too
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(ask({"ping"}), "pong\n");
    client.reset();
    const Clock::time_point left = Clock::now();
    const ProgramResult result = server->wait();
    EXPECT_LT(Clock::now() - left, 2s);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.error.find("gone"), std::string::npos) << result.error;
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Serving, AParentCanBeNamedAndForgotten) {
    RunningProgram parent("/bin/sleep", {"1000"});
    const std::string number = std::to_string(parent.process());
    start({"--parent=" + number});
    for (const char* wrong : {"0", "-1", "sleep"}) refused({"parent", wrong}, 2, "");
    ask({"parent", "none"});
    parent.send(SIGKILL);
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(ask({"ping"}), "pong\n");
    ask({"parent", number});
    EXPECT_EQ(server->wait().exitCode, 0);
}

// A frame of minutes, too, ends then.
TEST_F(Serving, WithoutItsParentALongFrameIsGivenUp) {
    RunningProgram parent("/bin/sleep", {"1000"});
    start({"--parent=" + std::to_string(parent.process())});
    ASSERT_EQ(cui({"set", "antialiasing", "16"}).exitCode, 0);
    ASSERT_EQ(cui({"resolution", "4000", "3000"}).exitCode, 0);
    std::this_thread::sleep_for(300ms);
    parent.send(SIGKILL);
    const Clock::time_point killed = Clock::now();
    EXPECT_EQ(server->wait().exitCode, 0);
    EXPECT_LT(Clock::now() - killed, 2s);
}

TEST_F(Serving, OfTwoWithOneNameOneWins) {
    start();
    const ProgramResult other = runProgram(
        programPath("RTServer"), {"room.obj", "--instance=" + instance.name()}, {.folder = folder().path()});
    EXPECT_EQ(other.exitCode, 75);
    EXPECT_NE(other.error.find("RTServer: "), std::string::npos);
    EXPECT_NE(other.error.find(instance.name()), std::string::npos) << other.error;
    EXPECT_EQ(ask({"ping"}), "pong\n");
}

TEST_F(Serving, DrawsOnlyWhatChanged) {
    start({"--look=headlight"});
    ask({"wait-idle"});
    ipc::Viewer viewer(instance.name());
    const std::uint64_t number = frameNumber(viewer);
    EXPECT_TRUE(status()["idle"]);
    ask({"get", "width"});
    ask({"set", "exposure.key", "0.18"});
    ask({"wait-idle"});
    EXPECT_LE(frameNumber(viewer), number + 1);
    const std::uint64_t settled = frameNumber(viewer);
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(frameNumber(viewer), settled);
    ask({"camera", "turn", "5", "0"});
    ask({"wait-idle"});
    EXPECT_GT(frameNumber(viewer), settled);
}

TEST_F(Serving, TheEyeNeedsTimeToAdapt) {
    start();
    ask({"wait-idle"});
    ipc::Viewer viewer(instance.name());
    const std::uint64_t before = frameNumber(viewer);
    ask({"set", "exposure.key", "1"});
    ask({"wait-idle"});
    EXPECT_GT(frameNumber(viewer), before + 5);
}

TEST_F(Serving, KeysMoveTheCamera) {
    start();
    ask({"wait-idle"});
    const nlohmann::json before = status()["eye"];
    ask({"key", "press", "W"});
    EXPECT_TRUE(eventually([&] { return status()["eye"] != before; }));
    EXPECT_FALSE(status()["idle"]);
    ask({"key", "release", "w"});
    ask({"wait-idle"});
    const nlohmann::json after = status()["eye"];
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(status()["eye"], after);
    ask({"key", "tap", "i"});
    ask({"wait-idle"});
    EXPECT_NE(status()["eye"], after) << "a tap is not lost";
    EXPECT_EQ(status()["forward"], nlohmann::json::parse(ask({"status", "--json"}))["forward"]);
    refused({"key", "press", "hyper"}, 2, "unknown key 'hyper'");
}

TEST_F(Serving, WhoWalksStaysOnTheGround) {
    writeText(folder() / "walk.scn", "version = 1\nmodel = \"room.obj\"\n[camera]\neye = [8.0, 5.0, -10.0]\n"
                                     "forward = [0.0, 0.0, -1.0]\n[walk]\nheight = 1.8\n");
    start({}, "walk.scn");
    const auto height = [&] { return status()["eye"][1].get<double>(); };
    ask({"wait-idle"});
    EXPECT_EQ(status()["mode"], "fly");
    EXPECT_EQ(height(), 5) << "who flies does not fall";
    ask({"walk"});
    ask({"wait-idle"});
    EXPECT_EQ(status()["mode"], "walk");
    const double standing = height();
    EXPECT_GT(standing, -0.5 + 1.2) << "the floor is at -0.5";
    EXPECT_LT(standing, -0.5 + 1.8);
    const double before = status()["eye"][2];
    ask({"key", "press", "s"});
    EXPECT_TRUE(eventually([&] { return status()["eye"][2].get<double>() > before + 0.2; }));
    ask({"key", "release", "s"});
    ask({"wait-idle"});
    EXPECT_NEAR(height(), standing, 0.01);
    ask({"key", "tap", "f"});
    EXPECT_TRUE(eventually([&] { return status()["mode"] == "fly"; }));
}

TEST_F(Serving, PausesAndResumes) {
    start();
    ask({"wait-idle"});
    ask({"pause"});
    ipc::Viewer viewer(instance.name());
    const std::uint64_t number = frameNumber(viewer);
    ask({"camera", "turn", "10", "0"});
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(frameNumber(viewer), number);
    EXPECT_TRUE(status()["paused"]);
    refused({"wait-idle"}, 1, "paused");
    ask({"resume"});
    ask({"wait-idle"});
    EXPECT_GT(frameNumber(viewer), number);
}

TEST_F(Serving, WithoutIdlingItDrawsOn) {
    start();
    ask({"idle", "off"});
    EXPECT_FALSE(status()["idle"]);
    ipc::Viewer viewer(instance.name());
    const std::uint64_t before = frameNumber(viewer);
    // Each frame has its own time: how many come in a second is up to the machine.
    for (std::uint64_t number = before; number <= before + 100; ++number) {
        ASSERT_TRUE(eventually([&] { return frameNumber(viewer) > number; })) << number - before;
    }
    refused({"wait-idle"}, 1, "never idles");
    ask({"idle", "on"});
    ask({"wait-idle"});
    EXPECT_TRUE(status()["idle"]);
}

TEST_F(Serving, SettingsAreReadAndWritten) {
    start();
    EXPECT_EQ(ask({"get", "antialiasing"}), "1\n");
    ask({"set", "antialiasing", "3"});
    EXPECT_EQ(ask({"get", "antialiasing"}), "3\n");
    EXPECT_NE(ask({"settings"}).find("antialiasing = 3\n"), std::string::npos);
    writeText(folder() / "fast.set", "version = 1\n[live]\nshadows = false\n");
    ask({"load", "set", "fast.set"});
    EXPECT_EQ(ask({"get", "shadows"}), "false\n");
    EXPECT_EQ(ask({"get", "antialiasing"}), "3\n");
    refused({"set", "antialiazing", "3"}, 2, "did you mean 'antialiasing'?");
    refused({"set", "antialiasing", "17"}, 2, "1 to 16");
    refused({"resolution", "20000", "4"}, 2, "16384");
    EXPECT_EQ(ask({"get", "width"}), "64\n");
}

TEST_F(Serving, FocusIsTakenFromAPlace) {
    start();
    const std::string distance = ask({"focus", "0.5", "0.5"});
    EXPECT_GT(std::stof(distance), 0);
    EXPECT_EQ(ask({"get", "depthOfField.focus"}), distance);
    EXPECT_EQ(ask({"get", "depthOfField.on"}), "true\n");
    ask({"set", "depthOfField.on", "false"});
    ask({"camera", "look-at", "0", "900", "0", "0", "1000", "1"}); // nothing but background
    refused({"focus", "0.5", "0.5"}, 1, "nothing to focus on");
    EXPECT_EQ(ask({"get", "depthOfField.focus"}), distance);
    EXPECT_EQ(ask({"get", "depthOfField.on"}), "false\n");
}

TEST_F(Serving, BesideAModelWhoWalksHasAFloor) {
    start();
    ask({"units", "m"});
    ask({"camera", "look-at", "500", "3", "0", "0", "0", "0"});
    EXPECT_NE(ask({"walk"}).find("nothing is below"), std::string::npos);
    ask({"wait-idle"});
    EXPECT_NE(ask({"status"}).find("unseen floor"), std::string::npos);
    EXPECT_EQ(status()["mode"], "walk");
    ask({"fly"});
    EXPECT_EQ(ask({"status"}).find("unseen floor"), std::string::npos);
    ask({"camera", "set", "0", "-900", "0", "0", "0", "-1"});
    refused({"walk"}, 1, "no floor below");
}

TEST_F(Serving, LightsAndEnvironmentsAreTold) {
    writeText(folder() / "sky.ppm", "P3 2 1 255 10 20 30 200 210 220\n");
    writeText(folder() / "lit.scn",
              "version = 1\nmodel = \"room.obj\"\nactiveEnvironment = 1\nmodelLights = false\n"
              "[camera]\neye = [0.0, 1.0, 5.0]\nlookAt = [0.0, 1.0, 0.0]\n"
              "[[light]]\nname = \"tall light\"\nkind = \"point\"\nposition = [0.0, 3.0, 0.0]\n"
              "intensity = [9.0, 9.0, 9.0]\n"
              "[[light]]\nkind = \"point\"\nposition = [1.0, 3.0, 0.0]\nintensity = [9.0, 9.0, 9.0]\n"
              "[[environment]]\nequirectangular = \"sky.ppm\"\n"
              "[[environment]]\nname = \"late evening\"\nequirectangular = \"sky.ppm\"\n");
    start({}, "lit.scn");
    EXPECT_EQ(ask({"lights"}), "1 on tall light\n2 on\n");
    ask({"light", "1", "off"});
    EXPECT_EQ(ask({"lights"}), "1 off tall light\n2 on\n");
    EXPECT_EQ(ask({"environments"}), "1 - sky\n2 active late evening\n");
    ask({"environment", "1"});
    EXPECT_EQ(ask({"environments"}), "1 active sky\n2 - late evening\n");
    EXPECT_EQ(ask({"scene"}), (folder() / "lit.scn").string() + "\n");
    const std::string first = ask({"camera", "get"});
    ask({"camera", "set", "1", "2", "3", "0", "0", "-1"});
    EXPECT_NE(ask({"camera", "get"}), first);
    ask({"camera", "reset"});
    EXPECT_EQ(ask({"camera", "get"}), first);
}

TEST_F(Serving, TheCameraMayLookStraightDown) {
    start();
    ask({"camera", "set", "1", "1", "1", "0", "-1", "0"});
    EXPECT_NE(ask({"camera", "get"}).find("up = [0.0, 0.0, -1.0]"), std::string::npos);
}

TEST_F(Serving, ACameraOfAnotherSceneIsLookedThrough) {
    start();
    writeCamera(folder() / "other.cam", 1.5, "lights = [true, false, true, false]\nenvironment = 3\n");
    EXPECT_NE(ask({"load", "camera", "other.cam"}).find("other.cam switches 4 lights"), std::string::npos);
    EXPECT_NE(ask({"camera", "get"}).find("eye = [1.5,"), std::string::npos);
}

TEST_F(Serving, ErrorsReachTheShell) {
    start({"--look=headlight"});
    refused({"load", "camera", "nothing.cam"}, 66, "nothing.cam");
    writeText(folder() / "bad.cam", "version = 1\neye = 3\n");
    refused({"load", "camera", "bad.cam"}, 65, "bad.cam:2");
    refused({"screenshot", "no/such/folder/a.png"}, 73, "a.png");
    refused({"light", "9", "on"}, 2, "there is no light 9");
    refused({"environment", "1"}, 2, "there is no environment 1");
    refused({"camera", "look-at", "1", "1", "1", "1", "1", "1"}, 2, "direction");
    refused({"camera", "set", "1", "1"}, 2, "EX EY EZ");
    refused({"focus", "320", "240"}, 2, "a number from 0 to 1 for X");
    refused({"resolutoin", "3", "4"}, 2, "resolution");
    refused({"free"}, 75, instance.name());
    EXPECT_EQ(ask({"ping"}), "pong\n");
}

TEST_F(Serving, WhatWasReadIsNotWrittenOver) {
    writeText(folder() / "room.scn", "version = 1\nmodel = \"room.obj\"\n[camera]\nfile = \"first.cam\"\n");
    writeCamera(folder() / "first.cam", 0);
    std::filesystem::create_hard_link(folder() / "room.obj", folder() / "linked.png");
    std::filesystem::create_hard_link(folder() / "room.scn", folder() / "scene.png");
    const std::string model = bytes("room.obj"), scene = bytes("room.scn");
    start({}, "room.scn");
    for (const char* what : {"camera", "scene"}) refused({"export", what, "room.obj"}, 2, "the same file");
    refused({"export", "camera", "room.scn"}, 2, "the same file");
    refused({"export", "scene", "first.cam"}, 2, "the same file");
    refused({"screenshot", "linked.png"}, 2, "the same file");
    EXPECT_EQ(cui({"render", "linked.png"}).exitCode, 2) << "the Renderer refuses it";
    refused({"render", "scene.png"}, 2, "the same file");
    EXPECT_EQ(bytes("room.obj"), model);
    EXPECT_EQ(bytes("room.scn"), scene);
    ask({"export", "camera", "first.cam"});
    ask({"export", "scene", "room.scn"});
    EXPECT_NE(bytes("room.scn"), scene) << "a scene may be kept under its own name";
}

TEST_F(Serving, NegativeNumbersAreNoOptions) {
    start();
    ask({"camera", "set", "-1.5", "-2", "3e0", "-1", "0", "-0.5"});
    EXPECT_EQ(status()["eye"], (nlohmann::json{-1.5, -2.0, 3.0}));
}

TEST_F(Serving, PathsMayHoldBlanksAndQuotes) {
    start();
    ask({"screenshot", "a \"b\" c.png"});
    EXPECT_EQ(pngFileSize(folder() / "a \"b\" c.png"), (PictureSize{64, 48}));
}

TEST_F(Serving, ScriptsStopAtTheFirstError) {
    start();
    writeText(folder() / "a.script",
              "# a comment\n\nresolution 33 22\nget width\nget nothing\nresolution 44 44\n");
    const ProgramResult result = cui({"script", "a.script"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.output, "33\n");
    EXPECT_NE(result.error.find("a.script:5: "), std::string::npos) << result.error;
    EXPECT_EQ(ask({"get", "width"}), "33\n");
}

TEST_F(Serving, OtherScenesCanBeLoaded) {
    start();
    writeWaves(folder() / "waves.obj", 10);
    ask({"load", "scene", "waves.obj"});
    EXPECT_EQ(status()["polygons"], 200);
    EXPECT_EQ(status()["width"], 64);
    writeText(folder() / "broken.scn", "version = 1\nmodell = \"room.obj\"\n");
    refused({"load", "scene", "broken.scn"}, 65, "model");
    EXPECT_EQ(status()["polygons"], 200);
    ask({"wait-idle"});
}

TEST_F(Serving, AMissingSceneEndsIt) {
    run({}, "nothing.obj");
    const ProgramResult result = server->wait();
    EXPECT_EQ(result.exitCode, 66);
    EXPECT_NE(result.error.find("nothing.obj"), std::string::npos);
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Serving, InTheBackgroundItIsReadyWhenTheCommandReturns) {
    const ProgramResult result =
        runProgram(programPath("RTServer"),
                   {"room.obj", "--daemon", "--resolution=32x24", "--instance=" + instance.name()},
                   {.folder = folder().path(), .timeoutSeconds = 60});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_FALSE(result.timedOut);
    ask({"wait-idle"});
    ask({"screenshot", "a.png"});
    EXPECT_EQ(pngFileSize(folder() / "a.png"), (PictureSize{32, 24}));
    ask({"quit"});
    EXPECT_TRUE(instance.segments().empty());
    EXPECT_EQ(
        runProgram(programPath("RTServer"), {"no.obj", "--daemon", "--instance=" + instance.name()}).exitCode,
        66);
}

TEST_F(Serving, ALongFrameHoldsNobodyUp) {
    start();
    const auto begun = Clock::now();
    ask({"set", "antialiasing", "16"});
    ask({"resolution", "1200", "1200"});
    for (int i = 0; i < 5; ++i) EXPECT_EQ(ask({"ping"}), "pong\n");
    const ProgramResult result = end(SIGTERM);
    EXPECT_EQ(result.exitCode, 143);
    EXPECT_LT(Clock::now() - begun, 5s) << "the frame takes minutes";
}

TEST_F(Serving, ALongFrameIsGivenUpForAChange) {
    start();
    ask({"set", "antialiasing", "16"});
    ask({"resolution", "4000", "4000"}); // takes minutes
    std::this_thread::sleep_for(200ms);
    ask({"set", "antialiasing", "1"});
    ask({"resolution", "16", "16"});
    ask({"wait-idle", "--timeout=20"});
}

TEST_F(Serving, WhatADeadServerLeftCanBeFreed) {
    start();
    server->send(SIGKILL);
    server->wait();
    ASSERT_FALSE(instance.segments().empty());
    EXPECT_NE(ask({"list"}).find(instance.name() + "  dead"), std::string::npos);
    ask({"free"});
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Serving, FramesAreLimited) {
    start({"--fps-limit=20"});
    ask({"wait-idle"});
    ask({"key", "press", "d"});
    std::this_thread::sleep_for(1500ms);
    const double rate = std::stod(ask({"fps"}));
    EXPECT_LE(rate, 21);
    EXPECT_GE(rate, 5);
}

} // namespace
