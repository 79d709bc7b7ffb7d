/// Edits that are taken back and made again, whichever command or key made them.
#include "command_room.h"

#include "rtserver/document/edit_history.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;

class Edits : public test::CommandRoom {
  protected:
    /// All that edits can change.
    void expectShown(const Snapshot& expected) const {
        EXPECT_EQ(document.scene()->lights, expected.scene->lights);
        EXPECT_EQ(document.scene()->activeEnvironment, expected.scene->activeEnvironment);
        expectSurroundings(expected.scene->environments);
        EXPECT_EQ(document.scene()->sky, expected.scene->sky);
        EXPECT_EQ(document.settings(), expected.settings);
        EXPECT_EQ(document.camera(), expected.camera);
        EXPECT_EQ(document.modelUnits().up, expected.modelUnits.up);
        EXPECT_EQ(document.modelUnits().metresPerUnit, expected.modelUnits.metresPerUnit);
        EXPECT_EQ(document.scene()->up, expected.scene->up);
    }
    /// Maps of a sky are drawn again: what they show counts, not which object shows it.
    void expectSurroundings(const decltype(rtcore::Scene::environments)& expected) const {
        const auto& shown = document.scene()->environments;
        ASSERT_EQ(shown.size(), expected.size());
        for (std::size_t i = 0; i < shown.size(); ++i) {
            EXPECT_EQ(shown[i]->name(), expected[i]->name());
            EXPECT_EQ(shown[i]->intensity, expected[i]->intensity);
            EXPECT_EQ(shown[i]->rotation(), expected[i]->rotation());
            EXPECT_EQ(shown[i]->meanRadiance(), expected[i]->meanRadiance());
            for (const rtcore::Vec3 to :
                 {rtcore::Vec3{0.3F, 0.8F, -0.5F}, {-0.9F, 0.2F, 0.1F}, {0.1F, -0.7F, 0.6F}}) {
                EXPECT_EQ(shown[i]->radiance(to, rtcore::TexelFilter::Bilinear),
                          expected[i]->radiance(to, rtcore::TexelFilter::Bilinear));
            }
        }
    }
    void tap(const std::string& key) {
        answer("key tap " + key);
        move(0ms, {});
    }
    decltype(rtcore::LdrImage::pixels) frame() {
        drawFrame();
        return host.maker.image().pixels;
    }
    void undoAll() {
        while (document.history().last() != nullptr) answer("undo");
    }
};

TEST_F(Edits, AreTakenBackAndMadeAgainOneByOne) {
    const std::vector<std::pair<std::string, std::string>> edits = {
        {"set maxDepth 3", "set maxDepth"},
        {"light 2 off", "light 2"},
        {"environment 2", "environment 2"},
        {"environment rotation 40", "environment rotation"},
        {"environment strength 3", "environment strength"},
        {"sky hour 9", "sky hour"},
        {"sky strength 2", "sky strength"},
        {"sky ground on", "sky ground"},
        {"sky haze on", "sky haze"},
        {"sky off", "sky"},
        {"sky on", "sky"},
        {"environment none", "environment none"},
        {"look studio", "look"},
        {"look sky", "look"},
        {"environment 1", "environment 1"},
        {"bloom on", "bloom"},
        {"camera set 1 2 3 0 0 -1", "camera set"},
        {"camera look-at 1 2 3 0 1 0", "camera look-at"},
        {"camera reset", "camera reset"},
        {"focus 0.5 0.9", "focus"},
        {"load camera DIR/a.cam", "load camera a"},
        {"load set DIR/a.set", "load set a"},
        {"defaults", "defaults"},
        {"quality final", "quality"},
        {"up +z", "up"},
        {"units cm", "units"},
    };
    std::vector<Snapshot> states{document.snapshot()};
    for (const auto& [line, label] : edits) {
        answer(line);
        states.push_back(document.snapshot());
        ASSERT_NE(document.history().last(), nullptr) << line;
        EXPECT_EQ(document.history().last()->label, label);
        EXPECT_EQ(document.history().position(), states.size() - 1);
    }
    for (std::size_t i = edits.size(); i-- > 0;) {
        EXPECT_EQ(answer("undo"), edits[i].second);
        expectShown(states[i]);
    }
    EXPECT_EQ(refusal("undo").text, "there is nothing to undo");
    for (std::size_t i = 0; i < edits.size(); ++i) {
        EXPECT_EQ(answer("redo"), edits[i].second);
        expectShown(states[i + 1]);
    }
    EXPECT_EQ(refusal("redo").text, "there is nothing to redo");
    EXPECT_EQ(refusal("redo").code, 1);
}

TEST_F(Edits, ATextIsPastedAsOneStep) {
    const Snapshot before = document.snapshot();
    answer("camera paste \"version = 1\neye = [1, 2, 3]\nforward = [0, 0, -1]\nantialiasing = 2\n"
           "lights = [false, true]\nenvironment = 1\"");
    EXPECT_EQ(document.camera().eye, (rtcore::Vec3{1, 2, 3}));
    EXPECT_EQ(document.settings().antialiasing, 2);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(environment(), 1);
    answer("undo");
    expectShown(before);
    EXPECT_EQ(refusal("camera paste nonsense").code, 65);
    EXPECT_EQ(document.history().last(), nullptr) << "what is refused is no step";
}

TEST_F(Edits, KeysMakeStepsAndMovementMakesNone) {
    tap("1");
    EXPECT_FALSE(lightIsOn(0));
    ASSERT_NE(document.history().last(), nullptr);
    EXPECT_EQ(document.history().last()->label, "light 1");
    answer("key press w");
    move(100ms, {});
    answer("key release w");
    move(100ms, {});
    const rtcore::Camera there = document.camera();
    EXPECT_EQ(answer("undo"), "light 1");
    EXPECT_TRUE(lightIsOn(0));
    EXPECT_EQ(document.camera(), there) << "the step did not place it";
    EXPECT_EQ(document.history().last(), nullptr);
}

TEST_F(Edits, KeysMakeTheStepsOfTheirCommands) {
    const std::vector<std::pair<std::string, std::string>> keys = {
        {"b", "bloom"}, {"2", "light 2"}, {"m+2", "environment 2"}};
    for (const auto& [key, label] : keys) {
        if (key.starts_with("m+")) answer("key press m");
        tap(key.substr(key.size() - 1));
        ASSERT_NE(document.history().last(), nullptr) << key;
        EXPECT_EQ(document.history().last()->label, label);
        EXPECT_EQ(document.history().last()->by, EditAuthor{});
    }
    EXPECT_EQ(document.history().position(), 3U);
    tap("9");
    EXPECT_EQ(document.history().position(), 3U) << "there is no such environment";
    EXPECT_EQ(messages.since(3), "4 event there is no environment 9");
    undoAll();
    EXPECT_TRUE(lightIsOn(1));
    EXPECT_EQ(document.settings().bloom.radius, 0);
    EXPECT_EQ(environment(), 0);
}

TEST_F(Edits, LookingAroundIsNone) {
    answer("light 1 off");
    answer("camera turn 10 5");
    const rtcore::Camera there = document.camera();
    EXPECT_EQ(document.history().position(), 1U);
    EXPECT_EQ(answer("undo"), "light 1");
    EXPECT_EQ(document.camera(), there) << "one goes on looking there";
    EXPECT_EQ(refusal("also camera turn 1 1").code, 2);
    answer("camera turn 1 1");
    EXPECT_EQ(answer("redo"), "light 1") << "nothing took its place";
}

TEST_F(Edits, WhatChangesNothingIsNoStep) {
    answer("light 1 on");
    answer("set antialiasing 1");
    answer("environment 1");
    EXPECT_EQ(document.history().last(), nullptr);
}

TEST_F(Edits, OfOneGestureAreOneStep) {
    answer("set maxDepth 3");
    for (const char* depth : {"4", "6", "7"}) answer(std::string("also set maxDepth ") + depth);
    EXPECT_EQ(document.history().position(), 1U);
    answer("also set antialiasing 3");
    EXPECT_EQ(document.history().position(), 2U) << "of another thing";
    answer("undo");
    answer("undo");
    EXPECT_EQ(document.settings().maxDepth, 5);
    EXPECT_EQ(document.settings().antialiasing, 1);
    answer("set maxDepth 3");
    answer("also set maxDepth 5");
    EXPECT_EQ(document.history().position(), 0U) << "all as it was";
    EXPECT_EQ(document.history().next(), nullptr);
    EXPECT_EQ(refusal("also walk").code, 2);
    EXPECT_EQ(refusal("also").code, 2);
    EXPECT_EQ(refusal("also also set maxDepth 3").code, 2);
}

TEST_F(Edits, ANewStepTakesThePlaceOfThoseTakenBack) {
    answer("set maxDepth 3");
    answer("light 1 off");
    answer("undo");
    answer("undo");
    answer("light 2 off");
    EXPECT_EQ(document.history().next(), nullptr);
    EXPECT_EQ(answer("undo"), "light 2");
    EXPECT_EQ(refusal("undo").code, 1);
}

TEST_F(Edits, LeaveTheSizeToTheWindow) {
    answer("set maxDepth 3");
    answer("resolution 48 36");
    answer("undo");
    EXPECT_EQ(document.settings().width, 48) << "a window was resized meanwhile";
    EXPECT_EQ(document.settings().maxDepth, 5);
    answer("set width 40");
    answer("undo");
    EXPECT_EQ(document.settings().width, 48);
}

TEST_F(Edits, WithoutRoomForTheFrameNothingIsTakenBack) {
    answer("set width 40");
    const Snapshot wide = document.snapshot();
    full = true;
    EXPECT_EQ(refusal("undo").code, 75);
    expectShown(wide);
    full = false;
    EXPECT_EQ(answer("undo"), "set width");
    EXPECT_EQ(document.settings().width, 32);
}

TEST_F(Edits, OfAnotherSceneAreForgotten) {
    answer("light 1 off");
    answer("undo");
    answer("light 2 off");
    document.show(test::worldOf(test::makeRoom()));
    EXPECT_EQ(document.history().last(), nullptr);
    EXPECT_EQ(document.history().next(), nullptr);
    EXPECT_EQ(document.history().position(), 0U);
}

TEST_F(Edits, AreKeptUpToFiveThousand) {
    for (int i = 0; i < 5100; ++i) answer("camera set " + std::to_string(i + 1) + " 2 3 0 0 -1");
    EXPECT_EQ(document.history().position(), 5100U);
    undoAll();
    EXPECT_EQ(document.history().position(), 100U);
    EXPECT_EQ(document.camera().eye.x, 100);
}

TEST_F(Edits, TakenBackAllGiveTheFirstBits) {
    const std::vector<std::string> choices = {"light 1 toggle",
                                              "light 2 toggle",
                                              "environment 1",
                                              "environment 2",
                                              "set antialiasing 2",
                                              "set antialiasing 1",
                                              "set shadows false",
                                              "set shadows true",
                                              "set exposure.key 0.3",
                                              "also set exposure.key",
                                              "camera angle 70",
                                              "also camera angle 65",
                                              "load camera DIR/a.cam",
                                              "camera set 1 2 3 0 0 -1",
                                              "defaults",
                                              "bloom on",
                                              "undo",
                                              "redo"};
    answer("set exposure.mode fixed");
    document.show(test::worldOf(test::makeRoom()));
    const Snapshot first = document.snapshot();
    const auto original = frame();
    std::mt19937 random{31415};
    for (int i = 0; i < 400; ++i) {
        std::string line = choices[random() % choices.size()];
        if (line == "also set exposure.key") line += " 0." + std::to_string(1 + random() % 8);
        const Failure failure = refusal(line);
        EXPECT_TRUE(failure.code == 0 || line == "undo" || line == "redo") << line << ": " << failure.text;
    }
    EXPECT_NE(frame(), original);
    undoAll();
    expectShown(first);
    EXPECT_EQ(frame(), original);
}

TEST_F(Edits, NoteWhatChangedForFramesAndCaches) {
    answer("light 1 off");
    answer("environment 2");
    answer("camera set 1 2 3 0 0 -1");
    changes();
    answer("undo");
    EXPECT_EQ(changes(), Changes{Change::View});
    answer("undo");
    EXPECT_EQ(changes(), Changes{Change::Sky});
    answer("undo");
    EXPECT_EQ(changes(), Changes{Change::Light});
}

} // namespace
} // namespace rtserver
