/// Save, Save as and Pack, from the first edit to the image of the file that was saved.
#include "process/server/live_server.h"

#include "common/commands/state_report.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/io/text/scn.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <random>

#include <sys/resource.h>

namespace {

using namespace test;
namespace fs = std::filesystem;

/// Fixture: a scene with lights, materials, a texture, an environment, fog and stills of its own, of a model
/// with a material library and a texture.
class SavedScene : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        fs::create_directories(folder() / "in/textures");
        rtcore::writeImage(folder() / "in/textures/wall.png", squares({200, 60, 40, 255}));
        rtcore::writeImage(folder() / "in/tile.png", squares({40, 60, 200, 255}));
        rtcore::writeHdrImage(folder() / "sky.hdr", rtcore::HdrImage(8, 4, {0.3F, 0.5F, 0.9F}));
        writeText(folder() / "in/room.mtl", "newmtl wall\nKd 0.8 0.8 0.8\nmap_Kd textures/wall.png\n"
                                            "newmtl floor\nKd 0.5 0.5 0.5\n");
        writeText(folder() / "in/room.obj",
                  "mtllib room.mtl\nv -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nv 4 5 -4\nv -4 5 -4\n"
                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl floor\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
                  "usemtl wall\nf 1/1 2/2 5/3\nf 1/1 5/3 6/4\n");
        writeText(
            folder() / "room.scn",
            "# by hand\nversion = 1\nmodel = 'in/room.obj'\nambient = [0.05, 0.05, 0.06]\n"
            "[camera]\neye = [0, 1.7, 6]\nlookAt = [0, 1.5, 0]\n"
            "[[light]]\nname = 'spot'\nkind = 'spot'\nposition = [1, 4, 1]\ndirection = [-0.2, -1, 0.1]\n"
            "intensity = [30, 28, 25]\ninnerAngle = 11\nouterAngle = 37\n"
            "[[light]]\nkind = 'sphere'\nposition = [-2, 3, 0]\nradius = 0.2\nintensity = [9, 9, 9]\n"
            "[[light]]\nname = 'sun'\nkind = 'directional'\ndirection = [0.3, -1, -0.2]\n"
            "[[material]]\nname = 'floor'\ndiffuseTexture = 'in/tile.png'\nreflectivity = 0.2\n"
            "[[environment]]\nname = 'day'\nequirectangular = 'sky.hdr'\nintensity = 0.7\n"
            "[fog]\nkind = 'homogeneous'\ndensity = 0.03\n"
            "[still]\nmaxDepth = 4\n[live]\nmaxDepth = 4\n");
    }
    static rtcore::LdrImage squares(rtcore::Rgba8 colour) {
        rtcore::LdrImage image(4, 4);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = i % 3 == 0 ? colour : rtcore::Rgba8{90, 90, 90, 255};
        return image;
    }
    /// As a user would, by several commands.
    void edit() {
        for (const Names& words :
             {Names{"set", "exposure.mode", "fixed"}, Names{"set", "exposure.value", "0.6"},
              Names{"set", "antialiasing", "2"}, Names{"light", "3", "off"},
              Names{"camera", "look-at", "0.3", "1.9", "5.7", "0.1", "1.3", "0.2", "63"},
              Names{"units", "0.9"}, Names{"bookmark", "add", "by the door"}})
            ask(words);
    }
    std::string shot(const std::string& file) {
        ask({"wait-idle"});
        ask({"screenshot", file});
        return bytes(file);
    }
    app::StateReport state() const { return app::parseStateReport(ask({"state"})); }
    /// Its live settings are the stills', too.
    std::string rendered(const std::string& scene, const Names& options = {}) const {
        Names words{scene, "-w", "64", "-h", "48", "-o", "still.png", "--force"};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult result = renderer(words, {.folder = folder().path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return bytes("still.png");
    }
};

TEST_F(SavedScene, GivesTheSameBitsWhenItIsOpenedAgain) {
    start({}, "room.scn");
    const std::string before = shot("before.png");
    edit();
    const app::StateReport shown = state();
    EXPECT_TRUE(shown.modified);
    const std::string image = shot("a.png");
    EXPECT_NE(image, before);
    fs::create_directory(folder() / "other");
    EXPECT_EQ(ask({"save", "as", "other/b.scn"}), (folder() / "other/b.scn").string() + "\n");
    EXPECT_FALSE(state().modified);
    EXPECT_EQ(ask({"scene"}), (folder() / "other/b.scn").string() + "\n");
    ask({"exit"});
    EXPECT_TRUE(rendered("other/b.scn") == image);
    start({}, "other/b.scn");
    EXPECT_TRUE(shot("b.png") == image);
    app::StateReport again = state();
    EXPECT_FALSE(again.modified);
    EXPECT_EQ(again.bookmarks, (Names{"by the door"}));
    EXPECT_EQ(again.camera, shown.camera);
    EXPECT_EQ(again.settings, shown.settings);
    EXPECT_EQ(again.lights, shown.lights);
    EXPECT_EQ(again.metresPerUnit, shown.metresPerUnit);
    ask({"camera", "turn", "40", "0"});
    ask({"bookmark", "go", "by the door"});
    EXPECT_TRUE(shot("c.png") == image);
}

TEST_F(SavedScene, ManyEditsGiveTheSameBits) {
    start({}, "room.scn");
    edit();
    std::mt19937 random{27182};
    const auto one = [&](int max) { return std::to_string(1 + random() % static_cast<unsigned>(max)); };
    std::string script;
    for (int i = 0; i < 150; ++i) {
        const std::vector<std::string> choices = {"light " + one(3) + " toggle",
                                                  "set maxDepth " + one(5),
                                                  "set antialiasing " + one(2),
                                                  "set exposure.value 0." + one(9),
                                                  "set shadows " +
                                                      std::string(random() % 2 == 0 ? "true" : "false"),
                                                  "bloom " + std::string(random() % 2 == 0 ? "on" : "off"),
                                                  "camera turn " + one(5) + " -0." + one(9),
                                                  "camera angle " + std::to_string(40 + random() % 50),
                                                  "camera zoom 1." + one(3),
                                                  "units 0." + one(9),
                                                  "bookmark add b" + one(4),
                                                  "bookmark go b" + one(1),
                                                  "undo"};
        script += (i == 0 ? std::string("bookmark add b1") : choices[random() % choices.size()]) + '\n';
        if (i == 100) script += "save as many.scn\n"; // and from there
    }
    writeText(folder() / "script", script);
    ask({"script", "script"});
    const std::string image = shot("a.png");
    ask({"save"});
    ask({"exit"});
    EXPECT_TRUE(rendered("many.scn") == image);
    start({}, "many.scn");
    EXPECT_TRUE(shot("b.png") == image);
}

TEST_F(SavedScene, HasTheSunOfItsSkyAsItWasEdited) {
    writeText(folder() / "sky.scn",
              "version = 2\nmodel = 'in/room.obj'\n[camera]\neye = [0, 1.7, 6]\nlookAt = [0, 1.5, 0]\n"
              "[sky]\ndirection = [1, 2, 1]\n");
    start({}, "sky.scn");
    ask({"set", "exposure.mode", "fixed"});
    const std::string before = shot("before.png");
    ask({"light", "power", "1", "1"});
    ask({"light", "size", "1", "3"});
    EXPECT_TRUE(state().modified);
    const std::string image = shot("a.png");
    EXPECT_NE(image, before);
    ask({"save", "as", "b.scn"});
    ask({"exit"});
    EXPECT_TRUE(rendered("b.scn") == image);
}

TEST_F(SavedScene, UneditedGivesTheStillOfTheFirst) {
    const std::string still = rendered("room.scn");
    start({}, "room.scn");
    ask({"save", "as", "b.scn"});
    EXPECT_TRUE(rendered("b.scn") == still);
}

TEST_F(SavedScene, WithoutLightsStaysDarkWhereItSaysSo) {
    const auto image = [&](const std::string& key) {
        writeText(folder() / "dark.scn", "version = 2\nmodel = 'in/room.obj'\nmodelLights = false\n" + key);
        (void)rendered("dark.scn");
        return rtcore::readLdrImage(folder() / "still.png");
    };
    const auto isDark = [](const rtcore::LdrImage& seen) {
        return std::all_of(seen.pixels.begin(), seen.pixels.end(),
                           [](rtcore::Rgba8 each) { return each.r == 0 && each.g == 0 && each.b == 0; });
    };
    EXPECT_FALSE(isDark(image("")));
    EXPECT_TRUE(isDark(image("defaultLight = false\n")));
}

TEST_F(SavedScene, OfABareModelKeepsWhatWasGuessedForIt) {
    start();
    ask({"set", "exposure.mode", "fixed"});
    refused({"save"}, 1, "save as");
    const std::string image = shot("a.png");
    ask({"save", "as", "b.scn"});
    ask({"exit"});
    EXPECT_TRUE(rendered("b.scn") == image);
    start({}, "b.scn");
    EXPECT_TRUE(shot("b.png") == image);
}

TEST_F(SavedScene, GroundIsTheSameInEachProgram) {
    writeText(folder() / "block.obj",
              "# units = metres\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 2 0\nv 1 2 0\nv 1 2 1\nv 0 2 1\n"
              "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
    const std::string fixed = "--setting=exposure.mode=fixed";
    start({fixed}, "block.obj");
    const std::string image = shot("a.png");
    ask({"save", "as", "b.scn"});
    ask({"sky", "ground", "off"});
    EXPECT_FALSE(shot("none.png") == image) << "a first look has a ground";
    ask({"exit"});
    EXPECT_TRUE(rendered("block.obj", {fixed}) == image);
    EXPECT_TRUE(rendered("b.scn") == image);
}

TEST_F(SavedScene, OverAFileOfTheUsersAsksAndKeepsIt) {
    const std::string hand = bytes("room.scn");
    start({}, "room.scn");
    edit();
    refused({"save"}, 73, "add 'replace'");
    EXPECT_EQ(bytes("room.scn"), hand);
    EXPECT_TRUE(state().modified);
    ask({"save", "replace"});
    EXPECT_EQ(bytes("room.scn~"), hand);
    EXPECT_FALSE(state().modified);
    ask({"light", "1", "off"});
    ask({"save"});
    EXPECT_EQ(bytes("room.scn~"), hand) << "ours is not kept";
}

TEST_F(SavedScene, IsPackedIntoAFolderThatCanBeMoved) {
    start({}, "room.scn");
    edit();
    const std::string image = shot("a.png");
    fs::create_directory(folder() / "taken");
    writeText(folder() / "taken/file", "mine");
    refused({"pack", "taken"}, 73, "not empty");
    EXPECT_EQ(ask({"pack", "packed"}), "6 files\n");
    EXPECT_TRUE(state().modified) << "a pack is a copy";
    ask({"exit"});
    fs::create_directory(folder() / "away");
    fs::rename(folder() / "packed", folder() / "away/with blank");
    fs::remove_all(folder() / "in");
    fs::remove(folder() / "sky.hdr");
    EXPECT_EQ(filesIn(folder() / "away/with blank"),
              (Names{"environments", "model", "room.scn", "textures"}));
    EXPECT_TRUE(rendered("away/with blank/room.scn") == image);
    start({}, "away/with blank/room.scn");
    EXPECT_TRUE(shot("b.png") == image);
}

TEST_F(SavedScene, IsPackedFromACachedModelAndFromABsp) {
    ASSERT_EQ(bspBuilder({"in/room.obj", "room.bsp"}, {.folder = folder().path()}).exitCode, 0);
    start({}, "in/room.obj");
    ask({"load", "scene", "in/room.obj", "room.bsp"});
    EXPECT_EQ(ask({"pack", "first"}), "4 files\n") << "with the textures that the cached model needs no more";
    ask({"load", "scene", "room.bsp"});
    EXPECT_EQ(ask({"pack", "second/"}), "2 files\n");
    ask({"exit"});
    fs::remove_all(folder() / "in");
    EXPECT_TRUE(rendered("first/room.scn") == rendered("second/room.scn"));
}

TEST_F(SavedScene, WithAbsolutePathsInItsModelIsNotPacked) {
    const std::string texture = (folder() / "in/textures/wall.png").string();
    writeText(folder() / "in/room.mtl", "newmtl wall\nmap_Kd " + texture + "\nnewmtl floor\n");
    start({}, "room.scn");
    refused({"pack", "packed"}, 65, texture + " by its absolute path");
    EXPECT_FALSE(fs::exists(folder() / "packed"));
}

TEST_F(SavedScene, StaysAsItWasWhereTheDiskIsFull) {
    start({}, "room.scn");
    ask({"save", "as", "b.scn"});
    const std::string before = bytes("b.scn");
    ask({"light", "1", "off"});
    rlimit limit{};
    ::prlimit(server->process(), RLIMIT_FSIZE, nullptr, &limit);
    const rlimit full{100, limit.rlim_max};
    ::prlimit(server->process(), RLIMIT_FSIZE, &full, nullptr);
    const Names there = filesIn(folder().path());
    refused({"save"}, 73, "b.scn: cannot be written");
    refused({"pack", "packed"}, 73, "cannot be written");
    EXPECT_EQ(filesIn(folder().path()), there) << "nothing half-written";
    EXPECT_TRUE(state().modified);
    ::prlimit(server->process(), RLIMIT_FSIZE, &limit, nullptr);
    EXPECT_EQ(bytes("b.scn"), before);
    ask({"save"});
    EXPECT_FALSE(state().modified);
    refused({"save", "as", "none/b.scn"}, 73, "make its folder first");
}

} // namespace
