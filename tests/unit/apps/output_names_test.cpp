#include "renderer/frame_list.h"
#include "renderer/output_names.h"

#include "common/command_line.h"

#include "rtcore/platform/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

using renderer::FrameRange;
using renderer::numberedPath;
using Paths = std::vector<std::filesystem::path>;

TEST(OutputNames, HashesBecomeTheNumber) {
    EXPECT_EQ(numberedPath("out/frame_####.png", 7, true), "out/frame_0007.png");
    EXPECT_EQ(numberedPath("f#.png", 123, true), "f123.png");
    EXPECT_EQ(numberedPath("##_###.exr", 5, false), "##_005.exr");
    EXPECT_EQ(numberedPath("####", 12, true), "0012");
    EXPECT_EQ(numberedPath("a##/b.png", 3, false), "a##/b.png");
}

TEST(OutputNames, ANameWithoutHashesGetsThem) {
    EXPECT_EQ(numberedPath("out/film.png", 7, true), "out/film_0007.png");
    EXPECT_EQ(numberedPath("film", 7, true), "film_0007");
    EXPECT_EQ(numberedPath("a.b.png", 12345, true), "a.b_12345.png");
    EXPECT_EQ(numberedPath("film.png", 7, false), "film.png");
}

TEST(FrameRanges, AreInclusiveAndMayBeOpen) {
    EXPECT_EQ(renderer::parseFrameRange("7"), (FrameRange{7, 7}));
    EXPECT_EQ(renderer::parseFrameRange("3-9"), (FrameRange{3, 9}));
    EXPECT_EQ(renderer::parseFrameRange("3-"), (FrameRange{3, INT_MAX}));
    EXPECT_EQ(renderer::parseFrameRange("-9"), (FrameRange{1, 9}));
    for (const char* text : {"", "-", "0", "9-3", "a", "1-b", "1-2-3", "1.5", "99999999999"}) {
        EXPECT_THROW(renderer::parseFrameRange(text), app::UsageError) << text;
    }
}

TEST(FrameLists, NumberFramesByTheirPlace) {
    const Paths cameras{"a.cam", "b.cam", "c.cam"}, patterns{"x_##.png", "-"};
    const auto frames = renderer::framesOfList(cameras, {2, 3}, patterns);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].number, 2);
    EXPECT_EQ(frames[0].camera, "b.cam");
    EXPECT_EQ(frames[0].outputs, (Paths{"x_02.png", "-"}));
    EXPECT_EQ(frames[1].outputs, (Paths{"x_03.png", "-"}));
    EXPECT_THROW(renderer::framesOfList(cameras, {4, 9}, patterns), app::UsageError);
    EXPECT_THROW(renderer::framesOfList(cameras, {}, Paths{"x.png", "x.png"}), app::UsageError);
}

TEST(FrameLists, AFrameIsFinishedWhenAllItsFilesAreThere) {
    const test::TemporaryFolder folder;
    const renderer::FrameTask frame = renderer::singleFrame("", Paths{folder / "a.png", folder / "a.exr"});
    EXPECT_FALSE(renderer::isFinished(frame));
    std::ofstream(folder / "a.png") << "x";
    EXPECT_FALSE(renderer::isFinished(frame));
    std::ofstream(folder / "a.exr") << "x";
    EXPECT_TRUE(renderer::isFinished(frame));
    EXPECT_FALSE(renderer::isFinished(renderer::singleFrame("", Paths{"-"})));
}

TEST(OutputChecks, TellBeforeTheWorkWhatCannotBeWritten) {
    const test::TemporaryFolder folder;
    EXPECT_NO_THROW(renderer::checkOutput(folder / "a.png"));
    EXPECT_NO_THROW(renderer::checkOutput("-"));
    EXPECT_THROW(renderer::checkOutput(folder / "a.nonsense"), app::UsageError);
    EXPECT_THROW(renderer::checkOutput(folder.path() / "missing" / "a.png"), rtcore::FileError);
    std::filesystem::create_directory(folder / "b.png");
    EXPECT_THROW(renderer::checkOutput(folder / "b.png"), rtcore::FileError);
}

} // namespace
