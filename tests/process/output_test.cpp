/// Where images go: files of several formats, standard output, names that need care.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"
#include "support/image_texts.h"

#include <gtest/gtest.h>

#include <chrono>

namespace {

class Outputs : public testing::Test {
  protected:
    void SetUp() override { test::writeRoom(folder / "room.obj"); }
    test::ProgramResult render(std::vector<std::string> extra) {
        extra.insert(extra.begin(), {"room.obj", "-w", "16", "-h", "12"});
        return test::renderer(extra, {.folder = folder.path()});
    }

    test::TemporaryFolder folder;
};

TEST_F(Outputs, StandardOutputHoldsThePictureAndNothingElse) {
    const test::ProgramResult result = render({"-o", "-"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::pngSize(result.output), (test::PictureSize{16, 12}));
    EXPECT_EQ(result.output.substr(result.output.size() - 8, 4), "IEND");
    EXPECT_EQ(result.error, "");
    ASSERT_EQ(render({"-o", "a.png"}).exitCode, 0);
    EXPECT_EQ(result.output, test::readBytes(folder / "a.png"));
}

TEST_F(Outputs, StandardOutputTakesPpm) {
    const test::ProgramResult result = render({"-o", "-", "--format", "ppm", "--verbose"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.output.rfind("P6\n16 12\n255\n", 0), 0U);
    EXPECT_EQ(result.output.size(), 13U + 16 * 12 * 3);
    EXPECT_NE(result.error.find("Mrays/s"), std::string::npos) << result.error;
}

TEST_F(Outputs, AListCanStreamToStandardOutput) {
    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\na.cam\n");
    const test::ProgramResult result = render({"-l", "film.lst", "-o", "-", "--format=ppm"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.output.size(), 2 * (13U + 16 * 12 * 3));
}

TEST_F(Outputs, OneRenderingCanHaveSeveralFiles) {
    const test::ProgramResult result = render({"-o", "a.png", "-o", "a.hdr", "-o", "a.ppm"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::pngFileSize(folder / "a.png"), (test::PictureSize{16, 12}));
    EXPECT_EQ(test::readBytes(folder / "a.hdr").rfind("#?RADIANCE", 0), 0U);
    EXPECT_EQ(test::readBytes(folder / "a.ppm").rfind("P6", 0), 0U);
    EXPECT_EQ(test::filesIn(folder.path()),
              (std::vector<std::string>{"a.hdr", "a.png", "a.ppm", "room.obj"}));
}

TEST_F(Outputs, ImagesSayHowTheyWereMade) {
    const auto textsOf = [&](const std::string& name) {
        return test::imageTexts(test::readBytes(folder / name));
    };
    ASSERT_EQ(render({"-o", "a.png", "-o", "a.exr", "-a", "3"}).exitCode, 0);
    test::Texts texts = textsOf("a.png");
    EXPECT_TRUE(texts["Software"].starts_with("rtsuite ")) << texts["Software"];
    EXPECT_EQ(texts["integrator"], "whitted");
    EXPECT_EQ(texts["samples"], "9");
    EXPECT_EQ(textsOf("a.exr"), texts);
    EXPECT_EQ(test::imageTexts(render({"-o", "-", "-a", "3"}).output), texts);
    ASSERT_EQ(render({"-o", "paths.exr", "--aovs", "--integrator=path", "--samples=5"}).exitCode, 0);
    texts["integrator"] = "path";
    texts["samples"] = "5";
    EXPECT_EQ(textsOf("paths.exr"), texts);

    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\na.cam\n");
    for (const char* threads : {"1", "3"}) {
        const std::string name = std::string("t") + threads + "f#.png",
                          option = std::string("--threads=") + threads;
        ASSERT_EQ(render({"-l", "film.lst", "-o", name, option}).exitCode, 0);
        EXPECT_EQ(render({"-l", "film.lst", "-o", name, "--verify"}).exitCode, 0);
    }
    EXPECT_EQ(textsOf("t1f2.png")["samples"], "1");
    for (const char* frame : {"f1.png", "f2.png"})
        EXPECT_EQ(test::readBytes(folder / (std::string("t1") + frame)),
                  test::readBytes(folder / (std::string("t3") + frame)));
}

TEST_F(Outputs, TheDebugSceneIsAModelThatCanBeRendered) {
    const test::ProgramResult result = render({"-dbg", "what.obj"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::filesIn(folder.path()), (std::vector<std::string>{"room.obj", "what.mtl", "what.obj"}));
    const test::ProgramResult seen =
        test::renderer({"what.obj", "-o", "what.png", "-w", "16", "-h", "12"}, {.folder = folder.path()});
    EXPECT_EQ(seen.exitCode, 0) << seen.error;
    EXPECT_EQ(test::pngFileSize(folder / "what.png"), (test::PictureSize{16, 12}));
}

TEST_F(Outputs, TheDebugSceneIsAnObjOfOneView) {
    test::writeText(folder / "film.lst", "a.cam\n");
    EXPECT_EQ(render({"-dbg", "what.ply"}).exitCode, 2);
    EXPECT_EQ(render({"-dbg", "what.obj", "-l", "film.lst"}).exitCode, 2);
    EXPECT_EQ(render({"-dbg", "no/such/folder/what.obj"}).exitCode, 73);
}

TEST_F(Outputs, LinearFormatsAreNotToneMapped) {
    test::writeText(folder / "bright.scn", "version = 1\nmodel = \"room.obj\"\nbackground = [7.5, 7.5, 7.5]\n"
                                           "[camera]\neye = [0.0, 50.0, 0.0]\nforward = [0.0, 1.0, 0.0]\n"
                                           "up = [0.0, 0.0, 1.0]\nfov = 60.0\n");
    for (const char* exposure : {"0.1", "100"}) {
        const test::ProgramResult result =
            test::renderer({"bright.scn", "-w", "4", "-h", "4", "--exposure", exposure, "-o", "a.pfm"},
                           {.folder = folder.path()});
        ASSERT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(rtcore::readHdrImage(folder / "a.pfm").at(2, 2), (rtcore::Colour{7.5F, 7.5F, 7.5F}));
    }
}

TEST_F(Outputs, NamesMayHoldAnything) {
    for (const char* name : {"with space", "quote'\"s", "kostel žlutý 光", "-dash", "per%cent"}) {
        const std::string base(name);
        std::filesystem::create_directory(folder / base);
        std::filesystem::copy_file(folder / "room.obj", folder.path() / base / (base + ".obj"));
        const std::string prefix = std::string("./").append(base).append("/").append(base);
        const test::ProgramSettings here{.folder = folder.path()};
        const test::ProgramResult built = test::bspBuilder({prefix + ".obj", prefix + ".bsp"}, here);
        EXPECT_EQ(built.exitCode, 0) << built.error;
        const test::ProgramResult rendered =
            test::renderer({prefix + ".bsp", "-w", "8", "-h", "8", "-o", prefix + ".png"}, here);
        EXPECT_EQ(rendered.exitCode, 0) << rendered.error;
        EXPECT_EQ(test::pngFileSize(folder.path() / base / (base + ".png")), (test::PictureSize{8, 8}));
        EXPECT_EQ(test::filesIn(folder / base).size(), 3U);
    }
    const test::ProgramResult terminated = test::renderer(
        {"-w", "8", "-h", "8", "--output=-dash.png", "--", "-dash/-dash.obj"}, {.folder = folder.path()});
    EXPECT_EQ(terminated.exitCode, 0) << terminated.error;
    EXPECT_TRUE(std::filesystem::exists(folder / "-dash.png"));
}

TEST_F(Outputs, FramesOfAListMayHaveANewFolder) {
    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\n");
    EXPECT_EQ(render({"-l", "film.lst", "-o", "frames/##.png", "--verify"}).exitCode, 1);
    EXPECT_EQ(render({"-l", "none.lst", "-o", "frames/##.png"}).exitCode, 66);
    EXPECT_EQ(render({"-l", "film.lst", "-o", "no/such/##.png"}).exitCode, 73);
    EXPECT_EQ(render({"-o", "frames/picture.png"}).exitCode, 73) << "that may be a slip";
    EXPECT_FALSE(std::filesystem::exists(folder / "frames"));
    EXPECT_FALSE(std::filesystem::exists(folder / "no"));
    const test::ProgramResult result = render({"-l", "film.lst", "-o", "frames/##.png", "-v"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.error.find("made the folder frames\n"), std::string::npos) << result.error;
    EXPECT_EQ(test::pngFileSize(folder / "frames/01.png"), (test::PictureSize{16, 12}));
}

TEST_F(Outputs, AListRemovesWhatKilledRunsLeft) {
    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\n");
    const std::filesystem::path old = folder / ".rtsuite-0123456789abcdef.png", foreign = folder / ".rtsuite";
    for (const auto& path : {old, foreign}) test::writeText(path, "half");
    const auto now = std::chrono::file_clock::now();
    for (const auto& path : {old, foreign}) std::filesystem::last_write_time(path, now);
    ASSERT_EQ(render({"-l", "film.lst", "-o", "##.png"}).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(old)) << "somebody may be writing it";
    EXPECT_TRUE(std::filesystem::exists(foreign));
}

TEST_F(Outputs, OneSideAloneKeepsTheAspect) {
    const auto size = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"room.obj", "-o", "size.png"};
        all.insert(all.end(), words.begin(), words.end());
        const test::ProgramResult result = test::renderer(all, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::pngFileSize(folder / "size.png");
    };
    EXPECT_EQ(size({"-w", "40"}), (test::PictureSize{40, 30}));
    EXPECT_EQ(size({"-h", "60"}), (test::PictureSize{80, 60}));
    test::writeCamera(folder / "wide.cam", 0, "width = 400\nheight = 100\n");
    EXPECT_EQ(size({"--camera=wide.cam", "-w", "40"}), (test::PictureSize{40, 10}));
    EXPECT_EQ(size({"--camera=wide.cam", "-w", "40", "-h", "40"}), (test::PictureSize{40, 40}));
    EXPECT_EQ(size({"--camera=wide.cam", "--size=a4-upright@5"}), (test::PictureSize{41, 58}));
}

TEST_F(Outputs, ASizeIsNamedOnceAndExists) {
    const auto refused = [&](const std::vector<std::string>& words, const std::string& part) {
        std::vector<std::string> all{"room.obj", "-o", "size.png"};
        all.insert(all.end(), words.begin(), words.end());
        const test::ProgramResult result = test::renderer(all, {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 2) << result.error;
        EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    };
    refused({"--size=a9"}, "'a9' is no size; there are hd, fullhd");
    refused({"--size=hd", "-w", "40"}, "leave out --width");
    refused({"--size=hd", "--panorama=64"}, "leave out --panorama");
    refused({"--size=90000x90000"}, "width");
}

} // namespace
