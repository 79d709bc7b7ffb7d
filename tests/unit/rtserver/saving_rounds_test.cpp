/// Scenes that are edited, saved and loaded again and again: what was saved is what is loaded, and nothing
/// grows.
#include "command_room.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/sky/scene_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

namespace rtserver {
namespace {

class SavingRounds : public test::CommandRoom {
  protected:
    void SetUp() override {
        test::SceneBuilder b;
        for (const char* name : {"wall", "floor", "twin", "twin", "", "glass*", "grass"}) {
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
        write("version = 2\nmodel = 'room.bsp'\n[camera]\neye = [0.3, 1.7, 6]\nlookAt = [0, 1.5, 0]\n"
              "[[light]]\nname = 'spot'\nkind = 'spot'\nposition = [1, 4, 1]\ndirection = [-0.2, -1, 0.1]\n"
              "intensity = [30, 28, 25]\ninnerAngle = 11\nouterAngle = 37\ntemperature = 3100\n"
              "[[light]]\nkind = 'sphere'\nposition = [-2, 3, 0]\nradius = 0.2\nintensity = [9, 9, 9]\n"
              "[[material]]\nname = 'wall'\nspecular = [0.1, 0.1, 0.1]\nshininess = 40\n"
              "[[material]]\nname = 'g*'\nopacity = 0.7\n");
    }
    void write(const std::string& text) {
        std::ofstream(folder / "0.scn") << text;
        show("0.scn");
    }
    void show(const std::string& name) {
        document.show(std::make_unique<World>(rtcore::loadScene(folder / name), folder / name,
                                              rtcore::ImportOptions()));
    }
    std::string saved(const std::string& name) {
        answer("save as DIR/" + name);
        std::ifstream in(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// Whether a command makes sense at that moment is the server's affair.
    void edit(const std::string& line) { (void)refusal(line); }
    /// A mirror that reflects nothing has any scale.
    static std::vector<rtcore::Material> materials(const rtcore::Scene& scene) {
        std::vector<rtcore::Material> all(scene.materials.begin(), scene.materials.end());
        for (rtcore::Material& each : all) {
            if (isBlack(each.mirror)) each.mirrorScale = 1;
        }
        return all;
    }
    /// All but the sun of a sky, which comes anew, and off where it was removed.
    static std::vector<rtcore::Light> lightsButTheSun(const rtcore::Scene& scene) {
        std::vector<rtcore::Light> lights = rtcore::lightsOf(scene.lights);
        if (const auto sun = rtcore::sunOf(scene))
            lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(*sun));
        return lights;
    }
    static std::ptrdiff_t count(const std::string& text, const std::string& part) {
        std::ptrdiff_t found = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
        return found;
    }
};

TEST_F(SavingRounds, GiveTheSameBytesAndTheSameScene) {
    const std::vector<std::string> kEdits = {"material set wall diffuse 0.1 0.2 0.3",
                                             "material set wall roughness 0.3",
                                             "material set wall specular 0.4 0.4 0.4",
                                             "material set wall shininess 77",
                                             "material set wall metallic 0.6",
                                             "material set twin emission 1 2 3",
                                             "material set 5 opacity 0.4",
                                             "material set floor metallic 1",
                                             "material set * flipTextures true",
                                             "material set grass roughness 0.123",
                                             "material set g* indexOfRefraction 1.4",
                                             "material set floor reflectivity 0.25",
                                             "material reset wall",
                                             "material set floor fresnel true",
                                             "part hide left",
                                             "part show 1",
                                             "part isolate right",
                                             "part hide 3",
                                             "part show-all",
                                             "light 1 toggle",
                                             "light power 1 33",
                                             "light temperature 1 2750",
                                             "light temperature 1 none",
                                             "light colour 1 1 0.5 0.2",
                                             "light add spot here",
                                             "light add rectangle here",
                                             "light copy 1 here",
                                             "light remove 2",
                                             "light kind 1 sphere",
                                             "light size 1 0.3",
                                             "light angles 1 20 50",
                                             "light mirrored 1 on",
                                             "light name 1 red",
                                             "light move 1 at 0.1 3.3 0.7",
                                             "light aim 1 at 0.7 0 0.1",
                                             "sky on",
                                             "sky hour 9.3",
                                             "sky turbidity 4.4",
                                             "sky north 33.3",
                                             "sky ground on",
                                             "sky haze on",
                                             "sky strength 0.7",
                                             "sky off",
                                             "sky place 49.2 16.6 1",
                                             "sky date 2026-03-07",
                                             "sky direction 0.3 0.7 0.2",
                                             "camera turn 7.7 3.1",
                                             "camera angle 47.3",
                                             "camera lens 33",
                                             "camera zoom 1.3",
                                             "camera reset",
                                             "bookmark add here",
                                             "bookmark add there",
                                             "bookmark rename here elsewhere",
                                             "bookmark remove there",
                                             "measure keep distance 0 0 0 0.1 3.3 0.7",
                                             "measure keep angle 1 0.3 0 0 0 0 0 1 0",
                                             "measure name 1 wide",
                                             "measure remove 1",
                                             "measure unit ft 2",
                                             "note add 0.1 0 0.7 \"a \\\"b\\\"\nc\" Ada",
                                             "note add 0 1 -2 b",
                                             "note text 2 c \"\"",
                                             "note remove 1",
                                             "units 0.3",
                                             "up +z",
                                             "up +y",
                                             "up auto",
                                             "set exposure.key 0.21",
                                             "set maxDepth 7",
                                             "set shadows false",
                                             "bloom on",
                                             "look studio",
                                             "look sky",
                                             "look headlight",
                                             "camera orthographic 0.1 2 3.3 0.2 0 -1 4.7"};
    std::mt19937 random{31415};
    for (int round = 1; round <= 60; ++round) {
        for (int i = 0; i < 4; ++i) edit(kEdits[random() % kEdits.size()]);
        const auto name = [round](const char* half) { return std::to_string(round) + half + ".scn"; };
        const std::string first = saved(name("a"));
        const auto scene = document.scene();
        show(name("a"));
        EXPECT_EQ(materials(*document.scene()), materials(*scene)) << round;
        EXPECT_EQ(lightsButTheSun(*document.scene()), lightsButTheSun(*scene)) << round;
        ASSERT_EQ(saved(name("b")), first) << round;
        for (const char* one : {"wall", "floor", "grass"})
            EXPECT_LE(count(first, std::string("[[material]]\nname = \"") + one + "\""), 1) << first;
        EXPECT_LE(count(first, "[[material]]"), 9) << first;
    }
}

TEST_F(SavingRounds, AMaterialHasOneTable) {
    for (int round = 1; round <= 5; ++round) {
        answer("material set wall roughness 0." + std::to_string(round));
        answer("material set grass emission 1 2 " + std::to_string(round));
        const std::string text = saved("a.scn");
        EXPECT_EQ(count(text, "[[material]]"), 3) << text; // wall, g*, grass
        show("a.scn");
    }
    answer("material set * opacity 0.9");
    EXPECT_EQ(count(saved("a.scn"), "[[material]]"), 8) << "one for each, and g*";
}

} // namespace
} // namespace rtserver
