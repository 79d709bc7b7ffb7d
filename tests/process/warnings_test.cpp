/// Losses of a model are reported by every program that opens it, from its .bsp, too.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace {

using Names = std::vector<std::string>;

const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0\n";

class ModelWarnings : public testing::Test {
  protected:
    std::string file(const std::string& name) const { return (folder / name).string(); }

    void expectWarnings(const test::ProgramResult& result, const std::string& model) {
        EXPECT_EQ(result.exitCode, 0) << result.error;
        for (const char* words :
             {"1 of 3 triangles was damaged and left out", "material library 'lost.mtl' is missing"}) {
            EXPECT_NE(result.error.find("warning: " + file(model) + ": " + words), std::string::npos)
                << result.error;
        }
    }

    std::string picture(const std::string& model, const std::string& name, const Names& options = {}) {
        Names arguments{file(model), "-o", file(name), "-w",       "48",
                        "-h",        "32", "-ao",      "--camera", file("c.cam")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const test::ProgramResult result = test::renderer(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        std::ifstream in(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    test::TemporaryFolder folder;
};

TEST_F(ModelWarnings, AreTheSameFromTheModelAndFromItsBsp) {
    test::writeText(folder / "m.obj",
                    std::string("mtllib lost.mtl\n") + kSquare + "f 1 2 3\nf 1 3 4\nf 1 2 5\n");
    const Names small{"-w", "16", "-h", "16", "-o", file("a.png")};
    const auto render = [&](const std::string& model) {
        Names arguments{file(model)};
        arguments.insert(arguments.end(), small.begin(), small.end());
        return test::renderer(arguments);
    };
    expectWarnings(render("m.obj"), "m.obj");
    expectWarnings(test::bspBuilder({file("m.obj"), file("m.bsp")}), "m.obj");
    expectWarnings(render("m.bsp"), "m.bsp");
}

// Copies in one object are welded, in objects of their own they are not.
TEST_F(ModelWarnings, ManyEqualTrianglesGiveTheBitsOfTheirCopies) {
    test::writeText(folder / "c.cam",
                    "version = 1\neye = [0.5, 0.4, 2]\nforward = [0.1, 0.05, -1]\nfov = 50\n");
    test::writeText(
        folder / "m.mtl",
        "newmtl red\nKd 0.8 0.1 0.1\nKs 0.2 0.2 0.2\nNs 20\nnewmtl glass\nd 0.3\nNi 1.5\nillum 4\n");
    for (const std::string material : {"red", "glass"}) {
        const std::string head =
            std::string("mtllib m.mtl\n") + kSquare + "v 0 0 -1\nv 2 0 -1\nv 0 2 -1\nusemtl red\nf 6 7 8\n";
        std::string welded = head, apart = head;
        for (const char* face : {"f 1 2 3\n", "f 3 2 1\n", "f 2 3 1\n"}) {
            for (int i = 0; i < 5; ++i) {
                const std::string object =
                    "o copy" + std::to_string(i) + face[2] + "\nusemtl " + material + "\n";
                apart += object + face;
                welded += (i == 0 ? object : "") + face;
            }
        }
        test::writeText(folder / "welded.obj", welded);
        test::writeText(folder / "apart.obj", apart);
        for (const Names& tree : {Names{}, Names{"-f"}}) {
            for (const char* model : {"welded", "apart"}) {
                Names arguments{file(std::string(model) + ".obj"), file(std::string(model) + ".bsp"), "-v"};
                arguments.insert(arguments.end(), tree.begin(), tree.end());
                const test::ProgramResult built = test::bspBuilder(arguments);
                const bool fewer = built.output.find("dropped: copies:         9\n") != std::string::npos;
                EXPECT_EQ(fewer, std::string(model) == "welded") << built.output;
            }
            EXPECT_EQ(picture("welded.bsp", "w.pfm"), picture("apart.bsp", "a.pfm")) << material;
        }
    }
}

TEST_F(ModelWarnings, OpenGlassIsNamedByVerboseAlone) {
    test::writeText(folder / "m.mtl", "newmtl glass\nd 0.1\nNi 1.5\n");
    test::writeText(folder / "m.obj", "mtllib m.mtl\nusemtl glass\n"
                                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\n"
                                      "o pane\nf 1 2 3 4\no tent\nf 5 7 6\nf 5 6 1\nf 6 7 1\nf 7 5 1\n");
    Names arguments{file("m.obj"), "-o", file("a.png"), "-w", "16", "-h", "12"};
    const char* const told = "the glass of \"pane\" is open (edges that do not join two triangles: 4)";
    const test::ProgramResult silent = test::renderer(arguments);
    EXPECT_EQ(silent.error.find("is open"), std::string::npos) << silent.error;
    arguments.emplace_back("-v");
    const test::ProgramResult verbose = test::renderer(arguments);
    EXPECT_NE(verbose.error.find(told), std::string::npos) << verbose.error;
    EXPECT_EQ(verbose.error.find("tent"), std::string::npos) << verbose.error;
}

TEST_F(ModelWarnings, ABspIsNotGivenTheEndingOfAnotherKind) {
    test::writeText(folder / "m.obj", std::string(kSquare) + "f 1 2 3\n");
    for (const char* name : {"a.png", "a.EXR", "a.jpg", "a.obj", "a.glb", "a.scn", "a.cam"}) {
        const test::ProgramResult result = test::bspBuilder({file("m.obj"), file(name)});
        EXPECT_EQ(result.exitCode, 2) << name << ": " << result.error;
        EXPECT_NE(result.error.find("name it " + file("a.bsp")), std::string::npos) << result.error;
    }
    EXPECT_EQ(test::filesIn(folder.path()), Names{"m.obj"});
    for (const char* name : {"a.bsp", "a", "a.tree", "a.BSP"})
        EXPECT_EQ(test::bspBuilder({file("m.obj"), file(name)}).exitCode, 0) << name;
}

} // namespace
