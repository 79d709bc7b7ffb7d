/// Variants: kept, switched, undone, saved, packed, and opened again with the same images.
#include "command_room.h"

#include "rtserver/document/exports.h"
#include "rtserver/document/variant_edits.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/sky/scene_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace rtserver {
namespace {

class VariantCommands : public test::CommandRoom {
  protected:
    void SetUp() override {
        test::SceneBuilder b;
        for (const char* name : {"wall", "floor", "twin", "twin", "", "glass*"}) {
            rtcore::Material paint = test::matte(0.5F);
            paint.nameOffset = b.buffers.addName(name);
            paint.specular = {0.2F, 0.2F, 0.2F};
            paint.shininess = 12;
            const std::uint32_t number = b.material(paint);
            b.square({static_cast<float>(number), 0, 0}, {0, 1, 0}, 0.4F, number);
        }
        b.buffers.parts = {{b.buffers.addName("left"), 0, 2},
                           {b.buffers.addName("right"), 4, 2},
                           {b.buffers.addName("*odd"), 6, 2}};
        rtcore::writeBsp(folder / "room.bsp", b.finish().model, nullptr, {});
        open("");
    }
    void open(const std::string& more) {
        const bool key = more.starts_with("active");
        std::ofstream(folder / "0.scn")
            << "version = 2\nmodel = 'room.bsp'\n"
            << (key ? more.substr(0, more.find('\n') + 1) : "")
            << "[camera]\neye = [2.5, 1.7, 4]\nlookAt = [2.5, 0, 0]\n"
               "[[light]]\nid = 1\nname = 'spot'\nkind = 'spot'\nposition = [1, 4, 1]\n"
               "direction = [-0.2, -1, 0.1]\nintensity = [30, 28, 25]\ninnerAngle = 11\nouterAngle = 37\n"
               "temperature = 3100\n"
               "[[light]]\nid = 2\nkind = 'sphere'\nposition = [4, 3, 0]\nradius = 0.2\nintensity = [9, 9, "
               "9]\n"
               "[[material]]\nname = 'wall'\nspecular = [0.1, 0.1, 0.1]\nshininess = 40\n"
            << more.substr(key ? more.find('\n') + 1 : 0);
        show(document, "0.scn");
    }
    void show(Document& into, const std::string& name) {
        into.show(std::make_unique<World>(rtcore::loadScene(folder / name), folder / name,
                                          rtcore::ImportOptions()));
    }
    const rtcore::SceneVariant& variant(const std::string& name) const {
        return *rtcore::findVariant(document.variants().all, name);
    }
    rtcore::Colour floorColour() const { return document.scene()->materials.at(1).diffuse; }
    bool leftIsHidden() const { return document.scene()->hiddenParts != nullptr; }
    /// Of an own frame maker, which keeps no light of other frames.
    static std::vector<rtcore::Colour> imageOf(const Workspace& of) {
        FrameMaker frames(1);
        test::draw(frames, of);
        return frames.radiance().pixels;
    }
    std::vector<rtcore::Colour> image() const { return imageOf(state); }
    std::string why(const std::string& line) { return refusal(line).text; }
    static Workspace& other(VariantCommands& room, std::unique_ptr<Workspace>& opened) {
        opened = std::make_unique<Workspace>(
            room.options, [](const rtcore::RenderSettings&) {}, room.messages);
        return *opened;
    }
    const std::string& anyOf(const std::vector<std::string>& lines) {
        return lines[static_cast<std::size_t>(random() % lines.size())];
    }

    std::mt19937 random{31};
};

const std::vector<std::string> kVariantEdits = {"material set wall diffuse 0.1 0.2 0.3",
                                                "material set floor roughness 0.3",
                                                "material set wall shininess 77",
                                                "material set 3 metallic 0.6",
                                                "material set twin emission 1 2 3",
                                                "material set 5 opacity 0.4",
                                                "material reset floor",
                                                "material set floor diffuse 0.7 0.1 0.1",
                                                "part hide left",
                                                "part show 1",
                                                "part isolate right",
                                                "part hide 3",
                                                "part show-all",
                                                "light 1 toggle",
                                                "light power 1 33",
                                                "light temperature 1 2750",
                                                "light colour 2 1 0.5 0.2",
                                                "light add spot here",
                                                "light remove 3",
                                                "light move 2 at 3 3.3 0.7",
                                                "light kind 2 rectangle",
                                                "sky on",
                                                "sky hour 9.3",
                                                "sky strength 0.7",
                                                "sky ground on",
                                                "sky off",
                                                "look sky",
                                                "look studio"};

const std::vector<std::string> kVariantSwitches = {"variant go a",  "variant go b",     "variant go c",
                                                   "variant leave", "variant add a",    "variant add b",
                                                   "variant add c", "variant update",   "variant update b",
                                                   "variant go a",  "variant remove c", "variant rebase"};

TEST_F(VariantCommands, KeepWhatDiffersFromTheBase) {
    answer("material set floor diffuse 0.4 0.2 0.1");
    answer("part hide left");
    answer("light power 2 50");
    EXPECT_EQ(answer("variant add oak"), "");
    EXPECT_EQ(answer("variant list"), "on oak");
    const rtcore::SceneVariant& oak = variant("oak");
    ASSERT_EQ(oak.materials.size(), 1U);
    EXPECT_EQ(oak.materials[0].pattern, "floor");
    EXPECT_EQ(oak.parts.size(), 1U);
    ASSERT_EQ(oak.lights.size(), 1U);
    EXPECT_EQ(oak.lights[0].id, 2);
    EXPECT_FALSE(oak.surroundings);
    EXPECT_NE(answer("variant get oak").find("[[variant.material]]\nname = \"floor\"\n"), std::string::npos);
}

TEST_F(VariantCommands, GiveBackWhatTheNextOneDoesNotMention) {
    const auto base = image();
    const rtcore::Colour grey = floorColour();
    answer("material set floor diffuse 0.4 0.2 0.1");
    answer("part hide left");
    answer("variant add oak");
    const auto oak = image();
    answer("variant leave");
    EXPECT_EQ(image(), base);
    answer("light 1 off");
    answer("variant add dark");
    answer("variant go oak");
    EXPECT_EQ(image(), oak);
    answer("variant go dark");
    EXPECT_EQ(floorColour(), grey);
    EXPECT_FALSE(leftIsHidden());
    EXPECT_FALSE(lightIsOn(0));
    answer("variant leave");
    EXPECT_EQ(image(), base);
    EXPECT_EQ(answer("variant list"), "off oak\noff dark");
}

TEST_F(VariantCommands, LeaveEditsOfOtherThingsAndTakeThemUpWhenTold) {
    answer("material set floor diffuse 0.4 0.2 0.1");
    answer("variant add oak");
    answer("material set wall diffuse 0.1 0.2 0.3");
    answer("material set floor diffuse 0.2 0.1 0.1");
    answer("variant update");
    EXPECT_EQ(variant("oak").materials.size(), 1U) << "the wall is none of its things";
    answer("variant leave");
    EXPECT_EQ(document.scene()->materials[0].diffuse, (rtcore::Colour{0.1F, 0.2F, 0.3F}));
    answer("variant go oak");
    EXPECT_EQ(floorColour(), (rtcore::Colour{0.2F, 0.1F, 0.1F}));
    answer("variant add oak");
    EXPECT_EQ(variant("oak").materials.size(), 2U);
    answer("variant rebase");
    EXPECT_EQ(why("variant add none").find("nothing differs"), 0U);
}

TEST_F(VariantCommands, SwitchSkiesAndLights) {
    answer("look sky");
    answer("variant add day");
    ASSERT_TRUE(variant("day").surroundings);
    EXPECT_TRUE(variant("day").surroundings->sky);
    EXPECT_EQ(variant("day").removedLights, std::vector<int>{2}) << "the sky's light is number 1 there";
    const rtcore::RenderSettings exposed = document.settings();
    const auto day = image();
    answer("variant leave");
    EXPECT_FALSE(document.settings().skyLight.on);
    EXPECT_EQ(document.scene()->lights.size(), 2U);
    document.setSettings(exposed); // of which variants have but the light of the sky
    answer("variant go day");
    EXPECT_EQ(image(), day);
    answer("undo");
    EXPECT_FALSE(document.scene()->sky);
    EXPECT_EQ(document.scene()->lights.size(), 2U);
}

TEST_F(VariantCommands, AreRenamedAndRemoved) {
    answer("light 1 off");
    answer("variant add a");
    answer("light 2 off");
    answer("variant add b");
    EXPECT_NE(why("variant rename a b").find("another variant is called 'b'"), std::string::npos);
    answer("variant rename b \"by night\"");
    EXPECT_EQ(answer("variant list"), "off a\non by night");
    answer("variant remove \"by night\"");
    EXPECT_FALSE(lightIsOn(1)) << "what is shown stays";
    EXPECT_EQ(answer("variant list"), "off a");
    answer("undo");
    EXPECT_EQ(answer("variant list"), "off a\non by night");
    for (std::size_t i = document.variants().all.size(); i < rtcore::kMaxVariants; ++i)
        answer("variant add " + std::to_string(i));
    EXPECT_NE(why("variant add more").find("100 variants already"), std::string::npos);
}

TEST_F(VariantCommands, AreShownAsTheFileSays) {
    const std::string variant = "[[variant]]\nname = 'oak'\n[[variant.material]]\nname = 'floor'\n"
                                "diffuse = [0.4, 0.2, 0.1]\n[[variant.part]]\nname = 'left'\nhidden = true\n"
                                "[[variant.part]]\nname = 'chair'\nhidden = true\n";
    open("activeVariant = 'oak'\n" + variant);
    EXPECT_EQ(floorColour(), (rtcore::Colour{0.4F, 0.2F, 0.1F}));
    EXPECT_TRUE(leftIsHidden());
    ASSERT_EQ(document.world().loaded.warnings.size(), 1U);
    EXPECT_NE(document.world().loaded.warnings[0].english().find("named like \"chair\""), std::string::npos);
    answer("variant leave");
    EXPECT_EQ(floorColour(), (rtcore::Colour{0.5F, 0.5F, 0.5F}));
    EXPECT_FALSE(leftIsHidden());
}

/// Edits and switches, some taken back; all taken back, the image has the bits of the first. RT_EDITS sets
/// how many (check-long.sh: 1,000, under sanitizers).
TEST_F(VariantCommands, TakenBackGiveTheFirstImage) {
    const char* const wanted = std::getenv("RT_EDITS");
    const int edits = wanted != nullptr ? std::atoi(wanted) : 200;
    const auto first = image();
    const auto scene = document.scene();
    int done = 0;
    for (int i = 0; i < edits; ++i) {
        const std::string& line = random() % 2 == 0 ? anyOf(kVariantEdits) : anyOf(kVariantSwitches);
        done += refusal(line).text.empty() ? 1 : 0;
        if (random() % 5 == 0) (void)refusal("undo");
        if (random() % 9 == 0) (void)refusal("redo");
    }
    EXPECT_GT(2 * done, edits);
    while (document.history().last() != nullptr) answer("undo");
    EXPECT_EQ(document.scene()->materials, scene->materials);
    EXPECT_EQ(document.scene()->lights, scene->lights);
    EXPECT_TRUE(document.variants().all.empty());
    EXPECT_EQ(image(), first);
}

/// Without a step back: whatever was switched, the base is the base, and each variant what it was.
TEST_F(VariantCommands, SwitchedGiveTheSameImages) {
    answer("material set wall roughness 0.3");
    answer("variant rebase");
    std::vector<std::vector<rtcore::Colour>> images{image()};
    answer("light colour 2 1 0.5 0.2");
    answer("part hide left");
    answer("variant add a");
    images.push_back(image());
    answer("variant leave");
    answer("material reset wall");
    answer("sky on");
    answer("sky hour 15");
    answer("light add sphere here");
    answer("variant add b");
    images.push_back(image());
    answer("variant leave");
    answer("light remove 1");
    answer("material set 5 opacity 0.4");
    answer("material set 4 diffuse 0.9 0.1 0.1");
    answer("variant add c");
    images.push_back(image());
    const std::vector<std::string> lines{"variant leave", "variant go a", "variant go b", "variant go c"};
    for (int i = 0; i < 100; ++i) {
        const auto which = static_cast<std::size_t>(random() % lines.size());
        answer(lines[which]);
        if (i % 10 != 0) continue;
        EXPECT_EQ(image(), images[which]) << lines[which] << " in round " << i;
    }
}

/// What is saved after random edits shows the same when it is opened, and so do its variants.
TEST_F(VariantCommands, AreSavedAndOpenedElsewhere) {
    for (int round = 0; round < 8; ++round) {
        for (int i = 0; i < 12; ++i)
            (void)refusal(random() % 2 == 0 ? anyOf(kVariantEdits) : anyOf(kVariantSwitches));
        const std::string name = std::to_string(round);
        std::filesystem::remove_all(folder / name);
        answer("save as DIR/" + name + ".scn replace");
        answer("pack DIR/" + name);
        const std::filesystem::path packed = name + "/" + name + ".scn";
        std::unique_ptr<Workspace> opened;
        Workspace& there = other(*this, opened);
        show(there.document, packed.string());
        EXPECT_EQ(there.document.variants().all, document.variants().all) << round;
        EXPECT_EQ(there.document.variants().active, document.variants().active);
        EXPECT_EQ(imageOf(there), image()) << round;
        for (const rtcore::SceneVariant& each : document.variants().all) {
            goToVariant(document, each.name);
            goToVariant(there.document, each.name);
            EXPECT_EQ(imageOf(there), image()) << round << each.name;
        }
    }
}

} // namespace
} // namespace rtserver
