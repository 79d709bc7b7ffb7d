/// No output destroys an input, whatever the names: symbolic and hard links count, too.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <map>

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class Overwriting : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        test::writeCamera(folder / "view.cam", 0);
        rtcore::writeImage(folder / "paper.png", rtcore::LdrImage(2, 2));
        test::writeText(folder / "wall.mtl", "newmtl paper\nKd 1 1 1\nmap_Kd paper.png\n");
        test::writeText(folder / "wall.obj", "mtllib wall.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                                             "usemtl paper\nf 1/1 2/1 3/1\n");
        test::writeText(folder / "wall.scn", "version = 1\nmodel = \"wall.obj\"\nsettings = \"some.set\"\n"
                                             "[[environment]]\nequirectangular = \"sky.png\"\n");
        rtcore::writeImage(folder / "sky.png", rtcore::LdrImage(4, 2));
        test::writeText(folder / "some.set", "version = 1\n");
    }
    test::ProgramResult render(Names words) {
        for (const char* each : {"-w", "8", "-h", "8"}) words.emplace_back(each);
        return test::renderer(words, {.folder = folder.path()});
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : test::filesIn(folder.path()))
            all[name] = test::readBytes(folder / name);
        return all;
    }
    /// The command line is refused, and no file is touched.
    void refused(const Names& words) {
        const auto before = contents();
        const test::ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, 2) << testing::PrintToString(words) << result.error;
        EXPECT_NE(result.error.find("input and output are the same file"), std::string::npos) << result.error;
        EXPECT_EQ(contents(), before) << testing::PrintToString(words);
    }

    test::TemporaryFolder folder;
};

TEST_F(Overwriting, TheSceneAndItsModel) {
    for (const char* name : {"room.obj", "view.cam", "wall.scn", "some.set"}) {
        const std::string disguised = std::string(name) + ".png";
        fs::copy_file(folder / name, folder / disguised);
        fs::create_hard_link(folder / disguised, folder / ("hard_" + disguised));
        fs::create_symlink(disguised, folder / ("soft_" + disguised));
    }
    refused({"wall.scn.png", "-o", "wall.scn.png"});
    refused({"wall.scn.png", "-o", "a.png", "-o", "hard_wall.scn.png"});
    refused({"room.obj.png", "-o", "soft_room.obj.png"});
    refused({"wall.scn", "--model=room.obj.png", "-o", "room.obj.png"});
    refused({"room.obj", "--camera=view.cam.png", "-o", "view.cam.png"});
    refused({"room.obj", "--set=some.set.png", "-o", "hard_some.set.png"});
    refused({"room.obj", "-dbg", "room.obj"});
}

TEST_F(Overwriting, WhatTheSceneAndTheModelName) {
    refused({"wall.obj", "-o", "paper.png"});
    refused({"wall.scn", "-o", "paper.png"});
    refused({"wall.scn", "-o", "sky.png"});
    refused({"wall.obj", "-dbg", "wall.obj"});
    fs::create_hard_link(folder / "wall.mtl", folder / "drawing.mtl");
    refused({"wall.obj", "-dbg", "drawing.obj"});
    ASSERT_EQ(test::bspBuilder({"wall.obj", "wall.bsp"}, {.folder = folder.path()}).exitCode, 0);
    EXPECT_EQ(render({"wall.bsp", "-o", "paper.png"}).exitCode, 0) << "a .bsp holds its textures";
}

TEST_F(Overwriting, ListsAndTheirCameras) {
    fs::copy_file(folder / "view.cam", folder / "2.png");
    test::writeText(folder / "1.png", "view.cam\n2.png\n");
    refused({"room.obj", "-l", "1.png", "-o", "#.png", "--force"});
    refused({"room.obj", "-l", "1.png", "-o", "#.png", "--frames=2"});
    refused({"room.obj", "-l", "1.png", "-o", "#.png", "--follow", "--follow-timeout=0"});
    refused({"wall.obj", "-l", "1.png", "-o", "paper.png", "-o", "b/#.png", "-o", "1.png", "-o", "#.png"});
}

TEST_F(Overwriting, Films) {
    test::writeText(folder / "film.mp4", "view.cam\n");
    refused({"room.obj", "-l", "film.mp4", "-o", "f#.png", "--video=film.mp4"});
    fs::create_hard_link(folder / "view.cam", folder / "view.mkv");
    refused({"room.obj", "-l", "film.mp4", "-o", "f#.png", "--video=view.mkv"});
}

TEST_F(Overwriting, AnOutputOfTheSceneStaysInItsFolder) {
    fs::create_directory(folder / "scene");
    fs::copy_file(folder / "room.obj", folder.path() / "scene" / "room.obj");
    test::writeText(folder / "photo.png", "precious");
    fs::create_directory_symlink("..", folder.path() / "scene" / "link");
    const auto writeScene = [&](const std::string& output) {
        test::writeText(folder.path() / "scene" / "s.scn",
                        "version = 1\nmodel = \"room.obj\"\noutput = \"" + output + "\"\n");
    };
    for (const std::string& output :
         {std::string("../photo.png"), (folder / "photo.png").string(), std::string("link/photo.png"),
          std::string("../new.png"), std::string("../scene2.png")}) {
        writeScene(output);
        const test::ProgramResult result = render({"scene/s.scn"});
        EXPECT_EQ(result.exitCode, 65) << output << result.error;
        EXPECT_NE(result.error.find("lies outside of the scene's folder; name it by -o"), std::string::npos)
            << result.error;
    }
    EXPECT_EQ(test::readBytes(folder / "photo.png"), "precious");
    EXPECT_FALSE(fs::exists(folder / "new.png"));
    EXPECT_EQ(render({"scene/s.scn", "-o", "photo.png"}).exitCode, 0);
    for (const std::string& output : {std::string("a.png"), (folder.path() / "scene" / "b.png").string(),
                                      std::string("../scene/c.png")}) {
        writeScene(output);
        EXPECT_EQ(render({"scene/s.scn"}).exitCode, 0) << output;
        EXPECT_TRUE(fs::exists(folder.path() / "scene" / fs::path(output).filename()));
    }
}

} // namespace
