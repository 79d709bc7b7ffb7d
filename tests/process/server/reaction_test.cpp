/// Nothing holds RTServer up: neither frames of hours nor files that do not answer.
#include "process/server/live_server.h"

#include "ipc/endpoint/client.h"
#include "ipc/endpoint/viewer.h"

#include <chrono>
#include <functional>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace test;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class Reaction : public LiveServer {
  protected:
    /// A frame of the server that suits, if it comes in time.
    bool seen(const std::function<bool(const ipc::FrameInfo&)>& suits, Clock::duration within = 20s) const {
        ipc::Viewer viewer(instance.name());
        ipc::Frame frame;
        for (const auto end = Clock::now() + within; Clock::now() < end;) {
            if (viewer.waitForFrame(frame, 100ms) && suits(frame.info)) return true;
        }
        return false;
    }
    static bool coarse(const ipc::FrameInfo& info) { return info.samples == 0; }
    /// Frames of hours.
    void makeHeavy() const {
        ask({"set", "ambientOcclusion.samples", "4096"});
        ask({"set", "ambientOcclusion.on", "true"});
        ask({"set", "antialiasing", "16"});
        ask({"resolution", "1600", "1200"});
    }
};

TEST_F(Reaction, WhateverTheSettingsAreAChangeIsSeen) {
    start({"--frame-time=33"});
    makeHeavy();
    std::uint32_t width = 0;
    EXPECT_TRUE(seen([&](const ipc::FrameInfo& info) {
        width = info.width;
        return coarse(info) && info.width >= 200 && info.height >= 150;
    })) << width;
    ask({"camera", "turn", "5", "0"});
    EXPECT_TRUE(seen(coarse)) << "and the next one";
    EXPECT_EQ(ask({"get", "antialiasing"}), "16\n");
    EXPECT_EQ(ask({"ping"}), "pong\n");
    ask({"set", "ambientOcclusion.on", "false"});
    ask({"set", "antialiasing", "1"});
    ask({"resolution", "64", "48"});
    ask({"wait-idle"});
    ipc::Viewer viewer(instance.name());
    ipc::Frame frame;
    ASSERT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(frame.info.samples, 1U);
    EXPECT_EQ(frame.info.width, 64U);
    makeHeavy();
    ask({"exit"});
    EXPECT_EQ(server->wait().exitCode, 0);
}

TEST_F(Reaction, WithoutAFrameTimeWhatIsTooHeavyIsTakenBackToo) {
    start({"--look=headlight"});
    makeHeavy();
    EXPECT_TRUE(seen(coarse)) << "a change in the midst of a long frame";
    ask({"set", "antialiasing", "1"});
    ask({"set", "ambientOcclusion.on", "false"});
    ask({"resolution", "64", "48"});
    ask({"wait-idle"});
}

TEST_F(Reaction, OthersAreAnsweredWhereAPredecessorWaits) {
    start();
    makeHeavy();
    for (int i = 0; i < 3; ++i) {
        const ProgramResult result = cui({"--timeout=0.3", "screenshot", "a.png"});
        EXPECT_EQ(result.exitCode, 75);
        EXPECT_EQ(ask({"--timeout=5", "ping"}), "pong\n");
        EXPECT_EQ(ask({"--timeout=5", "get", "antialiasing"}), "16\n");
        ask({"--timeout=10", "camera", "turn", "1", "0"});
    }
}

TEST_F(Reaction, AClientThatStandsInItsOwnWayIsHelped) {
    start({"--frame-time=33"});
    makeHeavy();
    ipc::Client client(instance.name());
    ipc::Ticket picture = 0, lighter = 0;
    ASSERT_EQ(client.send("screenshot " + (folder() / "a.png").string(), &picture), ipc::SendStatus::Sent);
    ASSERT_EQ(client.send("set antialiasing 1", &lighter), ipc::SendStatus::Sent);
    const ipc::Reply given = client.wait(picture, 30s);
    EXPECT_EQ(given.code, 75);
    EXPECT_TRUE(given.text.starts_with("given up")) << given.text;
    EXPECT_EQ(client.wait(lighter, 5s).status, ipc::ReplyStatus::Done);
}

TEST_F(Reaction, FilesGetTheWholeFrameToTheBit) {
    start({"--frame-time=33", "--resolution=640x480", "--setting=exposure.mode=fixed"});
    ask({"frame-time", "0.01"}); // coarse at first, however quick the machine is
    ask({"set", "antialiasing", "2"});
    ask({"screenshot", "coarse.png"});
    ask({"camera", "turn", "7", "2"});
    ask({"screenshot", "after.png"});
    ask({"key", "press", "w"});
    ask({"screenshot", "moving.png"});
    ask({"export", "camera", "moving.cam"});
    ask({"key", "release", "w"});
    EXPECT_EQ(pngFileSize(folder() / "moving.png"), (PictureSize{640, 480}));
    ask({"camera", "reset"});
    ask({"frame-time", "off"});
    ask({"screenshot", "whole.png"});
    EXPECT_FALSE(bytes("whole.png").empty());
    EXPECT_TRUE(bytes("coarse.png") == bytes("whole.png"));
    ask({"camera", "turn", "7", "2"});
    ask({"screenshot", "whole.png"});
    EXPECT_TRUE(bytes("after.png") == bytes("whole.png"));
}

TEST_F(Reaction, PausedItFinishesThePictureAndKeepsIt) {
    start({"--frame-time=33", "--resolution=640x480"});
    ask({"frame-time", "0.01"}); // coarse while something moves
    ask({"set", "antialiasing", "3"});
    ask({"wait-idle"});
    ask({"key", "press", "w"});
    EXPECT_TRUE(seen(coarse));
    ask({"pause"});
    EXPECT_TRUE(seen([](const ipc::FrameInfo& info) { return info.samples == 9; }));
    ipc::Viewer viewer(instance.name());
    ipc::Frame frame;
    ASSERT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(frame.info.width, 640U);
    ask({"camera", "turn", "10", "0"});
    EXPECT_FALSE(viewer.waitForFrame(frame, 300ms)) << "what changes is seen when the pause is over";
    ask({"key", "release", "w"});
    ask({"resume"});
    EXPECT_TRUE(viewer.waitForFrame(frame, 5s));
}

TEST_F(Reaction, InTheBackgroundItHasAFrameTime) {
    const ProgramResult result =
        runProgram(programPath("RTServer"),
                   {"room.obj", "--instance=" + instance.name(), "--resolution=1600x1200",
                    "--setting=antialiasing=16", "--daemon"},
                   {.folder = folder().path(), .timeoutSeconds = 60});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    ipc::Viewer viewer(instance.name());
    ipc::Frame frame;
    EXPECT_TRUE(viewer.waitForFrame(frame, 10s));
    EXPECT_EQ(frame.info.samples, 0U) << "the first frame is a coarse one";
    ask({"exit"});
}

TEST_F(Reaction, FilesThatAreNoneAreRefused) {
    start();
    ask({"wait-idle"});
    const std::string pipe = (folder() / "pipe.png").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const std::string text = "no regular file";
    int writer = -1; // at first there is nobody at its other end, then one who says nothing
    for (int round = 0; round < 2; ++round) {
        for (const Names& words :
             {Names{"screenshot", pipe}, {"export", "camera", pipe}, {"export", "scene", pipe}})
            refused(words, 73, text);
        for (const Names& words :
             {Names{"load", "camera", pipe}, {"load", "set", pipe}, {"load", "scene", pipe}, {"play", pipe}})
            refused(words, 66, text);
        if (round == 0) writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
        ASSERT_GE(writer, 0);
    }
    refused({"screenshot", "/dev/null"}, 73, "");
    writeText(folder() / "list.lst", "pipe.png\n");
    refused({"play", "list.lst"}, 66, "");
    EXPECT_EQ(ask({"ping"}), "pong\n");
    ::close(writer);
    EXPECT_EQ(end(SIGTERM).exitCode, 143);
}

TEST_F(Reaction, ARecordingThatEndedByItselfSaysWhy) {
    start();
    ask({"export", "video", "start", "walk.lst"});
    ask({"load", "scene", "room.obj"});
    refused({"export", "video", "stop"}, 1, "another scene was shown");
    ask({"export", "video", "start", "again.lst"});
    ask({"export", "video", "stop"});
    refused({"export", "video", "stop"}, 1, "nothing is being recorded");
}

} // namespace
