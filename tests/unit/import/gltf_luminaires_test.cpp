/// Lights of EXT_lights_ies: their profiles, where these may lie, and how they turn with their nodes.
#include "gltf_builder.h"

#include "rtcore/io/photometry/luminaire.h"
#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/model_photometry.h"

#include <cmath>

namespace {

using namespace rtcore;
using test::GltfBuilder;
using test::Json;
using test::near;
namespace fs = std::filesystem;

/// Brightest, with 80 cd, ahead; of another brightness to each side.
const std::string kProfile = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 2 3 5 1 2 0 0 0\n1 1 10\n0 45 90\n"
                             "0 90 180 270 360\n40 30 4  40 20 3  40 10 2  40 5 1  40 30 4\n";
const char* const kMime = "application/x-ies-lm-63";

std::uint32_t profileNumber() { return keepPhotometry(parseIes(kProfile, "x").web); }

/// The square with one light of that profile, in a node of these further members.
GltfBuilder litSquare(const Json& profile, const Json& use = Json::object(),
                      const Json& more = Json::object()) {
    GltfBuilder file = test::squareFile();
    file.root["extensionsUsed"] = {"EXT_lights_ies"};
    file.root["extensionsRequired"] = {"EXT_lights_ies"};
    file.root["extensions"] = {{"EXT_lights_ies", {{"lights", {profile}}}}};
    Json node = more, light = use;
    light["light"] = 0;
    node["name"] = "downlight";
    node["extensions"] = {{"EXT_lights_ies", light}};
    file.node(node);
    return file;
}

Json asDataUri(const std::string& text) {
    return {
        {"uri", std::string("data:") + kMime + ";base64," + test::base64(std::as_bytes(std::span(text)))}};
}

/// Reads a file beside which others may lie.
FileImport importBeside(const test::TemporaryFolder& folder, const GltfBuilder& file) {
    test::writeText(folder / "m.glb", file.binary());
    auto read = importGltf(folder / "m.glb", {});
    if (!read) throw std::runtime_error("no glTF");
    return std::move(*read);
}

void expectPlain(const FileImport& read, const std::string& why) {
    ASSERT_EQ(read.model.lights.size(), 1U) << why;
    EXPECT_EQ(read.model.lights[0].kind, LightKind::Point);
    EXPECT_EQ(read.model.triangles.size(), 2U);
    EXPECT_NE(test::warningsOf(read).find(why), std::string::npos) << test::warningsOf(read);
    EXPECT_NE(test::warningsOf(read).find("shine to all sides alike"), std::string::npos);
}

TEST(GltfLuminaires, ShineAsTheSameFileInAScene) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a b.ies", kProfile);
    SceneFile scene = parseSceneFile("version = 2\nmodel = \"x.obj\"\n[[light]]\nkind = \"ies\"\n"
                                     "position = [1, 2, 3]\ndirection = [0, 0, -1]\nright = [1, 0, 0]\n"
                                     "file = \"a b.ies\"\n",
                                     folder / "x.scn");
    std::vector<Sentence> warnings;
    readLuminaire(scene.lights.at(0), 1, warnings);
    const Light expected = scene.lights[0].light;
    EXPECT_NEAR(expected.intensity.r * kLumensPerWatt, 80, 1e-4);

    const Json there = {{"translation", {1, 2, 3}}};
    GltfBuilder embedded = litSquare({{"bufferView", 0}, {"mimeType", kMime}}, Json::object(), there);
    embedded.root["extensions"]["EXT_lights_ies"]["lights"][0]["bufferView"] = embedded.view(kProfile);
    for (const GltfBuilder& file : {litSquare({{"uri", "a%20b.ies"}}, Json::object(), there),
                                    litSquare(asDataUri(kProfile), Json::object(), there), embedded}) {
        const FileImport read = importBeside(folder, file);
        EXPECT_EQ(test::warningsOf(read), "");
        ASSERT_EQ(read.model.lights.size(), 1U);
        Light light = read.model.lights[0];
        EXPECT_EQ(read.model.strings[light.nameOffset], 'd');
        light.nameOffset = 0;
        EXPECT_EQ(light, expected);
    }
    const FileImport read = importBeside(folder, litSquare({{"uri", "a%20b.ies"}}));
    EXPECT_EQ(read.report.files.size(), 2U) << "packs take it along";
}

TEST(GltfLuminaires, TurnWithTheirNodesAndKeepTheirBrightness) {
    // A quarter about x: -z becomes +y; scaled, tinted and brighter.
    const Json turned = {{"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}, {"scale", {3, 3, 3}}};
    const Json use = {{"multiplier", 2.5}, {"color", {1, 0.5, 7}}};
    const Light light = litSquare(asDataUri(kProfile), use, turned).import().model.lights.at(0);
    EXPECT_TRUE(near(light.direction, {0, 1, 0}));
    EXPECT_TRUE(near(light.right, {1, 0, 0}));
    const float brightest = 2.5F * 80 / static_cast<float>(kLumensPerWatt);
    EXPECT_TRUE(near(light.intensity, {brightest, brightest / 2, brightest}, 1e-6F)) << light.intensity.r;
    EXPECT_EQ(light.photometry, profileNumber());
}

/// C = 90 points to +y, and to -y in a node that mirrors.
TEST(GltfLuminaires, AreMirroredByTheirNodes) {
    const Light light =
        litSquare(asDataUri(kProfile), Json::object(), {{"scale", {1, -1, 1}}}).import().model.lights.at(0);
    EXPECT_TRUE(near(light.right, {1, 0, 0}));
    EXPECT_TRUE(near(light.direction, {0, 0, -1}));
    const PhotometricWeb& web = *keptWeb(light.photometry);
    EXPECT_EQ(web.planes, (std::vector<double>{0, 90, 180, 270, 360}));
    EXPECT_EQ(web.candela, (std::vector<double>{80, 60, 8, 80, 10, 2, 80, 20, 4, 80, 40, 6, 80, 60, 8}));
}

TEST(GltfLuminaires, PassThroughTheImporterProgram) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.glb", litSquare(asDataUri(kProfile)).binary());
    const ImportedModel imported = test::importFile(folder / "m.glb");
    ASSERT_EQ(imported.model.lights.size(), 1U);
    EXPECT_EQ(imported.model.lights[0].kind, LightKind::Ies);
    EXPECT_EQ(imported.model.lights[0].photometry, profileNumber());
    EXPECT_TRUE(imported.report.warnings.empty());
}

/// A candela of both is the same.
TEST(GltfLuminaires, GoTogetherWithOtherLights) {
    GltfBuilder file = litSquare(asDataUri(kProfile));
    file.root["extensions"]["KHR_lights_punctual"] = {{"lights", {{{"type", "point"}, {"intensity", 80}}}}};
    file.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const FileImport read = file.import();
    ASSERT_EQ(read.model.lights.size(), 2U);
    EXPECT_EQ(read.model.lights[0].kind, LightKind::Point);
    EXPECT_FLOAT_EQ(read.model.lights[0].intensity.r, read.model.lights[1].intensity.r);
}

TEST(GltfLuminaires, ThatAreDamagedCostThemselves) {
    expectPlain(litSquare(asDataUri(kProfile.substr(0, 80))).import(), "'lights[0]'");
    expectPlain(litSquare(asDataUri("no profile")).import(), "a line TILT= should follow");
    expectPlain(
        litSquare(asDataUri("IESNA91\nTILT=NONE\n1 1 1 2 1 1 1 0 0 0 1 1 1 0 90 0 1e-200 0\n")).import(),
        "damaged");
    expectPlain(litSquare({{"bufferView", 77}, {"name", "batwing"}}).import(), "'batwing'");
    expectPlain(litSquare({{"bufferView", 77}}).import(), "its data are damaged or missing");
    expectPlain(litSquare({{"uri", "gone.ies"}}).import(), "'gone.ies'");
    expectPlain(litSquare(asDataUri(std::string(5'000'000, 'x'))).import(), "larger than 4 MB");
    GltfBuilder unlisted = litSquare(Json::object());
    unlisted.root["extensions"].clear();
    expectPlain(unlisted.import(), "its data are damaged or missing");
}

TEST(GltfLuminaires, AreReadInTheModelsFolderAlone) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "model/x");
    test::writeText(folder / "secret.ies", kProfile);
    fs::create_symlink(folder / "secret.ies", folder / "model/link.ies");
    for (const std::string& uri : {std::string("../secret.ies"), (folder / "secret.ies").string(),
                                   std::string("link.ies"), std::string("x/../../secret.ies")}) {
        test::writeText(folder / "model/m.glb", litSquare({{"uri", uri}}).binary());
        const auto read = importGltf(folder / "model/m.glb", {});
        ASSERT_TRUE(read);
        EXPECT_EQ(read->report.files.size(), 1U) << uri;
        expectPlain(*read, "outside of the model's folder");
    }
}

TEST(GltfLuminaires, AreNoMoreThanAreKept) {
    GltfBuilder file = litSquare(asDataUri(kProfile));
    Json& lights = file.root["extensions"]["EXT_lights_ies"]["lights"];
    for (std::size_t i = 1; i < kMaxModelPhotometries + 2; ++i) {
        std::string profile = kProfile;
        profile.replace(profile.find("40 30"), 2, std::to_string(41 + i));
        lights.push_back(asDataUri(profile));
        file.node({{"extensions", {{"EXT_lights_ies", {{"light", i}}}}}});
    }
    const FileImport read = file.import();
    EXPECT_EQ(read.model.lights.size(), kMaxModelPhotometries + 2);
    EXPECT_EQ(photometriesOf(read.model.lights).size(), kMaxModelPhotometries);
    EXPECT_NE(test::warningsOf(read).find("more profiles than are kept"), std::string::npos);
}

} // namespace
