/// Files of other people's kinds (field3 of the folder that RT_TEST_SCENES names), each with its right
/// answer.
#include "unit/import/import_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace rtcore;
using test::importFile;

class GltfCases : public testing::Test {
  protected:
    void SetUp() override {
        const char* const scenes = std::getenv("RT_TEST_SCENES");
        if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
        folder_ = std::filesystem::path(scenes) / "field3/gltf";
        if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
    }
    ImportedModel load(const std::string& name) const { return importFile(folder_ / name); }
    static std::string said(const ImportedModel& m) {
        std::string text;
        for (const Sentence& warning : m.report.warnings) text += warning.english() + "\n";
        return text;
    }
    std::filesystem::path folder_;
};

TEST_F(GltfCases, WholeNumbersAreTheSameModelAsFloats) {
    const ImportedModel plain = load("float.gltf");
    const Mesh& a = plain.model.mesh;
    const ImportedModel coarse = load("short.gltf"), other = load("uv16.gltf");
    EXPECT_EQ(said(coarse), "");
    EXPECT_EQ(said(other), "");
    const Mesh &b = other.model.mesh, &c = coarse.model.mesh;
    ASSERT_EQ(b.triangles.size(), a.triangles.size());
    ASSERT_FALSE(b.texcoords.empty());
    for (std::uint32_t t = 0; t < a.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(a.position(t, i), b.position(t, i)) << t;
            const Vec2 u = a.texcoords[a.shading[t].v[i]], v = b.texcoords[b.shading[t].v[i]];
            EXPECT_NEAR(u.x, v.x, 1e-3F) << t;
            EXPECT_NEAR(u.y, v.y, 1e-3F) << t;
        }
    }
    // Slivers at the poles have no area where positions are of 16 bits.
    EXPECT_NEAR(test::areaOf(c), test::areaOf(a), 1e-3 * test::areaOf(a));
    EXPECT_NEAR(test::volumeOf(c), test::volumeOf(a), 1e-3 * test::volumeOf(a));
    EXPECT_TRUE(test::near(c.bounds().lo, a.bounds().lo, 1e-3F));
    EXPECT_TRUE(test::near(c.bounds().hi, a.bounds().hi, 1e-3F));
}

TEST_F(GltfCases, JointsBendTheBoxThatTheyMove) {
    const ImportedModel posed = load("skin_posed.glb"), plain = load("skin_plain.glb");
    const auto top = [](const ImportedModel& m) {
        Vec3 highest;
        for (const Vertex& v : m.model.mesh.vertices)
            if (v.x < highest.x) highest = v.position();
        return highest;
    };
    EXPECT_EQ(posed.model.mesh.triangles.size(), plain.model.mesh.triangles.size());
    EXPECT_GT(top(posed).x, -1.13F);
    EXPECT_LT(top(posed).x, -0.6F);
    EXPECT_GT(top(plain).x, -0.55F);
    EXPECT_EQ(said(posed), "");
}

TEST_F(GltfCases, WeightsMoveTheirTargets) {
    const Box3 moved = load("weights_mesh.glb").model.mesh.bounds();
    EXPECT_TRUE(test::near(moved.size(), {1, 3, 1}));
    EXPECT_TRUE(test::near(load("weights_none.glb").model.mesh.bounds().size(), {1, 1, 1}));
}

TEST_F(GltfCases, FivePostsStandInARow) {
    const ImportedModel m = load("instances.glb");
    EXPECT_EQ(said(m), "");
    EXPECT_EQ(m.model.parts.size(), 5U);
    const Box3 all = m.model.mesh.bounds();
    EXPECT_NEAR(all.size().x, 4, 1.01F) << "posts at x = 0 to 4";
    EXPECT_GT(all.size().x, 4);
}

TEST_F(GltfCases, NamesWithBlanksAreFound) {
    const ImportedModel m = load("percent/percent.gltf");
    EXPECT_EQ(said(m), "");
    EXPECT_EQ(m.model.mesh.triangles.size(), 12U);
    EXPECT_EQ(m.model.textures.size(), 1U);
}

TEST_F(GltfCases, ImagesOfWebpAreRead) {
    const ImportedModel m = load("webp.gltf");
    if (said(m).find("WEBP") != std::string::npos) GTEST_SKIP() << "built without ImageMagick: " << said(m);
    EXPECT_EQ(said(m), "");
    ASSERT_EQ(m.model.textures.size(), 1U);
    const Texture& texture = m.model.textures[0];
    const Rgba8 left = m.model.texels[texture.firstTexel],
                right = m.model.texels[texture.firstTexel + texture.width - 1];
    EXPECT_GT(left.r, left.g);
    EXPECT_GT(right.g, right.r);
}

TEST_F(GltfCases, PackedByMeshoptimizerItOpensOrSaysTheRemedy) {
    try {
        const ImportedModel m = load("meshopt/meshopt-no-fallback.gltf");
        EXPECT_GT(m.model.mesh.triangles.size(), 0U);
        EXPECT_EQ(said(m), "");
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("it needs EXT_meshopt_compression"), std::string::npos);
    }
}

TEST_F(GltfCases, AListThatAllShareIsReadOnce) {
    ImportOptions options;
    options.memoryLimit = 300'000'000;
    const ImportedModel m = importFile(folder_ / "shared_60k_3500.glb", options);
    EXPECT_EQ(m.model.mesh.triangles.size(), 7000U);
    EXPECT_EQ(m.model.parts.size(), 3500U);
}

} // namespace
