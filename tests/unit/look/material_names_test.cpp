// Guesses of materials by their names.
#include "rtcore/look/material_names.h"

#include "rtcore/scene/material_edit.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rtcore {
namespace {

/// With a part of each material, which has that name.
Scene sceneOf(const std::vector<std::string>& names) {
    test::SceneBuilder b;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Material paint = test::matte(0.5F);
        paint.nameOffset = b.buffers.addName(names[i]);
        b.square({2 * static_cast<float>(i), 0, 0}, {0, 0, 1}, 1, b.material(paint));
    }
    return b.finish();
}

std::string kindOf(const std::string& name) {
    const std::vector<MaterialGuess> guesses = guessMaterials(sceneOf({"wall", name}));
    if (guesses.empty()) return "";
    EXPECT_EQ(guesses.size(), 1U) << name;
    EXPECT_EQ(guesses[0].change.number, 2);
    return guesses[0].kind;
}

TEST(MaterialNames, AreKnownInTheLanguagesOfExporters) {
    for (const char* const name : {"glass", "Glass_01", "Fensterglas", "verre", "Vidrio templado", "vetro",
                                   "sklo", "szk\xC5\x82o", "windowGlass", "GLAS", "Mat.001 glazing"})
        EXPECT_EQ(kindOf(name), "glass") << name;
    for (const char* const name : {"water", "Wasser", "pool-water", "eau", "\xC3\xA1gua", "voda"})
        EXPECT_EQ(kindOf(name), "water") << name;
    for (const char* const name : {"chrome", "Chrom matt", "cromo"})
        EXPECT_EQ(kindOf(name), "chrome") << name;
    for (const char* const name : {"Edelstahl", "steel_brushed", "acier", "hlin\xC3\xADk", "Inox", "messing"})
        EXPECT_EQ(kindOf(name), "metal") << name;
    for (const char* const name : {"parquet", "Parkett Eiche", "podlaha parkety", "M\xC3\xA1rmol",
                                   "dla\xC5\xBE"
                                   "ba"})
        EXPECT_EQ(kindOf(name), "polished") << name;
    EXPECT_EQ(kindOf("Spiegel"), "mirror");
    EXPECT_EQ(kindOf("CarPaint red"), "") << "two words";
    EXPECT_EQ(kindOf("carpaint"), "lacquer");
}

TEST(MaterialNames, OtherWordsMeanNothing) {
    for (const char* const name : {"", "wall", "Material.007", "glasses", "waterfall", "beauty", "metallicum",
                                   "tileset", "black", "flak", "frame", "Douglas fir", "textile", "crystal",
                                   "placard", "Glaswolle", "plateau", "\xD1\x81\xD1\x82\xD0\xB5", "\xC5"})
        EXPECT_EQ(kindOf(name), "") << name;
}

TEST(MaterialNames, CountOnlyWhereTheFileHasColoursAlone) {
    EXPECT_EQ(guessMaterials(sceneOf({"glass", "chrome", "wood"})).size(), 2U);
    for (int which = 0; which < 4; ++which) {
        Scene scene = sceneOf({"glass", "chrome", "wood"});
        Material& own = scene.materials[2];
        if (which == 0) own.opacity = 0.5F;
        if (which == 1) own.mirror = {0.2F, 0.2F, 0.2F};
        if (which == 2) own.emission = {1, 1, 1};
        if (which == 3) own.shininess = 70;
        EXPECT_TRUE(guessMaterials(scene).empty()) << which;
    }
}

TEST(MaterialNames, AreEditsThatCanBeTakenBack) {
    Scene scene = sceneOf({"glass", "wall", "Stahl"});
    const std::vector<Material> files = scene.materials;
    const std::vector<MaterialGuess> guesses = guessMaterials(scene);
    EXPECT_EQ(guessedText(guesses).english(), "2 materials are guessed by name (glass, metal)");
    useGuesses(scene, guesses);
    EXPECT_EQ(scene.materialEdits.size(), 2U);
    EXPECT_EQ(scene.materials[0].opacity, 0);
    EXPECT_EQ(scene.materials[1], files[1]);
    EXPECT_EQ(scene.materials[2].metallic, 1);
    for (const std::size_t i : {0U, 2U}) resetMaterial(scene, files, i);
    EXPECT_EQ(scene.materials, files);
    EXPECT_TRUE(scene.materialEdits.empty());
    EXPECT_EQ(guessedText({}).english(), "");
}

} // namespace
} // namespace rtcore
