/// The effects of commands on the state, and their requests to the host, one after the other.
#include "command_room.h"

#include "common/commands/command_lookup.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/scene/focal_length.h"
#include "rtcore/survey/default_view.h"
#include "rtcore/survey/subject.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <random>
#include <string>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;
using Commands = test::CommandRoom;

TEST_F(Commands, AskTheHost) {
    answer("parent 17");
    EXPECT_EQ(host.parent, 17);
    answer("parent none");
    EXPECT_EQ(host.parent, std::nullopt);
    answer("load scene /a.scn");
    answer("load scene /a.obj /a.bsp");
    ASSERT_EQ(host.loads.size(), 2U);
    EXPECT_EQ(host.loads[0].first, "/a.scn");
    EXPECT_EQ(host.loads[0].second, std::nullopt);
    EXPECT_EQ(host.loads[1].second, "/a.bsp");
    host.loading = true;
    EXPECT_EQ(refusal("load scene /b.scn").code, 1);
    host.told.tell("bloom on");
    host.told.warn("a texture is missing");
    EXPECT_EQ(answer("messages"), "1 event bloom on\n2 warning a texture is missing");
    EXPECT_EQ(answer("messages 1"), "2 warning a texture is missing");
    EXPECT_FALSE(host.quitted);
    answer("quit");
    EXPECT_TRUE(host.quitted);
}

TEST_F(Commands, ChangeUpAxisAndUnit) {
    const rtcore::Camera before = document.camera();
    EXPECT_EQ(answer("up +x"), "+x is up (as you say); one unit is 1 m (guessed)");
    EXPECT_EQ(document.scene()->up, (rtcore::Vec3{1, 0, 0}));
    EXPECT_EQ(document.camera().eye, before.eye) << "the room has a camera of its own";
    EXPECT_EQ(document.camera().up, (rtcore::Vec3{1, 0, 0}));
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Sky, Change::Setting}));
    answer("up +x");
    EXPECT_FALSE(changes().any());
    answer("units cm");
    EXPECT_EQ(document.scene()->metresPerUnit, 0.01F);
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Sky, Change::Setting}));
    answer("units 0.3048");
    EXPECT_EQ(document.scene()->metresPerUnit, 0.3048F);
    answer("up +y");
    answer("units m");
    EXPECT_EQ(document.camera(), before);
    EXPECT_NE(answer("units auto").find("guessed"), std::string::npos);
    EXPECT_EQ(refusal("up sideways").code, 2);
    EXPECT_EQ(refusal("units parsecs").code, 2);
    EXPECT_EQ(refusal("units 0").code, 2);
}

TEST_F(Commands, TurnTheViewOfAModelThatBringsNone) {
    rtcore::LoadedScene room = test::makeRoom();
    room.ownCamera = false;
    room.preset = rtcore::LightingPreset::Headlight;
    room.sceneFile.reset();
    room.camera = rtcore::defaultCamera(
        room.tree, room.scene.mesh(), rtcore::survey(room.tree, room.scene.mesh(), rtcore::Axes({0, 1, 0})));
    room.scene.lights = {rtcore::defaultLight(room.camera, room.tree.bounds)};
    document.show(test::worldOf(std::move(room)));
    const rtcore::Camera before = document.camera();
    const rtcore::Light light = document.scene()->lights[0].light;
    answer("up +z");
    EXPECT_EQ(document.camera().up, (rtcore::Vec3{0, 0, 1}));
    EXPECT_NE(document.camera().eye, before.eye);
    EXPECT_NE(document.scene()->lights[0].light, light);
    EXPECT_TRUE(changes().has(Change::Light));
    answer("up +y");
    EXPECT_EQ(document.camera(), before);
    EXPECT_EQ(document.scene()->lights[0].light, light);
}

TEST_F(Commands, EndTheOffersThatTheyDecide) {
    messages.offer("+z is taken for up (by its shape); 'up +y' turns the model");
    EXPECT_EQ(messages.since(0), "1 offer +z is taken for up (by its shape); 'up +y' turns the model");
    answer("up +y");
    EXPECT_EQ(messages.since(0), "");
    EXPECT_EQ(messages.count(), 1U);
}

TEST_F(Commands, SteerHowTheServerWorks) {
    answer("pause");
    EXPECT_TRUE(state.paused);
    EXPECT_EQ(refusal("wait-idle").text, "the server is paused; resume it first");
    answer("resume");
    EXPECT_FALSE(state.paused);
    answer("idle off");
    EXPECT_FALSE(state.idles);
    EXPECT_EQ(refusal("wait-idle").text, "the server never idles; 'idle on' lets it");
    answer("idle on");
    EXPECT_TRUE(state.idles);
    answer("frame-time 20");
    EXPECT_NEAR(state.frameSeconds, 0.02, 1e-9);
    answer("frame-time off");
    EXPECT_EQ(state.frameSeconds, 0);
}

TEST_F(Commands, DoNotDrawByPaths) {
    const std::string text = "integrator is path, which is for stills, not for the live view; put it into "
                             "[still], or use 'Renderer --setting integrator=path'";
    EXPECT_EQ(refusal("set integrator path").text, text);
    EXPECT_EQ(document.settings().integrator, rtcore::Integrator::Whitted);
    EXPECT_EQ(changes(), Changes{});
    answer("set path.samples 64");
    EXPECT_EQ(document.settings().path.samples, 64);
    std::ofstream(folder / "path.set") << "version = 1\n[live]\nintegrator = 'path'\n";
    EXPECT_NE(refusal("load set DIR/path.set").text.find(text), std::string::npos);
}

TEST_F(Commands, WhoseFramesFindNoRoomAreRefused) {
    full = true;
    const Failure failure = refusal("resolution 64 48");
    EXPECT_EQ(failure.code, 75);
    EXPECT_EQ(failure.text, "no room for that");
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(Commands, WalkWithABodyThatFitsTheModel) {
    rtcore::LoadedScene room = test::makeRoom();
    room.scene.metresPerUnit = 0.1F;
    document.show(test::worldOf(room));
    EXPECT_NE(refusal("walk").text.find("too small to walk"), std::string::npos);
    room.scene.walk.height = 0.12F;
    document.show(test::worldOf(std::move(room)));
    answer("walk");
    EXPECT_TRUE(walk.walking());
}

/// All of what the model is about is in the image.
void expectShownWhole(Document& document) {
    const rtcore::Camera& camera = document.camera();
    const rtcore::Vec3 forward = normalize(camera.forward);
    const rtcore::Vec3 right = normalize(cross(forward, camera.up)), up = cross(right, forward);
    const float half = std::tan(camera.horizontalFov * 3.14159265F / 360);
    const float aspect =
        static_cast<float>(document.settings().width) / static_cast<float>(document.settings().height);
    const rtcore::Mesh& mesh = document.scene()->model.mesh;
    const rtcore::Box3 box = rtcore::subjectOf(mesh, rtcore::axesOf(*document.scene())).bounds;
    for (const rtcore::Vertex& vertex : mesh.vertices) {
        if (!box.contains(vertex.position())) continue;
        const rtcore::Vec3 way = vertex.position() - camera.eye;
        const float far = dot(way, forward);
        ASSERT_GT(far, 0);
        EXPECT_LE(std::fabs(dot(way, right)), far * half);
        EXPECT_LE(std::fabs(dot(way, up)), far * half / aspect);
    }
}

TEST_F(Commands, OrbitWithoutLosingTheModel) {
    std::mt19937 random(3);
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (int i = 0; i < 1000; ++i) {
        answer(fmt::format("camera pivot {} {}", number(0, 1), number(0, 1)));
        answer(fmt::format("camera orbit {} {}", number(-180, 180), number(-90, 90)));
        answer(fmt::format("camera pan {} {}", number(-2, 2), number(-2, 2)));
        answer(fmt::format("camera approach {}", std::exp(number(-2, 2))));
        if (i % 10 != 0) continue;
        answer("camera fit");
        expectShownWhole(document);
    }
    EXPECT_EQ(document.camera().up, document.scene()->up);
}

TEST_F(Commands, ShowTheModelFromItsSides) {
    const auto forwardOf = [&](const std::string& side) {
        answer("camera view " + side);
        expectShownWhole(document);
        return normalize(document.camera().forward);
    };
    EXPECT_EQ(forwardOf("front"), (rtcore::Vec3{0, 0, -1}));
    EXPECT_EQ(forwardOf("back"), (rtcore::Vec3{0, 0, 1}));
    EXPECT_EQ(forwardOf("right"), (rtcore::Vec3{-1, 0, 0}));
    EXPECT_EQ(forwardOf("left"), (rtcore::Vec3{1, 0, 0}));
    EXPECT_EQ(forwardOf("top"), (rtcore::Vec3{0, -1, 0}));
    EXPECT_EQ(forwardOf("bottom"), (rtcore::Vec3{0, 1, 0}));
    EXPECT_LT(forwardOf("three-quarter").y, 0);
    EXPECT_EQ(refusal("camera view inside").code, 2);
    EXPECT_NE(refusal("camera fit nothing-like-that").code, 0);
}

TEST_F(Commands, PanByPartsOfTheImage) {
    answer("camera look-at 0 1 10 0 1 0");
    answer("camera pivot");
    EXPECT_EQ(refusal("camera pivot 0.5").code, 2) << "half a place";
    const rtcore::Camera before = document.camera();
    answer("camera pan 0.25 0");
    EXPECT_LT(document.camera().eye.x, before.eye.x) << "the model goes to the right";
    answer("camera pan -0.25 0.5");
    EXPECT_NEAR(document.camera().eye.x, before.eye.x, 1e-4);
    EXPECT_LT(document.camera().eye.y, before.eye.y);
    EXPECT_EQ(document.camera().forward, before.forward);
}

TEST_F(Commands, PlaceTheCamera) {
    answer("camera set 1 2 3 0 0 -2 40");
    EXPECT_EQ(document.camera().eye, (rtcore::Vec3{1, 2, 3}));
    EXPECT_EQ(document.camera().horizontalFov, 40);
    answer("camera look-at 0 2 3 0 2 0");
    EXPECT_EQ(normalize(document.camera().forward), (rtcore::Vec3{0, 0, -1}));
    EXPECT_EQ(document.camera().horizontalFov, 40) << "stays";
    answer("camera orthographic 0 2 3 0 0 -1 4");
    EXPECT_EQ(document.camera().kind, rtcore::CameraKind::Orthographic);
    EXPECT_EQ(document.camera().orthographicWidth, 4);
    answer("camera reset");
    EXPECT_EQ(document.camera(), test::makeRoom().camera);
    answer("walk");
    EXPECT_TRUE(walk.walking());
    answer("fly");
    EXPECT_FALSE(walk.walking());
    answer("camera set 0 -50 0 0 0 -1");
    EXPECT_EQ(refusal("walk").code, 1);
}

TEST_F(Commands, WidenAndNarrowTheFieldOfView) {
    const rtcore::Camera framed = document.camera();
    answer("camera angle 90");
    EXPECT_EQ(document.camera().horizontalFov, 90);
    EXPECT_EQ(document.camera().eye, framed.eye);
    answer("camera lens 50");
    EXPECT_NEAR(document.camera().horizontalFov, 39.598, 1e-3) << "of a lens of 50 mm, by its maker";
    answer("camera lens 18");
    EXPECT_NEAR(document.camera().horizontalFov, 90, 1e-4);
    EXPECT_NEAR(std::stod(answer("camera zoom 2")), 53.13, 0.01);
    EXPECT_NEAR(std::stod(answer("camera zoom 0.5")), 90, 1e-3) << "and back";
    EXPECT_NEAR(std::stod(answer("camera zoom 1000")), 0.5, 1e-3);
    EXPECT_NEAR(std::stod(answer("camera zoom 0.001")), 154.2, 0.1) << "from there";
    for (int i = 0; i < 5; ++i) answer("camera zoom 0.1");
    EXPECT_EQ(document.camera().horizontalFov, 170);
    answer("camera angle 175");
    EXPECT_EQ(answer("camera zoom 0.9"), "175") << "never the other way";
    answer("camera set 0 2 3 0 0 -1 5 0 1 0 0.1");
    const auto angleShown = [&] {
        const rtcore::RenderSettings& image = document.settings();
        return double{rtcore::fieldOfView(document.camera(), image.width, image.height)};
    };
    const double before = angleShown();
    const double told = std::stod(answer("camera zoom 1.5"));
    EXPECT_NEAR(told, angleShown(), 1e-3) << "of the image, whatever its author's";
    const auto halfWidth = rtcore::halfWidthOfAngle;
    EXPECT_NEAR(halfWidth(angleShown()) * 1.5, halfWidth(before), 1e-4);
    answer("camera orthographic 0 2 3 0 0 -1 4");
    EXPECT_EQ(answer("camera zoom 2"), "2");
    EXPECT_EQ(document.camera().kind, rtcore::CameraKind::Orthographic);
    answer("camera angle 60");
    EXPECT_EQ(document.camera().kind, rtcore::CameraKind::Perspective);
}

TEST_F(Commands, FocusOnWhatIsSeen) {
    answer("camera look-at 0 2 0 0 0 0.001");
    EXPECT_NEAR(std::stod(answer("focus 0.5 0.5")), 2, 0.01);
    EXPECT_TRUE(document.settings().depthOfField.on);
    EXPECT_NEAR(document.settings().depthOfField.focus, 2, 0.01);
}

TEST_F(Commands, PressKeys) {
    const Result timed = run("key press w 50");
    EXPECT_TRUE(walk.keyboard().isDown(timed.press));
    move(0ms, {});
    move(60ms, {});
    EXPECT_FALSE(walk.keyboard().isDown(timed.press));
    EXPECT_EQ(changes(), Changes{Change::View});
    answer("key tap 1");
    move(0ms, {});
    EXPECT_FALSE(lightIsOn(0));
    answer("bind k toggleLight 2");
    answer("key tap k");
    move(0ms, {});
    EXPECT_FALSE(lightIsOn(1));
    answer("unbind k");
    answer("key tap k");
    move(0ms, {});
    EXPECT_FALSE(lightIsOn(1));
    answer("bindings default");
    EXPECT_EQ(answer("bindings").find("K "), std::string::npos);
}

TEST_F(Commands, ThatNeedAFrameWaitForIt) {
    for (const char* line : {"screenshot DIR/b.png", "export camera DIR/b.cam"}) {
        EXPECT_EQ(run(line).when, ReplyWhen::Again) << line << ": there is no frame yet";
        drawFrame();
        EXPECT_EQ(run(line).when, ReplyWhen::Beside) << line;
        answer("light 1 toggle");
        EXPECT_EQ(run(line).when, ReplyWhen::Again) << line << ": the frame is outdated";
        test::draw(host.maker, state, kCoarsest);
        EXPECT_EQ(run(line).when, ReplyWhen::Again) << line << ": it is a coarse one";
        drawFrame();
        answer("camera turn 1 1");
        state.paused = true;
        EXPECT_EQ(run(line).when, ReplyWhen::Beside) << line << ": the frame stands while paused";
        state.paused = false;
        host.maker.drop();
    }
    state.paused = true;
    EXPECT_EQ(refusal("screenshot DIR/b.png").text, "there is no frame yet, and the server is paused");
}

TEST_F(Commands, WriteWhatWasShownWhenTheyRan) {
    drawFrame();
    const Result camera = run("export camera DIR/b.cam 640"), scene = run("export scene DIR/b.scn");
    answer("light 1 off");
    answer("camera turn 90 0");
    answer("environment 2");
    camera.work()();
    scene.work()();
    const rtcore::CameraFile cam = rtcore::readCameraFile(folder / "b.cam");
    EXPECT_EQ(cam.camera.eye, document.camera().eye);
    EXPECT_NEAR(cam.camera.forward.z, -1, 1e-5);
    EXPECT_EQ(cam.width, 640);
    EXPECT_EQ(cam.height, 24);
    EXPECT_EQ(cam.lightsOn, (std::vector{1, 2}));
    EXPECT_EQ(cam.environment, 0);
    EXPECT_EQ(cam.exposure, host.maker.exposure());
    const rtcore::SceneFile scn = rtcore::readSceneFile(folder / "b.scn");
    EXPECT_EQ(scn.model, "/rooms/room.obj");
    ASSERT_EQ(scn.lights.size(), 2U);
    EXPECT_EQ(scn.lights[0].name, "left");
    EXPECT_EQ(scn.lights[0].light.on, 1U);
}

TEST_F(Commands, WriteASkyAndNotWhatComesOfIt) {
    drawFrame();
    answer("sky hour 9");
    answer("sky place 48.2 16.4 1");
    EXPECT_EQ(answer("environments"), "1 - noon\n2 - dusk\n3 active sky");
    EXPECT_EQ(answer("lights"), "1 on left\n2 on\n3 on sun");
    run("export scene DIR/b.scn").work()();
    rtcore::SceneFile scn = rtcore::readSceneFile(folder / "b.scn");
    EXPECT_EQ(scn.sky, document.scene()->sky);
    EXPECT_EQ(scn.sky->date->second, 9 * 3600);
    EXPECT_EQ(scn.lights.size(), 2U);
    EXPECT_EQ(scn.environments.size(), 2U);
    EXPECT_EQ(scn.activeEnvironment, 2);
    answer("environment open DIR/a.pfm");
    answer("environment rotation -45");
    answer("environment strength 0.5");
    EXPECT_EQ(answer("environments"), "1 - noon\n2 - dusk\n3 active a");
    EXPECT_EQ(answer("lights"), "1 on left\n2 on");
    run("export scene DIR/b.scn").work()();
    scn = rtcore::readSceneFile(folder / "b.scn");
    EXPECT_FALSE(scn.sky);
    ASSERT_EQ(scn.environments.size(), 3U);
    EXPECT_EQ(scn.environments[2].files.front(), folder / "a.pfm");
    EXPECT_EQ(scn.environments[2].rotation, -45);
    EXPECT_EQ(scn.environments[2].intensity, 0.5F);
    answer("sky on");
    EXPECT_EQ(refusal("environment rotation 10").text, "the sky is turned by 'sky north'");
    answer("environment strength 4");
    EXPECT_EQ(document.scene()->sky->strength, 4);
    answer("environment none");
    EXPECT_EQ(refusal("environment strength 4").text, "no environment map is shown");
}

TEST_F(Commands, WriteOverNoFileThatTheSceneWasReadFrom) {
    rtcore::LoadedScene room = test::makeRoom();
    room.files = {folder / "a.cam", folder / "a.set"};
    document.show(test::worldOf(std::move(room)));
    drawFrame();
    EXPECT_NE(refusal("screenshot DIR/a.set").code, 0);
    EXPECT_NE(refusal("export scene DIR/a.cam").code, 0);
    EXPECT_EQ(refusal("export camera DIR/a.cam").code, 0) << "a description of the same kind may go";
    EXPECT_EQ(refusal("screenshot DIR/b.png").code, 0);
    EXPECT_TRUE(exists("b.png"));
}

TEST_F(Commands, RecordAndPlay) {
    answer("export video start DIR/r.lst 10");
    EXPECT_EQ(answer("export video"), inFolder("on 0.0 DIR/r.lst"));
    const Failure second = refusal("export video start DIR/s.lst");
    EXPECT_EQ(second.code, 1);
    EXPECT_NE(second.text.find("a recording is under way"), std::string::npos);
    move(0ms, {});
    move(100ms, {});
    EXPECT_EQ(answer("export video stop"), "2 frames");
    EXPECT_EQ(answer("export video"), inFolder("off DIR/r.lst"));
    changes();
    answer("play DIR/a.lst");
    move(1ms, {});
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Light}));
    EXPECT_FALSE(walk.atRest());
    answer("play stop");
    EXPECT_TRUE(walk.atRest());
}

TEST_F(Commands, SayWhatTheyDoToALongFrame) {
    using app::CommandEffect;
    using app::effectOf;
    EXPECT_EQ(effectOf("lights"), CommandEffect::Tells);
    EXPECT_EQ(effectOf("light 1 off"), CommandEffect::Changes);
    EXPECT_EQ(effectOf("screenshot /a.png"), CommandEffect::Waits);
    EXPECT_EQ(effectOf("pause"), CommandEffect::Steers);
    EXPECT_EQ(effectOf("nonsense"), CommandEffect::Tells) << "what is wrong with it";
    for (const char* const line :
         {"note add 0 0 0 a", "note remove 1", "measure keep seen 0 0 1 1", "bookmark rename a b",
          "by 7 also note text 1 b", "also measure name 1 a", "visitor note at 0.5 0.5 a Ada"})
        EXPECT_EQ(effectOf(line), CommandEffect::Keeps) << line;
    EXPECT_EQ(effectOf("by 7 also light 1 off"), CommandEffect::Changes);
    EXPECT_EQ(effectOf("by"), CommandEffect::Tells);
    EXPECT_EQ(effectOf("note go 1"), CommandEffect::Changes);
}

} // namespace
} // namespace rtserver
