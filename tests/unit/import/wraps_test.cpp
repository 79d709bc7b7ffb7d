// The fields that came with .bsp 3: wraps, kinds of cameras, parts, strength of emission.
#include "gltf_text.h"
#include "import_support.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace {

using namespace rtcore;
using test::GltfScene;
using test::importFile;
using test::importText;

class Wraps : public testing::Test {
  protected:
    Wraps() { writeImage(folder_ / "p.png", LdrImage(3, 2, {9, 8, 7, 255})); }

    Model ofGltf(const std::string& material, const std::string& samplers, const std::string& textures) {
        GltfScene scene;
        scene.material = material;
        scene.more =
            R"(,"images":[{"uri":"p.png"}],"samplers":[)" + samplers + R"(],"textures":[)" + textures + "]";
        test::writeText(folder_ / "t.gltf", scene.text());
        return importFile(folder_ / "t.gltf").model;
    }

    test::TemporaryFolder folder_;
};

TEST_F(Wraps, AreThoseOfTheSamplerInGltf) {
    const Model m = ofGltf(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                           R"({"wrapS":33071,"wrapT":33648})", R"({"source":0,"sampler":0})");
    ASSERT_EQ(m.textures.size(), 1U);
    EXPECT_EQ(m.textures[0], (Texture{0, 3, 2, TextureWrap::ClampToEdge, TextureWrap::MirroredRepeat}));
}

TEST_F(Wraps, RepeatWithoutASampler) {
    const Model m =
        ofGltf(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})", "", R"({"source":0})");
    ASSERT_EQ(m.textures.size(), 1U);
    EXPECT_EQ(m.textures[0], (Texture{0, 3, 2, TextureWrap::Repeat, TextureWrap::Repeat}));
}

TEST_F(Wraps, OfOnePictureShareItsTexels) {
    const Model m =
        ofGltf(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"emissiveFactor":[1,1,1],
"emissiveTexture":{"index":1},"normalTexture":{"index":2}})",
               R"({"wrapS":33071,"wrapT":33071},{"wrapS":33648,"wrapT":10497})",
               R"({"source":0,"sampler":0},{"source":0,"sampler":1},{"source":0,"sampler":0})");
    ASSERT_EQ(m.textures.size(), 2U);
    EXPECT_EQ(m.texels.size(), 6U);
    const Material& material = m.materials[0];
    EXPECT_EQ(material.diffuseTexture, material.normalTexture);
    const Texture clamped{0, 3, 2, TextureWrap::ClampToEdge, TextureWrap::ClampToEdge};
    const Texture mirrored{0, 3, 2, TextureWrap::MirroredRepeat, TextureWrap::Repeat};
    EXPECT_EQ(m.textures[material.diffuseTexture], clamped);
    EXPECT_EQ(m.textures[material.emissionTexture], mirrored);
}

TEST_F(Wraps, ClampInMtl) {
    test::writeText(folder_ / "m.mtl", "newmtl a\nmap_Kd -clamp on p.png\nnewmtl b\nmap_Kd -clamp off p.png\n"
                                       "newmtl c\nmap_Kd p.png\n");
    test::writeText(folder_ / "m.obj",
                    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                    "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n");
    const Model m = importFile(folder_ / "m.obj").model;
    const auto wrapOf = [&](const char* name) {
        const Texture& t = m.textures[test::materialNamed(m, name).diffuseTexture];
        EXPECT_EQ(t.wrapU, t.wrapV);
        return t.wrapU;
    };
    EXPECT_EQ(wrapOf("a"), TextureWrap::ClampToEdge);
    EXPECT_EQ(wrapOf("b"), TextureWrap::Repeat);
    EXPECT_EQ(wrapOf("c"), TextureWrap::Repeat);
}

// Assimp reads those that Maya writes.
TEST_F(Wraps, AreThoseOfMayaInCollada) {
    test::writeText(
        folder_ / "m.dae",
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_images><image id="i"><init_from>p.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON><newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="c"><lambert><diffuse><texture texture="t" texcoord="u"><extra><technique profile="MAYA"><wrapU>0</wrapU><wrapV>1</wrapV><mirrorV>1</mirrorV></technique></extra></texture></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">-1 0 -1 1 0 -1 0 0 1</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="q"><float_array id="qa" count="6">0 0 1 0 0 1</float_array><technique_common>
<accessor source="#qa" count="3" stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="s"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#q" offset="1" set="0"/>
<p>0 0 2 2 1 1</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
    const Model m = importFile(folder_ / "m.dae").model;
    ASSERT_EQ(m.textures.size(), 1U);
    EXPECT_EQ(m.textures[0].wrapU, TextureWrap::ClampToEdge);
    EXPECT_EQ(m.textures[0].wrapV, TextureWrap::MirroredRepeat);
}

TEST(EmissiveStrength, MultipliesTheEmission) {
    GltfScene scene;
    scene.material =
        R"({"emissiveFactor":[1,0.5,0.1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}})";
    scene.more = R"(,"extensionsUsed":["KHR_materials_emissive_strength"])";
    const ImportedModel strong = importText("t.gltf", scene.text());
    EXPECT_TRUE(test::near(strong.model.materials[0].emission, {3, 1.5F, 0.3F}));
    EXPECT_TRUE(strong.report.warnings.empty());
    scene.material = R"({"emissiveFactor":[1,0.5,0.1]})";
    EXPECT_TRUE(test::near(importText("t.gltf", scene.text()).model.materials[0].emission, {1, 0.5F, 0.1F}));
}

TEST(EmissiveStrength, IsReadFromAGlbToo) {
    GltfScene scene;
    scene.material =
        R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":5}}})";
    EXPECT_EQ(importText("t.glb", scene.binary()).model.materials[0].emission, (Colour{5, 5, 5}));
}

TEST(EmissiveStrength, OfNonsenseIsHarmless) {
    GltfScene scene;
    for (const char* strength : {"-3", "1e300", "\"much\"", "{}", "null"}) {
        scene.material =
            std::string(
                R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":)") +
            strength + "}}}";
        const Colour emission = importText("t.gltf", scene.text()).model.materials[0].emission;
        EXPECT_TRUE(emission.r >= 0 && emission.r <= 1e16F) << strength;
    }
}

Model camerasOf(const std::string& cameras) {
    GltfScene scene;
    scene.nodes = R"({"mesh":0},{"camera":0,"scale":[2,2,2]},{"camera":1})";
    scene.roots = "0,1,2";
    scene.more = R"(,"cameras":[)" + cameras + "]";
    return importText("t.gltf", scene.text()).model;
}

TEST(Cameras, OrthographicOnesOfGltf) {
    const Model m =
        camerasOf(R"({"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0.1,"zfar":9}},
{"type":"perspective","perspective":{"yfov":0.7,"aspectRatio":1,"znear":0.1}})");
    ASSERT_EQ(m.cameras.size(), 2U);
    EXPECT_EQ(m.cameras[0].kind, CameraKind::Orthographic);
    EXPECT_EQ(m.cameras[0].orthographicWidth, 6) << "xmag is half of the width, whatever the node's scale";
    EXPECT_EQ(m.cameras[0].aspect, 1.5F);
    EXPECT_EQ(m.cameras[1].kind, CameraKind::Perspective);
    EXPECT_EQ(m.cameras[1].orthographicWidth, 0);
    EXPECT_EQ(m.cameras[1].aspect, 1);
}

TEST(Cameras, WithoutAnAspectInGltfHaveTheirVerticalAngleInAnyImage) {
    const Model m = camerasOf(R"({"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}},
{"type":"orthographic","orthographic":{"xmag":0,"ymag":2,"znear":0.1,"zfar":9}})");
    const double narrow = std::tan(double{m.cameras[0].horizontalFov} * std::numbers::pi / 360);
    for (const auto& [width, height] : {std::pair{1920, 800}, {640, 480}, {100, 100}, {90, 200}, {10, 100}}) {
        const double wide = narrow * double{widening(m.cameras[0], width, height)};
        EXPECT_NEAR(2 * std::atan(wide * height / width), 0.7, 1e-5) << width << " x " << height;
    }
    EXPECT_EQ(m.cameras[1].kind, CameraKind::Perspective) << "of no width";
}

TEST(Parts, AreTheMeshesUnderTheirNodes) {
    GltfScene scene;
    scene.nodes =
        R"({"name":"house","children":[1,2]},{"name":"door","mesh":0},{"mesh":0,"translation":[5,0,0]})";
    const Model m = importText("t.gltf", scene.text()).model;
    ASSERT_EQ(m.parts.size(), 2U);
    EXPECT_EQ(m.name(m.parts[0].nameOffset), "door");
    EXPECT_EQ(m.parts[0].firstTriangle, 0U);
    EXPECT_EQ(m.parts[0].triangleCount, 1U);
    EXPECT_EQ(m.parts[1].firstTriangle, 1U);
    EXPECT_NE(m.name(m.parts[1].nameOffset), "door");

    const Model obj =
        importText("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no left\nf 1 2 3\no right\nf 3 2 1\nf 1 2 3\n").model;
    ASSERT_EQ(obj.parts.size(), 2U);
    EXPECT_EQ(obj.name(obj.parts[0].nameOffset), "left");
    EXPECT_EQ(obj.name(obj.parts[1].nameOffset), "right");
    EXPECT_EQ(obj.parts[1].firstTriangle, 1U);
    EXPECT_EQ(obj.parts[1].triangleCount, 2U);
}

TEST(Parts, AreNamedByTheWayToTheirNode) {
    GltfScene scene;
    scene.nodes =
        R"({"name":"house","children":[1]},{"name":"front","children":[2]},{"name":"door","mesh":0})";
    const Model m = importText("t.gltf", scene.text()).model;
    ASSERT_EQ(m.parts.size(), 1U);
    EXPECT_EQ(m.name(m.parts[0].nameOffset), "front/door");

    const Model obj = importText("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no table\nusemtl oak\nf 1 2 3\n"
                                          "usemtl steel\nf 3 2 1\n")
                          .model;
    ASSERT_EQ(obj.parts.size(), 2U);
    EXPECT_EQ(obj.name(obj.parts[0].nameOffset), "table/oak") << "of one object, by their material";
    EXPECT_EQ(obj.name(obj.parts[1].nameOffset), "table/steel");
}

TEST(Materials, KeepRoughnessAndMetal) {
    GltfScene scene;
    scene.material = R"({"pbrMetallicRoughness":{"roughnessFactor":0.25,"metallicFactor":0.75}})";
    const Material physical = importText("t.gltf", scene.text()).model.materials[0];
    EXPECT_EQ(physical.roughness, 0.25F);
    EXPECT_EQ(physical.metallic, 0.75F);
    EXPECT_EQ(physical.metallicRoughnessTexture, kNoTexture);
    EXPECT_EQ(importText("cube.obj", test::kCubeObj).model.materials[0].roughness, kNoRoughness);
}

} // namespace
