/// RTServer and programs that speak to it by the library: commands under way at once, keys of a client's own.
#include "process/server/live_server.h"

#include "common/commands/command_lines.h"
#include "common/commands/state_report.h"

#include "ipc/endpoint/client.h"

#include "rtcore/io/text/cam.h"

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
        const ipc::Reply refusal = client.wait(second, 20s);
        // A missing scene may be refused before the second load is looked at, which then fails alike.
        if (status == ipc::ReplyStatus::Done || refusal.code != 66) {
            EXPECT_EQ(refusal.text, "another scene is being loaded");
            EXPECT_EQ(refusal.code, 1);
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
        EXPECT_EQ(reply.code, 1);
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

TEST_F(Clients, FailuresSayWhatIsWrongAndTheExitCode) {
    start();
    ipc::Client client(instance.name());
    const auto failure = [&](const std::string& command) {
        ipc::Reply reply = client.request(command);
        EXPECT_EQ(reply.status, ipc::ReplyStatus::Failed) << command;
        return std::pair(reply.code, std::move(reply.text));
    };
    using Failure = std::pair<int, std::string>;
    EXPECT_EQ(failure("screenshot a.png"), Failure(2, "the path 'a.png' is not absolute"));
    EXPECT_EQ(failure(""), Failure(2, "the command is empty"));
    EXPECT_EQ(failure("set \"bloom"), Failure(2, "a quotation mark is not closed"));
    EXPECT_EQ(failure("set bloom"), Failure(2, "set takes NAME VALUE"));
    EXPECT_EQ(failure("camera turn 400 0"),
              Failure(2, "camera turn takes a number from -360 to 360 for RIGHT, not '400'"));
    EXPECT_EQ(failure("render a.png"), Failure(2, "render is what CUI does itself, not the server"));
    for (const std::string& wrong :
         {std::string("camera set nan 0 0 0 0 1"), std::string("camera turn 1e99 0"),
          std::string("light 99999999999999999999 on"), std::string("light 99 on"),
          std::string("camera set 0 0 0 0 0 1 60 0 0 1"), std::string(8000, 'x')})
        EXPECT_EQ(failure(wrong).first, 2) << wrong;
    EXPECT_EQ(failure("load camera " + path("none.cam")).first, 66);
    EXPECT_EQ(client.request("ping").text, "pong");
}

TEST_F(Clients, OneStateTellsWhatTheSingleCommandsTell) {
    writeText(folder() / "lights.scn",
              "version = 1\nmodel = \"room.obj\"\nmodelLights = false\n"
              "[[light]]\nname = \"tall light\"\nkind = \"point\"\nposition = [0.0, 3.0, 0.0]\n"
              "intensity = [9.0, 9.0, 9.0]\n"
              "[[light]]\nkind = \"point\"\nposition = [1.0, 3.0, 0.0]\nintensity = [9.0, 9.0, 9.0]\n");
    start({}, "lights.scn");
    ipc::Client client(instance.name());
    ASSERT_EQ(client.request("light 2 off").status, ipc::ReplyStatus::Done);
    const app::StateReport state = app::parseStateReport(client.request("state").text);
    EXPECT_EQ(state.scene, client.request("scene").text);
    rtcore::CameraFile camera;
    camera.camera = state.camera;
    EXPECT_EQ(rtcore::formatCameraFile(camera), client.request("camera get").text + "\n");
    std::string settings, lights, environments;
    for (const auto& [name, value] : state.settings)
        settings += (settings.empty() ? "" : "\n") + name + " = " + rtcore::settingText(value);
    EXPECT_EQ(settings, client.request("settings").text);
    ASSERT_EQ(state.lights.size(), 2U);
    EXPECT_TRUE(state.lights[0].on);
    EXPECT_FALSE(state.lights[1].on);
    EXPECT_EQ(client.request("lights").text, "1 on " + state.lights[0].name + "\n2 off");
    EXPECT_EQ(client.request("environments").text, "");
    EXPECT_TRUE(state.environments.empty());
}

TEST_F(Clients, ACameraIsSetByNumbersToTheBit) {
    start();
    ipc::Client client(instance.name());
    const auto camera = [&] { return app::parseStateReport(client.request("state").text).camera; };
    app::command::View view{.eye = {0.1F, 1.0F / 3, -2.7e-5F},
                            .forward = {0.3F, -0.2F, -1},
                            .width = 51.3F,
                            .up = {0.05F, 0.9F, 0.1F},
                            .aspect = 1.6F};
    for (const bool orthographic : {false, true}) {
        view.orthographic = orthographic;
        ASSERT_EQ(client.request(app::command::camera(view)).status, ipc::ReplyStatus::Done);
        const rtcore::Camera set = camera();
        EXPECT_EQ(set.eye, (rtcore::Vec3{0.1F, 1.0F / 3, -2.7e-5F}));
        EXPECT_EQ(set.forward, (rtcore::Vec3{0.3F, -0.2F, -1}));
        EXPECT_EQ(set.up, (rtcore::Vec3{0.05F, 0.9F, 0.1F}));
        EXPECT_EQ(set.aspect, 1.6F);
        EXPECT_EQ(orthographic ? set.orthographicWidth : set.horizontalFov, 51.3F);
        EXPECT_EQ(set.kind == rtcore::CameraKind::Orthographic, orthographic);
    }
    // The short form keeps what it does not name.
    ASSERT_EQ(client.request("camera set 1 2 3 0 0 -1 70").status, ipc::ReplyStatus::Done);
    ASSERT_EQ(client.request("camera set 4 5 6 1 0 0").status, ipc::ReplyStatus::Done);
    EXPECT_EQ(camera().horizontalFov, 70.0F);
    EXPECT_EQ(camera().kind, rtcore::CameraKind::Perspective);
    EXPECT_EQ(camera().aspect, 0.0F);
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
    EXPECT_NE(ask({"status"}).find("state: complete"), std::string::npos);
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
