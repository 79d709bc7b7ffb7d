/// RTServer and programs that speak to it by the library: commands under way at once, keys of a client's own.
#include "process/server/live_server.h"

#include "ipc/endpoint/client.h"

#include <chrono>

namespace {

using namespace test;
using namespace std::chrono_literals;

class Clients : public LiveServer {
  protected:
    std::string path(const std::string& name) const { return (folder() / name).string(); }
};

TEST_F(Clients, CommandsUnderWayAreDoneInTheirOrder) {
    start();
    ipc::Client client(instance.name());
    ipc::Ticket last = 0;
    for (const std::string size : {"20", "30"}) {
        ASSERT_EQ(client.send("resolution " + size + " 10"), ipc::SendStatus::Sent);
        ASSERT_EQ(client.send("screenshot " + path(size + ".png"), &last), ipc::SendStatus::Sent);
    }
    EXPECT_EQ(client.wait(last, 20s).status, ipc::ReplyStatus::Done);
    EXPECT_EQ(pngFileSize(folder() / "20.png"), (PictureSize{20, 10}));
    EXPECT_EQ(pngFileSize(folder() / "30.png"), (PictureSize{30, 10}));
}

TEST_F(Clients, AnswersThatComeLateAreEachGivenOnce) {
    start();
    ipc::Client client(instance.name());
    for (const auto& [scene, status] :
         {std::pair{"room.obj", ipc::ReplyStatus::Done}, std::pair{"none.obj", ipc::ReplyStatus::Failed}}) {
        ipc::Ticket load = 0, idle = 0, second = 0;
        ASSERT_EQ(client.send("load scene " + path(scene), &load), ipc::SendStatus::Sent);
        ASSERT_EQ(client.send("load scene " + path(scene), &second), ipc::SendStatus::Sent);
        ASSERT_EQ(client.send("wait-idle", &idle), ipc::SendStatus::Sent);
        const std::string refusal = client.wait(second, 20s).text;
        // What is missing may be refused before the second is looked at: then it is refused for that, too.
        if (status == ipc::ReplyStatus::Done || !refusal.starts_with("66 ")) {
            EXPECT_EQ(refusal, "1 another scene is being loaded");
        }
        EXPECT_EQ(client.wait(load, 20s).status, status) << scene;
        EXPECT_EQ(client.wait(idle, 20s).status, ipc::ReplyStatus::Done) << scene;
    }
}

TEST_F(Clients, WhoWaitsForIdleIsToldThatItWillNotBe) {
    start();
    ipc::Client client(instance.name());
    for (const std::string command : {"pause", "idle off"}) {
        ASSERT_EQ(client.request("key press d").status, ipc::ReplyStatus::Done);
        ipc::Ticket idle = 0;
        ASSERT_EQ(client.send("wait-idle", &idle), ipc::SendStatus::Sent);
        ASSERT_EQ(client.request(command).status, ipc::ReplyStatus::Done);
        const ipc::Reply reply = client.wait(idle, 10s);
        EXPECT_EQ(reply.status, ipc::ReplyStatus::Failed) << command;
        EXPECT_EQ(reply.text.substr(0, 2), "1 ");
        client.request("resume");
    }
}

TEST_F(Clients, AServerThatLoadsIsNotIdle) {
    writeWaves(folder() / "waves.obj", 150);
    start();
    ipc::Client client(instance.name());
    ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
    ipc::Ticket load = 0, idle = 0;
    ASSERT_EQ(client.send("load scene " + path("waves.obj"), &load), ipc::SendStatus::Sent);
    ASSERT_EQ(client.send("wait-idle", &idle), ipc::SendStatus::Sent);
    EXPECT_EQ(client.wait(idle, 1ms).status, ipc::ReplyStatus::TimedOut);
    EXPECT_EQ(client.wait(idle, 60s).status, ipc::ReplyStatus::Done);
    EXPECT_EQ(client.status().polygons, 2U * 150 * 150);
    EXPECT_EQ(client.wait(load, 1ms).status, ipc::ReplyStatus::Done);
}

TEST_F(Clients, NobodyWaitsForTheCommandsOfAnother) {
    start({"--fps-limit=1"});
    ipc::Client slow(instance.name()), quick(instance.name());
    ASSERT_EQ(slow.send("camera turn 1 0"), ipc::SendStatus::Sent);
    ipc::Ticket picture = 0;
    ASSERT_EQ(slow.send("screenshot " + path("a.png"), &picture), ipc::SendStatus::Sent);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(quick.request("ping", 200ms).text, "pong");
    EXPECT_EQ(slow.wait(picture, 10s).status, ipc::ReplyStatus::Done);
}

TEST_F(Clients, FailuresBeginWithTheExitCode) {
    start();
    ipc::Client client(instance.name());
    const auto failure = [&](const std::string& command) {
        const ipc::Reply reply = client.request(command);
        EXPECT_EQ(reply.status, ipc::ReplyStatus::Failed) << command;
        return reply.text;
    };
    EXPECT_EQ(failure("screenshot a.png"), "2 the path 'a.png' is not absolute");
    EXPECT_EQ(failure(""), "2 the command is empty");
    EXPECT_EQ(failure("set \"bloom"), "2 a quotation mark is not closed");
    EXPECT_EQ(failure("set bloom"), "2 set takes NAME VALUE");
    EXPECT_EQ(failure("camera set nan 0 0 0 0 1").substr(0, 2), "2 ");
    EXPECT_EQ(failure("camera turn 1e99 0").substr(0, 2), "2 ");
    EXPECT_EQ(failure("light 99999999999999999999 on").substr(0, 2), "2 ");
    EXPECT_EQ(failure("load camera " + path("none.cam")).substr(0, 3), "66 ");
    EXPECT_EQ(failure(std::string(8000, 'x')).substr(0, 2), "2 ");
    EXPECT_EQ(client.request("ping").text, "pong");
}

TEST_F(Clients, TheKeysOfOneThatLeavesAreReleased) {
    start();
    {
        ipc::Client client(instance.name());
        ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
        client.pressKey('W');
        ipc::Frame frame;
        client.readFrame(frame);
        ASSERT_TRUE(client.waitForFrame(frame, 10s));
        ASSERT_TRUE(client.waitForFrame(frame, 10s));
        EXPECT_EQ(client.status().idle, 0U);
    }
    ask({"wait-idle"});
    EXPECT_NE(ask({"status"}).find("state: idle"), std::string::npos);
}

TEST_F(Clients, ALongFrameComesInTheEndWhateverChanges) {
    start({"--setting=antialiasing=16"});
    ipc::Client client(instance.name());
    for (int side = 300; client.status().frameSeconds < 1.3; side += side / 2) {
        client.request("resolution " + std::to_string(side) + " " + std::to_string(side));
        ASSERT_EQ(client.request("wait-idle", 60s).status, ipc::ReplyStatus::Done);
    }
    ipc::Frame frame;
    client.readFrame(frame);
    bool came = false;
    for (const auto end = std::chrono::steady_clock::now() + 90s;
         !came && std::chrono::steady_clock::now() < end;) {
        client.send("camera turn 0.1 0");
        came = client.waitForFrame(frame, 100ms);
    }
    EXPECT_TRUE(came);
}

TEST_F(Clients, AnotherSceneIsSeenInItsOwnLightAtOnce) {
    for (const std::string brightness : {"0.01", "90.0"}) {
        writeText(folder() / (brightness + ".scn"), "version = 1\nmodel = \"room.obj\"\nbackground = [" +
                                                        brightness + ", " + brightness + ", " + brightness +
                                                        "]\nambient = [" + brightness + ", 0.0, 0.0]\n");
    }
    start({}, "0.01.scn");
    ipc::Client client(instance.name());
    ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
    ipc::Frame frame;
    client.readFrame(frame);
    const std::uint64_t before = frame.info.number;
    ASSERT_EQ(client.request("load scene " + path("90.0.scn"), 20s).status, ipc::ReplyStatus::Done);
    ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
    client.readFrame(frame);
    EXPECT_LE(frame.info.number, before + 2) << "the eye got used to it from frame to frame";
}

TEST_F(Clients, FramesHaveTheSizeThatWasAskedFor) {
    start();
    ipc::Client client(instance.name());
    ipc::Frame frame;
    for (const auto& [width, height] : {std::pair{50U, 30U}, std::pair{1300U, 800U}, std::pair{1U, 9U}}) {
        client.request("resolution " + std::to_string(width) + " " + std::to_string(height));
        ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
        client.readFrame(frame);
        EXPECT_EQ(frame.info.width, width);
        EXPECT_EQ(frame.info.height, height);
        EXPECT_EQ(frame.pixels.size(), std::size_t{4} * width * height);
        EXPECT_EQ(client.status().width, width);
    }
}

TEST_F(Clients, AnExportedCameraHasTheExposureOfItsOwnFrame) {
    start();
    ipc::Client client(instance.name());
    ipc::Ticket last = 0;
    for (const std::string value : {"3.5", "0.25"}) {
        ASSERT_EQ(client.send("set exposure.mode fixed"), ipc::SendStatus::Sent);
        ASSERT_EQ(client.send("set exposure.value " + value), ipc::SendStatus::Sent);
        ASSERT_EQ(client.send("export camera " + path("a.cam"), &last), ipc::SendStatus::Sent);
        ASSERT_EQ(client.wait(last, 20s).status, ipc::ReplyStatus::Done);
        EXPECT_NE(bytes("a.cam").find("exposure = " + value), std::string::npos) << bytes("a.cam");
    }
}

TEST_F(Clients, AFrameIsTheScreenshot) {
    start();
    ipc::Client client(instance.name());
    ASSERT_EQ(client.request("wait-idle", 20s).status, ipc::ReplyStatus::Done);
    ASSERT_EQ(client.request("screenshot " + path("a.ppm")).status, ipc::ReplyStatus::Done);
    ipc::Frame frame;
    ASSERT_TRUE(client.readFrame(frame) || frame.info.number > 0);
    ASSERT_EQ(frame.info.width, 64U);
    std::string colours;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (i % 4 < 3) colours += static_cast<char>(frame.pixels[i]);
    }
    const std::string file = bytes("a.ppm");
    ASSERT_GT(file.size(), colours.size());
    EXPECT_EQ(file.substr(file.size() - colours.size()), colours);
}

} // namespace
