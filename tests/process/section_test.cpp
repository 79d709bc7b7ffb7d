/// Scenes that are cut open, by the command line and by files.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

namespace {

/// A red box of 2, closed, in which a green one of 1 lies, seen from above in even light.
class Cuts : public testing::Test {
  protected:
    Cuts() {
        test::writeText(folder / "boxes.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n");
        test::writeText(folder / "boxes.obj", "mtllib boxes.mtl\n" + box("red", 1, 1) + box("green", 0.5, 9));
        writeScene("whole.scn", "");
        writeScene("cut.scn", "[[section]]\npoint = [0, 0.75, 0]\nnormal = [0, 1, 0]\n");
    }

    static std::string box(const std::string& material, double half, int first) {
        std::string text = "usemtl " + material + "\n";
        for (int i = 0; i < 8; ++i)
            text += "v " + std::to_string((i & 1) != 0 ? half : -half) + " " +
                    std::to_string((i & 2) != 0 ? half : -half) + " " +
                    std::to_string((i & 4) != 0 ? half : -half) + "\n";
        for (const auto& face :
             {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
            text += "f";
            for (const int corner : face) text += " " + std::to_string(first + corner);
            text += "\n";
        }
        return text;
    }
    void writeScene(const std::string& name, const std::string& sections,
                    const std::string& more = "") const {
        test::writeText(folder / name,
                        "version = 2\nmodel = \"boxes.obj\"\n" + more +
                            "ambient = [0.5, 0.5, 0.5]\n"
                            "defaultLight = false\n[camera]\neye = [0, 6, 0]\nforward = [0, -1, 0]\n"
                            "up = [0, 0, -1]\nfov = 25\n" +
                            sections);
    }
    test::ProgramResult render(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "a.ppm", "-w", "40", "-h", "40", "--force"});
        return test::renderer(arguments, {.folder = folder.path()});
    }
    std::string picture(const std::vector<std::string>& arguments) {
        const test::ProgramResult result = render(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "a.ppm");
    }
    /// Red and green of the pixel in the middle.
    static std::pair<int, int> middle(const std::string& ppm) {
        const std::size_t at = ppm.size() - 3 * (40 * 40) + 3 * (20 * 40 + 20);
        return {static_cast<unsigned char>(ppm.at(at)), static_cast<unsigned char>(ppm.at(at + 1))};
    }

    test::TemporaryFolder folder;
};

TEST_F(Cuts, TheCommandLineAndFilesCutTheSame) {
    const std::string open = "--section-caps=none";
    const std::string whole = picture({"whole.scn"}), cut = picture({"cut.scn", open});
    EXPECT_GT(middle(whole).first, 50);
    EXPECT_EQ(middle(whole).second, 0);
    EXPECT_EQ(middle(cut).first, 0);
    EXPECT_GT(middle(cut).second, 50) << "the box inside is seen";
    EXPECT_EQ(picture({"whole.scn", open, "--section=0,0.75,0,0,2,0"}), cut);
    EXPECT_EQ(picture({"cut.scn", open, "--section=0,3,0,0,1,0"}), whole) << "in place of the scene's";
    const std::string box = picture({"whole.scn", open, "--section-box=2,0.75,-2,-2,-2,2"});
    EXPECT_EQ(box, cut);
}

/// The inside of a closed box is dark, unless light falls in where it was cut.
TEST_F(Cuts, PathsKnowWhetherLightFallsIn) {
    const std::string paths = "--integrator=path", open = "--section-caps=none";
    EXPECT_LT(middle(picture({"cut.scn", open, paths})).second, 5);
    EXPECT_GT(middle(picture({"cut.scn", open, paths, "--section-light=cut"})).second, 50);
}

TEST_F(Cuts, PartsThatAreNotClosedAreNamed) {
    test::writeText(folder / "boxes.obj", "o lid\nv -1 1 -1\nv 1 1 -1\nv 0 -1 1\nf 1 2 3\n");
    const test::ProgramResult result = render({"whole.scn", "--section=0,0,0,0,1,0"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.error.find("not closed, so that they have no caps"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("'lid'"), std::string::npos) << result.error;
    EXPECT_EQ(render({"whole.scn", "--section=0,3,0,0,1,0"}).error.find("not closed"), std::string::npos);
}

// The cut at 0.75 goes through the red box alone, one at 0.25 through both.
TEST_F(Cuts, SolidsAreClosed) {
    using Codes = std::pair<int, int>;
    EXPECT_EQ(middle(picture({"cut.scn"})), (Codes{255, 0}));
    EXPECT_EQ(middle(picture({"cut.scn", "--integrator=path"})), (Codes{255, 0}));
    EXPECT_EQ(middle(picture({"cut.scn", "--section=0,0.25,0,0,1,0"})), (Codes{0, 255}));
    writeScene("one.scn", "[[section]]\npoint = [0, 0.25, 0]\nnormal = [0, 1, 0]\n",
               "sectionCaps = \"one\"\nsectionColour = [1, 1, 1]\n");
    EXPECT_EQ(middle(picture({"one.scn"})), (Codes{255, 255}));
    EXPECT_EQ(middle(picture({"one.scn", "--section-caps=own"})), (Codes{0, 255}));
}

TEST_F(Cuts, WhatIsNoSectionIsRefused) {
    const auto refused = [&](const std::vector<std::string>& options, const std::string& words) {
        std::vector<std::string> arguments = options;
        arguments.insert(arguments.begin(), "whole.scn");
        const test::ProgramResult result = render(arguments);
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
    };
    for (const char* const text : {"1,2,3", "0,0,0,0,1,0,0", "0,0,0,0,one,0", ",,,,,", "0 0 0 0 1 0"})
        refused({std::string("--section=") + text}, "is not six numbers, parted by commas");
    refused({"--section=0,0,0,0,0,0"}, "is zero");
    refused({"--section=1e300,0,0,0,1,0"}, "beyond 1e12");
    refused({"--section=0,0,0,0,1e300,0"}, "too large");
    refused({"--section-box=0,0,0,1,1,2e12"}, "beyond 1e12");
    refused({"--section-box=0,0,0,1,1,0"}, "must differ in each coordinate");
    refused({"--section-box=0,0,0,1,1,1", "--section=0,0,0,0,1,0"}, "more than six");
    refused({"--section-light=dim"}, "section-light");
    refused({"--section-caps=red"}, "section-caps");
    test::writeText(folder / "bad.scn",
                    "version = 2\nmodel = \"boxes.obj\"\n[[section]]\npoint = [0, 0, 0]\n");
    EXPECT_EQ(render({"bad.scn"}).exitCode, 65);
}

} // namespace
