/// Video lists: numbering, skipping, ranges, bad frames.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

class Lists : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directory(folder / "out");
        std::filesystem::create_directory(folder / "film");
        test::writeRoom(folder / "room.obj");
        for (int i = 1; i <= 4; ++i) {
            test::writeCamera(folder.path() / "film" / (std::to_string(i) + ".cam"), i * 0.5 - 1);
        }
        test::writeText(folder / "film" / "film.lst", "# a film\n1.cam\r\n2.cam # second\n\n3.cam\n4.cam\n");
    }
    test::ProgramResult render(Names extra) {
        extra.insert(extra.begin(), {"room.obj", "-l", "film/film.lst", "-w", "16", "-h", "12"});
        return test::renderer(extra, {.folder = folder.path()});
    }
    Names outputs() const { return test::filesIn(folder / "out"); }

    test::TemporaryFolder folder;
};

TEST_F(Lists, FramesAreNumberedFromOne) {
    const test::ProgramResult result = render({"-o", "out/frame_####.png"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(outputs(), (Names{"frame_0001.png", "frame_0002.png", "frame_0003.png", "frame_0004.png"}));
    EXPECT_NE(test::readBytes(folder / "out" / "frame_0001.png"),
              test::readBytes(folder / "out" / "frame_0004.png"));
}

/// But for indirect light, which the images of a list share.
TEST_F(Lists, AFrameEqualsThePictureByItself) {
    ASSERT_EQ(render({"-o", "out/f#.png", "--setting=indirect.mode=off"}).exitCode, 0);
    ASSERT_EQ(test::renderer({"room.obj", "--camera", "film/3.cam", "-w", "16", "-h", "12", "-o",
                              "out/single.png", "--setting=indirect.mode=off"},
                             {.folder = folder.path()})
                  .exitCode,
              0);
    EXPECT_EQ(test::readBytes(folder / "out" / "f3.png"), test::readBytes(folder / "out" / "single.png"));
}

TEST_F(Lists, WithoutHashesTheNumberIsAppended) {
    EXPECT_EQ(render({"-o", "out/film.png", "--frames", "2"}).exitCode, 0);
    EXPECT_EQ(outputs(), Names{"film_0002.png"});
    EXPECT_EQ(render({"--frames", "1"}).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "room_0001.png"));
}

TEST_F(Lists, FinishedFramesAreSkippedUnlessForced) {
    ASSERT_EQ(render({"-o", "out/f#.png", "--frames", "2", "-w", "20"}).exitCode, 0);
    const test::ProgramResult skipped = render({"-o", "out/f#.png"});
    EXPECT_EQ(skipped.exitCode, 0) << skipped.error;
    EXPECT_NE(skipped.error.find("1 of 4 frames are there already"), std::string::npos) << skipped.error;
    EXPECT_EQ(test::pngFileSize(folder / "out" / "f2.png"), (test::PictureSize{20, 12}));
    EXPECT_EQ(outputs().size(), 4U);
    EXPECT_EQ(render({"-o", "out/f#.png", "--force"}).exitCode, 0);
    EXPECT_EQ(test::pngFileSize(folder / "out" / "f2.png"), (test::PictureSize{16, 12}));
}

TEST_F(Lists, RangesPickFrames) {
    EXPECT_EQ(render({"-o", "out/f#.png", "--frames", "2-3"}).exitCode, 0);
    EXPECT_EQ(outputs(), (Names{"f2.png", "f3.png"}));
    EXPECT_EQ(render({"-o", "out/f#.png", "--frames", "9-"}).exitCode, 2);
}

TEST_F(Lists, ABadFrameIsReportedAndTheOthersGoOn) {
    test::writeText(folder / "film" / "2.cam", "version = 1\neye = \"here\"\n");
    std::filesystem::remove(folder / "film" / "4.cam");
    const test::ProgramResult result = render({"-o", "out/f#.png"});
    EXPECT_EQ(result.exitCode, 65) << result.error;
    EXPECT_NE(result.error.find("2.cam:2"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("4.cam"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("2 of 4 frames failed"), std::string::npos) << result.error;
    EXPECT_EQ(outputs(), (Names{"f1.png", "f3.png"}));
}

TEST_F(Lists, LightsOfOneFrameDoNotStayForTheNext) {
    test::writeText(folder / "lit.scn", "version = 1\nmodel = \"room.obj\"\n[[light]]\nkind = \"point\"\n"
                                        "position = [0.0, 6.0, 4.0]\nintensity = [60.0, 60.0, 60.0]\n");
    test::writeCamera(folder / "film" / "1.cam", 0, "lights = [false]\nexposure = 1.0\n");
    test::writeCamera(folder / "film" / "2.cam", 0, "exposure = 1.0\n");
    const Names base{"lit.scn", "-w", "16", "-h", "12"};
    const auto run = [&](Names extra) {
        extra.insert(extra.begin(), base.begin(), base.end());
        EXPECT_EQ(test::renderer(extra, {.folder = folder.path()}).exitCode, 0);
    };
    run({"-l", "film/film.lst", "--frames", "1-2", "-o", "out/f#.png"});
    run({"--camera", "film/2.cam", "-o", "out/single.png"});
    EXPECT_EQ(test::readBytes(folder / "out" / "f2.png"), test::readBytes(folder / "out" / "single.png"));
    EXPECT_NE(test::readBytes(folder / "out" / "f1.png"), test::readBytes(folder / "out" / "f2.png"));
}

// A recording says how bright each frame was, so that the film does not flicker.
TEST_F(Lists, FramesHaveTheExposuresOfTheirCameras) {
    const Names exposures{"0.02", "0.3", "4.0"};
    for (std::size_t i = 0; i < exposures.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        test::writeCamera(folder / "film" / (number + ".cam"), 0, "exposure = " + exposures[i] + "\n");
    }
    ASSERT_EQ(render({"-o", "out/f#.png", "--frames", "1-3", "--setting", "exposure.local=0.5",
                      "--setting=indirect.mode=off"})
                  .exitCode,
              0);
    test::writeCamera(folder / "plain.cam", 0);
    for (std::size_t i = 0; i < exposures.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        const Names single{"room.obj",
                           "-w",
                           "16",
                           "-h",
                           "12",
                           "--camera",
                           "plain.cam",
                           "--exposure",
                           exposures[i],
                           "--setting",
                           "exposure.local=0.5",
                           "--setting=indirect.mode=off",
                           "-o",
                           "out/single.png"};
        ASSERT_EQ(test::renderer(single, {.folder = folder.path()}).exitCode, 0);
        EXPECT_EQ(test::readBytes(folder / "out" / ("f" + number + ".png")),
                  test::readBytes(folder / "out" / "single.png"))
            << exposures[i];
    }
    EXPECT_NE(test::readBytes(folder / "out" / "f1.png"), test::readBytes(folder / "out" / "f3.png"));
}

} // namespace
