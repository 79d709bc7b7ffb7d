/// Recording and playing, apart from a server.
#include "rtserver/walk/playback.h"
#include "rtserver/walk/recording.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/platform/error.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace {

using namespace std::chrono_literals;

rtcore::CameraFile cameraAt(float x) {
    rtcore::CameraFile file;
    file.camera.eye = {x, 0, 0};
    return file;
}

TEST(Recording, KnowsAnExposureWhenTheNextFrameIsThere) {
    const test::TemporaryFolder folder;
    rtserver::Recording recording(folder / "a.lst", 4);
    EXPECT_EQ(recording.untilNext(), 0ns);
    recording.add(cameraAt(0));
    EXPECT_EQ(recording.untilNext(), 250ms);
    recording.settle(1);
    EXPECT_EQ(recording.frames(), 1);
    recording.advance(250ms);
    recording.add(cameraAt(1));
    recording.advance(250ms);
    recording.add(cameraAt(2));
    EXPECT_EQ(recording.frames(), 1) << "they wait";
    recording.settle(4);
    recording.finish();
    const auto files = rtcore::readCameraList(folder / "a.lst");
    ASSERT_EQ(files.size(), 3U);
    const float exposures[] = {1, 2, 4};
    for (std::size_t i = 0; i < 3; ++i) {
        const rtcore::CameraFile file = rtcore::readCameraFile(files[i]);
        EXPECT_FLOAT_EQ(*file.exposure, exposures[i]) << "even steps in the logarithm";
        EXPECT_EQ(*file.time, 0.25 * static_cast<double>(i));
        EXPECT_EQ(file.camera.eye.x, static_cast<float>(i));
    }
}

class Playing : public testing::Test {
  protected:
    void write(std::initializer_list<std::optional<double>> times) {
        std::ofstream list(folder_ / "a.lst");
        int i = 0;
        for (const auto& time : times) {
            rtcore::CameraFile file = cameraAt(static_cast<float>(i));
            file.time = time;
            const std::string name = std::to_string(i++) + ".cam";
            rtcore::writeCameraFile(folder_ / name, file);
            list << name << "\n";
        }
    }
    /// The index of the camera that is shown then, or -1.
    static int shown(rtserver::Playback& playback, std::chrono::nanoseconds time) {
        const auto shot = playback.advance(time);
        return shot ? static_cast<int>(shot->camera.camera.eye.x) : -1;
    }
    test::TemporaryFolder folder_;
};

TEST_F(Playing, KeepsTheTimes) {
    write({3.0, 3.5, 3.6, 5.0});
    rtserver::Playback playback(folder_ / "a.lst", {});
    EXPECT_EQ(playback.untilNext(), 0ns);
    EXPECT_EQ(shown(playback, 0ns), 0) << "the first one at once";
    EXPECT_NEAR(std::chrono::duration<double>(playback.untilNext()).count(), 0.5, 1e-6);
    EXPECT_EQ(shown(playback, 499ms), -1);
    EXPECT_EQ(shown(playback, 110ms), 2) << "one was passed over";
    EXPECT_EQ(shown(playback, 2s), 3);
    EXPECT_FALSE(shown(playback, 0s) == 3);
    EXPECT_TRUE(playback.ended());
}

TEST_F(Playing, WithoutTimesGoesAtThirtyASecond) {
    write({std::nullopt, std::nullopt, std::nullopt});
    rtserver::Playback playback(folder_ / "a.lst", {});
    EXPECT_EQ(shown(playback, 0ns), 0);
    EXPECT_EQ(shown(playback, 34ms), 1);
    EXPECT_EQ(shown(playback, 34ms), 2);
    EXPECT_FALSE(playback.ended()) << "the last one has its time, too";
    EXPECT_EQ(shown(playback, 34ms), -1);
    EXPECT_TRUE(playback.ended());
}

TEST_F(Playing, NeverGoesBackInTime) {
    write({1.0, 0.2, 1.1});
    rtserver::Playback playback(folder_ / "a.lst", {});
    EXPECT_EQ(shown(playback, 0ns), 1);
    EXPECT_EQ(shown(playback, 110ms), 2);
}

TEST_F(Playing, NeedsCameras) {
    write({});
    EXPECT_THROW(rtserver::Playback(folder_ / "a.lst", {}), rtcore::FileError);
    EXPECT_THROW(rtserver::Playback(folder_ / "none.lst", {}), rtcore::FileError);
    write({1.0, 1.1});
    std::ofstream(folder_ / "1.cam") << "nonsense";
    rtserver::Playback playback(folder_ / "a.lst", {});
    EXPECT_THROW(playback.advance(0ns), rtcore::FileError);
}

} // namespace
