/// glTF files of truth3 (of the folder that RT_TEST_SCENES names), as they are seen by paths in known light.
#include "process/models/quads_file.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace {

using rtcore::Colour;

class GltfSeen : public test::SeenFiles {
  protected:
    void SetUp() override {
        const char* const scenes = std::getenv("RT_TEST_SCENES");
        if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
        scenes_ = std::filesystem::path(scenes) / "truth3";
        if (!std::filesystem::exists(scenes_)) GTEST_SKIP() << scenes_ << " is not there";
    }

    Seen seen(const std::string& name, const std::string& integrator = "path") {
        const auto image = folder / "x.pfm";
        const test::ProgramResult result =
            test::renderer({(scenes_ / (name + ".scn")).string(), "--integrator=" + integrator,
                            "--samples=64", "-w", "64", "-h", "48", "-o", image.string()});
        EXPECT_EQ(result.exitCode, 0) << name << ": " << result.error;
        return {rtcore::readHdrImage(image), result.error};
    }
    /// Columns 6 to 19 and 44 to 57 of 64.
    static float left(const Seen& s) { return s.mean(6 / 64.0, 20 / 64.0).g; }
    static float right(const Seen& s) { return s.mean(44 / 64.0, 58 / 64.0).g; }

    struct Lit {
        int left = 64, right = -1, top = 48, bottom = -1;
    };
    static Lit lit(const Seen& s) {
        Lit box;
        for (int y = 0; y < s.image.height; ++y) {
            for (int x = 0; x < s.image.width; ++x) {
                if (s.image.at(x, y).g < 0.5F) continue;
                box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y),
                       std::max(box.bottom, y)};
            }
        }
        return box;
    }
    std::filesystem::path scenes_;
};

TEST_F(GltfSeen, SkinsAndMorphsStandInTheirPose) {
    const Lit skin = lit(seen("skin")), morph = lit(seen("morph"));
    EXPECT_NEAR(skin.left, 30, 1);
    EXPECT_NEAR(skin.right, 33, 1);
    EXPECT_NEAR(skin.top, 0, 1);
    EXPECT_NEAR(skin.bottom, 23, 1);
    EXPECT_NEAR(morph.left, 44, 1);
    EXPECT_NEAR(morph.right, 55, 1);
}

TEST_F(GltfSeen, MaterialsAreAsTheyAreMeant) {
    EXPECT_NEAR(seen("normal_scale_0").mean().g, 0.276F, 0.01F);
    EXPECT_NEAR(seen("colour_alpha_blend").mean().g, 0.70F, 0.01F);
    EXPECT_NEAR(seen("unlit_colour").mean().g, 0.25F, 0.005F);
    EXPECT_NEAR(seen("ior_2").mean().g, 0.111F, 0.003F);
    const Seen glass = seen("transmission_texture");
    EXPECT_LT(left(glass), 0.1F);
    EXPECT_NEAR(right(glass), 0.923F, 0.01F);
}

TEST_F(GltfSeen, TexturesLieWhereTheyAreMeant) {
    const Seen whole = seen("uv_u16"), mirrored = seen("transform_texcoord");
    EXPECT_NEAR(left(whole), 0, 0.01F);
    EXPECT_NEAR(right(whole), 1, 0.01F);
    EXPECT_NEAR(left(mirrored), 1, 0.01F);
    EXPECT_NEAR(right(mirrored), 0, 0.01F);
}

TEST_F(GltfSeen, MeshesWithoutNormalsHaveFacets) {
    const Seen s = seen("no_normals", "whitted");
    std::set<int> greys;
    for (const Colour& c : s.image.pixels) greys.insert(static_cast<int>(c.g * 1000));
    EXPECT_LT(greys.size(), 600U) << "one grey a facet and those of edges; smooth it had 887";
}

TEST_F(GltfSeen, QuantisedFilesAndThoseOfTwoScenesOpen) {
    EXPECT_NEAR(seen("quantization").mean().g, 1, 0.005F);
    const Seen second = seen("second_scene");
    EXPECT_EQ(second.said.find("damaged"), std::string::npos) << second.said;
    EXPECT_GT(second.mean().g, second.mean().r);
}

} // namespace
