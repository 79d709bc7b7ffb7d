// The looks of materials as a whole: copied from another one, or ready-made; taken back and kept in scenes.
#include "command_room.h"

#include "rtserver/document/exports.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/io/variants/material_words.h"
#include "rtcore/look/material_presets.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/scene/material_textures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using rtcore::Change;
using rtcore::Changes;
using rtcore::Colour;
using rtcore::Material;

class MaterialLooks : public test::CommandRoom {
  protected:
    void SetUp() override {
        test::SceneBuilder b;
        const std::uint32_t stripes = b.texture(1, 2, {{255, 255, 255, 255}, {0, 0, 0, 255}});
        const std::uint32_t grey = b.texture(1, 1, {{128, 128, 128, 255}});
        Material gloss = test::matte(0.4F), metal, glass = test::matte(0.1F), striped = test::matte(1);
        gloss.specular = {0.2F, 0.3F, 0.2F};
        gloss.shininess = 30;
        gloss.mirror = {0.1F, 0.1F, 0.2F};
        gloss.fresnel = 1;
        setMetallicRoughness(metal, {0.9F, 0.6F, 0.3F}, 1, 0.4F);
        metal.metallicRoughnessTexture = grey;
        metal.emission = {0.1F, 0, 0};
        setMetallicRoughness(glass, {}, 0, 0.3F);
        glass.opacity = 0.2F;
        glass.transmission = {0.5F, 0.9F, 0.5F};
        glass.attenuationDistance = 2;
        glass.indexOfRefraction = 1.7F;
        glass.priority = 4;
        glass.coat = 0.5F;
        striped.diffuseTexture = stripes;
        const auto add = [&](const char* name, Material m) {
            m.nameOffset = b.buffers.addName(name);
            const std::uint32_t number = b.material(m);
            b.square({static_cast<float>(number), 0, 0}, {0, 1, 0}, 0.4F, number);
        };
        add("gloss", gloss);
        add("metal", metal);
        add("glass", glass);
        add("stripes", striped);
        striped.diffuse = {0.5F, 0.5F, 1};
        add("blue stripes", striped);
        add("plain", test::matte(0.5F));
        rtcore::writeBsp(folder / "room.bsp", b.finish().model, nullptr, {});
        std::ofstream(folder / "room.scn")
            << "version = 2\nmodel = 'room.bsp'\nambient = [1, 1, 1]\n[camera]\neye = [2.5, 3, 4]\n"
               "lookAt = [2.5, 0, 0]\n[live]\nexposure.mode = 'fixed'\n";
        show("room.scn");
    }
    void show(const char* name) {
        document.show(std::make_unique<World>(rtcore::loadScene(folder / name), folder / name,
                                              rtcore::ImportOptions()));
        changes();
    }
    const Material& material(std::size_t index) const { return document.scene()->materials.at(index); }
    const Material& file(std::size_t index) const {
        return document.world().loaded.scene.materials.at(index);
    }
    /// Its words but for the name.
    std::string words(int number) {
        const std::string text = answer("material get " + std::to_string(number));
        return text.substr(text.find("\ndiffuse"));
    }
    std::vector<Colour> image() {
        FrameMaker frames(1);
        test::draw(frames, state);
        return frames.radiance().pixels;
    }
};

TEST_F(MaterialLooks, ACopySaysAllThatAMaterialSays) {
    answer("material set gloss emission 0.2 0.1 0");
    answer("material set gloss transmission 0.5 0.5 0.1");
    answer("material set glass roughness 0.6");
    const std::vector<Material> before = document.scene()->materials;
    for (const int from : {1, 3, 6}) {
        for (const char* const first : {"", "material set * metallic 1", "material set * shininess 9"}) {
            for (const int to : {1, 2, 3, 4, 6}) {
                if (from == to) continue;
                const std::string onto = std::to_string(to);
                if (*first != 0) answer("material set " + onto + std::string(first).substr(14));
                answer("material copy " + std::to_string(from) + ' ' + onto);
                Material wanted = material(static_cast<std::size_t>(from) - 1);
                wanted.nameOffset = material(static_cast<std::size_t>(to) - 1).nameOffset;
                EXPECT_TRUE(rtcore::looksAs(material(static_cast<std::size_t>(to) - 1), wanted))
                    << from << " to " << to << ' ' << first << words(from) << words(to);
                answer("undo");
                if (*first != 0) answer("undo");
            }
        }
    }
    EXPECT_EQ(document.scene()->materials, before);
}

TEST_F(MaterialLooks, ACopyHasTheMeansOfImages) {
    answer("material copy stripes plain");
    EXPECT_NEAR(material(5).diffuse.r, 0.5F, 1e-6F) << "half of them is white, half black";
    EXPECT_FALSE(hasTextures(material(5)));
    answer("material copy stripes gloss");
    EXPECT_FALSE(hasRoughness(material(0)));
    answer("material copy metal plain");
    EXPECT_NEAR(material(5).roughness, 0.4F * 128 / 255, 1e-3F);
    EXPECT_NEAR(material(5).metallic, 128.0F / 255, 1e-3F);
    EXPECT_EQ(material(5).emission, (Colour{0.1F, 0, 0}));
    answer("material copy plain stripes");
    EXPECT_FALSE(hasTextures(material(3))) << "which hide what is copied";
}

TEST_F(MaterialLooks, ACopyKeepsTexturesThatBothHave) {
    answer("material set 5 flipTextures true");
    answer("material copy 5 stripes");
    EXPECT_EQ(material(3).diffuseTexture, file(3).diffuseTexture);
    EXPECT_EQ(material(3).flipTextures, 1U);
    EXPECT_EQ(material(3).diffuse, file(4).diffuse);
}

TEST_F(MaterialLooks, ACopyIsOneStepHoweverManyItIsFor) {
    const std::vector<Colour> first = image();
    changes();
    answer("material copy gl* plain blue* 1");
    EXPECT_EQ(changes(), Changes{Change::Material});
    EXPECT_EQ(answer("materials"),
              "1 - gloss\n2 - metal\n3 - glass\n4 - stripes\n5 edited blue stripes\n6 edited plain")
        << "gloss is the first that fits, and stays";
    EXPECT_NE(image(), first);
    answer("undo");
    EXPECT_TRUE(document.scene()->materialEdits.empty());
    EXPECT_EQ(image(), first);
    EXPECT_EQ(refusal("material copy gloss plain tin").text,
              "no material of the model is 'tin'; 'materials' lists them");
    EXPECT_TRUE(document.scene()->materialEdits.empty()) << "nothing is done by halves";
    answer("material copy gloss gloss");
    EXPECT_TRUE(document.scene()->materialEdits.empty());
}

TEST_F(MaterialLooks, PresetsAreTakenBackToTheFirstBits) {
    answer("material set stripes diffuse 0.2 0.9 0.3");
    answer("material set glass priority 9");
    const std::vector<Colour> first = image();
    const std::vector<Material> before = document.scene()->materials;
    const auto edits = document.scene()->materialEdits;
    std::string names;
    for (const rtcore::MaterialPreset& each : rtcore::materialPresets()) {
        SCOPED_TRACE(each.name);
        names.append(names.empty() ? "" : "\n").append(each.name);
        answer(std::string("material preset * ") + each.name);
        for (const Material& m : document.scene()->materials) {
            EXPECT_FALSE(hasTextures(m));
            EXPECT_EQ(m.diffuse, each.look.diffuse);
            EXPECT_EQ(m.roughness, each.look.roughness);
        }
        EXPECT_EQ(material(2).priority, 9) << "not of the look";
        EXPECT_NE(image(), first);
        answer("undo");
        EXPECT_EQ(image(), first);
        EXPECT_EQ(document.scene()->materials, before);
        EXPECT_EQ(document.scene()->materialEdits, edits);
    }
    EXPECT_EQ(answer("material presets"), names);
    EXPECT_EQ(refusal("material preset gloss marbel").text,
              "unknown preset 'marbel'; did you mean 'marble'?");
    EXPECT_EQ(refusal("material preset tin gold").code, 2);
}

TEST_F(MaterialLooks, AreInAWrittenScene) {
    for (const char* const edit :
         {"material preset stripes clear-glass", "material preset gloss marble", "material copy glass metal",
          "material copy stripes plain", "material preset glass gold"})
        answer(edit);
    const std::vector<Material> edited = document.scene()->materials;
    const std::vector<Colour> whole = image();
    answer("export scene DIR/e.scn");
    show("e.scn");
    EXPECT_EQ(document.scene()->materials, edited);
    EXPECT_EQ(image(), whole);
}

} // namespace
} // namespace rtserver
