/// Materials as their authors meant them: what covers, what has a highlight, what emits.
#include "process/models/quads_file.h"

#include "rtcore/math/colour.h"

#include <cstdlib>

namespace {

using rtcore::Colour;
using test::emitting;
using test::metallicRoughness;
using test::QuadsFile;

constexpr const char* kBlend = ",\"alphaMode\":\"BLEND\"";

class MaterialsSeen : public test::SeenFiles {
  protected:
    /// A square of the material in front of one of radiance 1.
    Colour over(const std::string& material, const std::string& integrator, const std::string& more = "",
                const std::vector<float>& colour = {}) {
        QuadsFile file({{0, material, colour}, {-1, emitting()}});
        file.more = more;
        test::writeText(folder / "m.gltf", file.text());
        return see("m.gltf", integrator, kStraight).mean();
    }
};

void expectGrey(Colour seen, float min, float max, const std::string& what) {
    for (const float channel : {seen.r, seen.g, seen.b}) {
        EXPECT_GE(channel, min) << what;
        EXPECT_LE(channel, max) << what;
    }
}

TEST_F(MaterialsSeen, WhatABlendedSurfaceDoesNotCoverPassesUntouched) {
    for (const char* integrator : {"path", "whitted"}) {
        for (const float roughness : {0.0F, 0.05F, 0.6F}) {
            const std::string what = std::string(integrator) + " " + std::to_string(roughness);
            const auto seen = [&](const std::string& base) {
                return over(metallicRoughness(base, roughness, kBlend), integrator);
            };
            expectGrey(seen("0.02,0.02,0.02,0.3"), 0.67F, 0.71F, what + " dark");
            expectGrey(seen("0,0,0,0.6"), 0.38F, 0.42F, what + " black");
            expectGrey(seen("1,1,1,0.2"), 0.77F, 0.82F, what + " white");
            const Colour red = seen("1,0,0,0.5");
            EXPECT_NEAR(red.b, 0.5F, 0.02F) << what << ": no tint";
        }
    }
}

TEST_F(MaterialsSeen, BlendedSurfacesOfOtherFormatsPassTheSame) {
    const std::string square = "v -1 -1 Z\nv 1 -1 Z\nv 1 1 Z\nv -1 1 Z\n";
    const auto at = [&](const char* z) {
        std::string lines = square;
        for (std::size_t i = lines.find('Z'); i != std::string::npos; i = lines.find('Z'))
            lines.replace(i, 1, z);
        return lines;
    };
    test::writeText(folder / "m.obj", "mtllib m.mtl\n" + at("0") + at("-1") +
                                          "usemtl pane\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\n");
    for (const char* pane :
         {"d 0.3\nillum 2\nNi 1.45\n", "Tr 0.7\nillum 9\n", "d 0.3\nPr 0.1\nPm 0\nillum 2\nNi 1.45\n"}) {
        test::writeText(folder / "m.mtl", std::string("newmtl pane\nKd 0.02 0.02 0.02\n") + pane +
                                              "newmtl wall\nKd 1 1 1\nillum 0\n");
        for (const char* integrator : {"path", "whitted"})
            expectGrey(see("m.obj", integrator, kStraight).mean(), 0.67F, 0.71F, pane);
    }
}

/// A box of alpha 0.2 around the eye's line, before a wall that emits on its right half.
TEST_F(MaterialsSeen, ClosedBlendedSolidsNeitherBendNorHideWhatIsBehind) {
    test::writeText(folder / "m.mtl",
                    "newmtl veil\nKd 1 1 1\nd 0.2\nillum 2\nNi 1.45\nnewmtl wall\nKd 1 1 1\nillum 0\n");
    std::string box = "mtllib m.mtl\n";
    for (int i = 0; i < 8; ++i) {
        // Turned, so that a lens it would be.
        const float x = (i & 1) != 0 ? 0.9F : -0.9F, y = (i & 2) != 0 ? 1.0F : -1.0F,
                    z = (i & 4) != 0 ? 0.9F : -0.9F;
        box += "v " + std::to_string(0.8F * x + 0.6F * z) + " " + std::to_string(y) + " " +
               std::to_string(0.8F * z - 0.6F * x) + "\n";
    }
    box +=
        "v 0 -9 -3\nv 9 -9 -3\nv 9 9 -3\nv 0 9 -3\nusemtl veil\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\n"
        "f 1 5 7 3\nf 2 4 8 6\nusemtl wall\nf 9 10 11 12\n";
    test::writeText(folder / "m.obj", box);
    for (const char* integrator : {"path", "whitted"}) {
        const Seen seen =
            see("m.obj", integrator, "[camera]\neye = [0, 0, 5]\nforward = [0, 0, -1]\nfov = 20\n");
        EXPECT_LT(seen.mean(0.2, 0.49, 0.4, 0.6).g, 0.1F) << integrator;
        EXPECT_GT(seen.mean(0.51, 0.8, 0.4, 0.6).g, 0.6F) << integrator;
    }
}

TEST_F(MaterialsSeen, LightPassesBlendedPanesToWhatIsBehindThem) {
    const std::string camera = "[camera]\neye = [1.5, 0, 0.9]\nforward = [-1.5, 0, -0.9]\nfov = 4\n";
    for (const char* integrator : {"path", "whitted"}) {
        const auto lit = [&](const std::string& alpha) {
            QuadsFile file(
                {{1, metallicRoughness("0,0,0," + alpha, 0, kBlend)}, {0, metallicRoughness("1,1,1,1", 1)}});
            test::writeText(folder / "m.gltf", file.text());
            return see("m.gltf", integrator, camera + kSun).mean().g;
        };
        const float whole = lit("0");
        EXPECT_GT(whole, 0.8F);
        EXPECT_NEAR(lit("0.3") / whole, 0.7F, 0.02F) << integrator;
    }
}

TEST_F(MaterialsSeen, LightPassesClosedBlendedSolidsStraight) {
    const std::string floor = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\n";
    std::string box;
    for (int i = 0; i < 8; ++i) {
        box += std::string("v ") + ((i & 1) != 0 ? "1 " : "-1 ") + ((i & 2) != 0 ? "1 " : "-1 ") +
               ((i & 4) != 0 ? "1\n" : "0.5\n");
    }
    box += "usemtl smoke\nf 5 7 8 6\nf 9 10 12 11\nf 5 6 10 9\nf 7 11 12 8\nf 5 9 11 7\nf 6 8 12 10\n";
    test::writeText(
        folder / "m.mtl",
        "newmtl smoke\nKd 0 0 0\nd 0.3\nillum 2\nNi 1.45\nnewmtl floor\nKd 0.5 0.5 0.5\nillum 1\n");
    const std::string camera = "[camera]\neye = [1.5, 0, 0.45]\nforward = [-1.5, 0, -0.45]\nfov = 4\n";
    for (const char* integrator : {"path", "whitted"}) {
        const auto lit = [&](const std::string& before) {
            test::writeText(folder / "m.obj",
                            "mtllib m.mtl\n" + floor + before + "usemtl floor\nf 1 2 3 4\n");
            return see("m.obj", integrator, camera + kSun).mean().g;
        };
        EXPECT_NEAR(lit(box) / lit(""), 0.49F, 0.02F) << integrator;
    }
}

// A cube of 2 around the origin that blends and is seen from outside alone, made glass by the scene, before a
// wall.
TEST_F(MaterialsSeen, AnOverrideMakesBlendedSolidsGlass) {
    QuadsFile file({{1, metallicRoughness("1,1,1,0.05", 0, kBlend)}, {-8, emitting()}});
    file.scenes = R"("scene":0,"scenes":[{"nodes":[0,1,2,3,4,5,6]}])";
    std::string text = file.text();
    const std::string one = R"("nodes":[{"mesh":0},)";
    std::string six = R"("nodes":[{"mesh":0},)";
    for (const char* turn : {"0.70710678,0,0,0.70710678", "-0.70710678,0,0,0.70710678", "1,0,0,0",
                             "0,0.70710678,0,0.70710678", "0,-0.70710678,0,0.70710678"})
        six += std::string(R"({"mesh":0,"rotation":[)") + turn + "]},";
    ASSERT_NE(text.find(one), std::string::npos);
    text.replace(text.find(one), one.size(), six);
    test::writeText(folder / "m.gltf", text);
    for (const char* integrator : {"path", "whitted"}) {
        const Colour seen = see("m.gltf", integrator,
                                "[camera]\neye = [0, 0, 5]\nforward = [0, 0, -1]\nfov = 6\n"
                                "[[material]]\nnumber = 1\nopacity = 0\nindexOfRefraction = 1.5\n"
                                "transmission = [0.5, 0.5, 0.5]\nattenuationDistance = 2\n")
                                .mean();
        expectGrey(seen, 0.43F, 0.53F, integrator); // halved on its way, and a part is mirrored
    }
}

TEST_F(MaterialsSeen, TransmissionStaysGlass) {
    const std::string glass = ",\"extensions\":{\"KHR_materials_transmission\":{\"transmissionFactor\":1}}";
    const std::string used = ",\"extensionsUsed\":[\"KHR_materials_transmission\"]";
    const Colour seen = over(metallicRoughness("1,0.5,0.5,1", 0, glass), "path", used);
    EXPECT_NEAR(seen.r, 0.92F, 0.01F);
    EXPECT_NEAR(seen.g, 0.46F, 0.01F) << "tinted by the base colour";
}

TEST_F(MaterialsSeen, AlphasOfVerticesCoverWhereTheMaterialBlendsOrMasks) {
    const std::vector<float> faint{0, 0, 0, 0.3F}, solid{0, 0, 0};
    for (const char* integrator : {"path", "whitted"}) {
        const auto seen = [&](const std::string& mode, const std::vector<float>& colour) {
            return over(metallicRoughness("1,1,1,1", 1, mode), integrator, "", colour);
        };
        expectGrey(seen(kBlend, faint), 0.68F, 0.72F, "blended");
        expectGrey(seen(",\"alphaMode\":\"MASK\"", faint), 0.99F, 1.01F, "masked");
        expectGrey(seen(",\"alphaMode\":\"MASK\",\"alphaCutoff\":0.2", faint), 0, 0.02F, "above the cutoff");
        expectGrey(seen("", faint), 0, 0.02F, "opaque");
        expectGrey(seen(kBlend, solid), 0, 0.02F, "without alphas");
        expectGrey(over(metallicRoughness("1,1,1,0.5", 1, kBlend), integrator, "", faint), 0.83F, 0.87F,
                   "both");
    }
}

TEST_F(MaterialsSeen, UnlitColoursAreMultipliedByThoseOfVerticesAndCovered) {
    const std::vector<float> half{0.5F, 0.5F, 0.5F, 1};
    const std::string unlit = ",\"extensions\":{\"KHR_materials_unlit\":{}}";
    const std::string used = ",\"extensionsUsed\":[\"KHR_materials_unlit\"]";
    for (const char* integrator : {"path", "whitted"}) {
        expectGrey(over(metallicRoughness("0.5,0.5,0.5,1", 1, unlit), integrator, used, half), 0.249F, 0.251F,
                   integrator);
        expectGrey(over(metallicRoughness("0.5,0.5,0.5,0.2", 1, unlit + kBlend), integrator, used), 0.89F,
                   0.91F, "0.2 of 0.5 and 0.8 of 1");
    }
}

TEST_F(MaterialsSeen, TheIndexOfADielectricSetsWhatItReflects) {
    const std::string sky = "background = [1, 1, 1]\n";
    for (const auto& [index, reflected] :
         {std::pair{"1", 0.0F}, {"1.5", 0.04F}, {"2", 0.1111F}, {"3", 0.25F}}) {
        const std::string ior =
            std::string(",\"extensions\":{\"KHR_materials_ior\":{\"ior\":") + index + "}}";
        QuadsFile file({{0, metallicRoughness("0,0,0,1", 0, ior)}});
        file.more = ",\"extensionsUsed\":[\"KHR_materials_ior\"]";
        test::writeText(folder / "m.gltf", file.text());
        EXPECT_NEAR(see("m.gltf", "path", sky + kStraight).mean().g, reflected, 0.003F) << index;
    }
}

/// A square of Collada, with this in its effect.
std::string collada(const std::string& shading) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t">)" +
           shading + R"(</technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="matte"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">-1 -1 0 1 -1 0 1 1 0 -1 1 0</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST_F(MaterialsSeen, ColladaHasNoHighlightThatIsNotInTheFile) {
    const std::string diffuse = "<diffuse><color>0.8 0.4 0.2 1</color></diffuse>";
    const auto seen = [&](const std::string& shading) {
        test::writeText(folder / "m.dae", collada(shading));
        return see("m.dae", "path", std::string("background = [1, 1, 1]\n") + kStraight).mean();
    };
    for (const std::string kind : {"lambert", "phong", "blinn"}) {
        const Colour plain = seen("<" + kind + ">" + diffuse + "</" + kind + ">");
        EXPECT_NEAR(plain.r, 0.8F, 0.005F) << kind;
        EXPECT_NEAR(plain.g, 0.4F, 0.005F) << kind;
        EXPECT_NEAR(plain.b, 0.2F, 0.005F) << kind;
    }
    const Colour faceted = seen("<lambert>" + diffuse +
                                "</lambert><extra><technique profile=\"MAX3D\">"
                                "<faceted>1</faceted></technique></extra>");
    EXPECT_NEAR(faceted.b, 0.2F, 0.005F);
    EXPECT_NEAR(seen("<phong>" + diffuse + "<!-- <specular><color>1 1 1 1</color></specular> --></phong>").b,
                0.2F, 0.005F);
    const Colour stated = seen("<phong>" + diffuse +
                               "<specular><color>0 0 0.5 1</color></specular>"
                               "<shininess><float>10</float></shininess></phong>");
    EXPECT_GT(stated.b, 0.4F) << "what the file says stays";
}

TEST_F(MaterialsSeen, TheSharedCasesAreRight) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr || !std::filesystem::exists(std::filesystem::path(scenes) / "truth3"))
        GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const auto seen = [&](const std::string& name, const std::string& integrator) {
        return seeScene(std::filesystem::path(scenes) / "truth3" / (name + ".scn"), integrator);
    };
    for (const char* integrator : {"path", "whitted"}) {
        expectGrey(seen("window_dark", integrator).mean(), 0.67F, 0.71F, integrator);
        const Seen ball = seen("blend_ball", integrator);
        expectGrey(ball.mean(24 / 64.0, 31 / 64.0, 16 / 48.0, 32 / 48.0), 0, 0.05F, integrator);
        expectGrey(ball.mean(33 / 64.0, 40 / 64.0, 16 / 48.0, 32 / 48.0), 0.75F, 0.9F, integrator);
        expectGrey(seen("colour_alpha_blend", integrator).mean(), 0.69F, 0.71F, integrator);
        expectGrey(seen("unlit_colour", integrator).mean(), 0.249F, 0.251F, integrator);
        const Seen second = seen("second_scene", integrator);
        EXPECT_EQ(second.said.find("damaged"), std::string::npos) << second.said;
        EXPECT_GT(second.mean().g, second.mean().r);
    }
    EXPECT_NEAR(seen("ior_2", "path").mean().g, 0.1111F, 0.003F);
    const Colour lambert = seen("dae_lambert", "path").mean();
    EXPECT_NEAR(lambert.r, 0.8F, 0.005F);
    EXPECT_NEAR(lambert.b, 0.2F, 0.005F);
}

} // namespace
