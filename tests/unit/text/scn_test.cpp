#include "rtcore/io/text/scn.h"

#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using rtcore::Colour;
using rtcore::EnvironmentKind;
using rtcore::Material;
using rtcore::parseSceneFile;
using rtcore::SceneFile;
using rtcore::Vec3;

const std::string kMinimalScene = "version = 1\nmodel = \"nave.glb\"\n";

SceneFile parse(const std::string& more, const std::string& path = "x.scn") {
    return parseSceneFile(kMinimalScene + more, path);
}
/// The problem of the least scene with more lines, from the third on.
std::string sceneProblem(const std::string& more) {
    return test::badData([&] { parse(more); });
}

TEST(Scn, TheLeastSceneHasDefaults) {
    const SceneFile scene = parse("");
    EXPECT_EQ(scene.model, "nave.glb");
    EXPECT_FALSE(scene.settings || scene.output || scene.camera || scene.cameraFile);
    EXPECT_EQ(scene.metresPerUnit, 1.0F);
    EXPECT_EQ(scene.up, (Vec3{0, 1, 0}));
    EXPECT_EQ(scene.background, Colour{});
    EXPECT_TRUE(scene.modelLights);
    EXPECT_EQ(scene.activeEnvironment, 0);
    EXPECT_EQ(scene.creaseAngle, 40.0F);
    EXPECT_TRUE(scene.lights.empty() && scene.materials.empty() && scene.environments.empty());
    EXPECT_EQ(scene.fog.kind, rtcore::FogKind::None);
    EXPECT_EQ(scene.walk.height, 1.8F);
}

TEST(Scn, KeysOfTheRootAreRead) {
    const SceneFile scene =
        parse("metresPerUnit = 0.01\nup = \"-z\"\nbackground = [1, 2, 3]\nambient = [0, 0.5, 0]\n"
              "creaseAngle = 60\nmodelLights = false\n");
    EXPECT_EQ(scene.metresPerUnit, 0.01F);
    EXPECT_EQ(scene.up, (Vec3{0, 0, -1}));
    EXPECT_EQ(scene.background, (Colour{1, 2, 3}));
    EXPECT_EQ(scene.ambient, (Colour{0, 0.5F, 0}));
    EXPECT_EQ(scene.creaseAngle, 60.0F);
    EXPECT_FALSE(scene.modelLights);
}

TEST(Scn, DeflectionIsAKeyOfVersionTwo) {
    const auto withVersion = [](const std::string& version, const std::string& value) {
        return parseSceneFile("version = " + version + "\nmodel = \"a\"\ndeflection = " + value + "\n",
                              "x.scn");
    };
    EXPECT_EQ(withVersion("2", "0.01").deflection, 0.01F);
    for (const auto& [version, value] : {std::pair{"1", "0.01"}, {"2", "0"}, {"2", "0.2"}}) {
        const std::string message = test::badData([&] { withVersion(version, value); });
        EXPECT_NE(message.find("deflection"), std::string::npos) << message;
    }
}

TEST(Scn, SectionsAreReadAndRefused) {
    const std::string head = "version = 2\nmodel = \"a\"\n",
                      one = "[[section]]\npoint = [0, 1.2, 0]\nnormal = [0, 1, 0]\n";
    const SceneFile scene = parseSceneFile(head + "sectionLight = \"cut\"\n" + one, "x.scn");
    ASSERT_EQ(scene.sections.planes.size(), 1U);
    EXPECT_EQ(scene.sections.planes[0], (rtcore::SectionPlane{{0, 1.2F, 0}, {0, 1, 0}}));
    EXPECT_TRUE(scene.sections.letLightIn());
    EXPECT_TRUE(parseSceneFile(head + "sectionLight = \"cut\"\n", "x.scn").sections.empty());
    const auto refused = [](const std::string& text, const std::string& words) {
        const std::string message = test::badData([&] { parseSceneFile(text, "x.scn"); });
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    std::string seven = head;
    for (int i = 0; i < 7; ++i) seven += one;
    refused(seven, "more than 6 sections");
    refused(head + "[[section]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n", "is zero");
    refused(head + "[[section]]\nnormal = [0, 1, 0]\n", "point");
    refused(head + "[[section]]\npoint = [0, 2e12, 0]\nnormal = [0, 1, 0]\n", "beyond 1e12");
    refused(head + "sectionLight = \"some\"\n", "sectionLight");
    const rtcore::CapStyle caps =
        parseSceneFile(head + "sectionCaps = \"one\"\nsectionColour = [1, 0, 0.5]\nsectionHatching = true\n",
                       "x.scn")
            .sections.caps;
    EXPECT_EQ(caps, (rtcore::CapStyle{rtcore::CapColours::One, {1, 0, 0.5F}, true}));
    refused(head + "sectionCaps = \"red\"\n", "sectionCaps");
    refused(head + "sectionColour = [1, 2, 0]\n", "sectionColour");
    refused("version = 1\nmodel = \"a\"\nsectionHatching = true\n", "sectionHatching");
    refused("version = 1\nmodel = \"a\"\n" + one, "section");
}

TEST(Scn, PathsStartAtTheFolderOfTheScene) {
    const SceneFile scene =
        parse("settings = \"../a.set\"\noutput = \"/tmp/b.png\"\n[camera]\nfile = \"c/d.cam\"\n"
              "[[material]]\nname = \"m\"\ndiffuseTexture = \"t.png\"\n"
              "[[environment]]\ncross = \"e.hdr\"\n",
              "scenes/nave/x.scn");
    EXPECT_EQ(scene.model, "scenes/nave/nave.glb");
    EXPECT_EQ(*scene.settings, "scenes/nave/../a.set");
    EXPECT_EQ(*scene.output, "/tmp/b.png");
    EXPECT_EQ(*scene.cameraFile, "scenes/nave/c/d.cam");
    EXPECT_EQ(*scene.materials[0].diffuseTexture, "scenes/nave/t.png");
    EXPECT_EQ(scene.environments[0].files[0], "scenes/nave/e.hdr");
}

TEST(Scn, ReadsBothVersions) {
    for (const std::string version : {"1", "2"}) {
        const SceneFile scene = parseSceneFile("version = " + version + "\nmodel = \"a\"\n", "x.scn");
        EXPECT_EQ(scene.model, "a");
    }
    EXPECT_EQ(test::badData([] { parseSceneFile("version = 3\nmodel = \"a\"\n", "x.scn"); }),
              "x.scn:1:11: version 3 is unknown; this program reads version 1 to 2");
    EXPECT_EQ(test::badData([] { parseSceneFile("model = \"a\"\n", "x.scn"); }),
              "x.scn:1:1: the version is missing; begin the file with: version = 2");
}

TEST(Scn, ReadsMeasures) {
    const std::string head = "version = 2\nmodel = \"a.obj\"\n";
    const auto read = [&](const std::string& text) { return parseSceneFile(head + text, "x.scn").measures; };
    const rtcore::KeptMeasures measures =
        read("measureUnit = \"cm\"\nmeasureDecimals = 0\n"
             "[[measure]]\nkind = \"distance\"\npoints = [[0, 0, 0], [0.1, 1e9, 3]]\nname = \"door\"\n"
             "[[measure]]\nkind = \"area\"\npoints = [[1, 2, 3]]\nnormal = [0, 2, 0]\narea = 4.5\n"
             "[[measure]]\nkind = \"volume\"\npoints = [[1, 2, 3]]\npart = 3\nvolume = 0.5\n");
    EXPECT_EQ(measures.unit, rtcore::LengthUnit::Centimetre);
    EXPECT_EQ(measures.decimals, 0);
    ASSERT_EQ(measures.all.size(), 3U);
    EXPECT_EQ(measures.all[0].points[1], (rtcore::Vec3d{0.1, 1e9, 3}));
    EXPECT_EQ(measures.all[0].name, "door");
    EXPECT_EQ(measures.all[1].amount, 4.5);
    EXPECT_EQ(measures.all[2].part, 3);
}

TEST(Scn, RefusesMeasuresWithTheirLine) {
    const auto refusal = [](const std::string& text) {
        return test::badData([&] { parseSceneFile("version = 2\nmodel = \"a\"\n" + text, "x.scn"); });
    };
    const auto refused = [&](const std::string& keys, const char* part) {
        EXPECT_NE(refusal("[[measure]]\n" + keys).find(part), std::string::npos)
            << refusal("[[measure]]\n" + keys);
    };
    EXPECT_EQ(refusal("[[measure]]\nkind = \"distance\"\npoints = [[0, 0, 0]]\n"),
              "x.scn:5:10: distance has 2 points, not 1");
    refused("kind = \"chain\"\npoints = [[0, 0, 0], [1, 0, 0]]\n", "chain has 3 to 64 points, not 2");
    refused("kind = \"angle\"\npoints = [[0, 0, 0], [0, 0, 0], [1, 0, 0]]\n", "an angle needs two points");
    refused("kind = \"length\"\npoints = []\n", "length");
    refused("kind = \"distance\"\n", "points");
    refused("kind = \"distance\"\npoints = [[0, 0], [1, 0, 0]]\n", "three numbers");
    refused("kind = \"distance\"\npoints = [[0, 0, 0], [1, 2e12, 0]]\n", "x.scn:5:26: ");
    refused("kind = \"distance\"\npoints = [1, 2, 3]\n", "three numbers");
    refused("kind = \"distance\"\npoints = 7\n", "positions in brackets");
    refused("kind = \"distance\"\npoints = [[0, 0, 0], [1, 0, 0]]\narea = 2\n", "unknown key 'area'");
    refused("kind = \"area\"\npoints = [[0, 0, 0]]\nnormal = [0, 0, 0]\narea = 2\n", "normal");
    refused("kind = \"area\"\npoints = [[0, 0, 0]]\nnormal = [0, 1, 0]\narea = -2\n", "area is -2");
    refused("kind = \"area\"\npoints = [[0, 0, 0]]\narea = 2\n", "normal");
    refused("kind = \"volume\"\npoints = [[0, 0, 0]]\npart = 0\nvolume = 1\n", "part is 0");
    refused("kind = \"distance\"\npoints = [[0, 0, 0], [1, 0, 0]]\nname = \"" + std::string(201, 'n') +
                "\"\n",
            "at most 200 bytes");
    std::string many;
    for (int i = 0; i < 1001; ++i)
        many += "[[measure]]\nkind = \"distance\"\npoints = [[0, 0, 0], [1, 0, 0]]\n";
    EXPECT_NE(refusal(many).find("more than 1000 measures"), std::string::npos);
    EXPECT_NE(refusal("measureDecimals = 7\n").find("measureDecimals is 7"), std::string::npos);
    EXPECT_NE(sceneProblem("[[measure]]\nkind = \"distance\"\npoints = [[0, 0, 0], [1, 0, 0]]\n")
                  .find("version = 2"),
              std::string::npos);
}

TEST(Scn, ReadsNotes) {
    const rtcore::SceneNotes notes =
        parseSceneFile(
            "version = 2\nmodel = \"a\"\nup = \"+z\"\n"
            "[[note]]\npoint = [0.1, 1e9, 3]\ntext = \"too dark,\\n<b>here</b>\"\nauthor = \"Ada\"\n"
            "written = \"2026-11-30T18:40:00Z\"\neye = [1, 2, 3]\nlookAt = [1, 5, 3]\nfov = 70\n"
            "[[note]]\npoint = [0, 0, 0]\ntext = \"a\"\n",
            "x.scn")
            .notes;
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0].point, (rtcore::Vec3d{0.1, 1e9, 3}));
    EXPECT_EQ(notes[0].text, "too dark,\n<b>here</b>");
    EXPECT_EQ(notes[0].author, "Ada");
    EXPECT_EQ(notes[0].written, "2026-11-30T18:40:00Z");
    ASSERT_TRUE(notes[0].view);
    EXPECT_EQ(notes[0].view->forward, (rtcore::Vec3{0, 3, 0}));
    EXPECT_EQ(notes[0].view->up, (rtcore::Vec3{0, 0, 1}));
    EXPECT_EQ(notes[0].view->horizontalFov, 70);
    EXPECT_FALSE(notes[1].view);
}

TEST(Scn, ReadsVariants) {
    const SceneFile scene =
        rtcore::parseSceneFile("version = 2\nmodel = \"m.obj\"\nactiveVariant = \"night\"\n"
                               "[[variant]]\nname = \"oak\"\n"
                               "[[variant.material]]\nname = \"floor\"\ndiffuse = [0.5, 0.3, 0.1]\n"
                               "[[variant.part]]\nnumber = 2\nhidden = true\n"
                               "[[variant]]\nname = \"night\"\nremovedLights = [4]\n"
                               "[[variant.light]]\nid = 3\nkind = \"point\"\nposition = [1, 2, 3]\n"
                               "[variant.surroundings]\nenvironment = -1\n",
                               "x.scn");
    ASSERT_EQ(scene.variants.size(), 2U);
    EXPECT_EQ(scene.activeVariant, "night");
    EXPECT_EQ(scene.variants[0].materials.at(0).pattern, "floor");
    EXPECT_EQ(scene.variants[0].parts.at(0).number, 2);
    EXPECT_FALSE(scene.variants[0].surroundings);
    EXPECT_EQ(scene.variants[1].lights.at(0).id, 3);
    EXPECT_EQ(scene.variants[1].removedLights, std::vector<int>{4});
    ASSERT_TRUE(scene.variants[1].surroundings);
    EXPECT_FALSE(scene.variants[1].surroundings->skyLight);
    EXPECT_FALSE(scene.variants[1].surroundings->sky);
    EXPECT_FALSE(scene.shown);
}

TEST(Scn, RefusesVariantsWithTheirLine) {
    const auto refusal = [](const std::string& text) {
        return test::badData(
            [&] { rtcore::parseSceneFile("version = 2\nmodel = \"m.obj\"\n" + text, "x.scn"); });
    };
    const auto refused = [&](const std::string& text, const std::string& part) {
        const std::string why = refusal(text);
        EXPECT_NE(why.find(part), std::string::npos) << why;
    };
    const std::string light = "[[variant.light]]\nid = 3\nkind = \"point\"\nposition = [1, 2, 3]\n";
    refused("activeVariant = \"a\"\n", "x.scn:3:17: there is no [[variant]] 'a' in this file");
    refused("[[variant]]\n", "name");
    refused("[[variant]]\nname = \"\"\n", "x.scn:4:8: name is empty; a variant is known by its name");
    refused("[[variant]]\nname = \"a\\u0007\"\n", "without control characters");
    refused("[[variant]]\nname = \"a\"\n[[variant]]\nname = \"a\"\n", "another variant is called 'a', too");
    refused("[[variant]]\nname = \"a\"\n[[variant.material]]\nname = \"b\"\ndiffuseTexture = \"c.png\"\n",
            "x.scn:7:18: a variant takes no textures");
    refused("[[variant]]\nname = \"a\"\n[[variant.part]]\nname = \"b\"\nuncut = true\n",
            "hides and shows parts");
    refused("[[variant]]\nname = \"a\"\n[[variant.light]]\nkind = \"point\"\nposition = [1, 2, 3]\n", "id");
    refused("[[variant]]\nname = \"a\"\n" + light + light, "two lights have the id 3");
    refused("[[variant]]\nname = \"a\"\nremovedLights = [3]\n" + light, "light 3 is given twice");
    std::string many;
    for (int i = 0; i < 101; ++i) many += "[[variant]]\nname = \"" + std::to_string(i) + "\"\n";
    refused(many, "more than 100 variants");
    EXPECT_NE(sceneProblem("[[variant]]\nname = \"a\"\n").find("version = 2"), std::string::npos);
}

TEST(Scn, ReadsFlights) {
    const rtcore::Flights flights =
        parseSceneFile("version = 2\nmodel = \"a\"\nup = \"+z\"\n"
                       "[[flight]]\nname = \"round\"\nseconds = 20\nclosed = true\ntarget = [0.1, 0, 3]\n"
                       "[[flight.key]]\neye = [1, 2, 3]\nlookAt = [1, 5, 3]\nfov = 70\n"
                       "[[flight.key]]\neye = [4, 2, 3]\nforward = [0, 1, 0]\nexposure = 0.25\n"
                       "[[flight]]\nname = \"in\"\ntiming = \"times\"\n"
                       "[[flight.key]]\neye = [1, 2, 3]\nforward = [0, 1, 0]\n"
                       "[[flight.key]]\ntime = 2.5\neye = [1, 3, 3]\nforward = [0, 1, 0]\n"
                       "[[flight]]\nname = \"table\"\nturns = -1\ntarget = [0, 0, 0]\n"
                       "[[flight.key]]\neye = [1, 3, 3]\nforward = [0, 1, 0]\n",
                       "x.scn")
            .flights;
    ASSERT_EQ(flights.size(), 3U);
    EXPECT_EQ(flights[0].name, "round");
    EXPECT_EQ(flights[0].timing, rtcore::FlightTiming::Even);
    EXPECT_EQ(flights[0].seconds, 20);
    EXPECT_TRUE(flights[0].closed);
    EXPECT_EQ(flights[0].target, (rtcore::Vec3d{0.1, 0, 3}));
    ASSERT_EQ(flights[0].keys.size(), 2U);
    EXPECT_EQ(flights[0].keys[0].camera.forward, (rtcore::Vec3{0, 3, 0}));
    EXPECT_EQ(flights[0].keys[0].camera.up, (rtcore::Vec3{0, 0, 1}));
    EXPECT_FALSE(flights[0].keys[0].exposure);
    EXPECT_EQ(flights[0].keys[1].exposure, 0.25F);
    EXPECT_EQ(flights[1].timing, rtcore::FlightTiming::Times);
    EXPECT_EQ(flights[1].keys[1].time, 2.5);
    EXPECT_EQ(flights[2].turns, -1);
}

TEST(Scn, RefusesFlightsWithTheirLine) {
    const auto refusal = [](const std::string& text) {
        return test::badData([&] { parseSceneFile("version = 2\nmodel = \"a\"\n" + text, "x.scn"); });
    };
    const std::string key = "[[flight.key]]\neye = [1, 3, 3]\nforward = [0, 1, 0]\n";
    const auto refused = [&](const std::string& keys, const std::string& frames, const char* part) {
        const std::string why = refusal("[[flight]]\n" + keys + frames);
        EXPECT_NE(why.find(part), std::string::npos) << why;
    };
    refused("", key, "name");
    refused("name = \"\"\n", key, "x.scn:4:8: name is empty");
    refused("name = \"a\\u0007\"\n", key, "x.scn:4:8: the name of a flight is UTF-8");
    refused("name = \"" + std::string(201, 'x') + "\"\n", key, "at most 200 bytes");
    refused("name = \"a\"\n", "", "the flight has no key frame");
    refused("name = \"a\"\nseconds = 0\n", key, "x.scn:5:11: a flight takes between 0 and 86400");
    refused("name = \"a\"\nseconds = 86401\n", key, "seconds is 86401");
    refused("name = \"a\"\ntiming = \"odd\"\n", key, "timing");
    refused("name = \"a\"\nclosed = true\ntiming = \"times\"\n", key, "x.scn:5:10: a flight by times ends");
    refused("name = \"a\"\ntiming = \"times\"\n", key + key, "that of number 2 does not");
    refused("name = \"a\"\ntiming = \"times\"\n", key.substr(0, 15) + "time = 1\n" + key.substr(15),
            "the time of the first key frame is 0");
    refused("name = \"a\"\n", key + key.substr(0, 15) + "orthographicWidth = 3\n" + key.substr(15),
            "cannot be in one flight");
    refused("name = \"a\"\nturns = 1\n", key, "x.scn:5:9: a turntable needs the target");
    refused("name = \"a\"\nturns = 1\ntarget = [0, 0, 0]\n", key + key, "one key frame");
    refused("name = \"a\"\nturns = 1001\ntarget = [0, 0, 0]\n", key, "turns is 1001");
    refused("name = \"a\"\ntarget = [2e12, 0, 0]\n", key, "x.scn:5:");
    refused("name = \"a\"\nspeed = 3\n", key, "unknown key 'speed'");
    refused("name = \"a\"\n", key + "speed = 3\n", "unknown key 'speed'");
    refused("name = \"a\"\n", key + "exposure = 0\n", "exposure");
    refused("name = \"a\"\n", key + key + "time = 1\n", "has no time");
    refused("name = \"a\"\nseconds = 1e-9\n", key, "between 0 and 86400");
    refused("name = \"a\"\ntiming = \"times\"\n", key + key + "time = 1e-310\n", "number 2 does not");
    refused("name = \"a\"\n", key + "[[flight]]\nname = \"a\"\n" + key, "another flight is called 'a', too");
    std::string many, frames = "[[flight]]\nname = \"a\"\n";
    for (int i = 0; i < 101; ++i) many += "[[flight]]\nname = \"" + std::to_string(i) + "\"\n" + key;
    EXPECT_NE(refusal(many).find("more than 100 flights"), std::string::npos);
    for (int i = 0; i < 1001; ++i) frames += key;
    EXPECT_NE(refusal(frames).find("at most 1000 key frames"), std::string::npos);
    EXPECT_NE(sceneProblem("[[flight]]\nname = \"a\"\n" + key).find("version = 2"), std::string::npos);
}

TEST(Scn, RefusesNotesWithTheirLine) {
    const auto refusal = [](const std::string& text) {
        return test::badData([&] { parseSceneFile("version = 2\nmodel = \"a\"\n" + text, "x.scn"); });
    };
    const auto refused = [&](const std::string& keys, const char* part) {
        EXPECT_NE(refusal("[[note]]\n" + keys).find(part), std::string::npos) << refusal("[[note]]\n" + keys);
    };
    EXPECT_EQ(refusal("[[note]]\npoint = [0, 0, 0]\ntext = \" \"\n"), "x.scn:5:8: the note has no text");
    refused("text = \"a\"\n", "point");
    refused("point = [0, 0, 0]\n", "text");
    refused("point = [0, 0]\ntext = \"a\"\n", "three numbers");
    refused("point = [0, 2e12, 0]\ntext = \"a\"\n", "x.scn:4:");
    refused("point = [0, 0, 0]\ntext = \"a\\u0007\"\n", "x.scn:5:8: the text of a note is UTF-8");
    refused("point = [0, 0, 0]\ntext = \"a\\u202E\"\n", "control characters");
    refused("point = [0, 0, 0]\ntext = \"" + std::string(2001, 'x') + "\"\n", "at most 2000 characters");
    refused("point = [0, 0, 0]\ntext = \"a\"\nauthor = \"" + std::string(65, 'x') + "\"\n",
            "x.scn:6:10: the name of an author");
    refused("point = [0, 0, 0]\ntext = \"a\"\nauthor = \"a\\nb\"\n", "x.scn:6:10: ");
    refused("point = [0, 0, 0]\ntext = \"a\"\nwritten = \"2026-02-30T00:00:00Z\"\n", "x.scn:6:11: written");
    refused("point = [0, 0, 0]\ntext = \"a\"\neye = [0, 0, 0]\n", "forward");
    refused("point = [0, 0, 0]\ntext = \"a\"\nfov = 60\n", "eye");
    refused("point = [0, 0, 0]\ntext = \"a\"\nname = \"b\"\n", "unknown key 'name'");
    std::string many;
    for (int i = 0; i < 1001; ++i) many += "[[note]]\npoint = [0, 0, 0]\ntext = \"a\"\n";
    EXPECT_NE(refusal(many).find("more than 1000 notes"), std::string::npos);
    EXPECT_NE(sceneProblem("[[note]]\npoint = [0, 0, 0]\ntext = \"a\"\n").find("version = 2"),
              std::string::npos);
}

TEST(Scn, ReadsBookmarks) {
    const std::string newest = "version = 2\nmodel = \"a\"\nup = \"+z\"\n";
    const SceneFile scene = parseSceneFile(newest + "[[bookmark]]\nname = \"door\"\neye = [1, 2, 3]\n"
                                                    "lookAt = [1, 5, 3]\nfov = 40\n"
                                                    "[[bookmark]]\nname = \"Door\"\neye = [0, 0, 0]\n"
                                                    "forward = [1, 0, 0]\n",
                                           "x.scn");
    ASSERT_EQ(scene.bookmarks.size(), 2U);
    EXPECT_EQ(scene.bookmarks[0].name, "door");
    EXPECT_EQ(scene.bookmarks[0].camera.forward, (rtcore::Vec3{0, 3, 0}));
    EXPECT_EQ(scene.bookmarks[0].camera.up, (rtcore::Vec3{0, 0, 1}));
    EXPECT_EQ(scene.bookmarks[0].camera.horizontalFov, 40);
    EXPECT_EQ(findBookmark(scene.bookmarks, "Door"), scene.bookmarks.begin() + 1);
    EXPECT_EQ(findBookmark(scene.bookmarks, "gate"), scene.bookmarks.end());
    const auto refusal = [&](const std::string& keys) {
        return test::badData([&] { parseSceneFile(newest + "[[bookmark]]\n" + keys, "x.scn"); });
    };
    const std::string view = "eye = [0, 0, 0]\nforward = [1, 0, 0]\n";
    EXPECT_EQ(refusal(view), "x.scn:4:1: the key 'name' is missing here; add it");
    EXPECT_EQ(refusal("name = \"\"\n" + view), "x.scn:5:8: name is empty; a bookmark is known by its name");
    EXPECT_EQ(refusal("name = \"a\"\n" + view + "[[bookmark]]\nname = \"a\"\n" + view),
              "x.scn:9:8: another bookmark is called 'a', too");
    EXPECT_EQ(refusal("name = \"a\"\nfile = \"a.cam\"\n" + view).substr(0, 24), "x.scn:6:1: unknown key '");
}

TEST(Scn, RefusesNewKeysInOldFiles) {
    EXPECT_NE(sceneProblem("defaultLight = false").find("version = 2"), std::string::npos)
        << sceneProblem("defaultLight = false");
    EXPECT_NE(
        sceneProblem("[[bookmark]]\nname = \"a\"\neye = [0, 0, 0]\nforward = [1, 0, 0]").find("version = 2"),
        std::string::npos);
    EXPECT_FALSE(parseSceneFile("version = 2\nmodel = \"a\"\ndefaultLight = false\n", "x.scn").defaultLight);
}

TEST(Scn, LightsHaveIdsAndTemperatures) {
    const std::string second = "version = 2\nmodel = \"a\"\n";
    const std::string light = "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\nintensity = [2, 2, 2]\n";
    const SceneFile scene = parseSceneFile(second + light + "id = 7\ntemperature = 2700\n" + light, "x.scn");
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].id, 7);
    EXPECT_EQ(scene.lights[0].temperature, 2700);
    EXPECT_EQ(scene.lights[0].light.intensity, (rtcore::Colour{2, 2, 2}));
    EXPECT_NEAR(luminance(tintedLight(scene.lights[0]).intensity), 2, 1e-5);
    EXPECT_GT(tintedLight(scene.lights[0]).intensity.r, 2);
    EXPECT_EQ(scene.lights[1].id, 0);
    EXPECT_EQ(scene.lights[1].temperature, 0);
    const auto refused = [&](const std::string& text) {
        return test::badData([&] { parseSceneFile(text, "x.scn"); });
    };
    EXPECT_EQ(refused(second + light + "id = 7\n" + light + "id = 7\n"),
              "x.scn:12:6: two lights have the id 7");
    EXPECT_EQ(refused(second + light + "id = 0\n"),
              "x.scn:7:6: id is 0, but takes a whole number from 1 to 1000000000");
    EXPECT_NE(refused(second + light + "temperature = 100\n").find("at least 1667"), std::string::npos);
    const std::string first = "version = 1\nmodel = \"a\"\n";
    EXPECT_NE(refused(first + light + "id = 7\n").find("version 2"), std::string::npos);
    EXPECT_NE(refused(first + light + "temperature = 2700\n").find("version 2"), std::string::npos);
}

TEST(Scn, ErrorsNameTheirPlace) {
    EXPECT_EQ(test::badData([] { parseSceneFile("version = 1\n", "x.scn"); }),
              "x.scn:1:1: the key 'model' is missing here; add it");
    EXPECT_EQ(sceneProblem("modle = 1"), "x.scn:3:1: unknown key 'modle'; did you mean 'model'?");
    EXPECT_EQ(sceneProblem("up = \"y\"").substr(0, 36), "x.scn:3:6: unknown up 'y'; did you m");
    EXPECT_EQ(sceneProblem("metresPerUnit = 0"),
              "x.scn:3:17: metresPerUnit is 0, but takes a number at least 1e-09 and at most 1e+09");
    EXPECT_EQ(sceneProblem("output = \"\""), "x.scn:3:10: output is no path; give the name of a file");
    EXPECT_EQ(sceneProblem("output = \"a\\u0000b\""),
              "x.scn:3:10: output is no path; give the name of a file");
    EXPECT_EQ(sceneProblem("output = 3"), "x.scn:3:10: output is a whole number, but takes a path in quotes");
    EXPECT_EQ(sceneProblem("background = [0, 0, -1]"),
              "x.scn:3:21: background is -1, but takes a finite number at least 0");
    EXPECT_EQ(sceneProblem("[fog]\nkind = \"exponental\""),
              "x.scn:4:8: unknown kind 'exponental'; did you mean 'exponential'?");
    EXPECT_EQ(sceneProblem("[fog]\ndensity = 1"), "x.scn:3:1: the key 'kind' is missing here; add it");
    EXPECT_EQ(sceneProblem("[fog]\nkind = \"none\"\nscaleHeight = 0"),
              "x.scn:5:15: scaleHeight is 0, but takes a finite number above 0");
    EXPECT_EQ(sceneProblem("[walk]\nsped = 1"), "x.scn:4:1: unknown key 'sped'; did you mean 'speed'?");
    EXPECT_EQ(sceneProblem("[light]\nkind = \"point\""),
              "x.scn:3:1: light is a table, but takes tables, [[light]]");
    EXPECT_EQ(sceneProblem("light = [1]"),
              "x.scn:3:10: light is a whole number, but takes tables, [[light]]");
    EXPECT_EQ(sceneProblem("[[fog]]"), "x.scn:3:1: fog is an array, but takes a table, [fog]");
    EXPECT_EQ(sceneProblem("[still]\nmaxdepth = 1"),
              "x.scn:4:1: unknown setting 'maxdepth'; did you mean 'maxDepth'?");
}

TEST(Scn, TheCameraLooksAtAPointOrForward) {
    const SceneFile at = parse("[camera]\neye = [1, 2, 3]\nlookAt = [1, 2, 8]\nfov = 90\n");
    EXPECT_EQ(at.camera->forward, (Vec3{0, 0, 5}));
    EXPECT_EQ(at.camera->horizontalFov, 90.0F);
    const SceneFile forward = parse("[camera]\neye = [1, 2, 3]\nforward = [1, 0, 0]\nup = [0, 0, 1]\n");
    EXPECT_EQ(forward.camera->forward, (Vec3{1, 0, 0}));
    EXPECT_EQ(forward.camera->up, (Vec3{0, 0, 1}));
    // The scene's up is the camera's, too.
    EXPECT_EQ(parse("up = \"+z\"\n[camera]\neye = [0, 0, 0]\nforward = [1, 0, 0]\n").camera->up,
              (Vec3{0, 0, 1}));
    EXPECT_EQ(parse("up = \"+z\"\n[camera]\neye = [0, 0, 9]\nlookAt = [0, 0, 0]\n").camera->up,
              (Vec3{0, 1, 0}));
}

TEST(Scn, CamerasThatMakeNoViewAreRefused) {
    EXPECT_EQ(sceneProblem("[camera]\neye = [1, 2, 3]\nlookAt = [1, 2, 3]"),
              "x.scn:5:10: lookAt is where eye is; the camera needs a direction");
    EXPECT_EQ(sceneProblem("[camera]\neye = [0, 0, 0]\nforward = [1, 0, 0]\nlookAt = [1, 0, 0]"),
              "x.scn:6:10: forward and lookAt are both given; leave one out");
    EXPECT_EQ(sceneProblem("[camera]\neye = [0, 0, 0]"),
              "x.scn:3:1: the key 'forward' is missing here; add it");
    EXPECT_EQ(sceneProblem("[camera]\neye = [0, 0, 0]\nlookAt = [0, 9, 0]\nup = [0, 1, 0]"),
              "x.scn:6:6: up is parallel to the view direction; give another up");
    EXPECT_EQ(sceneProblem("[camera]\nfile = \"a.cam\"\naspect = 1"),
              "x.scn:5:10: file and aspect are both given; leave one out");
    EXPECT_EQ(sceneProblem("[camera]\neye = [0, 0, 0]\nfile = \"a.cam\""),
              "x.scn:4:7: file and eye are both given; leave one out");
    EXPECT_EQ(sceneProblem("[camera]\nfille = \"a.cam\""),
              "x.scn:4:1: unknown key 'fille'; did you mean 'file'?");
    // The way from one end of all floats to the other is no float.
    EXPECT_NE(sceneProblem("[camera]\neye = [-3e38, 0, 0]\nlookAt = [3e38, 0, 0]"), "no error");
}

TEST(Scn, LightsOfEachKindAreRead) {
    const SceneFile scene =
        parse("[[light]]\nname = \"candle\"\nkind = \"point\"\nposition = [0, 3, 0]\nintensity = [10, 9, 8]\n"
              "radius = 0.02\n"
              "[[light]]\nkind = \"directional\"\ndirection = [0, 0, -7]\non = false\n"
              "[[light]]\nkind = \"spot\"\nposition = [1, 0, 0]\ndirection = [0, -1, 0]\ninnerAngle = 0\n"
              "outerAngle = 60\n");
    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_FALSE(scene.modelLights); // since there are some here
    const rtcore::Light &point = scene.lights[0].light, &sun = scene.lights[1].light,
                        &spot = scene.lights[2].light;
    EXPECT_EQ(scene.lights[0].name, "candle");
    EXPECT_EQ(point.kind, rtcore::LightKind::Point);
    EXPECT_EQ(point.position, (Vec3{0, 3, 0}));
    EXPECT_EQ(point.intensity, (Colour{10, 9, 8}));
    EXPECT_EQ(point.radius, 0.02F);
    EXPECT_EQ(point.on, 1U);
    EXPECT_EQ(sun.kind, rtcore::LightKind::Directional);
    EXPECT_EQ(sun.direction, (Vec3{0, 0, -1}));
    EXPECT_EQ(sun.intensity, (Colour{1, 1, 1}));
    EXPECT_EQ(sun.on, 0U);
    EXPECT_EQ(spot.kind, rtcore::LightKind::Spot);
    EXPECT_EQ(spot.cosInner, 1.0F);
    EXPECT_EQ(spot.cosOuter, 0.5F);
}

TEST(Scn, LightsThatMakeNoSenseAreRefused) {
    EXPECT_EQ(sceneProblem("[[light]]\nposition = [0, 0, 0]"),
              "x.scn:3:1: the key 'kind' is missing here; add it");
    EXPECT_EQ(sceneProblem("[[light]]\nkind = \"point\""),
              "x.scn:3:1: the key 'position' is missing here; add it");
    EXPECT_EQ(sceneProblem("[[light]]\nkind = \"directional\"\ndirection = [0, 0, 0]"),
              "x.scn:5:13: direction is zero; give where the light shines to");
    const std::string spot = "[[light]]\nkind = \"spot\"\nposition = [0,0,0]\ndirection = [1,0,0]\n";
    EXPECT_EQ(sceneProblem(spot), "x.scn:3:1: the key 'outerAngle' is missing here; add it");
    EXPECT_EQ(sceneProblem(spot + "outerAngle = 20\ninnerAngle = 20"),
              "x.scn:8:14: innerAngle must be below outerAngle, by enough to tell them apart");
    EXPECT_EQ(sceneProblem(spot + "outerAngle = 0"),
              "x.scn:7:14: innerAngle must be below outerAngle, by enough to tell them apart");
    EXPECT_EQ(sceneProblem(spot + "outerAngle = 181").substr(0, 30), "x.scn:7:14: outerAngle is 181,");
    EXPECT_EQ(sceneProblem(spot + "outerAngle = 180"), "no error");
}

TEST(Scn, MaterialOverridesChangeWhatTheyName) {
    const SceneFile scene =
        parse("[[material]]\nname = \"glass*\"\nreflectivity = 0.25\nfresnel = true\nopacity = 0\n"
              "indexOfRefraction = 1.6\nshininess = 90\ntransmission = [1, 0.5, 0]\nattenuationDistance = 2\n"
              "emission = [4, 5, 6]\n"
              "[[material]]\nname = \"floor\"\ndiffuse = [0.9, 0.5, 0]\nspecular = [0.1, 0.1, 0.1]\n"
              "reflectivity = [0, 0, 1]\n");
    Material glass;
    glass.mirrorScale = 0.5F;
    scene.materials[0].applyTo(glass);
    EXPECT_EQ(glass.mirror, (Colour{0.25F, 0.25F, 0.25F}));
    EXPECT_EQ(glass.mirrorScale, 1.0F);
    EXPECT_EQ(glass.fresnel, 1U);
    EXPECT_EQ(glass.opacity, 0.0F);
    EXPECT_EQ(glass.indexOfRefraction, 1.6F);
    EXPECT_EQ(glass.shininess, 90.0F);
    EXPECT_EQ(glass.transmission, (Colour{1, 0.5F, 0}));
    EXPECT_EQ(glass.attenuationDistance, 2.0F);
    EXPECT_EQ(glass.emission, (Colour{4, 5, 6}));
    EXPECT_EQ(glass.diffuse, Material{}.diffuse);

    Material floor;
    scene.materials[1].applyTo(floor);
    EXPECT_EQ(floor.diffuse, (Colour{0.9F, 0.5F, 0}));
    EXPECT_EQ(floor.specular, (Colour{0.1F, 0.1F, 0.1F}));
    EXPECT_EQ(floor.mirror, (Colour{0, 0, 1}));
    EXPECT_EQ(floor.opacity, 1.0F);
}

TEST(Scn, AnOverrideOfOneLobeTakesFromTheOther) {
    Material material;
    material.diffuse = {0.5F, 0.5F, 0.5F};
    material.specular = {0.5F, 0.25F, 0};
    rtcore::MaterialOverride change;
    change.diffuse = Colour{0.75F, 0.75F, 0.75F};
    change.applyTo(material);
    EXPECT_EQ(material.specular, (Colour{0.25F, 0.25F, 0}));
    change = {};
    change.specular = Colour{1, 0, 0};
    change.applyTo(material);
    EXPECT_EQ(material.diffuse, (Colour{0, 0.75F, 0.75F}));
}

TEST(Scn, MaterialsThatMakeNoSenseAreRefused) {
    EXPECT_EQ(sceneProblem("[[material]]\nopacity = 1"), "x.scn:3:1: the key 'name' is missing here; add it");
    EXPECT_EQ(sceneProblem("[[material]]\nname = \"\"").substr(0, 20), "x.scn:4:8: name is e");
    EXPECT_EQ(sceneProblem("[[material]]\nname = \"a\"\nreflectivity = 1.5"),
              "x.scn:5:16: reflectivity is 1.5, but takes a number at least 0 and at most 1");
    EXPECT_EQ(sceneProblem("[[material]]\nname = \"a\"\ndiffuse = [0.9, 0, 0]\nspecular = [0.2, 0, 0]")
                  .substr(0, 41),
              "x.scn:6:12: diffuse and specular together");
    EXPECT_EQ(sceneProblem("[[material]]\nname = \"a\"\nopactiy = 1"),
              "x.scn:5:1: unknown key 'opactiy'; did you mean 'opacity'?");
}

SceneFile parseVersion2(const std::string& more) {
    return rtcore::parseSceneFile("version = 2\nmodel = \"m.bsp\"\n" + more, "x.scn");
}

TEST(Scn, RoughnessAndMetalAreThoseOfGltf) {
    const SceneFile scene = parseVersion2("[[material]]\nname = \"brass\"\ndiffuse = [0.8, 0.6, 0.2]\n"
                                          "roughness = 0.15\nmetallic = 1\n"
                                          "[[material]]\nnumber = 2\nroughness = 1\n");
    Material brass;
    brass.specular = {0.2F, 0.2F, 0.2F};
    scene.materials[0].applyTo(brass);
    EXPECT_EQ(brass.diffuse, (Colour{0.8F, 0.6F, 0.2F}));
    EXPECT_EQ(brass.specular, rtcore::kWhite * 0.04F) << "of what is no metal";
    EXPECT_EQ(brass.roughness, 0.15F);
    EXPECT_EQ(brass.metallic, 1.0F);
    EXPECT_EQ(scene.materials[1].number, 2);
    scene.materials[1].applyTo(brass);
    EXPECT_EQ(brass.diffuse, (Colour{0.8F, 0.6F, 0.2F})) << "its base colour stays";
    EXPECT_EQ(brass.roughness, 1.0F);
}

TEST(Scn, PartsAreHiddenAndShown) {
    const SceneFile scene =
        parseVersion2("[[part]]\nname = \"*\"\nhidden = true\n[[part]]\nnumber = 3\nhidden = false\n");
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(scene.parts[0], (rtcore::PartDescription{"*", {}, true}));
    EXPECT_EQ(scene.parts[1], (rtcore::PartDescription{"", 3, false}));
}

TEST(Scn, WhatCameWithVersion2IsRefusedInVersion1) {
    for (const char* key : {"roughness = 0.5", "metallic = 0.5", "textures = false", "flipTextures = true"}) {
        const std::string text = std::string("[[material]]\nname = \"a\"\n") + key;
        EXPECT_NE(sceneProblem(text).find("came with version 2"), std::string::npos) << sceneProblem(text);
    }
    EXPECT_NE(sceneProblem("[[material]]\nnumber = 1").find("came with version 2"), std::string::npos);
    EXPECT_NE(sceneProblem("[[part]]\nname = \"a\"\nhidden = true").find("came with version 2"),
              std::string::npos);
}

TEST(Scn, OneKeyOfAMaterialIsReadByItself) {
    const auto key = [](const std::string& name, const std::vector<std::string>& words) {
        return rtcore::parseMaterialKey(name, words);
    };
    EXPECT_EQ(key("diffuse", {"1", "0.5", "0"}).diffuse, (Colour{1, 0.5F, 0}));
    EXPECT_EQ(key("reflectivity", {"0.25"}).reflectivity, (Colour{0.25F, 0.25F, 0.25F}));
    EXPECT_EQ(key("textures", {"false"}).textures, false);
    const auto refusal = [&](const std::string& name, const std::vector<std::string>& words) {
        try {
            key(name, words);
        } catch (const rtcore::FileError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(refusal("roughness", {"2"}), "roughness is 2, but takes a number at least 0 and at most 1");
    EXPECT_EQ(refusal("opactiy", {"1"}), "unknown key 'opactiy'; did you mean 'opacity'?");
    EXPECT_NE(refusal("diffuse", {"1", "0"}), "none");
    EXPECT_NE(refusal("diffuse", {"red"}), "none");
    EXPECT_NE(refusal("opacity", {}), "none");
    EXPECT_NE(refusal("opacity", {"nan"}), "none");
}

TEST(Scn, EnvironmentsOfEachKindAreRead) {
    const SceneFile scene =
        parse("activeEnvironment = 3\n[[environment]]\nequirectangular = \"a.hdr\"\nname = \"night\"\n"
              "intensity = 2\n[[environment]]\ncross = \"b.png\"\n[[environment]]\nstrip = \"c.png\"\n"
              "[[environment]]\nfaces = [\"1\", \"2\", \"3\", \"4\", \"5\", \"6\"]\n");
    ASSERT_EQ(scene.environments.size(), 4U);
    EXPECT_EQ(scene.activeEnvironment, 3);
    EXPECT_EQ(scene.environments[0].kind, EnvironmentKind::Equirectangular);
    EXPECT_EQ(scene.environments[0].name, "night");
    EXPECT_EQ(scene.environments[0].intensity, 2.0F);
    EXPECT_EQ(scene.environments[1].kind, EnvironmentKind::Cross);
    EXPECT_EQ(scene.environments[2].kind, EnvironmentKind::Strip);
    EXPECT_EQ(scene.environments[3].kind, EnvironmentKind::Faces);
    EXPECT_EQ(scene.environments[3].files.size(), 6U);
    EXPECT_EQ(scene.environments[3].files[5], "6");
}

TEST(Scn, EnvironmentsThatMakeNoSenseAreRefused) {
    const std::string exactlyOne =
        "x.scn:3:1: an environment has exactly one of the keys equirectangular, cross, strip, faces and "
        "parts";
    EXPECT_EQ(sceneProblem("[[environment]]"), exactlyOne);
    EXPECT_EQ(sceneProblem("[[environment]]\ncross = \"a\"\nstrip = \"b\""), exactlyOne);
    EXPECT_EQ(sceneProblem("[[environment]]\nfaces = [\"a\"]"),
              "x.scn:4:9: faces has 1 files, but takes six: +x, -x, +y, -y, +z, -z");
    EXPECT_EQ(sceneProblem("activeEnvironment = 0"),
              "x.scn:3:21: activeEnvironment is 0, but there are 0 [[environment]], counted from 0");
    EXPECT_EQ(sceneProblem("activeEnvironment = 1\n[[environment]]\ncross = \"a\"").substr(0, 12),
              "x.scn:3:21: ");
    EXPECT_EQ(sceneProblem("activeEnvironment = -1\n[[environment]]\ncross = \"a\"").substr(0, 12),
              "x.scn:3:21: ");
}

TEST(Scn, ASkyIsReadByDateOrByDirection) {
    const SceneFile dated =
        rtcore::parseSceneFile("version = 2\nmodel = \"m.obj\"\n[sky]\ndate = \"2024-02-29\"\nhour = 17.25\n"
                               "timeZone = 2\nlatitude = 48.2\nlongitude = 16.37\nnorth = 30\nturbidity = 4\n"
                               "strength = 0.5\n",
                               "x.scn");
    const rtcore::SunDate date{2024, 2, 29, 62100, 2, 48.2, 16.37};
    EXPECT_EQ(dated.sky, (rtcore::Sky{.date = date, .north = 30, .turbidity = 4, .strength = 0.5F}));
    EXPECT_EQ(dated.activeEnvironment, 0);
    const SceneFile pointed = rtcore::parseSceneFile(
        "version = 2\nmodel = \"m.obj\"\n[sky]\ndirection = [1, 2, 3]\n[[environment]]\ncross = \"a\"",
        "x.scn");
    EXPECT_FALSE(pointed.sky->date);
    EXPECT_EQ(pointed.sky->direction, (Vec3{1, 2, 3}));
    EXPECT_EQ(pointed.activeEnvironment, 1);
    EXPECT_EQ(rtcore::parseSceneFile("version = 2\nmodel = \"m.obj\"\n[sky]\n", "x.scn").sky, rtcore::Sky{});
    EXPECT_TRUE(
        rtcore::parseSceneFile("version = 2\nmodel = \"m.obj\"\n[sky]\nground = true", "x.scn").sky->ground);
}

TEST(Scn, SkiesThatMakeNoSenseAreRefused) {
    const auto refusal = [](const std::string& sky, const char* version = "2") {
        return test::badData([&] {
            rtcore::parseSceneFile(std::string("version = ") + version + "\nmodel = \"m.obj\"\n" + sky,
                                   "x.scn");
        });
    };
    EXPECT_NE(refusal("[sky]", "1").find("'sky' came with version 2"), std::string::npos);
    EXPECT_NE(
        refusal("[[environment]]\ncross = \"a\"\nrotation = 9", "1").find("'rotation' came with version 2"),
        std::string::npos);
    EXPECT_EQ(refusal("[sky]\ndate = \"2023-02-29\""),
              "x.scn:4:8: date is \"2023-02-29\", but takes a day from 1800 to 2200 such as \"2026-06-21\"");
    EXPECT_EQ(refusal("[sky]\ndirection = [0, 1, 0]\nhour = 3"),
              "x.scn:5:8: direction and hour are both given; leave one out");
    EXPECT_EQ(refusal("[sky]\ndirection = [0, 0, 0]"),
              "x.scn:4:13: direction is that to the sun, and not zero");
    EXPECT_EQ(refusal("[sky]\nturbidity = 1.5"),
              "x.scn:4:13: turbidity is 1.5, but takes a number at least 2 and at most 10");
    EXPECT_EQ(refusal("activeEnvironment = 1\n[sky]").substr(0, 12), "x.scn:3:21: ");
    EXPECT_EQ(refusal("activeEnvironment = -1\n[sky]"), "no error");
}

TEST(Scn, PositionsAreSeenFromTheModelsZero) {
    const rtcore::LocalOrigin zero{{458213, 5428765, 312}};
    const std::string byHand =
        "version = 2\nmodel = \"m\"\nup = \"+z\"\n"
        "[camera]\neye = [458213.25, 5428760, 313.5]\nlookAt = [458213.25, 5428765, 313.5]\n"
        "[[light]]\nkind = \"point\"\nposition = [458214.1, 5428765, 312]\n"
        "[[bookmark]]\nname = \"b\"\neye = [458213, 5428765, 312.1]\nforward = [1, 0, 0]\n"
        "[[measure]]\nkind = \"distance\"\n"
        "points = [[458213.001, 5428765, 312], [458214.001, 5428765, 312]]\n"
        "[[note]]\npoint = [458213.001, 5428765, 312]\ntext = \"a\"\n"
        "[fog]\nkind = \"exponential\"\ngroundHeight = 311.9\n";
    const rtcore::SceneFile scene = rtcore::parseSceneFile(byHand, "x.scn", zero);
    EXPECT_NEAR(scene.measures.all[0].points[0].x, 0.001, 1e-9);
    EXPECT_NEAR(scene.measures.all[0].points[1].x, 1.001, 1e-9);
    EXPECT_NEAR(scene.notes[0].point.x, 0.001, 1e-9);
    EXPECT_EQ(scene.camera->eye, (rtcore::Vec3{0.25F, -5, 1.5F}));
    EXPECT_EQ(scene.camera->forward, (rtcore::Vec3{0, 5, 0}));
    EXPECT_EQ(scene.lights[0].light.position, (rtcore::Vec3{1.1F, 0, 0}));
    EXPECT_EQ(scene.bookmarks[0].camera.eye, (rtcore::Vec3{0, 0, 0.1F}));
    EXPECT_EQ(scene.fog.groundHeight, -0.1F);
    const std::string written = rtcore::formatSceneFile(scene, "x.scn");
    EXPECT_NE(written.find("origin = [458213.0, 5428765.0, 312.0]\n"), std::string::npos);
    const rtcore::SceneFile again = rtcore::parseSceneFile(written, "x.scn", zero);
    EXPECT_EQ(again.camera, scene.camera);
    EXPECT_EQ(again.lights, scene.lights);
    EXPECT_EQ(again.bookmarks, scene.bookmarks);
    EXPECT_EQ(again.measures, scene.measures);
    EXPECT_EQ(again.notes, scene.notes);
    EXPECT_EQ(again.fog.groundHeight, scene.fog.groundHeight);
}

} // namespace
