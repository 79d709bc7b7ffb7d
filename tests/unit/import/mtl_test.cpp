// Material libraries of OBJ files: where they are, and what they say.
#include "rtcore/io/import/obj/map_statement.h"
#include "rtcore/io/import/obj/material_libraries.h"

#include "import_support.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;
using test::near;
using test::TemporaryFolder;
using test::writeText;

class Mtl : public testing::Test {
  protected:
    void library(const std::string& name, const std::string& material, const std::string& lines) {
        std::filesystem::create_directories((folder_ / name).parent_path());
        writeText(folder_ / name, "newmtl " + material + "\n" + lines);
    }
    ImportedModel model(const std::string& mtllib, const std::string& material = "red") {
        std::filesystem::create_directories(folder_ / "model");
        writeText(folder_ / "model/m.obj", mtllib + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nusemtl " +
                                               material + "\nf 1/1 2/2 3/1\n");
        return test::importFile(folder_ / "model/m.obj");
    }
    static std::string said(const ImportedModel& model) {
        std::string text;
        for (const Sentence& warning : model.report.warnings) text += warning.english() + "\n";
        return text;
    }
    void expectRed(const std::string& mtllib) {
        const ImportedModel m = model(mtllib);
        EXPECT_EQ(m.model.materials[0].diffuse, (Colour{1, 0, 0})) << mtllib;
        EXPECT_EQ(said(m), "") << mtllib;
    }
    TemporaryFolder folder_;
};

TEST_F(Mtl, LibrariesAreFoundAsModelsNameThem) {
    library("model/a.mtl", "red", "Kd 1 0 0\n");
    library("model/My Lib.mtl", "red", "Kd 1 0 0\n");
    library("model/sub/Deep.mtl", "red", "Kd 1 0 0\n");
    library("model/b.mtl", "green", "Kd 0 1 0\n");
    for (const char* line :
         {"mtllib a.mtl", "mtllib  a.mtl ", "mtllib \"a.mtl\"", "mtllib A.MTL", "mtllib b.mtl a.mtl",
          "mtllib My Lib.mtl", "mtllib \"My Lib.mtl\"", "mtllib b.mtl My Lib.mtl",
          "mtllib \"b.mtl\" \"My Lib.mtl\"", "mtllib sub/Deep.mtl", "mtllib sub\\deep.mtl",
          "mtllib C:\\Users\\eva\\a.mtl", "mtllib D:\\x y\\sub\\Deep.mtl", "mtllib ./a.mtl",
          "mtllib b.mtl\nmtllib a.mtl", "mtllib b.mtl \\\n a.mtl"})
        expectRed(line);
    EXPECT_EQ(said(model("mtllib a.mtl gone.mtl")),
              "material library 'gone.mtl' is missing; what it describes is plain grey\n");
    EXPECT_EQ(said(model("mtllib no one.mtl")),
              "material library 'no one.mtl' is missing; what it describes is plain grey\n");
    library("model/m.mtl", "red", "Kd 1 0 0\n");
    expectRed("mtllib no one.mtl");
}

TEST_F(Mtl, NoLibraryOutsideOfTheModelsFolderIsRead) {
    library("secret.mtl", "red", "Kd 1 0 0\n");
    library("modelling/secret.mtl", "red", "Kd 1 0 0\n");
    std::filesystem::create_directories(folder_ / "model");
    std::filesystem::create_symlink("../secret.mtl", folder_ / "model/link.mtl");
    std::filesystem::create_directory_symlink("..", folder_ / "model/up");
    for (const std::string& name : {std::string("../secret.mtl"), (folder_ / "secret.mtl").string(),
                                    std::string("link.mtl"), std::string("up/secret.mtl"),
                                    std::string("..\\secret.mtl"), std::string("../modelling/secret.mtl")}) {
        const ImportedModel m = model("mtllib " + name);
        EXPECT_NE(m.model.materials[0].diffuse, (Colour{1, 0, 0})) << name;
        EXPECT_NE(said(m).find("is not read, as it lies outside of the model's folder"), std::string::npos)
            << said(m);
        EXPECT_EQ(m.report.files.size(), 1U) << name;
    }
    // A link to the model leads to the folder of the model.
    library("model/a.mtl", "red", "Kd 1 0 0\n");
    model("mtllib a.mtl");
    std::filesystem::create_directories(folder_ / "other");
    std::filesystem::create_symlink(folder_ / "model/m.obj", folder_ / "other/m.obj");
    std::filesystem::create_symlink(folder_ / "model/a.mtl", folder_ / "other/a.mtl");
    EXPECT_EQ(test::importFile(folder_ / "other/m.obj").model.materials[0].diffuse, (Colour{1, 0, 0}));
}

TEST_F(Mtl, StatementsThatAreNotUnderstoodAreNamed) {
    library("model/a.mtl", "red", "Kd 1 0 0\nKd x\nillum two\nfoo\nKs 0.5 # half\n  Ns 20\nillum 2\n");
    const ImportedModel m = model("mtllib a.mtl");
    EXPECT_EQ(said(m), "'a.mtl', line 3: 'Kd' is not understood and passed over, as are 2 lines more\n");
    EXPECT_EQ(m.model.materials[0].diffuse, (Colour{1, 0, 0}));
    EXPECT_TRUE(near(m.model.materials[0].specular, Colour{}, 0.51F));
    library("model/a.mtl", "red",
            "aniso 0.0\nanisor 0\nPs 0\nPc 0.0\nKa 1 1 1\nmap_Ka x.png\nsharpness 60\n");
    EXPECT_EQ(said(model("mtllib a.mtl")), "");
    library("model/a.mtl", "red", "Pc 0.5\nrefl -type sphere sky.png\nmap_Pr r.png\n");
    EXPECT_EQ(said(model("mtllib a.mtl")), "ignored, since not supported: 'Pc', 'refl' and 'map_Pr'\n");
}

TEST_F(Mtl, OneNumberIsAGrey) {
    library("model/a.mtl", "red", "Kd 0.25\nd -halo 0.5\n");
    const Material m = model("mtllib a.mtl").model.materials[0];
    EXPECT_EQ(m.diffuse, (Colour{0.25F, 0.25F, 0.25F}));
    EXPECT_EQ(m.opacity, 0.5F);
}

TEST_F(Mtl, OptionsOfImages) {
    const auto nameOf = [](const char* words) { return mapStatementOf(words).name; };
    EXPECT_EQ(nameOf("a.png"), "a.png");
    EXPECT_EQ(nameOf("a b.png "), "a b.png");
    EXPECT_EQ(nameOf("\"a b.png\""), "a b.png");
    EXPECT_EQ(nameOf("-s 2 2 2 -o 1 -clamp on a b.png"), "a b.png");
    EXPECT_EQ(nameOf("-blendu on -cc off -texres 512 -imfchan r -type sphere -t 1 1 -mm 0 1 -boost 2 a.png"),
              "a.png");
    EXPECT_EQ(nameOf("a b.png -bm 0.5"), "a b.png");
    EXPECT_EQ(nameOf("-odd.png"), "-odd.png");
    EXPECT_EQ(nameOf("a -s b.png"), "a -s b.png");
    EXPECT_EQ(nameOf("-s 1 1 1"), "");
    EXPECT_EQ(nameOf(""), "");
    const MapStatement all = mapStatementOf("-s 2 3 -o 0.5 wood.png -bm 4 -clamp ON");
    EXPECT_EQ(all.layout.scale, (Vec2{2, 3}));
    EXPECT_EQ(all.layout.offset, (Vec2{0.5F, 0}));
    EXPECT_EQ(all.bump, 4);
    EXPECT_TRUE(all.clamped);
}

TEST_F(Mtl, ImagesAreFoundByTheEndsOfTheirPaths) {
    std::filesystem::create_directories(folder_ / "model/Tex Maps");
    const LdrImage red(1, 1, {255, 0, 0, 255}), green(1, 1, {0, 255, 0, 255});
    writeImage(folder_ / "model/Tex Maps/a.png", red);
    writeImage(folder_ / "model/a.png", green);
    for (const char* name :
         {"C:\\Users\\eva\\Tex Maps\\a.png", "/gone/Tex Maps/a.png ", "\"Tex Maps/a.png\""}) {
        library("model/a.mtl", "red", std::string("map_Kd ") + name + "\n");
        const ImportedModel m = model("mtllib a.mtl");
        ASSERT_EQ(m.model.texels.size(), 1U) << name;
        EXPECT_EQ(m.model.texels[0], (Rgba8{255, 0, 0, 255})) << name;
        EXPECT_EQ(said(m), "") << name;
    }
    // Beside the library first.
    std::filesystem::create_directories(folder_ / "model/sub");
    writeImage(folder_ / "model/sub/a.png", red);
    library("model/sub/b.mtl", "red", "map_Kd a.png\n");
    EXPECT_EQ(model("mtllib sub/b.mtl").model.texels[0], (Rgba8{255, 0, 0, 255}));
    library("model/sub/b.mtl", "red", "map_Kd Tex Maps/a.png\n");
    EXPECT_EQ(model("mtllib sub/b.mtl").model.texels[0], (Rgba8{255, 0, 0, 255}));
}

TEST_F(Mtl, CasesOfTheField) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path cases = std::filesystem::path(scenes) / "field3/obj";
    EXPECT_EQ(test::importFile(cases / "dot.obj").model.mesh.triangles.size(), 1U);
    EXPECT_FALSE(test::importFile(cases / "aniso.obj").model.mesh.triangles.empty());
    const ImportedModel trail = test::importFile(cases / "trail.obj");
    EXPECT_EQ(said(trail), "");
    EXPECT_NE(trail.model.materials[0].diffuseTexture, kNoTexture);
    const ImportedModel two = test::importFile(cases / "libs/two_libs_one_line.obj");
    EXPECT_EQ(said(two), "");
    EXPECT_EQ(two.model.textures.size(), 2U);
    EXPECT_EQ(said(test::importFile(cases / "libs/lib_win.obj")), "");
    const ImportedModel paths = test::importFile(cases / "paths/texture_paths.obj");
    EXPECT_EQ(said(paths), "");
    for (const Material& material : paths.model.materials) EXPECT_NE(material.diffuseTexture, kNoTexture);
}

} // namespace
