/// What moves by itself: the walker, keys, paths that are recorded and played.
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

class ServerMotion : public test::ShownRoom {
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
        return std::make_unique<Playback>(folder / "a.lst");
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
TEST_F(ServerMotion, RestrainedKeysMoveAndEditNothing) {
    const int radius = state.settings().bloom.radius;
    const bool light = state.scene()->lights[0].light.on != 0;
    state.setBindings(rtcore::KeyBindings(
        std::vector<rtcore::KeyBinding>{{'K', rtcore::Action::ToggleBloom},
                                        {'L', rtcore::Action::ToggleLight, rtcore::KeyNone, 1},
                                        {'W', rtcore::Action::Forward}}));
    state.move(1ms, restrainedKeys({'K', 'L', 'W'}, 2));
    state.move(50ms, {});
    EXPECT_EQ(state.settings().bloom.radius, radius);
    EXPECT_EQ(state.scene()->lights[0].light.on != 0, light);
    EXPECT_EQ(state.history().last(), nullptr);
    EXPECT_TRUE(changes().has(Change::View)) << "but it moves";
    state.move(1ms, restrainedKeys({'K', 'L'}, 1));
    state.move(1ms, {});
    EXPECT_EQ(state.settings().bloom.radius, radius);
    EXPECT_NE(state.scene()->lights[0].light.on != 0, light) << "bloom alone is withheld";
    ipc::KeyState both = restrainedKeys({'K'}, 2); // and another client's
    both.presses['K'] += 1;
    state.move(1ms, both);
    EXPECT_NE(state.settings().bloom.radius, radius) << "the other one may";
}

TEST_F(ServerMotion, NothingMovesUntilAKeyIsPressed) {
    state.move(100ms, {});
    EXPECT_TRUE(state.atRest());
    EXPECT_EQ(changes(), Changes{});
    EXPECT_EQ(state.untilEvent(), std::chrono::nanoseconds::max());
}

TEST_F(ServerMotion, AKeyThatIsHeldMovesTheView) {
    const float before = state.camera().eye.z;
    state.move(0ms, keys({'W'}));
    EXPECT_FALSE(state.atRest());
    EXPECT_EQ(changes(), Changes{}) << "it acts from now on";
    state.move(100ms, keys({'W'}));
    EXPECT_EQ(changes(), Changes{Change::View});
    EXPECT_LT(state.camera().eye.z, before);
}

TEST_F(ServerMotion, KeysSwitchWhatTheSceneHas) {
    state.move(0ms, keys({'2'}));
    EXPECT_FALSE(lightIsOn(1));
    EXPECT_EQ(changes(), Changes{Change::Light});
    state.move(0ms, {});
    state.move(0ms, keys({'M', '2'}));
    EXPECT_EQ(environment(), 1);
    EXPECT_EQ(changes(), Changes{Change::Sky});
    state.move(0ms, {});
    state.move(0ms, keys({'B'}));
    EXPECT_EQ(changes(), Changes{Change::Setting});
    EXPECT_GT(state.settings().bloom.radius, 0);
    state.move(0ms, {});
    state.move(0ms, keys({'9'}));
    EXPECT_EQ(changes(), Changes{}) << "the scene has two";
    EXPECT_EQ(messages.since(0), "1 event light 2 off\n2 event environment 2\n3 event bloom on\n"
                                 "4 event there is no light 9");
}

TEST_F(ServerMotion, WalksWhereThereIsAFloor) {
    EXPECT_FALSE(state.walking());
    state.setWalking(true);
    EXPECT_TRUE(state.walking());
    EXPECT_FALSE(state.onUnseenFloor());
    state.setWalking(false);
    EXPECT_FALSE(state.walking());
    rtcore::Camera below = state.camera();
    below.eye.y = -50;
    state.setCamera(below);
    EXPECT_THROW(state.setWalking(true), std::runtime_error);
    EXPECT_FALSE(state.walking());
    state.move(0ms, keys({'F'}));
    EXPECT_NE(messages.since(0).find("there is no room to stand here"), std::string::npos);
}

TEST_F(ServerMotion, RecordsTheCameraAtAnEvenPace) {
    EXPECT_FALSE(state.recording());
    state.startRecording(std::make_unique<Recording>(folder / "r.lst", 10));
    EXPECT_TRUE(state.recording());
    EXPECT_EQ(state.recordedList(), folder / "r.lst");
    EXPECT_THROW(state.startRecording(std::make_unique<Recording>(folder / "s.lst", 10)), std::runtime_error);
    state.move(0ms, keys({'W'}));
    state.settleRecording(1);
    for (int i = 0; i < 2; ++i) {
        EXPECT_LE(state.untilEvent(), 100ms);
        state.move(100ms, keys({'W'}));
        state.settleRecording(2);
    }
    EXPECT_EQ(state.recordedTime(), 200ms);
    EXPECT_EQ(state.stopRecording(2), 3);
    EXPECT_FALSE(state.recording());
    EXPECT_EQ(state.recordedTime(), 0ms);
    const auto files = rtcore::readCameraList(folder / "r.lst");
    ASSERT_EQ(files.size(), 3U);
    const rtcore::CameraFile first = rtcore::readCameraFile(files[0]),
                             last = rtcore::readCameraFile(files[2]);
    EXPECT_EQ(first.exposure, 1.0F);
    EXPECT_EQ(last.exposure, 2.0F);
    EXPECT_LT(last.camera.eye.z, first.camera.eye.z);
    EXPECT_EQ(last.lightsOn, (std::vector{1, 2}));
}

TEST_F(ServerMotion, ARecordingEndsWithItsScene) {
    EXPECT_THROW(state.stopRecording(1), std::runtime_error);
    state.startRecording(std::make_unique<Recording>(folder / "r.lst", 10));
    state.show(test::worldOf(test::makeRoom()));
    EXPECT_FALSE(state.recording());
    try {
        state.stopRecording(1);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("another scene was shown"), std::string::npos);
    }
}

TEST_F(ServerMotion, APathShowsItsCamerasInTime) {
    state.play(path());
    EXPECT_FALSE(state.atRest());
    state.move(1ms, {});
    EXPECT_EQ(changes(), Changes{}) << "the first camera sees what was shown";
    state.move(100ms, {});
    EXPECT_EQ(changes(), (Changes{Change::View, Change::Light, Change::Setting}));
    EXPECT_EQ(state.camera().eye.x, 1);
    EXPECT_FALSE(lightIsOn(0));
    EXPECT_EQ(state.shownSettings().exposure.mode, rtcore::ExposureMode::Fixed);
    EXPECT_EQ(state.shownSettings().exposure.value, 3.0F);
    EXPECT_EQ(state.settings().exposure.mode, rtcore::ExposureMode::Automatic) << "of the path alone";
    state.move(100ms, {});
    EXPECT_TRUE(state.atRest()) << "its last camera had its time";
    EXPECT_EQ(state.shownSettings().exposure.mode, rtcore::ExposureMode::Automatic);
    EXPECT_EQ(changes(), Changes{Change::Setting}) << "the exposure is found anew";
    EXPECT_EQ(state.camera().eye.x, 1) << "it stays there";
}

TEST_F(ServerMotion, AKeyThatMovesEndsAPath) {
    state.play(path());
    state.move(1ms, {});
    state.move(1ms, keys({'W'}));
    state.move(200ms, keys({'W'}));
    EXPECT_EQ(state.camera().eye.x, 0);
    EXPECT_TRUE(lightIsOn(0));
}

TEST_F(ServerMotion, APathEndsWalking) {
    state.setWalking(true);
    state.play(path());
    EXPECT_FALSE(state.walking());
    state.stopPlaying();
    EXPECT_TRUE(state.atRest());
}

TEST_F(ServerMotion, APathThatCannotBeReadIsAnError) {
    auto playback = path();
    std::ofstream(folder / "1.cam") << "nonsense";
    EXPECT_NO_THROW(state.play(std::move(playback)));
    EXPECT_THROW(state.move(200ms, {}), rtcore::FileError);
}

} // namespace
} // namespace rtserver
