/// A scene after edits and the scene that is exported then show the same bits, and have a state that goes on
/// alike. RT_EDIT_STATES sets after how many random edits (check-long.sh: 200).
#include "command_room.h"

#include "common/commands/state_report.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/io/text/cosine.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/sky/scene_sky.h"
#include "rtserver/commands/state_report_of.h"
#include "rtserver/document/exports.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace rtserver {
namespace {

/// The room under a sky, with an environment map, from files.
class SavedEdits : public test::CommandRoom {
  protected:
    void SetUp() override {
        const rtcore::LoadedScene room = test::makeRoom();
        rtcore::writeBsp(folder / "room.bsp", room.scene.model, &room.tree, {});
        std::ofstream(folder / "room.scn")
            << "version = 2\nmodel = 'room.bsp'\n"
               "[camera]\neye = [1.5, 1.4, 1]\nlookAt = [0, 0.5, -3]\n"
               "[[light]]\nkind = 'sphere'\nposition = [1, 3, 1]\nradius = 0.3\nintensity = [2, 2, 2]\n"
               "[[environment]]\nequirectangular = 'a.pfm'\n"
               "[sky]\ndirection = [1, 2, 1]\n[live]\nwidth = 20\nheight = 14\nmaxDepth = 2\n";
        options.settings = {};
        show(document, folder / "room.scn");
        changes();
    }
    static void show(Document& to, const std::filesystem::path& scene) {
        to.show(std::make_unique<World>(rtcore::loadScene(scene), scene, rtcore::ImportOptions()));
    }
    int sun() const {
        const auto light = rtcore::sunOf(*document.scene());
        return light ? document.scene()->lights[*light].notes.id : 0;
    }
    static std::vector<rtcore::Colour> imageOf(const Document& shown) {
        rtcore::RenderControl control;
        rtcore::Frame frame;
        control.threads = 1;
        EXPECT_TRUE(test::renderFrame({*shown.scene(), *shown.tracer(), shown.camera(), shown.settings()},
                                      control, frame));
        return frame.radiance.pixels;
    }
    /// Another server shows the exported scene.
    void expectSaved(const std::string& after) {
        SCOPED_TRACE(after);
        rtcore::writeSceneFile(folder / "export.scn", sceneFileOf(document));
        Document other{options, [](const rtcore::RenderSettings&) {}, messages};
        show(other, folder / "export.scn");
        EXPECT_TRUE(imageOf(other) == imageOf(document));
        EXPECT_EQ(skyOf(other), skyOf(document));
        EXPECT_EQ(other.scene()->materials, document.scene()->materials);
        // A sky whose light was taken away comes back with one that is off.
        const std::optional<rtcore::Sky>& sky = document.scene()->sky;
        if (sky && !sky->studio && !rtcore::sunOf(*document.scene())) {
            EXPECT_EQ(other.scene()->lights.size(), document.scene()->lights.size() + 1);
            EXPECT_EQ(other.scene()->lights.back().light.on, 0U);
            return;
        }
        EXPECT_EQ(other.scene()->lights, document.scene()->lights);
    }
    /// As a file has it: with a date the direction says nothing.
    static std::optional<rtcore::Sky> skyOf(const Document& shown) {
        std::optional<rtcore::Sky> sky = shown.scene()->sky;
        if (sky && sky->date) sky->direction = {};
        return sky;
    }
    bool modified() const { return stateReportOf(document).modified; }
};

TEST_F(SavedEdits, EachCommandOnTheSun) {
    const std::string number = std::to_string(sun());
    const auto before = imageOf(document);
    EXPECT_EQ(document.scene()->lights[lightOf(*document.scene(), sun())].light.discSine,
              rtcore::sineOfHalf(0.53));
    expectSaved("nothing");
    for (const char* edit : {"N off", "N on", "power N 1", "colour N 1 0.5 0.2", "temperature N 3000",
                             "temperature N none", "aim N along 1 -1 -0.5", "size N 4", "N off", "N on",
                             "name N sunlight", "kind N spot", "remove N"}) {
        std::string line = "light " + std::string(edit);
        line.replace(line.find(" N") + 1, 1, number);
        document.noteSaved(folder / "room.scn", document.history().state());
        ASSERT_FALSE(modified());
        answer(line);
        EXPECT_TRUE(modified()) << line;
        expectSaved(line);
    }
    EXPECT_FALSE(imageOf(document) == before);
}

/// A model has a profile of its own, which its scenes name by number.
TEST_F(SavedEdits, LuminairesOfTheModelShineInItsScenes) {
    const rtcore::LoadedScene room = test::makeRoom();
    rtcore::Light own;
    own.kind = rtcore::LightKind::Ies;
    own.position = {1.5F, 2, -1};
    own.right = {1, 0, 0};
    own.intensity = {9, 8, 7};
    own.photometry = rtcore::keepPhotometry({{0, 30, 90}, {0, 180, 360}, {9, 8, 1, 9, 4, 1, 9, 8, 1}});
    rtcore::Model lit = room.scene.model;
    lit.lights = {&own, 1};
    rtcore::writeBsp(folder / "lit.bsp", lit, &room.tree, {});
    const std::string head = "version = 2\nmodel = 'lit.bsp'\n"
                             "[camera]\neye = [1.5, 1.4, 1]\nlookAt = [0, 0.5, -3]\n"
                             "[live]\nwidth = 20\nheight = 14\n";
    std::ofstream(folder / "lit.scn") << head;
    show(document, folder / "lit.scn");
    EXPECT_EQ(document.scene()->lights.at(0).light.photometry, own.photometry);
    const auto before = imageOf(document);
    expectSaved("nothing");
    EXPECT_NE(answer("light get 1").find("modelLuminaire = 1"), std::string::npos) << answer("light get 1");
    answer("light copy 1 at 0.5 1.5 -2");
    answer("light turn 1 70");
    expectSaved("light turn");
    EXPECT_FALSE(imageOf(document) == before);
    answer("light kind 1 point");
    EXPECT_EQ(answer("light get 1").find("modelLuminaire"), std::string::npos);
    expectSaved("light kind");

    // Without an intensity it is as bright as its profile.
    std::ofstream(folder / "own.scn") << head
                                      << "[[light]]\nkind = 'ies'\nposition = [0, 1, 0]\n"
                                         "direction = [0, -1, 0]\nmodelLuminaire = 1\n";
    const rtcore::SceneLight light = rtcore::loadScene(folder / "own.scn").scene.lights.at(0);
    EXPECT_EQ(light.light.photometry, own.photometry);
    EXPECT_NEAR(light.light.intensity.r * rtcore::kLumensPerWatt, 9, 1e-4);
    std::ofstream(folder / "gone.scn") << head
                                       << "[[light]]\nname = 'a'\nkind = 'ies'\nposition = [0, 1, 0]\n"
                                          "direction = [0, -1, 0]\nmodelLuminaire = 2\n";
    const rtcore::LoadedScene gone = rtcore::loadScene(folder / "gone.scn");
    EXPECT_EQ(gone.scene.lights.at(0).light.photometry, 0U);
    ASSERT_EQ(gone.warnings.size(), 1U);
    EXPECT_EQ(gone.warnings[0].english(),
              "the model has no luminaire 2; light 'a' shines to all sides alike");
}

TEST_F(SavedEdits, AnEditOfTheSunIsToBeSavedAndTakenBack) {
    const std::string number = std::to_string(sun());
    const auto before = document.scene();
    answer("light power " + number + " 1");
    EXPECT_TRUE(modified());
    const auto edited = document.scene()->lights;
    EXPECT_NE(edited, before->lights);
    answer("undo");
    EXPECT_FALSE(modified());
    EXPECT_EQ(document.scene()->lights, before->lights);
    answer("redo");
    EXPECT_EQ(document.scene()->lights, edited);
    expectSaved("redo");
    answer("sky hour 9"); // gives its own light back
    EXPECT_FALSE(rtcore::isSunEdited(*document.scene()));
    expectSaved("sky hour");
}

TEST_F(SavedEdits, TheSkyChangesNoOtherLightThatIsCalledSun) {
    answer("light remove " + std::to_string(sun()));
    const std::string number = answer("light add directional at 0 2 0");
    answer("light name " + number + " sun");
    const auto lights = document.scene()->lights;
    for (const char* edit : {"sky hour 9", "sky direction -1 1 0", "sky turbidity 4"}) {
        answer(edit);
        EXPECT_EQ(document.scene()->lights, lights) << edit;
        EXPECT_EQ(stateReportOf(document).sun, 0);
        expectSaved(edit);
    }
    answer("sky off");
    EXPECT_EQ(document.scene()->lights, lights);
    expectSaved("sky off");
    answer("sky on");
    EXPECT_EQ(document.scene()->lights.size(), lights.size() + 1);
    EXPECT_EQ(stateReportOf(document).sun, sun());
    EXPECT_NE(std::to_string(sun()), number);
    expectSaved("sky on");
}

TEST_F(SavedEdits, TheSunOfAFileGoesWithTheSkyOfTheFile) {
    answer("light power " + std::to_string(sun()) + " 1");
    rtcore::writeSceneFile(folder / "edited.scn", sceneFileOf(document));
    rtcore::LoadOptions evening;
    evening.lighting.sky.emplace().direction = {1, 0.1F, 0};
    evening.lighting.sky->date.reset();
    const rtcore::Scene own = rtcore::loadScene(folder / "room.scn", evening).scene;
    EXPECT_EQ(rtcore::loadScene(folder / "edited.scn", evening).scene.lights, own.lights);
    rtcore::LoadOptions map;
    map.lighting.environment = folder / "a.pfm";
    EXPECT_EQ(rtcore::loadScene(folder / "edited.scn", map).scene.lights.size(), own.lights.size() - 1);
}

/// Commands of every kind that changes what is seen, in turns of chance.
class RandomCommands {
  public:
    explicit RandomCommands(std::uint32_t seed) : random_(seed) {}
    std::string next(const rtcore::Scene& scene) {
        const std::vector<std::string> kinds = {
            "light power " + light(scene) + " " + real(0.1, 5),
            "light colour " + light(scene) + " " + real(0.1, 1) + " " + real(0.1, 1) + " " + real(0.1, 1),
            "light temperature " + light(scene) + " " + (below(3) == 0 ? "none" : real(2000, 9000)),
            "light aim " + light(scene) + " along " + vector(),
            "light size " + light(scene) + " " + real(0.1, 3),
            "light size " + light(scene) + " 1 " + real(0.1, 3),
            "light kind " + light(scene) + " " + one({"point", "directional", "spot", "sphere", "rectangle"}),
            "light name " + light(scene) + " " + one({"sun", "moon"}),
            "light remove " + light(scene),
            "light add " + one({"point", "directional", "spot", "sphere", "rectangle"}) + " at 1 2 " +
                real(-1, 1),
            "light copy " + light(scene),
            "light " + light(scene) + " toggle",
            "light move " + light(scene) + " at " + vector(),
            "light angles " + light(scene) + " 20 " + real(25, 80),
            "light mirrored " + light(scene) + " " + one({"on", "off"}),
            "sky " + one({"on", "on", "off"}),
            "sky hour " + real(7, 17),
            "sky strength " + real(0.2, 2),
            "sky direction " + vector(),
            "sky north " + real(-90, 90),
            "sky turbidity " + real(2, 9),
            "sky ground " + one({"on", "off"}),
            "sky haze " + one({"on", "off"}),
            "material set 1 diffuse " + real(0, 1) + " " + real(0, 1) + " 0.5",
            "material set 1 " + one({"roughness", "reflectivity", "opacity"}) + " " + real(0, 1),
            "material reset 1",
            "part " + one({"hide", "show"}) + " box",
            "environment " + one({"1", "2", "none", "rotation 40", "strength 0.7", "open DIR/a.pfm"}),
            "set " + one({"areaLights.samples 2", "skyLight.on true", "skyLight.on false", "shadows true",
                          "integrator path", "integrator whitted", "path.bounces 1", "maxDepth 3"}),
            "camera turn " + real(-5, 5) + " " + real(-3, 3),
            "up " + one({"+y", "+y", "+z"}),
            "units " + one({"m", "cm"}),
            "look " + one({"sky", "studio", "headlight"}),
            "undo",
            "redo",
        };
        return kinds[below(static_cast<unsigned>(kinds.size()))];
    }

  private:
    unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }
    std::string real(double low, double high) {
        return std::to_string(low + (high - low) * below(1000) / 999);
    }
    std::string vector() { return real(-1, 1) + " " + real(-2, 2) + " " + real(-1, 1); }
    std::string one(const std::vector<std::string>& words) {
        return words[below(static_cast<unsigned>(words.size()))];
    }
    /// Every other time the sun.
    std::string light(const rtcore::Scene& scene) {
        const auto sun = rtcore::sunOf(scene);
        if (scene.lights.empty()) return "1";
        const bool wanted = sun && below(2) == 0;
        const std::size_t i = wanted ? *sun : below(static_cast<unsigned>(scene.lights.size()));
        return std::to_string(scene.lights[i].notes.id);
    }
    std::mt19937 random_;
};

TEST_F(SavedEdits, OfEveryKindGiveTheSameBits) {
    const char* const wanted = std::getenv("RT_EDIT_STATES");
    const int states = wanted != nullptr ? std::atoi(wanted) : 12;
    RandomCommands commands(31415);
    for (int i = 0; i < states && !HasFailure(); ++i) {
        std::string done;
        for (int k = 0; k < 5; ++k) {
            const std::string line = commands.next(*document.scene());
            if (refusal(line).code == 0) done += line + "; ";
        }
        expectSaved(std::to_string(i) + ": " + done);
    }
}

} // namespace
} // namespace rtserver
