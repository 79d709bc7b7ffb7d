#include "renderer/film_format.h"
#include "renderer/frame_check.h"
#include "renderer/frame_list.h"
#include "renderer/output_names.h"

#include "common/cli/command_line.h"
#include "common/progress/progress.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(FrameLists, ChunksHoldEachFrameOnceInOrder) {
    const Paths cameras(11, "a.cam"), patterns{"x_##.png"};
    for (int parts = 1; parts <= 14; ++parts) {
        int next = 1;
        for (int part = 1; part <= parts; ++part) {
            const auto frames =
                renderer::framesOfChunk(renderer::framesOfList(cameras, {}, patterns), {part, parts});
            EXPECT_LE(frames.size(), static_cast<std::size_t>(11 / parts + 1));
            for (const renderer::FrameTask& frame : frames) EXPECT_EQ(frame.number, next++);
        }
        EXPECT_EQ(next, 12) << parts;
    }
}

TEST(FrameLists, ChunksAreReadStrictly) {
    EXPECT_EQ(renderer::parseChunk("3/10"), (renderer::Chunk{3, 10}));
    for (const char* text :
         {"", "/", "0/1", "2/1", "1", "1/", "/1", "a/b", "1/2/3", "-1/2", "1/99999999999"}) {
        EXPECT_THROW(renderer::parseChunk(text), app::UsageError) << text;
    }
}

TEST(FrameLists, AFrameIsWholeWhenAllItsFilesCanBeDecoded) {
    const test::TemporaryFolder folder;
    app::Progress progress("test", app::ProgressStyle::None);
    const std::vector<renderer::FrameTask> frames{
        renderer::singleFrame("", Paths{folder / "a.png", folder / "a.hdr"})};
    const auto flaws = [&] { return renderer::findFlaws(frames, 2, progress); };
    EXPECT_EQ(flaws().size(), 2U);
    EXPECT_TRUE(flaws()[0].missing);
    rtcore::writeImage(folder / "a.png", rtcore::LdrImage(3, 2));
    std::ofstream(folder / "a.hdr") << "x";
    ASSERT_EQ(flaws().size(), 1U);
    EXPECT_FALSE(flaws()[0].missing);
    EXPECT_EQ(flaws()[0].file, folder / "a.hdr");
    rtcore::writeHdrImage(folder / "a.hdr", rtcore::HdrImage(3, 2));
    EXPECT_TRUE(flaws().empty());
    const std::vector<renderer::FrameTask> streamed{renderer::singleFrame("", Paths{"-"})};
    EXPECT_EQ(renderer::findFlaws(streamed, 1, progress).size(), 1U);
}

// A file that lacks any number of bytes at its end is broken, whatever its format.
TEST(FrameLists, EveryTruncationIsFound) {
    const test::TemporaryFolder folder;
    app::Progress progress("test", app::ProgressStyle::None);
    rtcore::LdrImage picture(9, 7);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i].g = static_cast<std::uint8_t>(i * 37);
    for (const std::string format : {"png", "jpg", "bmp", "ppm", "tga", "tiff", "hdr", "pfm", "exr"}) {
        const std::filesystem::path path = folder / ("a." + format);
        if (!rtcore::isWritableFormat(path)) continue;
        rtcore::writeImage(path, picture);
        const std::vector<renderer::FrameTask> frames{renderer::singleFrame("", Paths{path})};
        EXPECT_TRUE(renderer::findFlaws(frames, 1, progress).empty()) << format;
        // Old TGA files have no footer.
        const std::uintmax_t footer = format == "tga" ? 26 : 0;
        for (auto size = std::filesystem::file_size(path) - footer; size-- > 0;) {
            std::filesystem::resize_file(path, size);
            ASSERT_EQ(renderer::findFlaws(frames, 1, progress).size(), 1U) << format << " of " << size;
        }
    }
}

TEST(FilmFormats, AskForWhatPlayersShow) {
    const auto words = renderer::encodeArguments("a.MP4", {16, 12, 29.97}, "/tmp/x:y.mp4");
    EXPECT_EQ(words.back(), "file:/tmp/x:y.mp4");
    EXPECT_NE(std::find(words.begin(), words.end(), "yuv420p"), words.end());
    EXPECT_NE(std::find(words.begin(), words.end(), "29.97"), words.end());
    EXPECT_TRUE(renderer::needsEvenSize("a.MP4"));
    EXPECT_FALSE(renderer::needsEvenSize("a.mkv"));
    EXPECT_EQ(renderer::encodeCommand("my film.mkv", 25),
              "ffmpeg -framerate 25 -i frame_%04d.png -c:v ffv1 -level 3 -g 1 -pix_fmt bgr0 -f matroska "
              "'file:my film.mkv'");
    EXPECT_THROW(renderer::checkFilm("a.avi"), app::UsageError);
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
