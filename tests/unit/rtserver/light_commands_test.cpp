/// Lights that commands add, remove and change.
#include "command_room.h"

#include "rtserver/document/exports.h"
#include "rtserver/document/light_edits.h"

#include "rtcore/io/text/cosine.h"
#include "rtcore/math/blackbody.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using rtcore::Change;
using rtcore::Changes;
using rtcore::Colour;
using rtcore::LightDescription;
using rtcore::LightKind;
using rtcore::Vec3;

class LightCommands : public test::CommandRoom {
  protected:
    LightDescription light(int id) const {
        return describeLight(*document.scene(), lightOf(*document.scene(), id));
    }
    std::vector<int> ids() const {
        std::vector<int> all;
        for (const rtcore::SceneLight& each : document.scene()->lights) all.push_back(each.notes.id);
        return all;
    }
    void expectNear(Vec3 is, Vec3 expected, float error = 1e-4F) {
        EXPECT_NEAR(is.x, expected.x, error);
        EXPECT_NEAR(is.y, expected.y, error);
        EXPECT_NEAR(is.z, expected.z, error);
    }
};

TEST_F(LightCommands, ALuminaireIsThatOfItsFileAndIsTurned) {
    std::ofstream(folder / "a \"{0}\" <b>.ies")
        << "IESNA:LM-63-1995\nTILT=NONE\n1 100 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n8 4\n";
    answer(R"(light file 1 "DIR/a \"{0}\" <b>.ies")");
    EXPECT_EQ(light(1).light.kind, LightKind::Ies);
    const rtcore::Vec3 before = light(1).light.right;
    answer("light turn 1 90");
    expectNear(light(1).light.right, cross(before, light(1).light.direction));
    const rtcore::Vec3 turned = light(1).light.right;
    for (const float each : {turned.x, turned.y, turned.z})
        EXPECT_TRUE(each == 0 || std::fabs(each) > 1e-6F) << each << ": no rounding is saved";
    EXPECT_NE(answer("light get 1").find((folder / "a \\\"{0}\\\" <b>.ies").string()), std::string::npos)
        << answer("light get 1") << "the whole path, whichever folder the server is in";
    const Colour bright = light(1).light.intensity;
    EXPECT_EQ(refusal("light file 1 DIR/bad.cam").code, 65);
    EXPECT_EQ(light(1).light.intensity, bright);
    answer("light kind 1 point");
    EXPECT_EQ(answer("light get 1").find("file"), std::string::npos);
}

TEST_F(LightCommands, AddEachKind) {
    int id = 3;
    for (const rtcore::LightTraits& traits : rtcore::kLightTraits) {
        EXPECT_EQ(answer("light add " + std::string(traits.name) + " at 1 2 3"), std::to_string(id));
        EXPECT_EQ(changes(), Changes{Change::Light});
        const LightDescription added = light(id++);
        EXPECT_EQ(rtcore::traitsOf(added.light).name, traits.name);
        EXPECT_GT(powerOf(added), 0);
        if (traits.position) {
            EXPECT_EQ(added.light.position, (Vec3{1, 2, 3}));
        }
        // Lights that a file could not describe are never made.
        rtcore::SceneFile file = sceneFileOf(document);
        EXPECT_NO_THROW(rtcore::parseSceneFile(rtcore::formatSceneFile(file, "x.scn"), "x.scn"));
    }
    drawFrame();
}

TEST_F(LightCommands, AddHereAndWhereOneLooks) {
    answer("camera set 0 2 3 0 -1 0 60 0 0 -1");
    answer("light add point here");
    EXPECT_EQ(light(3).light.position, (Vec3{0, 2, 3}));
    answer("light add point seen");
    const Vec3 place = light(4).light.position;
    EXPECT_NEAR(place.x, 0, 1e-4);
    EXPECT_NEAR(place.z, 3, 1e-4);
    EXPECT_GT(place.y, 0) << "off the floor";
    EXPECT_LT(place.y, 0.5F);
    answer("light add point");
    EXPECT_EQ(light(5).light.position, place);
    answer("camera set 0 2 3 0 1 0 60 0 0 -1"); // nothing is above
    EXPECT_EQ(refusal("light add point seen").text, "there is no surface there; the light stays as it was");
    answer("light add spot");
    EXPECT_EQ(light(6).light.position, (Vec3{0, 2, 3}));
    expectNear(light(6).light.direction, {0, 1, 0});
}

TEST_F(LightCommands, MoveToWhatAPixelSees) {
    answer("camera set 0 2 3 0 -1 0 90 0 0 -1");
    answer("light move 1 seen 1 0.5"); // the right edge of 90 degrees
    const Vec3 place = light(1).light.position;
    EXPECT_NEAR(place.x, 2, 0.01);
    EXPECT_NEAR(place.z, 3, 0.01);
    EXPECT_EQ(refusal("light move 1 seen 1 1.5").text, "seen takes numbers from 0 to 1, not '1.5'");
}

TEST_F(LightCommands, IdsStayWhileOthersComeAndGo) {
    answer("light remove 1");
    EXPECT_EQ(ids(), (std::vector<int>{2}));
    EXPECT_EQ(answer("light copy 2"), "3");
    EXPECT_EQ(answer("lights"), "2 on\n3 on");
    answer("light 3 off");
    EXPECT_EQ(answer("lights"), "2 on\n3 off");
    EXPECT_EQ(refusal("light 1 on").text, "there is no light 1; the scene has numbers 2 to 3");
    answer("light remove 2");
    EXPECT_EQ(refusal("light power 9 5").text, "there is no light 9; the scene has only number 3");
    answer("light remove 3");
    EXPECT_EQ(refusal("light name 3 x").text, "there is no light 3; the scene has none");
    EXPECT_EQ(answer("lights"), "");
    EXPECT_EQ(answer("light add point here"), "4") << "none is given again";
}

TEST_F(LightCommands, KeysNameLightsByTheirIds) {
    answer("light remove 1");
    answer("key tap 2");
    move(std::chrono::milliseconds(0), {});
    EXPECT_EQ(answer("lights"), "2 off");
    EXPECT_NE(messages.since(0).find("light 2 off"), std::string::npos);
    answer("key tap 1");
    move(std::chrono::milliseconds(0), {});
    EXPECT_NE(messages.since(0).find("there is no light 1"), std::string::npos);
}

TEST_F(LightCommands, CamerasNameLightsByTheirIds) {
    answer("light remove 1");
    answer("light copy 2");
    answer("light 2 off");
    const rtcore::CameraFile file = cameraFileOf(document, 1);
    EXPECT_EQ(file.lightsOn, (std::vector<int>{3}));
    EXPECT_EQ(file.lightsOff, (std::vector<int>{2}));
    answer("light remove 3");
    answer("light 2 on");
    EXPECT_EQ(document.applyCameraFile(file, "a.cam").english(),
              "a.cam names lights that the scene lacks (3); these stay as they are");
    EXPECT_EQ(answer("lights"), "2 off");
}

TEST_F(LightCommands, PowerCountsAllDirections) {
    constexpr float kPi = std::numbers::pi_v<float>;
    answer("light power 1 100");
    EXPECT_NEAR(light(1).light.intensity.g, 100 / (4 * kPi), 1e-4);
    answer("light kind 1 rectangle");
    EXPECT_NEAR(light(1).light.intensity.g, 100 / kPi, 1e-3);
    EXPECT_NEAR(powerOf(light(1)), 100, 1e-3);
    answer("light kind 1 sphere");
    EXPECT_NEAR(light(1).light.intensity.g, 100 / (4 * kPi), 1e-4);
    answer("light kind 1 directional");
    answer("light power 1 3");
    EXPECT_NEAR(light(1).light.intensity.g, 3, 1e-5);
    EXPECT_EQ(refusal("light power 1 0").code, 2);
    EXPECT_EQ(refusal("light power 1 -3").code, 2);
    EXPECT_EQ(refusal("light power 1 much").code, 2);
}

/// Against the sum over its cone.
TEST_F(LightCommands, PowerOfASpotIsThatOfItsCone) {
    answer("light kind 1 spot");
    answer("light angles 1 20 50");
    const LightDescription spot = light(1);
    double sum = 0;
    constexpr int kSteps = 100'000;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        const double t = std::clamp((cosine - double{spot.light.cosOuter}) /
                                        (double{spot.light.cosInner} - double{spot.light.cosOuter}),
                                    0.0, 1.0);
        sum += t * t * (3 - 2 * t) * 2 * std::numbers::pi / kSteps;
    }
    EXPECT_NEAR(static_cast<double>(powerOf(spot)) / (sum * double{spot.light.intensity.g}), 1, 1e-4);
}

TEST_F(LightCommands, ColourAndTemperatureKeepThePower) {
    answer("light power 1 50");
    answer("light colour 1 1 0.5 0.25");
    EXPECT_NEAR(powerOf(light(1)), 50, 1e-3);
    EXPECT_NEAR(light(1).light.intensity.r / light(1).light.intensity.b, 4, 1e-4);
    answer("light temperature 1 2700");
    EXPECT_NEAR(powerOf(light(1)), 50, 1e-3);
    const Colour lit = document.scene()->lights[0].light.intensity, body = rtcore::blackbodyColour(2700);
    EXPECT_NEAR(lit.r / lit.g, body.r / body.g, 1e-4);
    EXPECT_EQ(light(1).temperature, 2700);
    answer("light power 1 25");
    EXPECT_EQ(light(1).temperature, 2700);
    EXPECT_NEAR(powerOf(light(1)), 25, 1e-3);
    const Colour before = document.scene()->lights[0].light.intensity;
    answer("light temperature 1 none");
    EXPECT_EQ(light(1).temperature, 0);
    EXPECT_EQ(document.scene()->lights[0].light.intensity, before);
    answer("light temperature 1 5000");
    answer("light colour 1 1 1 1");
    EXPECT_EQ(light(1).temperature, 0);
    EXPECT_EQ(refusal("light colour 1 0 0 0").text, "black is no colour of a light; switch it off instead");
    EXPECT_EQ(refusal("light colour 1 1 1 -1").code, 2);
    EXPECT_EQ(refusal("light temperature 1 400").code, 2);
}

TEST_F(LightCommands, TurnWhatHasADirection) {
    EXPECT_EQ(refusal("light aim 1 ahead").text,
              "a point light shines to all sides; 'light kind' changes that");
    answer("light kind 1 spot");
    answer("light aim 1 at 0 4 -5");
    expectNear(light(1).light.direction, {0, 0, -1});
    answer("light aim 1 along 0 -3 0");
    EXPECT_EQ(light(1).light.direction, (Vec3{0, -1, 0}));
    answer("light aim 1 ahead");
    EXPECT_EQ(light(1).light.direction, document.camera().forward);
    EXPECT_EQ(refusal("light aim 1 along 0 0 0").text,
              "the direction is zero; give where the light shines to");
    EXPECT_EQ(refusal("light aim 1 along 0 0").code, 2);
    answer("light kind 1 rectangle");
    answer("light aim 1 along 1 1 0");
    EXPECT_NEAR(dot(light(1).light.right, light(1).light.direction), 0, 1e-6);
    EXPECT_NEAR(length(light(1).light.right), 1, 1e-6);
    answer("light kind 1 directional");
    EXPECT_EQ(refusal("light move 1 here").text, "a directional light has no position; 'light aim' turns it");
}

TEST_F(LightCommands, SizesSuitTheKind) {
    answer("light size 1 0.3");
    EXPECT_EQ(light(1).light.radius, 0.3F);
    EXPECT_EQ(refusal("light size 1 1 2").text, "a point light takes a radius alone");
    answer("light kind 1 rectangle");
    answer("light size 1 1.5 0.5");
    EXPECT_EQ(light(1).light.width, 1.5F);
    EXPECT_EQ(light(1).light.height, 0.5F);
    EXPECT_EQ(refusal("light size 1 2").text, "a rectangle light takes WIDTH and HEIGHT");
    EXPECT_EQ(refusal("light angles 1 10 20").text, "a rectangle light has no cone");
    answer("light kind 1 directional");
    answer("light size 1 0.53");
    EXPECT_EQ(light(1).light.discSine, rtcore::sineOfHalf(0.53));
    EXPECT_EQ(refusal("light size 1 2 1").text,
              "a directional light takes one angle, in degrees, at most 180");
    EXPECT_EQ(refusal("light size 1 181").code, 2);
    answer("light kind 1 spot");
    EXPECT_EQ(refusal("light angles 1 30 20").text,
              "the inner angle must be below the outer one, by enough to tell them apart");
}

TEST_F(LightCommands, PowersHaveUnits) {
    answer("units mm");
    answer("light power 1 800 lm");
    EXPECT_NEAR(powerOf(light(1)), 800 / 683.0 * 1e6, 1);
    EXPECT_NE(answer("light get 1").find("\n# 1.1713 W, 800 lm"), std::string::npos) << answer("light get 1");
    answer("light power 1 5 W");
    EXPECT_NEAR(powerOf(light(1)), 5e6, 5);
    answer("light power 1 5");
    EXPECT_NEAR(powerOf(light(1)), 5, 1e-5) << "of scene units";
    EXPECT_EQ(refusal("light power 1 5 lx").text, "lx is for directional lights; others give off lm or W");
    answer("light kind 1 directional");
    answer("light power 1 1366 lx");
    EXPECT_NEAR(powerOf(light(1)), 2, 1e-5) << "whatever the unit";
    EXPECT_EQ(refusal("light power 1 800 lm").text, "a directional light has no lm; give lx, or W for W/m2");
    EXPECT_EQ(refusal("light power 1 800 cd").code, 2);
}

TEST_F(LightCommands, NewOnesAreAsLargeAndBrightAsElectricOnesByTheUnit) {
    for (const auto& [unit, metres] : {std::pair{"m", 1.0}, std::pair{"mm", 0.001}, std::pair{"cm", 0.01}}) {
        answer("units " + std::string(unit));
        const std::string sphere = answer("light add sphere at 0 2 0"),
                          panel = answer("light add rectangle at 0 2 0");
        EXPECT_NEAR(light(std::stoi(sphere)).light.radius * metres, 0.06, 1e-6);
        EXPECT_NEAR(light(std::stoi(panel)).light.width * metres, 0.6, 1e-6);
        for (const std::string& added : {sphere, panel})
            EXPECT_NE(answer("light get " + added).find(" 800 lm"), std::string::npos);
    }
}

TEST_F(LightCommands, WrongPlacesAreRefused) {
    for (const char* wrong : {"light move 1", "light move 1 at", "light move 1 at 1 2", "light move 1 here 1",
                              "light move 1 here 1 2 3", "light move 1 seen 1", "light move 1 there",
                              "light add bulb", "light add point at 1 2 nan"})
        EXPECT_EQ(refusal(wrong).code, 2) << wrong;
}

/// A film that is rendered from a recording shows the light that was seen.
TEST_F(LightCommands, AnEditEndsARecordingButASwitchDoesNot) {
    answer("export video start DIR/walk.lst");
    ASSERT_TRUE(walk.recording());
    answer("light 1 off");
    EXPECT_TRUE(walk.recording());
    answer("light power 1 5");
    EXPECT_FALSE(walk.recording());
    EXPECT_NE(messages.since(0).find("the lights were edited"), std::string::npos);
    EXPECT_NE(refusal("export video stop").text.find("the lights were edited"), std::string::npos);
}

TEST_F(LightCommands, MirrorsShowWhatHasASurface) {
    EXPECT_EQ(refusal("light mirrored 1 on").text, "a point light has no surface that mirrors show");
    answer("light kind 1 sphere");
    answer("light mirrored 1 on");
    EXPECT_TRUE(isMirrored(light(1).light));
    EXPECT_NE(answer("light get 1").find("mirrored = true"), std::string::npos);
    answer("light kind 1 rectangle");
    EXPECT_TRUE(isMirrored(light(1).light));
    answer("light kind 1 spot");
    EXPECT_EQ(light(1).light.mirrored, 0U);
}

TEST_F(LightCommands, ADragIsOneStep) {
    const auto before = document.scene();
    answer("light move 1 at 1 1 1");
    answer("also light move 1 at 1 2 1");
    answer("also light move 1 at 1 3 1");
    EXPECT_EQ(light(1).light.position, (Vec3{1, 3, 1}));
    EXPECT_EQ(answer("undo"), "light move 1");
    EXPECT_EQ(document.scene()->lights, before->lights);
}

TEST_F(LightCommands, AreTakenBackToTheSameBits) {
    drawFrame();
    const auto image = host.maker.image().pixels;
    const auto lights = document.scene()->lights;
    for (const char* edit :
         {"light add sphere at 0 2 0", "light copy 3 at 1 2 0", "light remove 1", "light temperature 2 3000",
          "light colour 3 1 0 0", "light kind 2 spot", "light aim 2 seen 0.5 0.9", "light angles 2 10 30",
          "light power 2 400", "light size 4 0.5", "light mirrored 3 on", "light name 2 bulb",
          "light move 3 seen 0.5 0.9", "light 4 off"})
        answer(edit);
    drawFrame();
    EXPECT_NE(host.maker.image().pixels, image);
    while (document.history().last() != nullptr) answer("undo");
    EXPECT_EQ(document.scene()->lights, lights);
    drawFrame();
    EXPECT_EQ(host.maker.image().pixels, image);
}

TEST_F(LightCommands, AFileGivesThemBack) {
    for (const char* edit : {"light remove 1", "light temperature 2 3000", "light add spot at 0 3 0",
                             "light colour 3 1 0.7 0.2", "light name 3 \"a bulb\"", "light 3 off"})
        answer(edit);
    const rtcore::SceneFile file =
        rtcore::parseSceneFile(rtcore::formatSceneFile(sceneFileOf(document), "x.scn"), "x.scn");
    rtcore::Scene scene;
    for (const LightDescription& each : file.lights) putLight(scene, scene.lights.size(), each);
    EXPECT_EQ(scene.lights, document.scene()->lights);
}

TEST_F(LightCommands, PrintALight) {
    answer("light power 1 100");
    const std::string text = answer("light get 1");
    EXPECT_TRUE(text.starts_with("[[light]]\nid = 1\nname = \"left\"\nkind = \"point\"\n")) << text;
    EXPECT_NE(text.find("\n# 100"), std::string::npos) << text;
}

} // namespace
} // namespace rtserver
