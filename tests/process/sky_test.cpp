/// Skies and environment maps: --sky, --environment, [sky] and [[environment]] of a .scn.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

class Skies : public testing::Test {
  protected:
    Skies() { test::writeRoom(folder / "room.obj"); }

    std::string file(const std::string& name) const { return (folder / name).string(); }
    test::ProgramResult render(const std::string& scene, const Names& options) {
        Names arguments{file(scene), "-o", file("a.ppm"), "-w", "48", "-h", "32"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return test::renderer(arguments);
    }
    /// The bytes of the image.
    std::string image(const std::string& scene, const Names& options = {}) {
        const test::ProgramResult result = render(scene, options);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "a.ppm");
    }
    void writeScene(const std::string& name, const std::string& lines) {
        test::writeText(folder / name, "version = 2\nmodel = \"room.obj\"\n" + lines);
    }
    /// A map of two colours, left and right of the middle.
    void writeMap(const std::string& name, int width, int height) {
        std::string text = "P3 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
        for (int i = 0; i < width * height; ++i)
            text += i % width < width / 2 ? "250 90 20\n" : "20 60 250\n";
        test::writeText(folder / name, text);
    }

    test::TemporaryFolder folder;
};

TEST_F(Skies, AnOptionIsWhatASceneSays) {
    writeScene("plain.scn", "");
    writeScene("sky.scn", "[sky]\nhour = 9\nlatitude = 48.2\nturbidity = 4\nhaze = true\n");
    const std::string sky = image("sky.scn");
    EXPECT_NE(sky, image("plain.scn"));
    EXPECT_EQ(sky, image("plain.scn", {"--sky=hour=9,latitude=48.2,turbidity=4"}));
    EXPECT_NE(sky, image("sky.scn", {"--sky=17"}));
    EXPECT_NE(sky, image("plain.scn", {"--sky=hour=9,latitude=48.2,turbidity=4,haze=false"}));
    writeScene("pointed.scn", "[sky]\ndirection = [1, 2, -1]\nhaze = true\n");
    EXPECT_EQ(image("pointed.scn"), image("plain.scn", {"--sky=direction=1/2/-1"}));
}

TEST_F(Skies, AreTheSameForEveryThreadAndInstructionSet) {
    const std::string sky = image("room.obj", {"--sky=9", "--threads=1"});
    EXPECT_EQ(sky, image("room.obj", {"--sky=9", "--threads=3"}));
    EXPECT_EQ(sky, image("room.obj", {"--sky=9", "--isa=scalar"}));
}

TEST_F(Skies, MapsOfFilesAreShownTurnedAndScaled) {
    writeMap("map.ppm", 16, 8);
    writeScene("turned.scn", "[[environment]]\nequirectangular = \"map.ppm\"\nrotation = 90\n");
    writeScene("whole.scn", "[[environment]]\nequirectangular = \"map.ppm\"\nrotation = 360\n");
    writeScene("none.scn", "activeEnvironment = -1\n[[environment]]\nequirectangular = \"map.ppm\"\n");
    writeScene("plain.scn", "");
    EXPECT_NE(image("turned.scn"), image("whole.scn"));
    EXPECT_EQ(image("none.scn"), image("plain.scn"));
    EXPECT_NE(image("room.obj", {"--environment", file("map.ppm")}), image("room.obj"));
}

TEST_F(Skies, ALookLightsWhatBringsNoLight) {
    const std::string sky = image("room.obj");
    EXPECT_EQ(sky, image("room.obj", {"--look=sky"}));
    EXPECT_NE(sky, image("room.obj", {"--look=headlight"}));
    EXPECT_NE(sky, image("room.obj", {"--look=studio"}));
    EXPECT_NE(image("room.obj", {"--look=studio"}), image("room.obj", {"--look=headlight"}));
    EXPECT_EQ(image("room.obj", {"--sky=9"}), image("room.obj", {"--look=sky", "--sky=9"}));
    writeScene("lit.scn", "[[light]]\nkind = \"point\"\nposition = [0, 2, 3]\nintensity = [9, 9, 9]\n");
    writeScene("dim.scn", "[[light]]\nkind = \"point\"\nposition = [0, 2, 3]\nintensity = [1, 1, 1]\n");
    EXPECT_EQ(image("lit.scn", {"--look=studio"}), image("dim.scn", {"--look=studio"})) << "in its place";
}

TEST_F(Skies, WhatMakesNoSenseIsRefused) {
    EXPECT_EQ(render("room.obj", {"--look=candle"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--look=sky", "--environment=a.hdr"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--look=studio", "--sky=9"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--sky=25"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--sky=hour=9,moon=1"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--sky=date=2026-02-30"}).exitCode, 2);
    EXPECT_EQ(render("room.obj", {"--sky=9", "--environment=a.hdr"}).exitCode, 2);
    EXPECT_NE(render("room.obj", {"--sky=\"]\n["}).error.find("--sky"), std::string::npos);
    for (const char* sky : {"--sky=banana", "--sky=hour=", "--sky=9,"})
        EXPECT_NE(render("room.obj", {sky}).error.find("such as hour=17,latitude=48.2"), std::string::npos)
            << sky;
    writeMap("odd.ppm", 5, 2);
    const test::ProgramResult odd = render("room.obj", {"--environment", file("odd.ppm")});
    EXPECT_EQ(odd.exitCode, 65);
    EXPECT_NE(odd.error.find("an environment is twice as wide as high"), std::string::npos) << odd.error;
    EXPECT_EQ(render("room.obj", {"--environment", file("missing.hdr")}).exitCode, 66);
}

} // namespace
