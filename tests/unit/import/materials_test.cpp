#include "gltf_text.h"
#include "import_support.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;
using test::near;

/// The material of an OBJ whose MTL has these lines.
Material ofMtl(const std::string& lines, ImportReport* report = nullptr) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
    test::writeText(folder / "m.mtl", "newmtl paint\n" + lines);
    const ImportedModel m = test::importFile(folder / "m.obj");
    if (report != nullptr) *report = m.report;
    EXPECT_EQ(m.model.materials.size(), 1U) << "unused ones are left out";
    return test::materialNamed(m.model, "paint");
}

Material ofGltf(const std::string& json, const std::string& more = "") {
    test::GltfScene scene;
    scene.material = json;
    scene.more = more;
    return test::importText("m.gltf", scene.text()).model.materials[0];
}

TEST(MtlMaterial, LambertAndHighlight) {
    Material m = ofMtl("Kd 0.5 0.25 0.125\nKs 0.25 0.25 0.5\nNs 50\nillum 2\nKe 1 2 3\nNi 1.4\n");
    EXPECT_TRUE(near(m.diffuse, {0.5F, 0.25F, 0.125F}));
    EXPECT_TRUE(near(m.specular, {0.25F, 0.25F, 0.5F}));
    EXPECT_EQ(m.shininess, 50);
    EXPECT_TRUE(near(m.emission, {1, 2, 3}));
    EXPECT_TRUE(isBlack(m.mirror));
    EXPECT_EQ(m.opacity, 1);
    m = ofMtl("Kd 0.5 0.5 0.5\nKs 1 1 1\nNs 50\nillum 1\n");
    EXPECT_TRUE(isBlack(m.specular));
}

// One white glow, or metal all over, is never what an author meant by an image.
TEST(MissingImages, MakeNothingShineAndNothingMetal) {
    EXPECT_TRUE(isBlack(ofMtl("Kd 0.5 0.5 0.5\nKe 1 1 1\nmap_Ke nowhere.png\n").emission));
    const Material m = ofGltf(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},
"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}})",
                              R"(,"textures":[{"source":0}],"images":[{"uri":"nowhere.png"}])");
    EXPECT_TRUE(isBlack(m.emission));
    EXPECT_EQ(m.metallic, 0);
    EXPECT_EQ(ofGltf("{}").metallic, 1) << "as the file says";
}

TEST(MtlMaterial, EnergyIsConserved) {
    const Material m = ofMtl("Kd 0.8 0.6 0.6\nKs 0.9 0.45 0\nNs 10\nillum 2\n");
    EXPECT_TRUE(near(m.diffuse, {0.8F, 0.6F, 0.6F}));
    EXPECT_TRUE(near(m.specular, {0.2F, 0.1F, 0})) << "scaled with its hue";
    EXPECT_TRUE(near(ofMtl("Kd 7 -1 0.5\nillum 1\n").diffuse, {1, 0, 0.5F}));
}

TEST(MtlMaterial, MirrorsOnlyFromIllum3To7) {
    for (int illum = 0; illum <= 10; ++illum) {
        const Material m =
            ofMtl("Kd 0.1 0.1 0.1\nKs 0.8 0.7 0.6\nNs 100\nillum " + std::to_string(illum) + "\n");
        const bool mirror = illum >= 3 && illum <= 7;
        EXPECT_TRUE(near(m.mirror, mirror ? Colour{0.8F, 0.7F, 0.6F} : Colour{})) << illum;
        EXPECT_EQ(m.fresnel, illum == 5 || illum == 7 ? 1U : 0U) << illum;
        EXPECT_EQ(m.opacity, 1) << illum << ": without d or Ni there is no glass";
    }
}

TEST(MtlMaterial, GlassForIllum467) {
    for (const int illum : {4, 6, 7}) {
        const std::string model = "illum " + std::to_string(illum) + "\n";
        const Material clear =
            ofMtl("Kd 0.01 0.01 0.01\nKs 0.3 0.3 0.3\nTf 0.1 0.1 0.1\nNs 200\nNi 2.5\n" + model);
        EXPECT_EQ(clear.opacity, 0) << illum;
        EXPECT_FLOAT_EQ(clear.indexOfRefraction, 2.5F);
        EXPECT_EQ(clear.transmission, kWhite) << "a grey filter is no filter";
        const Material half = ofMtl("d 0.5\nTf 1 0.5 0.25\nNi 1.5\n" + model);
        EXPECT_EQ(half.opacity, 0.5F);
        EXPECT_TRUE(near(half.transmission, {1, 0.5F, 0.25F}));
    }
}

TEST(MtlMaterial, DissolveAndItsOpposite) {
    Material m = ofMtl("Kd 1 0 0\nd 0.25\nNi 1.5\nillum 2\n");
    EXPECT_EQ(m.opacity, 0.25F);
    EXPECT_EQ(m.indexOfRefraction, 1) << "no glass: light goes straight";
    EXPECT_EQ(ofMtl("Tr 0.75\nillum 2\n").opacity, 0.25F);
    EXPECT_EQ(ofMtl("d 1\nTr 1\nillum 2\n").opacity, 1) << "Tr the wrong way round";
}

TEST(MtlMaterial, Illum0IsUnlit) {
    const Material m = ofMtl("Kd 0.5 0.25 0\nillum 0\n");
    EXPECT_TRUE(isBlack(m.diffuse));
    EXPECT_TRUE(near(m.emission, {0.5F, 0.25F, 0}));
}

TEST(MtlMaterial, AMissingLibraryGivesAPlainMaterial) {
    const ImportedModel m =
        test::importText("m.obj", "mtllib none.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(m.model.materials.size(), 1U);
}

TEST(GltfMaterial, RoughDielectric) {
    const Material m = ofGltf(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0,"roughnessFactor":0.5}})");
    EXPECT_TRUE(near(m.diffuse, {0.5F, 0.25F, 0.125F}));
    EXPECT_TRUE(near(m.specular, {0.04F, 0.04F, 0.04F}));
    EXPECT_EQ(m.roughness, 0.5F);
    EXPECT_EQ(m.metallic, 0.0F);
    EXPECT_EQ(m.opacity, 1);
}

TEST(GltfMaterial, Metals) {
    Material m = ofGltf(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[0.9,0.6,0.3,1],"metallicFactor":1,"roughnessFactor":0}})");
    EXPECT_TRUE(near(m.diffuse, {0.9F, 0.6F, 0.3F})) << "the base colour";
    EXPECT_EQ(m.roughness, 0.0F);
    EXPECT_EQ(m.metallic, 1.0F);
    m = ofGltf(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.2,1],"metallicFactor":0.5,"roughnessFactor":0.15}})");
    EXPECT_TRUE(near(m.diffuse, {0.8F, 0.4F, 0.2F}));
    EXPECT_EQ(m.roughness, 0.15F);
    EXPECT_EQ(m.metallic, 0.5F);
}

TEST(GltfMaterial, AlphaModes) {
    const std::string colour =
        R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25],"roughnessFactor":1})";
    EXPECT_EQ(ofGltf("{" + colour + "}").opacity, 1);
    const Material blend = ofGltf("{" + colour + R"(,"alphaMode":"BLEND"})");
    EXPECT_EQ(blend.opacity, 0.25F);
    EXPECT_EQ(blend.indexOfRefraction, 1);
    EXPECT_EQ(ofGltf("{" + colour + R"(,"alphaMode":"MASK"})").opacity, 0) << "under the cutoff of 0.5";
    EXPECT_EQ(ofGltf("{" + colour + R"(,"alphaMode":"MASK","alphaCutoff":0.2})").opacity, 1);
    const std::string smooth =
        R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25],"roughnessFactor":0.05})";
    const Material window = ofGltf("{" + smooth + R"(,"alphaMode":"BLEND"})");
    EXPECT_TRUE(isVeil(window)) << "however smooth";
    EXPECT_EQ(window.opacity, 0.25F);
    EXPECT_EQ(window.frontOnly, 1U);
    EXPECT_EQ(ofGltf("{" + smooth + R"(,"alphaMode":"BLEND","doubleSided":true})").frontOnly, 0U);
    EXPECT_EQ(ofGltf("{" + smooth + "}").frontOnly, 0U);
}

TEST(GltfMaterial, Transmission) {
    const Material m = ofGltf(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.5,1],"metallicFactor":0,"roughnessFactor":0},
            "extensions":{"KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_ior":{"ior":1.33}}})",
        R"(,"extensionsUsed":["KHR_materials_transmission","KHR_materials_ior"])");
    EXPECT_EQ(m.opacity, 0);
    EXPECT_FLOAT_EQ(m.indexOfRefraction, 1.33F);
    EXPECT_TRUE(near(m.transmission, {1, 0.5F, 0.5F}));
}

TEST(GltfMaterial, SpecularGlossinessAndUnlit) {
    const Material sg = ofGltf(
        R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.4,0.4,0.4,1],
            "specularFactor":[0.5,0.5,0.5],"glossinessFactor":0.5}}})",
        R"(,"extensionsUsed":["KHR_materials_pbrSpecularGlossiness"])");
    EXPECT_TRUE(near(sg.diffuse, {0.4F, 0.4F, 0.4F})) << "the lobes take of it what they reflect";
    EXPECT_TRUE(near(sg.specular, {0.5F, 0.5F, 0.5F}));
    EXPECT_EQ(sg.roughness, 0.5F);
    EXPECT_EQ(sg.metallic, 0.0F);
    const Material unlit = ofGltf(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[0.4,0.3,0.2,1]},"extensions":{"KHR_materials_unlit":{}}})",
        R"(,"extensionsUsed":["KHR_materials_unlit"])");
    EXPECT_TRUE(near(unlit.emission, {0.4F, 0.3F, 0.2F}));
    EXPECT_TRUE(isBlack(unlit.diffuse));
    EXPECT_FALSE(hasRoughness(unlit)) << "it reflects nothing";
}

TEST(GltfMaterial, Emission) {
    EXPECT_TRUE(near(ofGltf(R"({"emissiveFactor":[1,0.5,0]})").emission, {1, 0.5F, 0}));
}

TEST(ColladaMaterial, PhongWithReflection) {
    const std::string dae =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong>
<diffuse><color>0.2 0.3 0.4 1</color></diffuse><specular><color>0.5 0.5 0.5 1</color></specular><shininess><float>20</float></shininess>
<reflective><color>1 1 1 1</color></reflective><reflectivity><float>0.25</float></reflectivity>
</phong></technique></profile_COMMON></effect></library_effects><library_materials><material id="m" name="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="x"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="x" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    const Material m = test::importText("m.dae", dae).model.materials[0];
    EXPECT_TRUE(near(m.diffuse, {0.2F, 0.3F, 0.4F}));
    EXPECT_TRUE(near(m.specular, {0.5F, 0.5F, 0.5F}));
    EXPECT_EQ(m.shininess, 20);
    EXPECT_TRUE(near(m.mirror, {0.25F, 0.25F, 0.25F}));
}

/// Two models of one geometry, whose first triangle has the material 0 and the second the material 1.
std::string twoInstances(const std::string& more) {
    std::string text =
        "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: "
        "7400\n}\nObjects:  {\n"
        "Geometry: 1, \"Geometry::g\", \"Mesh\" {\nVertices: *12 {\na: 0,0,0,1,0,0,0,1,0,1,1,0\n}\n"
        "PolygonVertexIndex: *6 {\na: 0,1,-3,1,3,-3\n}\nGeometryVersion: 124\nLayerElementMaterial: 0 {\n"
        "Version: 101\nMappingInformationType: \"ByPolygon\"\nReferenceInformationType: \"IndexToDirect\"\n"
        "Materials: *2 {\na: 0,1\n}\n}\nLayer: 0 {\nVersion: 100\nLayerElement:  {\n"
        "Type: \"LayerElementMaterial\"\nTypedIndex: 0\n}\n}\n}\n";
    for (const auto& [id, name] : {std::pair{2, "left"}, std::pair{3, "right"}})
        text += "Model: " + std::to_string(id) + ", \"Model::" + name +
                "\", \"Mesh\" {\nVersion: 232\nProperties70:  {\nP: \"Lcl Translation\", \"Lcl "
                "Translation\", \"\", "
                "\"A\"," +
                std::to_string(id) + ",0,0\n}\n}\n";
    for (const auto& [id, colour] :
         {std::pair{10, "1,0,0"}, std::pair{11, "0,1,0"}, std::pair{12, "0,0,1"}, std::pair{13, "1,1,0"}})
        text += "Material: " + std::to_string(id) + ", \"Material::m" + std::to_string(id) +
                "\", \"\" {\nVersion: 102\nShadingModel: \"lambert\"\nProperties70:  {\nP: \"DiffuseColor\", "
                "\"Color\", \"\", \"A\"," +
                colour + "\n}\n}\n";
    return text +
           "}\nConnections:  {\nC: \"OO\",2,0\nC: \"OO\",1,2\nC: \"OO\",10,2\nC: \"OO\",11,2\n"
           "C: \"OO\",3,0\nC: \"OO\",1,3\n" +
           more + "}\n";
}

std::vector<Colour> coloursOfFbx(const std::string& fbx) {
    const Model m = test::importText("m.fbx", fbx).model;
    std::vector<Colour> colours;
    for (const ShadingTriangle& t : m.mesh.shading) colours.push_back(m.materials[t.material].diffuse);
    return colours;
}

TEST(FbxInstances, HaveTheirOwnMaterials) {
    constexpr Colour kRed{1, 0, 0}, kGreen{0, 1, 0};
    EXPECT_EQ(coloursOfFbx(twoInstances("C: \"OO\",11,3\nC: \"OO\",10,3\n")),
              (std::vector<Colour>{kRed, kGreen, kGreen, kRed}));
    EXPECT_EQ(coloursOfFbx(twoInstances("C: \"OO\",10,3\nC: \"OO\",11,3\n")),
              (std::vector<Colour>{kRed, kGreen, kRed, kGreen}));
}

TEST(FbxInstances, MaterialsThatAreNotReadAreCounted) {
    const ImportedModel m = test::importText("m.fbx", twoInstances("C: \"OO\",12,3\nC: \"OO\",13,3\n"));
    ASSERT_EQ(m.report.warnings.size(), 1U);
    EXPECT_NE(m.report.warnings[0].english().find("2 meshes of nodes that show the geometry of another"),
              std::string::npos);
}

} // namespace
