#include "gltf_text.h"
#include "import_support.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace rtcore;

/// Red above, green below; the lower right texel is half clear.
LdrImage picture(bool clear) {
    LdrImage image(2, 2);
    image.at(0, 0) = image.at(1, 0) = {255, 0, 0, 255};
    image.at(0, 1) = image.at(1, 1) = {0, 255, 0, 255};
    if (clear) image.at(1, 1).a = 128;
    return image;
}

class Textures : public testing::Test {
  protected:
    ImportedModel ofMtl(const std::string& lines, int materials = 1) {
        std::ostringstream obj, mtl;
        obj << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
        for (int i = 0; i < materials; ++i) {
            obj << "usemtl m" << i << "\nf 1/1 2/2 3/3\n";
            mtl << "newmtl m" << i << "\n" << lines;
        }
        test::writeText(folder_ / "m.obj", obj.str());
        test::writeText(folder_ / "m.mtl", mtl.str());
        return test::importFile(folder_ / "m.obj");
    }
    test::TemporaryFolder folder_;
};

TEST_F(Textures, AreReadOnceWhoeverNamesThem) {
    writeImage(folder_ / "Wood.png", picture(false));
    const ImportedModel m = ofMtl("Kd 1 1 1\nmap_Kd .\\wood.png\n", 3);
    ASSERT_EQ(m.model.textures.size(), 1U);
    ASSERT_EQ(m.model.texels.size(), 4U);
    EXPECT_EQ(m.model.texels[0], (Rgba8{255, 0, 0, 255})) << "rows from the top";
    for (const Material& material : m.model.materials) EXPECT_EQ(material.diffuseTexture, 0U);
    EXPECT_TRUE(m.report.warnings.empty());
}

TEST_F(Textures, MissingAndBrokenOnesAreWarnings) {
    test::writeText(folder_ / "broken.png", "no image");
    for (const char* name : {"none.png", "broken.png"}) {
        const ImportedModel m = ofMtl(std::string("Kd 0.5 0.25 0.5\nmap_Kd ") + name + "\n", 2);
        EXPECT_EQ(m.model.materials[0].diffuseTexture, kNoTexture);
        EXPECT_EQ(m.model.materials[0].diffuse.g, 0.25F);
        ASSERT_EQ(m.report.warnings.size(), 1U) << "once, though two materials name it";
        EXPECT_NE(m.report.warnings[0].english().find(name), std::string::npos);
    }
}

TEST_F(Textures, CanBeTurnedUpsideDown) {
    ImportOptions options;
    ofMtl("Kd 1 1 1\n");
    const ImportedModel upright = test::importFile(folder_ / "m.obj", options);
    options.flipTextures = true;
    const ImportedModel turned = test::importFile(folder_ / "m.obj", options);
    ASSERT_EQ(turned.model.mesh.texcoords.size(), upright.model.mesh.texcoords.size());
    ASSERT_FALSE(turned.model.mesh.texcoords.empty());
    for (std::size_t i = 0; i < turned.model.mesh.texcoords.size(); ++i) {
        EXPECT_EQ(turned.model.mesh.texcoords[i].x, upright.model.mesh.texcoords[i].x);
        EXPECT_EQ(turned.model.mesh.texcoords[i].y, 1 - upright.model.mesh.texcoords[i].y);
    }
}

TEST_F(Textures, AnUnsetColourDoesNotDarkenThem) {
    writeImage(folder_ / "a.png", picture(false));
    EXPECT_EQ(ofMtl("map_Kd a.png\n").model.materials[0].diffuse, kWhite);
    EXPECT_EQ(ofMtl("Kd 0 0 0\nmap_Kd a.png\n").model.materials[0].diffuse, kWhite);
    EXPECT_EQ(ofMtl("Kd 0.5 0.5 0.5\nmap_Kd a.png\n").model.materials[0].diffuse.r, 0.5F);
    const Material emissive = ofMtl("map_Ke a.png\n").model.materials[0];
    EXPECT_EQ(emissive.emissionTexture, 0U);
    EXPECT_EQ(emissive.emission, kWhite);
}

TEST_F(Textures, ScaleTheEmissionInFormatsMadeForOpenGlAndDirect3d) {
    writeImage(folder_ / "a.png", picture(false));
    const auto emissive = [&](const std::string& name, const std::string& text) {
        test::writeText(folder_ / name, text);
        const Model model = test::importFile(folder_ / name).model;
        EXPECT_EQ(model.materials.size(), 1U) << name;
        EXPECT_TRUE(test::near(model.materials[0].emission, {0.8F, 0.8F, 0.8F})) << name;
        return model.materials[0];
    };
    const Material ac = emissive("m.ac", "AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 0 0 0 emis 0.8 0.8 0.8 "
                                         "spec 0 0 0 shi 0 trans 0\nOBJECT world\nkids 1\nOBJECT poly\n"
                                         "texture \"a.png\"\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\n"
                                         "SURF 0x10\nmat 0\nrefs 3\n0 0 0\n1 1 0\n2 0 1\nkids 0\n");
    const Material x = emissive("m.x", "xof 0303txt 0032\nMesh m { 3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,1,2;;\n"
                                       "MeshTextureCoords { 3; 0;0;, 1;0;, 0;1;; }\n"
                                       "MeshMaterialList { 1; 1; 0;; Material a { 1;1;1;1;; 0; 0;0;0;;\n"
                                       "0.8;0.8;0.8;; TextureFilename { \"a.png\"; } } } }\n");
    for (const Material& material : {ac, x}) {
        EXPECT_NE(material.diffuseTexture, kNoTexture);
        EXPECT_EQ(material.emissionTexture, material.diffuseTexture);
    }
    EXPECT_EQ(ofMtl("Kd 1 1 1\nKe 0.8 0.8 0.8\nmap_Kd a.png\n").model.materials[0].emissionTexture,
              kNoTexture);
    EXPECT_EQ(ofMtl("Kd 1 1 1\nKe 0 0 0\nmap_Kd a.png\n").model.materials[0].emissionTexture, kNoTexture);
}

TEST_F(Textures, AlphaMaps) {
    LdrImage mask(2, 1);
    mask.at(0, 0) = {255, 255, 255, 255};
    mask.at(1, 0) = {0, 0, 0, 255};
    writeImage(folder_ / "mask.png", mask);
    writeImage(folder_ / "clear.png", picture(true));
    writeImage(folder_ / "white.png", LdrImage(2, 2, {255, 255, 255, 255}));
    Material m = ofMtl("map_Kd clear.png\nmap_d mask.png\n").model.materials[0];
    EXPECT_NE(m.alphaTexture, kNoTexture);
    EXPECT_EQ(m.alphaFromAlpha, 0U) << "black and white";
    m = ofMtl("map_Kd clear.png\nmap_d clear.png\n").model.materials[0];
    EXPECT_EQ(m.alphaTexture, m.diffuseTexture);
    EXPECT_EQ(m.alphaFromAlpha, 1U);
    EXPECT_EQ(ofMtl("map_d white.png\n").model.materials[0].alphaTexture, kNoTexture) << "hides nothing";
    EXPECT_EQ(ofMtl("map_Kd clear.png\n").model.materials[0].alphaTexture, kNoTexture)
        << "MTL asks for map_d";
}

/// A glTF whose only image is inside.
ImportedModel embedded(const std::string& material) {
    const auto png = encodeImage(picture(true), "png");
    test::GltfScene scene;
    scene.material = material;
    scene.more =
        R"(,"extensionsUsed":["KHR_texture_transform"],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
        test::base64(png) + R"("}])";
    return test::importText("m.gltf", scene.text());
}

TEST_F(Textures, InsideTheModel) {
    const ImportedModel m =
        embedded(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0}})");
    ASSERT_EQ(m.model.textures.size(), 1U);
    EXPECT_EQ(m.model.texels[2], (Rgba8{0, 255, 0, 255}));
    EXPECT_EQ(m.model.materials[0].diffuseTexture, 0U);
    EXPECT_EQ(m.model.materials[0].alphaTexture, kNoTexture) << "opaque by default";
}

TEST_F(Textures, MaskAndBlend) {
    const std::string base = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0})";
    const Material mask =
        embedded("{" + base + R"(,"alphaMode":"MASK","alphaCutoff":0.7})").model.materials[0];
    EXPECT_EQ(mask.alphaTexture, 0U);
    EXPECT_EQ(mask.alphaFromAlpha, 1U);
    EXPECT_FLOAT_EQ(mask.alphaCutoff, 0.7F);
    const Material blend = embedded("{" + base + R"(,"alphaMode":"BLEND"})").model.materials[0];
    EXPECT_EQ(blend.alphaTexture, 0U);
    EXPECT_EQ(blend.alphaCutoff, 0);
}

TEST_F(Textures, RoughnessAndMetalAreKept) {
    const Material m =
        embedded(R"({"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0},"roughnessFactor":0.5}})")
            .model.materials[0];
    EXPECT_EQ(m.metallicRoughnessTexture, 0U);
    EXPECT_EQ(m.roughness, 0.5F);
    EXPECT_EQ(m.metallic, 1.0F);
    EXPECT_EQ(m.diffuse, kWhite);
}

TEST_F(Textures, TransformsOfTextureCoordinatesAreApplied) {
    const ImportedModel m = embedded(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
        "extensions":{"KHR_texture_transform":{"offset":[0.25,0.5],"scale":[2,4]}}}}})");
    const Mesh& mesh = m.model.mesh;
    // (0, 0), (1, 0), (0, 1) with v down become (0.25, 0.5), (2.25, 0.5), (0.25, 4.5); v up: 1 - v.
    const Vec2 b = mesh.texcoords[mesh.shading[0].v[1]], c = mesh.texcoords[mesh.shading[0].v[2]];
    EXPECT_NEAR(b.x, 2.25F, 1e-5F);
    EXPECT_NEAR(b.y, 0.5F, 1e-5F);
    EXPECT_NEAR(c.x, 0.25F, 1e-5F);
    EXPECT_NEAR(c.y, -3.5F, 1e-5F);
}

} // namespace
