// Damaged files: each is read, or refused by a FileError. Nothing else may happen (run under sanitizers,
// too).
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/set.h"
#include "support/damaged_text.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

/// How many of the damaged examples were still read.
template <typename Read>
int survivorsOf(const std::vector<std::string>& examples, std::uint32_t seed, Read read) {
    if (examples.empty()) return 0;
    test::DamagedText damaged(examples, test::kTomlTokens, seed);
    int readable = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const std::string text = damaged.next();
        try {
            read(text);
            ++readable;
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
            EXPECT_LT(std::string(error.what()).size(), 2000U);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what() << "\n" << text;
        }
    }
    return readable;
}

template <typename Read>
int survivors(const std::string& tag, std::uint32_t seed, Read read) {
    return survivorsOf(test::documentedExamples(tag), seed, read);
}

/// Some damage goes unseen (in comments, in names), some does not.
void expectSome(int readable) {
    EXPECT_GT(readable, 0);
    EXPECT_LT(readable, test::damagedTexts());
}

TEST(Mutation, ScenesAreReadOrRefused) {
    expectSome(survivors("toml scn", 51, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        // A scene that was read can be written and read again.
        rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
    }));
}

/// In files of nothing else, so that damage meets them.
TEST(Mutation, NotesAreReadOrRefused) {
    const std::string head = "version = 2\nmodel = \"a\"\norigin = [5e5, 0, -3]\n";
    const std::vector<std::string> examples{
        head + "[[note]]\npoint = [0, 1e11, -8.5]\ntext = \"a\\n\\\"\xC5\xBD\\t\\u20AC\"\nauthor = \"Ada\"\n"
               "written = \"2026-11-30T18:40:00Z\"\n[[note]]\npoint = [0, 0, 0]\ntext = \"b\"\n",
        head + "[[note]]\npoint = [1, 2, 3]\ntext = \"c\"\neye = [0, 1.7, -8]\nforward = [0, 0, -1]\n"
               "up = [0, 1, 0]\nfov = 70\naspect = 1.5\n[[note]]\npoint = [0, 0, 1]\ntext = \"d\"\n"
               "eye = [0, 0, 0]\nlookAt = [1, 0, 0]\northographicWidth = 4\n"};
    expectSome(survivorsOf(examples, 57, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        const rtcore::SceneFile again =
            rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
        EXPECT_EQ(again.notes, scene.notes) << text;
    }));
}

TEST(Mutation, FlightsAreReadOrRefused) {
    const std::string head = "version = 2\nmodel = \"a\"\norigin = [5e5, 0, -3]\n";
    const std::vector<std::string> examples{
        head +
            "[[flight]]\nname = \"a \xC5\xBD\"\nseconds = 12.5\nclosed = true\ntarget = [0, 1e11, -8.5]\n"
            "[[flight.key]]\neye = [0, 1.7, -8]\nforward = [0, 0, -1]\nexposure = 0.5\n"
            "[[flight.key]]\neye = [1, 1.7, -8]\nlookAt = [1, 0, 0]\nup = [0, 1, 0]\nfov = 70\naspect = 2\n"
            "[[flight]]\nname = \"b\"\nturns = 1\ntarget = [0, 1, 0]\n"
            "[[flight.key]]\neye = [1, 1.7, -8]\nforward = [0, 0, -1]\northographicWidth = 4\n",
        head + "[[flight]]\nname = \"c\"\ntiming = \"times\"\n"
               "[[flight.key]]\neye = [0, 1.7, -8]\nforward = [0, 0, -1]\n"
               "[[flight.key]]\ntime = 1.5\neye = [0, 1.7, -8]\nforward = [0, 1, -1]\nexposure = 2\n"
               "[[flight.key]]\ntime = 3\neye = [9, 1.7, -8]\nforward = [0, 1, -1]\n"};
    expectSome(survivorsOf(examples, 58, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        const rtcore::SceneFile again =
            rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
        EXPECT_EQ(again.flights, scene.flights) << text;
    }));
}

TEST(Mutation, VariantsAreReadOrRefused) {
    const std::string head = "version = 2\nmodel = \"a\"\norigin = [5e5, 0, -3]\nactiveVariant = \"b\"\n";
    const std::vector<std::string> examples{
        head + "[[variant]]\nname = \"b\"\nremovedLights = [3, 1000]\n"
               "[[variant.material]]\nname = \"oak \xC5\xBD*\"\ndiffuse = [0.1, 0.2, 0.3]\nroughness = 0.5\n"
               "[[variant.material]]\nnumber = 7\ntextures = false\nopacity = 0.25\n"
               "[[variant.part]]\nname = \"chair\"\nhidden = true\n[[variant.part]]\nnumber = 3\nhidden = "
               "false\n"
               "[[variant]]\nname = \"c\"\n[[variant.light]]\nid = 2\nkind = \"point\"\n"
               "position = [0, 1e11, -8.5]\nintensity = [1, 2, 3]\nradius = 0.5\n"
               "[[variant.light]]\nid = 4\nkind = \"directional\"\ndirection = [0, -1, 0]\nangle = 0.5\n",
        head + "[[variant]]\nname = \"b\"\n[variant.surroundings]\nbackground = [0, 0, 0.5]\nambient = [1, "
               "1, 1]\n"
               "skyLight = true\n[variant.surroundings.sky]\ndate = \"2026-06-21\"\nhour = 9.5\nsunId = 4\n"
               "[[variant]]\nname = \"c\"\n[variant.surroundings]\nenvironment = -1\nskyLight = false\n"
               "[shown]\nremovedLights = [1]\n[[shown.material]]\nnumber = 2\nfresnel = true\n"
               "[shown.surroundings]\n[shown.surroundings.sky]\ndirection = [0, 1, 0]\n"};
    expectSome(survivorsOf(examples, 59, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        const rtcore::SceneFile again =
            rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
        EXPECT_EQ(again.variants, scene.variants) << text;
        EXPECT_EQ(again.activeVariant, scene.activeVariant) << text;
        EXPECT_EQ(again.shown, scene.shown) << text;
    }));
}

TEST(Mutation, SectionsAndMeasuresAreReadOrRefused) {
    const std::string head = "version = 2\nmodel = \"a\"\norigin = [5e5, 0, -3]\n";
    const std::vector<std::string> examples{
        head + "measureUnit = \"cm\"\nmeasureDecimals = 1\n"
               "[[measure]]\nkind = \"distance\"\npoints = [[0, 1e11, -8.5], [2, 0, -8]]\nname = \"a\"\n"
               "[[measure]]\nkind = \"angle\"\npoints = [[1, 0, 0], [0, 0, 0], [0, 1, 0]]\n"
               "[[measure]]\nkind = \"height\"\npoints = [[1, 3, 0], [1, 0, 0]]\n",
        head + "[[measure]]\nkind = \"chain\"\npoints = [[0, 0, 0], [1, 0, 0], [1, 2, 0], [1, 2, 3]]\n"
               "[[measure]]\nkind = \"area\"\npoints = [[0, 0, -4]]\nnormal = [0, 1, 0]\narea = 24.5\n"
               "[[measure]]\nkind = \"volume\"\npoints = [[1, 0, 0]]\npart = 12\nvolume = 0.75\n",
        head + "sectionLight = \"cut\"\nsectionCaps = \"one\"\nsectionColour = [0.1, 0.2, 1]\n"
               "[[section]]\npoint = [0, 1.2, 0]\nnormal = [0, 1, 0]\n"
               "[[section]]\npoint = [3e11, 0, 0]\nnormal = [-1, 0, 1e-9]\n"};
    expectSome(survivorsOf(examples, 56, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        const rtcore::SceneFile again =
            rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
        EXPECT_EQ(again.measures, scene.measures) << text;
        EXPECT_EQ(again.sections, scene.sections) << text;
    }));
}

TEST(Mutation, CamerasAreReadOrRefused) {
    expectSome(survivors("toml cam", 52, [](const std::string& text) {
        const rtcore::CameraFile camera = rtcore::parseCameraFile(text, "x.cam");
        EXPECT_EQ(rtcore::parseCameraFile(rtcore::formatCameraFile(camera), "x.cam"), camera);
    }));
}

TEST(Mutation, SettingsAreReadOrRefused) {
    expectSome(survivors("toml set", 53, [](const std::string& text) {
        const rtcore::SettingsFile settings = rtcore::parseSettingsFile(text, "x.set");
        EXPECT_EQ(rtcore::parseSettingsFile(rtcore::formatSettingsFile(settings), "x.set"), settings);
    }));
}

TEST(Mutation, ListsAreReadOrRefused) {
    expectSome(
        survivors("text list", 54, [](const std::string& text) { rtcore::parseCameraList(text, "l"); }));
}

} // namespace
