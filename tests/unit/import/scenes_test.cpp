/// On real models: the folder that RT_TEST_SCENES names.
#include "import_support.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace {

using namespace rtcore;
using test::near;

class Scenes : public testing::Test {
  protected:
    void SetUp() override {
        const char* const folder = std::getenv("RT_TEST_SCENES");
        if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
        folder_ = folder;
    }
    ImportedModel load(const std::string& name) const { return test::importFile(folder_ / name); }
    std::filesystem::path folder_;
};

/// 3DS counts z upwards, so its importer turns y up; the exporter of spot.3ds had not turned it before.
Vec3 turned(Vec3 p, const std::string& name) { return name.ends_with(".3ds") ? Vec3{p.x, -p.z, p.y} : p; }

TEST_F(Scenes, SpotIsTheSameInNineFiles) {
    const ImportedModel reference = load("spot/spot.obj");
    const Mesh& r = reference.model.mesh;
    ASSERT_EQ(r.triangles.size(), 5856U);
    for (const char* name : {"spot.ply", "spot_bin.ply", "spot.stl", "spot_bin.stl", "spot.3ds", "spot.x",
                             "spot.dae", "spot.glb"}) {
        const ImportedModel m = load(std::string("spot/") + name);
        const Mesh& mesh = m.model.mesh;
        EXPECT_EQ(mesh.triangles.size(), 5856U) << name;
        EXPECT_EQ(mesh.vertices.size(), r.vertices.size()) << name;
        EXPECT_NEAR(test::areaOf(mesh), test::areaOf(r), 1e-4) << name;
        EXPECT_NEAR(test::volumeOf(mesh), test::volumeOf(r), 1e-4) << name << ": faces outwards as well";
        Box3 bounds;
        for (const Vertex& v : mesh.vertices) bounds.extend(turned(v.position(), name));
        EXPECT_TRUE(near(bounds.lo, r.bounds().lo, 1e-4F)) << name;
        EXPECT_TRUE(near(bounds.hi, r.bounds().hi, 1e-4F)) << name;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 97) {
            for (int i = 0; i < 3; ++i) {
                EXPECT_TRUE(near(turned(mesh.position(t, i), name), r.position(t, i), 1e-4F))
                    << name << " " << t;
                if (mesh.texcoords.empty()) continue;
                const Vec2 a = mesh.texcoords[mesh.shading[t].v[i]], b = r.texcoords[r.shading[t].v[i]];
                EXPECT_NEAR(a.x, b.x, 1e-3F) << name << " " << t;
                EXPECT_NEAR(a.y, b.y, 1e-3F) << name << " " << t;
            }
        }
    }
}

TEST_F(Scenes, SmoothScansShareTheirNormals) {
    const ImportedModel dragon = load("dragon/dragon_res2.ply");
    const Mesh& mesh = dragon.model.mesh;
    EXPECT_LT(mesh.normals.size(), mesh.vertices.size() * 5 / 4);
    const ImportedModel sibenik = load("sibenik/sibenik.obj");
    EXPECT_EQ(sibenik.model.mesh.triangles.size() + sibenik.report.degenerateTriangles, 75284U);
    EXPECT_TRUE(near(sibenik.model.mesh.bounds().lo, {-20.1411F, -15.3123F, -8.4968F}, 1e-3F));
}

TEST_F(Scenes, CornellBoxesHaveTheirMirrorsGlassAndLights) {
    const ImportedModel sphere = load("cornell/CornellBox-Sphere.obj");
    const Material& mirror = test::materialNamed(sphere.model, "leftSphere");
    EXPECT_TRUE(near(mirror.mirror, {0.95F, 0.95F, 0.95F}));
    EXPECT_EQ(mirror.fresnel, 1U);
    EXPECT_EQ(mirror.opacity, 1);
    const Material& glass = test::materialNamed(sphere.model, "rightSphere");
    EXPECT_EQ(glass.opacity, 0);
    EXPECT_FLOAT_EQ(glass.indexOfRefraction, 2.5F);
    EXPECT_EQ(glass.transmission, kWhite);
    EXPECT_TRUE(near(test::materialNamed(sphere.model, "light").emission, {10, 10, 10}));
    EXPECT_TRUE(isBlack(test::materialNamed(sphere.model, "floor").mirror));
    EXPECT_TRUE(near(test::materialNamed(sphere.model, "leftWall").diffuse, {0.63F, 0.065F, 0.05F}));
    const ImportedModel water = load("cornell/CornellBox-Water.obj");
    EXPECT_EQ(test::materialNamed(water.model, "water").opacity, 0);
    EXPECT_FLOAT_EQ(test::materialNamed(water.model, "water").indexOfRefraction, 1.5F);
    const ImportedModel box = load("cornell/CornellBox-Mirror.obj");
    EXPECT_TRUE(near(test::materialNamed(box.model, "tallBox").mirror, {0.95F, 0.95F, 0.95F}));
    EXPECT_TRUE(near(test::materialNamed(box.model, "light").emission, {17, 12, 4}));
}

/// A copy under another name would not find its images: the textured library is named as the plain one
/// here.
TEST_F(Scenes, SponzaHasItsTextures) {
    const test::TemporaryFolder folder;
    namespace fs = std::filesystem;
    fs::create_symlink(folder_ / "sponza_crytek/sponza.obj", folder / "sponza.obj");
    fs::create_symlink(folder_ / "sponza_crytek/sponza_textured.mtl", folder / "sponza.mtl");
    fs::create_directory_symlink(folder_ / "sponza_crytek/textures", folder / "textures");
    const ImportedModel m = test::importFile(folder / "sponza.obj");
    EXPECT_GT(m.model.textures.size(), 10U);
    EXPECT_TRUE(m.report.warnings.empty()) << m.report.warnings[0].english();
    const auto textured = std::count_if(m.model.materials.begin(), m.model.materials.end(),
                                        [](const Material& a) { return a.diffuseTexture != kNoTexture; });
    EXPECT_GT(textured, 20);
}

/// Nothing else may happen with a damaged file: a sound model, or one error that says which file.
TEST_F(Scenes, BrokenFilesGiveAnErrorOrASoundModel) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "broken")) {
        ++files;
        const auto start = std::chrono::steady_clock::now();
        try {
            const ImportedModel m = test::importFile(entry.path());
            EXPECT_FALSE(m.model.mesh.triangles.empty()) << entry.path();
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData) << entry.path();
            EXPECT_NE(std::string(error.what()).find(entry.path().string()), std::string::npos)
                << error.what();
            EXPECT_NE(std::string(error.what()).find(';'), std::string::npos)
                << "no remedy: " << error.what();
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_LT(seconds, 20) << entry.path();
    }
    EXPECT_GE(files, 25);
}

TEST_F(Scenes, TheFileThatKillsAssimpIsNamed) {
    try {
        load("broken/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply");
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("crash-30d6"), std::string::npos);
        EXPECT_EQ(error.kind, FailureKind::BadData);
    }
}

} // namespace
