/// Motion by itself: the walker, keys, paths that are recorded and played.
#include "shown_room.h"

#include "rtcore/io/recording/camera_list.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;

ipc::KeyState keys(std::initializer_list<int> down) {
    ipc::KeyState state;
    for (const int key : down) {
        state.down.set(static_cast<std::size_t>(key));
        state.presses[static_cast<std::size_t>(key)] = 1;
    }
    return state;
}

class WalkTest : public test::ShownRoom {
  protected:
    /// The first camera looks as the room does, the second one from aside with a light off, at a fixed
    /// exposure.
    std::unique_ptr<Playback> path() {
        std::ofstream list(folder / "a.lst");
        for (int i = 0; i < 2; ++i) {
            rtcore::CameraFile file = test::cameraFileOf(test::makeRoom().camera);
            file.camera.eye.x = static_cast<float>(i);
            file.time = 0.1 * i;
            if (i == 1) {
                file.lights = {false, true};
                file.exposure = 3.0F;
            }
            const std::string name = std::to_string(i) + ".cam";
            rtcore::writeCameraFile(folder / name, file);
            list << name << "\n";
        }
        list.close();
        return std::make_unique<Playback>(folder / "a.lst", rtcore::LocalOrigin());
    }

    test::TemporaryFolder folder;
};

/// A press of each by a client of such a restraint.
ipc::KeyState restrainedKeys(std::initializer_list<int> down, std::size_t restraint) {
    ipc::KeyState state = keys(down);
    for (std::size_t level = 0; level < restraint; ++level) state.restrained[level] = state.presses;
    return state;
}

// Whatever they are bound to by now.
TEST_F(WalkTest, RestrainedKeysMoveAndEditNothing) {
    const int radius = document.settings().bloom.radius;
    const bool light = document.scene()->lights[0].light.on != 0;
    walk.setBindings(rtcore::KeyBindings(
        std::vector<rtcore::KeyBinding>{{'K', rtcore::Action::ToggleBloom},
                                        {'L', rtcore::Action::ToggleLight, rtcore::KeyNone, 1},
                                        {'W', rtcore::Action::Forward}}));
    move(1ms, restrainedKeys({'K', 'L', 'W'}, 2));
    move(50ms, {});
    EXPECT_EQ(document.settings().bloom.radius, radius);
    EXPECT_EQ(document.scene()->lights[0].light.on != 0, light);
    EXPECT_EQ(document.history().last(), nullptr);
    EXPECT_TRUE(changes().has(Change::View)) << "but it moves";
    move(1ms, restrainedKeys({'K', 'L'}, 1));
    move(1ms, {});
    EXPECT_EQ(document.settings().bloom.radius, radius);
    EXPECT_NE(document.scene()->lights[0].light.on != 0, light) << "bloom alone is withheld";
    ipc::KeyState both = restrainedKeys({'K'}, 2); // and another client's
    both.presses['K'] += 1;
    move(1ms, both);
    EXPECT_NE(document.settings().bloom.radius, radius) << "the other one may";
}

TEST_F(WalkTest, NothingMovesUntilAKeyIsPressed) {
    move(100ms, {});
    EXPECT_TRUE(walk.atRest());
    EXPECT_EQ(changes(), Changes{});
    EXPECT_EQ(walk.untilEvent(), std::chrono::nanoseconds::max());
}

TEST_F(WalkTest, AKeyThatIsHeldMovesTheView) {
    const float before = document.camera().eye.z;
    move(0ms, keys({'W'}));
    EXPECT_FALSE(walk.atRest());
    EXPECT_EQ(changes(), Changes{}) << "it acts from now on";
    move(100ms, keys({'W'}));
    EXPECT_EQ(changes(), Changes{Change::View});
    EXPECT_LT(document.camera().eye.z, before);
}

TEST_F(WalkTest, KeysSwitchWhatTheSceneHas) {
    move(0ms, keys({'2'}));
    EXPECT_FALSE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    move(0ms, {});
    move(0ms, keys({'M', '2'}));
    EXPECT_EQ(environment(), 1);
    EXPECT_EQ(changes(), Changes{Change::Sky});
    move(0ms, {});
    move(0ms, keys({'B'}));
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_GT(document.settings().bloom.radius, 0);
    move(0ms, {});
    move(0ms, keys({'9'}));
    EXPECT_EQ(changes(), Changes{}) << "the scene has two";
    EXPECT_EQ(messages.since(0), "1 event light 2 off\n2 event environment 2\n3 event bloom on\n"
                                 "4 event there is no light 9");
}

TEST_F(WalkTest, WalksWhereThereIsAFloor) {
    EXPECT_FALSE(walk.walking());
    walk.setWalking(true);
    EXPECT_TRUE(walk.walking());
    EXPECT_FALSE(walk.onUnseenFloor());
    walk.setWalking(false);
    EXPECT_FALSE(walk.walking());
    rtcore::Camera below = document.camera();
    below.eye.y = -50;
    document.setCamera(below);
    EXPECT_THROW(walk.setWalking(true), std::runtime_error);
    EXPECT_FALSE(walk.walking());
    move(0ms, keys({'F'}));
    EXPECT_NE(messages.since(0).find("there is no room to stand here"), std::string::npos);
}

TEST_F(WalkTest, RecordsTheCameraAtAnEvenPace) {
    EXPECT_FALSE(walk.recording());
    walk.startRecording(std::make_unique<Recording>(folder / "r.lst", 10));
    EXPECT_TRUE(walk.recording());
    EXPECT_EQ(walk.recordedList(), folder / "r.lst");
    EXPECT_THROW(walk.startRecording(std::make_unique<Recording>(folder / "s.lst", 10)), std::runtime_error);
    move(0ms, keys({'W'}));
    walk.settleRecording(1);
    for (int i = 0; i < 2; ++i) {
        EXPECT_LE(walk.untilEvent(), 100ms);
        move(100ms, keys({'W'}));
        walk.settleRecording(2);
    }
    EXPECT_EQ(walk.recordedTime(), 200ms);
    EXPECT_EQ(walk.stopRecording(2), 3);
    EXPECT_FALSE(walk.recording());
    EXPECT_EQ(walk.recordedTime(), 0ms);
    const auto files = rtcore::readCameraList(folder / "r.lst");
    ASSERT_EQ(files.size(), 3U);
    const rtcore::CameraFile first = rtcore::readCameraFile(files[0]),
                             last = rtcore::readCameraFile(files[2]);
    EXPECT_EQ(first.exposure, 1.0F);
    EXPECT_EQ(last.exposure, 2.0F);
    EXPECT_LT(last.camera.eye.z, first.camera.eye.z);
    EXPECT_EQ(last.lightsOn, (std::vector{1, 2}));
}

TEST_F(WalkTest, ARecordingEndsWithItsScene) {
    EXPECT_THROW(walk.stopRecording(1), std::runtime_error);
    walk.startRecording(std::make_unique<Recording>(folder / "r.lst", 10));
    document.show(test::worldOf(test::makeRoom()));
    EXPECT_FALSE(walk.recording());
    try {
        walk.stopRecording(1);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("another scene was shown"), std::string::npos);
    }
}

TEST_F(WalkTest, APathShowsItsCamerasInTime) {
    walk.play(path());
    EXPECT_FALSE(walk.atRest());
    move(1ms, {});
    EXPECT_EQ(changes(), Changes{}) << "the first camera sees what was shown";
    move(100ms, {});
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Light, Change::Setting}));
    EXPECT_EQ(document.camera().eye.x, 1);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(document.frameSettings().exposure.mode, rtcore::ExposureMode::Fixed);
    EXPECT_EQ(document.frameSettings().exposure.value, 3.0F);
    EXPECT_EQ(document.settings().exposure.mode, rtcore::ExposureMode::Automatic) << "of the path alone";
    move(100ms, {});
    EXPECT_TRUE(walk.atRest()) << "its last camera had its time";
    EXPECT_EQ(document.frameSettings().exposure.mode, rtcore::ExposureMode::Automatic);
    EXPECT_EQ(changes(), Changes{Change::Setting}) << "the exposure is found anew";
    EXPECT_EQ(document.camera().eye.x, 1) << "it stays there";
}

TEST_F(WalkTest, AKeyThatMovesEndsAPath) {
    walk.play(path());
    move(1ms, {});
    move(1ms, keys({'W'}));
    move(200ms, keys({'W'}));
    EXPECT_EQ(document.camera().eye.x, 0);
    EXPECT_TRUE(lightIsOn(0));
}

TEST_F(WalkTest, AnEditThatPlacesTheCameraEndsAPath) {
    walk.play(path());
    move(1ms, {});
    switchLight(document, 2, false);
    EXPECT_FALSE(walk.atRest()) << "it goes on where only the scene is edited";
    rtcore::Camera aside = document.camera();
    aside.eye.x = 2;
    document.setCamera(aside);
    EXPECT_TRUE(walk.atRest());
    move(200ms, {});
    EXPECT_EQ(document.camera(), aside);
}

TEST_F(WalkTest, ABodyComesAlongWhereTheCameraIsPlaced) {
    walk.setWalking(true);
    rtcore::Camera aside = document.camera();
    aside.eye.x = 2;
    document.setCamera(aside);
    EXPECT_TRUE(walk.walking());
    EXPECT_NEAR(document.camera().eye.x, 2, 1e-5);
    aside.eye.y = -50;
    document.setCamera(aside);
    EXPECT_FALSE(walk.walking()) << "there is no floor";
    EXPECT_EQ(document.camera(), aside);
}

// The box stands in the way until it is cut off, and again after undo.
TEST_F(WalkTest, ASectionOpensTheWay) {
    const rtcore::Camera start = document.camera();
    const auto wayTo = [&] {
        document.setCamera(start);
        for (int i = 0; i < 24; ++i) move(250ms, keys({'W'}));
        move(1ms, {});
        return document.camera().eye.z;
    };
    walk.setWalking(true);
    EXPECT_NEAR(wayTo(), -1.7F, 0.05F);
    cutOpen(document, {{{{0, 0, -1}, {0, 0, -1}}}, rtcore::SectionLight::Whole, {}});
    EXPECT_LT(wayTo(), -4);
    EXPECT_TRUE(walk.walking()) << "the floor carries";
    cutOpen(document, {});
    EXPECT_NEAR(wayTo(), -1.7F, 0.05F);
}

TEST_F(WalkTest, APathEndsWalking) {
    walk.setWalking(true);
    walk.play(path());
    EXPECT_FALSE(walk.walking());
    walk.stopPlaying();
    EXPECT_TRUE(walk.atRest());
}

TEST_F(WalkTest, APathThatCannotBeReadIsAnError) {
    auto playback = path();
    std::ofstream(folder / "1.cam") << "nonsense";
    EXPECT_NO_THROW(walk.play(std::move(playback)));
    EXPECT_THROW(move(200ms, {}), rtcore::FileError);
}

} // namespace
} // namespace rtserver
