#include "rtcore/io/recording/path_recorder.h"

#include "rtcore/io/recording/camera_list.h"
#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace {

rtcore::CameraFile frameAt(int i) {
    rtcore::CameraFile frame;
    frame.camera.eye = {static_cast<float>(i), 2, 0.1F};
    frame.camera.forward = {0, 0, -1};
    frame.exposure = 0.5F;
    frame.time = i / 60.0;
    return frame;
}

void expectFrames(const std::vector<std::filesystem::path>& cameras) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        EXPECT_EQ(rtcore::readCameraFile(cameras[i]), frameAt(static_cast<int>(i))) << cameras[i];
    }
}

TEST(PathRecorder, WritesFramesThatReadBack) {
    const test::TemporaryFolder folder;
    rtcore::PathRecorder recorder(folder / "walk.lst");
    for (int i = 0; i < 3; ++i) recorder.add(frameAt(i));
    EXPECT_EQ(recorder.frames(), 3);
    // While it runs, readers see all of it.
    EXPECT_EQ(rtcore::readCameraList(folder / "walk.lst").size(), 3U);
    EXPECT_FALSE(rtcore::readGrowingCameraList(folder / "walk.lst").ended);
    recorder.finish();
    const rtcore::GrowingCameraList list = rtcore::readGrowingCameraList(folder / "walk.lst");
    EXPECT_TRUE(list.ended);
    EXPECT_EQ(list.cameras.size(), 3U);
    expectFrames(list.cameras);
    EXPECT_EQ(test::fileContent(folder / "walk.lst"),
              "# recording\nwalk.cams/000001.cam\nwalk.cams/000002.cam\n"
              "walk.cams/000003.cam\n# end\n");
}

TEST(PathRecorder, IsFinishedByItsDestructor) {
    const test::TemporaryFolder folder;
    rtcore::PathRecorder(folder / "walk.lst").add(frameAt(0));
    EXPECT_TRUE(rtcore::readGrowingCameraList(folder / "walk.lst").ended);
}

TEST(PathRecorder, NeverOverwrites) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "walk.lst", "mine\n");
    EXPECT_THROW(rtcore::PathRecorder(folder / "walk.lst"), rtcore::FileError);
    EXPECT_EQ(test::fileContent(folder / "walk.lst"), "mine\n");
    std::filesystem::create_directory(folder / "run.cams");
    EXPECT_THROW(rtcore::PathRecorder(folder / "run.lst"), rtcore::FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "run.lst"));
    EXPECT_THROW(rtcore::PathRecorder(folder.path() / "missing" / "a.lst"), rtcore::FileError);
}

TEST(PathRecorder, ABadFrameIsLeftOut) {
    const test::TemporaryFolder folder;
    rtcore::PathRecorder recorder(folder / "walk.lst");
    recorder.add(frameAt(0));
    rtcore::CameraFile bad = frameAt(1);
    bad.camera.eye.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(recorder.add(bad), rtcore::FileError);
    recorder.add(frameAt(1));
    recorder.finish();
    const auto cameras = rtcore::readCameraList(folder / "walk.lst");
    EXPECT_EQ(cameras.size(), 2U);
    expectFrames(cameras);
}

TEST(PathRecorder, AListThatIsCutAnywhereIsValid) {
    const test::TemporaryFolder folder;
    rtcore::PathRecorder(folder / "walk.lst").add(frameAt(0));
    const std::string text = test::fileContent(folder / "walk.lst");
    const std::size_t named = text.find(".cam\n") + 5;
    for (std::size_t size = text.find('\n') + 1; size <= text.size(); ++size) {
        const auto cut = std::string_view(text).substr(0, size);
        const auto cameras = rtcore::parseCameraList(cut, folder / "walk.lst");
        EXPECT_EQ(cameras.size(), size >= named ? 1U : 0U) << cut;
        expectFrames(cameras);
    }
}

TEST(PathRecorder, AKilledProgramLeavesAValidList) {
    for (int kill = 0; kill < 10; ++kill) {
        const test::TemporaryFolder folder;
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            rtcore::PathRecorder recorder(folder / "walk.lst");
            for (int i = 0;; ++i) recorder.add(frameAt(i));
        }
        const auto begun = [&] {
            return rtcore::readGrowingCameraList(folder / "walk.lst").cameras.size() > 3;
        };
        const auto start = std::chrono::steady_clock::now();
        while (!begun() && std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
            std::this_thread::sleep_for(std::chrono::microseconds(300 + 170 * kill));
        }
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto cameras = rtcore::readCameraList(folder / "walk.lst");
        EXPECT_GT(cameras.size(), 3U);
        expectFrames(cameras);
    }
}

TEST(GrowingLists, CountWholeLinesOnly) {
    const auto parse = [](const char* text) { return rtcore::parseGrowingCameraList(text, "l"); };
    EXPECT_EQ(parse("").cameras.size(), 0U);
    EXPECT_EQ(parse("a.cam").cameras.size(), 0U);
    EXPECT_EQ(parse("a.cam\nb.cam").cameras.size(), 1U);
    EXPECT_EQ(parse("a.cam\n\xC3").cameras.size(), 1U);
    EXPECT_FALSE(parse("a.cam\n# end").ended);
    EXPECT_TRUE(parse("a.cam\n  # end \r\n\n").ended);
    EXPECT_FALSE(parse("# end\na.cam\n").ended);
    EXPECT_FALSE(parse("a.cam # end\n").ended);
    EXPECT_TRUE(rtcore::readGrowingCameraList("missing/list").cameras.empty());
}

TEST(GrowingLists, OnlyRecordingsDropAHalfLine) {
    EXPECT_EQ(rtcore::parseCameraList("a.cam\nb.ca", "l").size(), 2U);
    EXPECT_EQ(rtcore::parseCameraList("# recording\r\na.cam\nb.ca", "l").size(), 1U);
}

} // namespace
