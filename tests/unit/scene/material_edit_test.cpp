// Edits of materials: what they make of a scene, alone and one after the other.
#include "rtcore/scene/material_edit.h"

#include "rtcore/scene/metallic_roughness.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <optional>
#include <type_traits>

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
    template <typename Part, typename T>
    void edit(std::size_t material, std::optional<T> Part::*member, const std::type_identity_t<T>& value) {
        MaterialOverride change;
        change.*member = value;
        edit(material, change);
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
        setMetallicRoughness(m, rtcore::kWhite, 1, roughness);
        EXPECT_EQ(rtcore::roughnessOf(m), roughness);
        setPhong(m, {});
        EXPECT_FALSE(hasRoughness(m));
        EXPECT_NEAR(rtcore::roughnessOf(m), roughness, 1e-4F) << "from the shininess " << m.shininess;
    }
    EXPECT_EQ(rtcore::roughnessOf(test::matte(0.5F)), 1.0F) << "without a highlight";
}

TEST(MetallicRoughness, PhongsModelGetsTheSameColours) {
    const Colour base{0.8F, 0.4F, 0.2F};
    Material m;
    m.metallicRoughnessTexture = 0;
    setMetallicRoughness(m, base, 1, 0.4F);
    EXPECT_EQ(m.diffuse, base);
    EXPECT_EQ(m.specular, rtcore::kWhite * 0.04F);
    setPhong(m, {.diffuse = {0.5F, 0.5F, 0.25F}, .roughness = 0.5F, .metallic = 0.5F});
    EXPECT_EQ(m.diffuse, base * 0.5F);
    EXPECT_NEAR(m.specular.r, 0.5F * 0.04F + 0.5F * 0.4F, 1e-6F);
    EXPECT_NEAR(m.specular.b, 0.5F * 0.04F + 0.5F * 0.05F, 1e-6F);
    EXPECT_NEAR(m.mirrorScale, 1 - 0.2F / rtcore::kMirrorsBelow, 1e-6F);
    EXPECT_EQ(m.mirror, m.specular);
    EXPECT_EQ(m.metallicRoughnessTexture, rtcore::kNoTexture);
}

TEST_F(MaterialEdits, InAnyOrderAreTheSame) {
    edit(1, &MaterialOverride::diffuse, Colour{0.2F, 0.3F, 0.4F});
    edit(1, &MaterialOverride::roughness, 0.25F);
    edit(0, &MaterialOverride::metallic, 0.5F);
    const Scene first = scene;
    scene.materials = loaded;
    scene.materialEdits.clear();
    edit(0, &MaterialOverride::metallic, 0.5F);
    edit(1, &MaterialOverride::roughness, 0.25F);
    edit(1, &MaterialOverride::diffuse, Colour{0.2F, 0.3F, 0.4F});
    EXPECT_EQ(scene.materials, first.materials);
    EXPECT_EQ(scene.materialEdits, first.materialEdits);
    ASSERT_EQ(scene.materialEdits.size(), 2U);
    EXPECT_EQ(scene.materialEdits[0].number, 1);
    resetMaterial(scene, loaded, 1);
    resetMaterial(scene, loaded, 0);
    EXPECT_EQ(scene.materials, loaded);
    EXPECT_TRUE(scene.materialEdits.empty());
}

TEST_F(MaterialEdits, TheColourOfAMetalIsItsBaseColour) {
    edit(1, &MaterialOverride::metallic, 1.0F);
    edit(1, &MaterialOverride::roughness, 0.5F);
    edit(1, &MaterialOverride::diffuse, Colour{0.9F, 0.7F, 0.3F});
    EXPECT_EQ(scene.materials[1].diffuse, (Colour{0.9F, 0.7F, 0.3F}));
    EXPECT_EQ(scene.materials[1].metallic, 1.0F);
    EXPECT_EQ(scene.materials[1].specular, rtcore::kWhite * 0.04F);
}

TEST_F(MaterialEdits, ATexturesMeanTintsTheHighlightOfAMetal) {
    edit(0, &MaterialOverride::metallic, 1.0F);
    EXPECT_EQ(scene.materials[0].diffuse, loaded[0].diffuse) << "the texture tints each point";
    edit(0, &MaterialOverride::fresnel, true);
    EXPECT_NEAR(scene.materials[0].specular.r, 0.5F, 1e-6F) << "half of it is white, half black";
    edit(0, &MaterialOverride::textures, false);
    EXPECT_EQ(scene.materials[0].diffuseTexture, rtcore::kNoTexture);
    EXPECT_EQ(scene.materials[0].specular.r, 1.0F);
    edit(0, &MaterialOverride::textures, true);
    EXPECT_EQ(scene.materials[0].diffuseTexture, loaded[0].diffuseTexture);
    edit(0, &MaterialOverride::flipTextures, true);
    EXPECT_EQ(scene.materials[0].flipTextures, 1U);
}

TEST_F(MaterialEdits, ARoughnessIsTheSameEverywhere) {
    loaded[0].metallicRoughnessTexture = loaded[0].diffuseTexture;
    setMetallicRoughness(loaded[0], rtcore::kWhite, 1, 1);
    scene.materials = loaded;
    edit(0, &MaterialOverride::roughness, 0.25F);
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.roughness, 0.25F);
    EXPECT_NEAR(m.metallic, 0.5F, 1e-6F) << "the mean of the texture";
    EXPECT_EQ(m.metallicRoughnessTexture, rtcore::kNoTexture);
}

TEST_F(MaterialEdits, ShininessTakesThePlaceOfRoughnessAndTheOtherWayRound) {
    edit(1, &MaterialOverride::roughness, 0.1F);
    edit(1, &MaterialOverride::shininess, 7.0F);
    EXPECT_EQ(scene.materials[1].shininess, 7.0F);
    EXPECT_FALSE(hasRoughness(scene.materials[1]));
    edit(1, &MaterialOverride::roughness, 0.5F);
    EXPECT_EQ(scene.materials[1].roughness, 0.5F);
    EXPECT_FALSE(scene.materialEdits[0].shininess.has_value());
}

TEST_F(MaterialEdits, LobesThatWouldExceedOneGiveWay) {
    edit(1, &MaterialOverride::specular, Colour{0.6F, 0.6F, 0.6F});
    edit(1, &MaterialOverride::diffuse, Colour{0.9F, 0.9F, 0.9F});
    const Material& m = scene.materials[1];
    EXPECT_EQ(m.diffuse, (Colour{0.9F, 0.9F, 0.9F}));
    EXPECT_LE(maxComponent(m.diffuse + m.specular), 1.000001F);
}

/// Corners of leaves with holes are one only where they are equal; of glass with holes, up to rounding.
TEST_F(MaterialEdits, WhatBecomesGlassWithHolesIsLookedAtAnew) {
    test::SceneBuilder b;
    Material leaf = test::matte(1);
    leaf.alphaTexture = b.texture(1, 1, {{9, 9, 9, 9}});
    const std::uint32_t holes = b.material(leaf);
    for (const float side : {-1.0F, 1.0F}) {
        for (const rtcore::Vec3 n : {rtcore::Vec3{side, 0, 0}, {0, side, 0}, {0, 0, side}})
            b.square(n, n, 1, holes);
    }
    scene = b.finish();
    loaded = scene.materials;
    EXPECT_FALSE(scene.isClosed(0));
    edit(holes, &MaterialOverride::opacity, 0.5F);
    EXPECT_TRUE(scene.isClosed(0));
    edit(holes, &MaterialOverride::opacity, 1.0F);
    EXPECT_FALSE(scene.isClosed(0));
}

TEST_F(MaterialEdits, WhatBecomesGlassIsClosed) {
    EXPECT_EQ(scene.closed, nullptr);
    edit(1, &MaterialOverride::opacity, 0.1F);
    ASSERT_NE(scene.closed, nullptr);
    EXPECT_TRUE(scene.isClosed(2)) << "the box";
    EXPECT_FALSE(scene.isClosed(0)) << "the floor";
    edit(1, &MaterialOverride::opacity, 1.0F);
    EXPECT_EQ(scene.closed, nullptr);
}

} // namespace
