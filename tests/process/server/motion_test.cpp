/// Motion in the server's own time: keys that are pressed for a time, bindings, fewer pixels in motion, a
/// better tree later.
#include "process/server/live_server.h"

#include "ipc/endpoint/viewer.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

namespace {

using namespace test;
using namespace std::chrono_literals;

class Motions : public LiveServer {
  protected:
    nlohmann::json status() const { return nlohmann::json::parse(ask({"status", "--json"})); }
    double distance(const nlohmann::json& a, const nlohmann::json& b) const {
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += std::pow(a[i].get<double>() - b[i].get<double>(), 2);
        return std::sqrt(sum);
    }
};

TEST_F(Motions, AKeyIsPressedForATime) {
    start();
    std::vector<double> ways;
    for (const char* rate : {"--for=500", "--for=500"}) {
        ask({"wait-idle"});
        const nlohmann::json before = status()["eye"];
        ask({"key", "press", "w", rate});
        ask({"wait-idle"});
        ways.push_back(distance(before, status()["eye"]));
    }
    EXPECT_GT(ways[0], 0.1);
    EXPECT_NEAR(ways[0], ways[1], ways[0] * 0.03) << "it does not depend on frames; a step more or less";

    writeText(folder() / "walk.txt", "key press w --for 300\nkey press s --for=300\nkey press w 200\n");
    ask({"script", "walk.txt"});
    refused({"key", "press", "w", "--for=0"}, 2, "for");
    refused({"ping", "--for=5"}, 2, "key press");
}

TEST_F(Motions, TheSpeedOfFlyingIsAFactor) {
    start();
    std::vector<double> ways;
    for (const char* factor : {"1", "3"}) {
        ask({"speed", factor});
        ask({"wait-idle"});
        const nlohmann::json before = status()["eye"];
        ask({"key", "press", "w", "--for=300"});
        ask({"wait-idle"});
        ways.push_back(distance(before, status()["eye"]));
    }
    EXPECT_NEAR(ways[1], 3 * ways[0], ways[0] * 0.2);
    for (const char* wrong : {"0", "-1", "1e9", "fast"}) refused({"speed", wrong}, 2, "");
}

TEST_F(Motions, KeysCanBeBoundAnew) {
    start();
    const std::string before = ask({"bindings"});
    EXPECT_NE(before.find("W forward\n"), std::string::npos);
    EXPECT_NE(before.find("M+3 selectEnvironment 3\n"), std::string::npos);
    ask({"bind", "k", "forward"});
    ask({"bind", "M+K", "toggleLight", "1"});
    ask({"unbind", "W"});
    const std::string after = ask({"bindings"});
    EXPECT_EQ(after.find("W forward\n"), std::string::npos);
    EXPECT_NE(after.find("K forward\nM+K toggleLight 1\n"), std::string::npos);
    ask({"wait-idle"});
    const nlohmann::json start = status()["eye"];
    ask({"key", "press", "w", "--for=50"});
    EXPECT_EQ(status()["eye"], start);
    ask({"key", "press", "k", "--for=50"});
    EXPECT_NE(status()["eye"], start);
    ask({"bindings", "default"});
    EXPECT_EQ(ask({"bindings"}), before);
    refused({"bind", "k", "forwards"}, 2, "did you mean 'forward'");
    refused({"bind", "k", "toggleLight"}, 2, "takes a number");
    refused({"bind", "k", "jump", "1"}, 2, "takes no number");
    refused({"unbind", "k"}, 2, "not bound");
}

TEST_F(Motions, TheBloomKeySwitchesIt) {
    start();
    ask({"set", "bloom", "7"});
    EXPECT_EQ(ask({"get", "bloom.radius"}), "7\n");
    ask({"bloom", "off"});
    EXPECT_EQ(ask({"get", "bloom"}), "0\n");
    ask({"key", "tap", "b"});
    ask({"wait-idle"});
    EXPECT_EQ(ask({"get", "bloom"}), "7\n");
    ask({"light", "1", "toggle"});
}

TEST_F(Motions, WhatAKeyDidIsTold) {
    writeText(folder() / "room.obj", "# units = metres\n" + bytes("room.obj")); // so that none is offered
    start();
    const auto told = [this](const char* key) {
        const std::string before = ask({"messages"});
        ask({"key", "tap", key});
        ask({"wait-idle"});
        return ask({"messages"}).substr(before.size());
    };
    EXPECT_EQ(told("1"), "1 event light 1 off\n");
    EXPECT_EQ(told("1"), "2 event light 1 on\n");
    EXPECT_EQ(told("9"), "3 event there is no light 9\n");
    EXPECT_EQ(told("b"), "4 event bloom on\n");
    EXPECT_EQ(ask({"messages", "3"}), "4 event bloom on\n");
    EXPECT_EQ(told("w"), "") << "that is seen";
    refused({"messages", "-1"}, 2, "at least 0 for KNOWN");
}

TEST_F(Motions, FewerPixelsWhileItMovesAndAllAtRest) {
    start({"--resolution=320x240"});
    ask({"wait-idle"});
    ask({"screenshot", "before.png"});
    ask({"frame-time", "0.05"}); // too little for so many
    ask({"key", "press", "i", "--for=300"});
    ipc::Viewer viewer(instance.name());
    ipc::Frame frame;
    ask({"key", "press", "o"});
    std::uint32_t min = 320;
    for (int i = 0; i < 200 && min == 320; ++i, std::this_thread::sleep_for(5ms)) {
        if (viewer.readFrame(frame)) min = std::min(min, frame.info.width);
    }
    EXPECT_LT(min, 320U);
    EXPECT_EQ(status()["width"], 320) << "what it is asked for";
    ask({"screenshot", "moving.png"});
    EXPECT_EQ(pngFileSize(folder() / "moving.png"), (PictureSize{320, 240})) << "files get all pixels";
    ask({"key", "release", "o"});
    ask({"wait-idle"});
    viewer.readFrame(frame);
    EXPECT_EQ(frame.info.width, 320U);
    refused({"frame-time", "fast"}, 2, "a number from 0 to 10000 or off");
}

TEST_F(Motions, ALargeModelIsShownAtOnceAndTracedFasterLater) {
    writeWaves(folder() / "waves.obj", 330);
    start({}, "waves.obj");
    ask({"wait-idle"});
    ask({"screenshot", "first.png"});
    ASSERT_TRUE(server->waitForError("the exact kd-tree is in use")) << server->wait().error;
    ask({"resolution", "65", "48"});
    ask({"resolution", "64", "48"});
    ask({"wait-idle"});
    ask({"screenshot", "second.png"});
    EXPECT_EQ(bytes("first.png"), bytes("second.png"));
    ask({"units", "m"}); // in millimetres it were too small to walk
    ask({"walk"});
    ask({"wait-idle"});
    std::this_thread::sleep_for(500ms); // time for another tree, if it were built again
    const std::string said = end(SIGTERM).error;
    const std::string message = "the exact kd-tree is in use";
    EXPECT_EQ(said.find(message), said.rfind(message)) << said;
}

TEST_F(Motions, AKeyThatIsHeldForATimeIsReleasedWhenItsCommandEnds) {
    start();
    for (const int signal : {SIGINT, SIGKILL}) {
        const std::string before = ask({"camera", "get"});
        RunningProgram command(programPath("CUI"),
                               {"--instance=" + instance.name(), "key", "press", "a", "--for=60000"});
        for (int i = 0; i < 1000 && ask({"camera", "get"}) == before; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        command.send(signal);
        command.wait();
        ask({"wait-idle", "--timeout=10"});
    }
}

} // namespace
