// Edits of materials: what they make of a scene, alone and one after the other.
#include "rtcore/scene/material_edit.h"

#include "rtcore/scene/metallic_roughness.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using rtcore::Colour;
using rtcore::Material;
using rtcore::MaterialOverride;
using rtcore::Scene;

class MaterialEdits : public testing::Test {
  protected:
    MaterialEdits() {
        test::SceneBuilder b;
        Material textured = test::matte(1);
        textured.diffuseTexture = b.texture(1, 2, {{255, 255, 255, 255}, {0, 0, 0, 255}});
        const std::uint32_t wood = b.material(textured);
        const std::uint32_t plain = b.material(test::matte(0.5F));
        b.square({0, 0, 0}, {0, 1, 0}, 10, wood);
        b.box({-1, 0, -1}, {1, 2, 1}, plain);
        scene = b.finish();
        loaded = scene.materials;
    }
    void edit(std::size_t material, const MaterialOverride& change) {
        const std::vector<Material> before = scene.materials;
        editMaterial(scene, loaded, material, change);
        closeSurfaces(scene, before);
    }

    Scene scene;
    std::vector<Material> loaded;
};

TEST(MetallicRoughness, ShininessAndRoughnessAreInverse) {
    for (const float roughness : {0.05F, 0.2F, 0.5F, 0.9F}) {
        Material m;
        rtcore::setReflection(m, {0.5F, 0.5F, 0.5F}, roughness);
        EXPECT_NEAR(rtcore::roughnessOf(m), roughness, 1e-4F) << "from the shininess " << m.shininess;
    }
    EXPECT_EQ(rtcore::roughnessOf(test::matte(0.5F)), 1.0F) << "without a highlight";
}

TEST(MetallicRoughness, TheBaseColourIsFoundAgain) {
    const Colour base{0.8F, 0.4F, 0.2F}, mean{0.5F, 0.5F, 0.25F};
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
        Material m;
        setMetallicRoughness(m, base, mean, metallic, 0.4F);
        const Colour found = baseColourOf(m, mean);
        EXPECT_NEAR(found.r, base.r, 1e-6F);
        EXPECT_NEAR(found.g, base.g, 1e-6F);
        EXPECT_NEAR(found.b, base.b, 1e-6F);
    }
}

TEST_F(MaterialEdits, InAnyOrderAreTheSame) {
    edit(1, {.diffuse = Colour{0.2F, 0.3F, 0.4F}});
    edit(1, {.roughness = 0.25F});
    edit(0, {.metallic = 0.5F});
    const Scene first = scene;
    scene.materials = loaded;
    scene.materialEdits.clear();
    edit(0, {.metallic = 0.5F});
    edit(1, {.roughness = 0.25F});
    edit(1, {.diffuse = Colour{0.2F, 0.3F, 0.4F}});
    EXPECT_EQ(scene.materials, first.materials);
    EXPECT_EQ(scene.materialEdits, first.materialEdits);
    ASSERT_EQ(scene.materialEdits.size(), 2U);
    EXPECT_EQ(scene.materialEdits[0].number, 1);
    resetMaterial(scene, loaded, 1);
    resetMaterial(scene, loaded, 0);
    EXPECT_EQ(scene.materials, loaded);
    EXPECT_TRUE(scene.materialEdits.empty());
}

TEST_F(MaterialEdits, TheColourOfAMetalIsThatOfItsReflection) {
    edit(1, {.metallic = 1.0F});
    edit(1, {.roughness = 0.5F});
    edit(1, {.diffuse = Colour{0.9F, 0.7F, 0.3F}});
    EXPECT_EQ(scene.materials[1].diffuse, Colour{});
    EXPECT_EQ(scene.materials[1].specular, (Colour{0.9F, 0.7F, 0.3F}));
    edit(1, {.metallic = 0.0F});
    EXPECT_EQ(scene.materials[1].diffuse, (Colour{0.9F, 0.7F, 0.3F}));
}

TEST_F(MaterialEdits, ATexturesMeanTintsAMetal) {
    edit(0, {.metallic = 1.0F});
    EXPECT_NEAR(scene.materials[0].specular.r, 0.5F, 1e-6F) << "half of it is white, half black";
    edit(0, {.textures = false});
    EXPECT_EQ(scene.materials[0].diffuseTexture, rtcore::kNoTexture);
    EXPECT_EQ(scene.materials[0].specular.r, 1.0F);
    edit(0, {.textures = true});
    EXPECT_EQ(scene.materials[0].diffuseTexture, loaded[0].diffuseTexture);
    edit(0, {.flipTextures = true});
    EXPECT_EQ(scene.materials[0].flipTextures, 1U);
}

TEST_F(MaterialEdits, ShininessTakesThePlaceOfRoughnessAndTheOtherWayRound) {
    edit(1, {.roughness = 0.1F});
    edit(1, {.shininess = 7.0F});
    EXPECT_EQ(scene.materials[1].shininess, 7.0F);
    edit(1, {.roughness = 0.5F});
    EXPECT_FLOAT_EQ(scene.materials[1].shininess, 7.5F);
    EXPECT_FALSE(scene.materialEdits[0].shininess.has_value());
}

TEST_F(MaterialEdits, LobesThatWouldExceedOneGiveWay) {
    edit(1, {.specular = Colour{0.6F, 0.6F, 0.6F}});
    edit(1, {.diffuse = Colour{0.9F, 0.9F, 0.9F}});
    const Material& m = scene.materials[1];
    EXPECT_EQ(m.diffuse, (Colour{0.9F, 0.9F, 0.9F}));
    EXPECT_LE(maxComponent(m.diffuse + m.specular), 1.000001F);
}

TEST_F(MaterialEdits, WhatBecomesGlassIsClosed) {
    EXPECT_EQ(scene.closed, nullptr);
    edit(1, {.opacity = 0.1F});
    ASSERT_NE(scene.closed, nullptr);
    EXPECT_TRUE(scene.isClosed(2)) << "the box";
    EXPECT_FALSE(scene.isClosed(0)) << "the floor";
    edit(1, {.opacity = 1.0F});
    EXPECT_EQ(scene.closed, nullptr);
}

} // namespace
