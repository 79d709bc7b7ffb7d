// Ready-made materials: their names, their ranges, and that none gives off more than it gets.
#include "rtcore/look/material_presets.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/scene/material_textures.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {
namespace {

bool isAlbedo(Colour c) { return std::min({c.r, c.g, c.b}) >= 0 && maxComponent(c) <= 1; }

/// Textured, coated glass that shines, of Phong's model or of roughness.
Material crowded(bool phong) {
    Material m;
    for (const auto texture : kMaterialTextures) m.*texture = 0;
    m.flipTextures = 1;
    if (!phong) setMetallicRoughness(m, {0.1F, 0.9F, 0.3F}, 0.7F, 0.9F);
    m.mirror = m.specular = {0.1F, 0.2F, 0.1F};
    m.fresnel = phong ? 1 : 0;
    m.opacity = 0.5F;
    m.transmission = {0.5F, 0.2F, 0.9F};
    m.attenuationDistance = 3;
    m.indexOfRefraction = 2;
    m.emission = {4, 5, 6};
    m.coat = phong ? 0 : 0.7F;
    m.coatRoughness = 0.9F;
    return m;
}

/// A floor of it, dressed.
Material dressed(const Material& file, const MaterialOverride& look) {
    test::SceneBuilder b;
    b.texture(1, 1, {{10, 200, 90, 80}});
    b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(file));
    Scene scene = b.finish();
    const std::vector<Material> loaded = scene.materials;
    MaterialOverride before;
    before.metallic = 0.3F;
    before.priority = 7.0F;
    editMaterial(scene, loaded, 0, before);
    giveLook(scene, loaded, 0, look);
    EXPECT_EQ(scene.materialEdits.size(), 1U);
    return scene.materials[0];
}

TEST(MaterialPresets, HaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const MaterialPreset& each : materialPresets()) {
        const std::string_view name = each.name;
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << name;
        EXPECT_EQ(&materialPresetNamed(name), &each);
        EXPECT_TRUE(each.look.pattern.empty() && !each.look.number) << name;
    }
    EXPECT_EQ(names.size(), kMaterialPresets);
}

TEST(MaterialPresets, OthersAreRefusedWithTheNearestName) {
    for (const auto& [given, why] : {std::pair{"crome", "unknown preset 'crome'; did you mean 'chrome'?"},
                                     {"clear glass", "unknown preset 'clear glass'; did you mean "
                                                     "'clear-glass'?"}}) {
        try {
            materialPresetNamed(given);
            ADD_FAILURE() << given;
        } catch (const BadValue& error) {
            EXPECT_EQ(sentenceOf(error).english(), why);
        }
    }
    EXPECT_THROW(materialPresetNamed(""), BadValue);
}

TEST(MaterialPresets, KeepTheirRangesAndConserveEnergy) {
    for (const MaterialPreset& each : materialPresets()) {
        const Material m = dressed(crowded(false), each.look);
        SCOPED_TRACE(each.name);
        EXPECT_TRUE(isAlbedo(m.diffuse) && isAlbedo(m.transmission) && isBlack(m.emission));
        for (const float part : {m.opacity, m.roughness, m.metallic, m.coat, m.coatRoughness})
            EXPECT_TRUE(part >= 0 && part <= 1) << part;
        for (const MaterialNumber& number : kMaterialNumbers)
            EXPECT_TRUE(m.*number.field >= number.minimum && m.*number.field <= number.maximum) << number.key;
        // Fresnel's reflection takes its part first; what is left is divided, so none of them adds light
        // while each part is an albedo, unless a metal lets light through.
        EXPECT_TRUE(m.metallic == 0 || m.opacity == 1);
        EXPECT_TRUE(m.metallic == 0 || m.metallic == 1) << "there is nothing between";
    }
}

TEST(MaterialPresets, ReplaceWhateverWasThere) {
    for (const MaterialPreset& each : materialPresets()) {
        SCOPED_TRACE(each.name);
        const Material plain = dressed(test::matte(0.5F), each.look);
        EXPECT_FALSE(hasTextures(plain));
        EXPECT_EQ(plain.priority, 7) << "which says nothing of the look";
        Material other = dressed(crowded(true), each.look);
        EXPECT_FALSE(hasTextures(other));
        other.flipTextures = plain.flipTextures; // of none
        EXPECT_EQ(other, plain);
    }
}

} // namespace
} // namespace rtcore
