#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/written_mark.h"

#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <algorithm>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

namespace {

using rtcore::Colour;
using rtcore::SceneFile;
using rtcore::Vec3;
using test::Random;

Colour fraction(Random& random, float max) {
    return {max * random.fraction(), max * random.fraction(), max * random.fraction()};
}
Colour positive(Random& random) { return {random.positive(), random.positive(), random.positive()}; }
Vec3 point(Random& random) { return {random.number(), random.number(), random.number()}; }

rtcore::KeptMeasure randomMeasure(Random& random, const std::string& name) {
    rtcore::KeptMeasure measure{.kind = static_cast<rtcore::MeasureKind>(random.below(6)), .points = {}};
    constexpr std::array<std::size_t, 6> counts{2, 7, 3, 2, 1, 1};
    for (std::size_t n = counts.at(static_cast<std::size_t>(measure.kind)); n > 0; --n)
        measure.points.push_back({double{random.fraction()} / 3, static_cast<double>(n) * 1e11 / 7,
                                  -1.0 / static_cast<double>(n)});
    const bool sized = measure.points.size() == 1;
    if (sized) measure.amount = double{random.fraction()} / 3;
    if (measure.kind == rtcore::MeasureKind::Area) measure.normal = {random.fraction(), 1, 0};
    if (measure.kind == rtcore::MeasureKind::Volume) measure.part = 7;
    if (random.flag()) measure.name = name;
    return measure;
}

std::string noteOf(Random& random) {
    constexpr std::array<std::string_view, 9> pieces{
        "a", "\n", "\t", "\"", "\\", "\xC5\xBD", "\xF0\x9F\x98\x80", "#", "'"};
    std::string text = "n";
    for (std::size_t n = random.below(12); n > 0; --n) text += pieces.at(random.below(pieces.size()));
    return text;
}

rtcore::SceneNote randomNote(Random& random, const std::optional<rtcore::Camera>& view) {
    rtcore::SceneNote note{
        .point = {double{random.fraction()} / 3, 1e11 / 7, -1.0 / 3}, .text = noteOf(random), .view = view};
    if (random.flag()) note.author = "Ada \"A\" \xC5\xBD";
    if (random.flag()) note.written = "2026-11-30T18:40:00Z";
    return note;
}

rtcore::Flight randomFlight(Random& random, const std::string& name,
                            const std::function<rtcore::Camera()>& camera) {
    rtcore::Flight flight{.name = name, .seconds = 0.1 + double{random.fraction()}};
    if (random.flag()) flight.target = rtcore::Vec3d{double{random.fraction()} / 3, 1e11 / 7, -1.0 / 3};
    flight.closed = random.flag();
    if (random.flag()) {
        flight.timing = rtcore::FlightTiming::Times;
        flight.seconds = 10; // that of flights that say none
        flight.closed = false;
    } else if (flight.target && random.flag()) {
        flight.turns = 0.1 + double{random.fraction()};
    }
    const rtcore::CameraKind kind = camera().kind;
    for (std::size_t n = flight.turns != 0 ? 0 : random.below(4); true; --n) {
        rtcore::FlightKey key{.camera = camera()};
        while (key.camera.kind != kind) key.camera = camera();
        if (random.flag()) key.exposure = 0.1F + random.fraction();
        if (flight.timing == rtcore::FlightTiming::Times && !flight.keys.empty())
            key.time = flight.keys.back().time + 0.1 + double{random.fraction()};
        flight.keys.push_back(key);
        if (n == 0) return flight;
    }
}

/// With quotes, backslashes, control characters and letters of two to four bytes; never empty.
std::string awkwardName(Random& random) {
    constexpr std::array<std::string_view, 17> pieces{
        "a",          "\"", "\\", "\n", "\t", "\x01",   "\x7F",   "\u00e4", "\u20ac",
        "\U0001F4A1", "'",  " ",  "\r", "#",  "\u009b", "\u202e", "\u2028"};
    std::string name;
    for (std::size_t n = 1 + random.below(12); n > 0; --n) name += pieces.at(random.below(pieces.size()));
    return name;
}

rtcore::LightDescription randomLight(Random& random) {
    rtcore::LightDescription result;
    rtcore::Light& light = result.light;
    if (random.flag()) result.name = awkwardName(random);
    light.kind = static_cast<rtcore::LightKind>(random.below(rtcore::kLightKinds));
    const rtcore::LightTraits& traits = traitsOf(light);
    if (traits.position) {
        light.position = point(random);
        light.radius = random.positive();
    }
    if (traits.direction) light.direction = rtcore::normalize(point(random));
    if (traits.turns()) light.right = rtcore::basisAround(light.direction).tangent;
    if (traits.beam == rtcore::Beam::Measured && random.flag()) {
        result.file = "/l/" + awkwardName(random);
        if (random.flag()) result.lumens = random.positive();
    }
    if (traits.sides) {
        light.width = random.positive();
        light.height = random.positive();
    }
    light.intensity = positive(random);
    if (traits.disc && random.flag()) light.discSine = random.fraction();
    if (isAreaLight(light.kind)) light.mirrored = random.flag() ? 1 : 0;
    if (traits.beam == rtcore::Beam::Cone) {
        light.cosOuter = random.fraction() - 0.5F;
        light.cosInner = light.cosOuter + 0.1F + 0.4F * random.fraction();
    }
    light.on = random.flag() ? 1 : 0;
    if (random.flag()) result.temperature = 1700 + 23000 * random.fraction();
    return result;
}

rtcore::MaterialOverride randomMaterial(Random& random) {
    rtcore::MaterialOverride m;
    if (random.flag()) {
        m.number = 1 + static_cast<int>(random.below(1000));
    } else {
        m.pattern = awkwardName(random);
    }
    if (random.flag()) m.diffuse = fraction(random, 0.5F);
    if (random.flag()) m.specular = fraction(random, 0.5F);
    if (random.flag()) m.transmission = fraction(random, 1);
    if (random.flag()) m.emission = positive(random);
    if (random.flag()) m.reflectivity = fraction(random, 1);
    if (random.flag()) m.shininess = 100'000 * random.fraction();
    if (random.flag()) m.opacity = random.fraction();
    if (random.flag()) m.attenuationDistance = random.positive();
    if (random.flag()) m.indexOfRefraction = 1 + 4 * random.fraction();
    if (random.flag()) m.priority = std::floor(100 * random.fraction());
    if (random.flag()) m.roughness = random.fraction();
    if (random.flag()) m.metallic = random.fraction();
    if (random.flag()) m.textures = random.flag();
    if (random.flag()) m.flipTextures = random.flag();
    if (random.flag()) m.fresnel = random.flag();
    if (random.flag()) m.diffuseTexture = "/t/" + awkwardName(random);
    return m;
}

rtcore::PartDescription randomPart(Random& random) {
    const bool numbered = random.flag();
    rtcore::PartDescription part{numbered ? "" : awkwardName(random), {}, {}, {}};
    if (numbered) part.number = 1 + static_cast<int>(random.below(1000));
    if (random.flag()) part.hidden = random.flag();
    if (!part.hidden || random.flag()) part.uncut = random.flag();
    return part;
}

rtcore::EnvironmentFile randomEnvironment(Random& random) {
    rtcore::EnvironmentFile environment;
    environment.kind = static_cast<rtcore::EnvironmentKind>(random.below(5));
    const bool shell = environment.kind == rtcore::EnvironmentKind::Parts;
    const std::size_t count = environment.kind == rtcore::EnvironmentKind::Faces ? 6 : shell ? 0 : 1;
    for (std::size_t i = 0; i < count; ++i) environment.files.emplace_back("/e/" + awkwardName(random));
    if (shell) environment.parts = {awkwardName(random), awkwardName(random)};
    if (random.flag()) environment.name = awkwardName(random);
    environment.intensity = random.positive();
    if (random.flag()) environment.rotation = 720 * random.fraction() - 360;
    return environment;
}

rtcore::Sky randomSky(Random& random) {
    rtcore::Sky sky;
    if (random.flag()) {
        sky.date.reset();
        sky.direction = point(random);
    } else {
        const int month = 1 + static_cast<int>(random.below(12));
        const int year = 1800 + static_cast<int>(random.below(401));
        const auto days = static_cast<std::size_t>(rtcore::daysOfMonth(year, month));
        sky.date = rtcore::SunDate{.year = year,
                                   .month = month,
                                   .day = 1 + static_cast<int>(random.below(days)),
                                   .second = static_cast<int>(random.below(86401)),
                                   .timeZone = static_cast<double>(random.below(30)) - 14.75,
                                   .latitude = 180 * static_cast<double>(random.fraction()) - 90,
                                   .longitude = 360 * static_cast<double>(random.fraction()) - 180};
    }
    sky.north = 720 * random.fraction() - 360;
    sky.turbidity = 2 + 8 * random.fraction();
    sky.strength = random.positive();
    sky.ground = random.fraction() < 0.5F;
    sky.studio = random.flag();
    return sky;
}

rtcore::SceneVariant randomVariant(Random& random) {
    rtcore::SceneVariant variant;
    for (std::size_t n = random.below(3); n > 0; --n) {
        variant.materials.push_back(randomMaterial(random));
        variant.materials.back().diffuseTexture.reset();
        variant.parts.push_back(randomPart(random));
        variant.parts.back().hidden = random.flag();
        variant.parts.back().uncut.reset();
        variant.lights.push_back(randomLight(random));
        variant.lights.back().id = static_cast<int>(n);
        variant.removedLights.push_back(static_cast<int>(10 + n));
    }
    if (random.flag()) return variant;
    rtcore::VariantSurroundings all{positive(random), positive(random), random.flag()};
    if (random.flag()) all.environment = static_cast<int>(random.below(3)) - 1;
    if (random.flag()) all.sky = randomSky(random);
    if (all.sky && random.flag()) all.sunId = 7;
    variant.surroundings = all;
    return variant;
}

void addVariants(Random& random, SceneFile& scene) {
    for (std::size_t n = random.below(4); n > 0; --n) {
        scene.variants.push_back(randomVariant(random));
        scene.variants.back().name = std::to_string(n) + "\"\xC5\xBD\\";
    }
    if (scene.variants.empty()) return;
    if (random.flag()) scene.activeVariant = scene.variants.front().name;
    if (random.flag()) scene.shown = randomVariant(random);
}

rtcore::Camera randomSceneCamera(Random& random) {
    return {point(random),
            {1, 0.1F * random.fraction(), 0},
            {0, 1, random.fraction()},
            0.1F + 179 * random.fraction()};
}

SceneFile randomScene(Random& random) {
    SceneFile s;
    s.model = "/m/" + awkwardName(random);
    if (random.flag()) s.settings = "/s/" + awkwardName(random);
    if (random.flag()) s.output = "/o/" + awkwardName(random);
    s.metresPerUnit = 1e-6F + random.fraction();
    s.up = random.flag() ? Vec3{0, 0, 1} : Vec3{-1, 0, 0};
    s.background = positive(random);
    s.ambient = positive(random);
    s.modelLights = random.flag();
    s.defaultLight = random.flag();
    s.flipTextures = random.flag();
    s.creaseAngle = 180 * random.fraction();
    const auto near = [&] { return std::clamp(random.number(), -1e12F, 1e12F); };
    for (std::size_t n = random.below(4); n > 0; --n)
        s.sections.planes.push_back({{near(), near(), near()}, {0, random.number(), 1}});
    if (random.flag()) s.sections.light = rtcore::SectionLight::Cut;
    if (random.flag())
        s.sections.caps = {rtcore::CapColours::One, {random.fraction(), random.fraction(), 0}, random.flag()};
    if (random.flag()) s.deflection = 1e-6F + 0.09F * random.fraction();
    if (random.flag())
        s.pose = {rtcore::PoseChoice::Kind::Moment, awkwardName(random), double{random.number()}};
    if (random.flag()) {
        s.camera = randomSceneCamera(random);
    } else if (random.flag()) {
        s.cameraFile = "/c/" + awkwardName(random);
    }
    for (std::size_t n = random.below(4); n > 0; --n)
        s.bookmarks.push_back({std::to_string(n) + awkwardName(random), randomSceneCamera(random)});
    for (std::size_t n = random.below(4); n > 0; --n)
        s.measures.all.push_back(randomMeasure(random, awkwardName(random)));
    for (std::size_t n = random.below(4); n > 0; --n)
        s.notes.push_back(
            randomNote(random, random.flag() ? std::optional(randomSceneCamera(random)) : std::nullopt));
    for (std::size_t n = random.below(4); n > 0; --n)
        s.flights.push_back(randomFlight(random, std::to_string(n) + "\"\xC5\xBD\\",
                                         [&] { return randomSceneCamera(random); }));
    addVariants(random, s);
    if (random.flag()) s.measures.unit = rtcore::LengthUnit::Inch;
    s.measures.decimals = static_cast<int>(random.below(7));
    for (std::size_t n = random.below(4); n > 0; --n) s.lights.push_back(randomLight(random));
    for (std::size_t n = random.below(4); n > 0; --n) s.materials.push_back(randomMaterial(random));
    for (std::size_t n = random.below(4); n > 0; --n) s.parts.push_back(randomPart(random));
    for (std::size_t n = random.below(4); n > 0; --n) s.environments.push_back(randomEnvironment(random));
    if (random.flag()) {
        s.sky = randomSky(random);
        s.sun = {random.flag() ? 0 : 7, random.flag()};
    }
    const std::size_t environments = s.environments.size() + (s.sky ? 1 : 0);
    if (environments > 0) s.activeEnvironment = static_cast<int>(random.below(environments + 1)) - 1;
    s.fog.kind = static_cast<rtcore::FogKind>(random.below(3));
    s.fog.density = random.positive();
    s.fog.scaleHeight = random.positive();
    s.fog.groundHeight = random.number();
    s.fog.colour = positive(random);
    s.fog.albedo = {random.fraction(), random.fraction(), random.fraction()};
    s.fog.surroundings = random.positive();
    s.fog.emission = positive(random);
    s.walk = {random.positive(), random.positive(), random.positive(), random.positive(), random.positive()};
    if (random.flag()) s.live = {{"width", 17}, {"exposure.key", 0.1F + random.fraction()}};
    if (random.flag()) s.still = {{"shadows", false}, {"toneMapping", std::string("channels")}};
    return s;
}

void expectEqual(const SceneFile& a, const SceneFile& b) {
    EXPECT_EQ(a.model, b.model);
    EXPECT_EQ(a.settings, b.settings);
    EXPECT_EQ(a.output, b.output);
    EXPECT_EQ(a.metresPerUnit, b.metresPerUnit);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.background, b.background);
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.modelLights, b.modelLights);
    EXPECT_EQ(a.defaultLight, b.defaultLight);
    EXPECT_EQ(a.bookmarks, b.bookmarks);
    EXPECT_EQ(a.measures, b.measures);
    EXPECT_EQ(a.notes, b.notes);
    EXPECT_EQ(a.flights, b.flights);
    EXPECT_EQ(a.variants, b.variants);
    EXPECT_EQ(a.activeVariant, b.activeVariant);
    EXPECT_EQ(a.shown, b.shown);
    EXPECT_EQ(a.flipTextures, b.flipTextures);
    EXPECT_EQ(a.pose, b.pose);
    EXPECT_EQ(a.deflection, b.deflection);
    EXPECT_EQ(a.sections, b.sections);
    EXPECT_EQ(a.activeEnvironment, b.activeEnvironment);
    EXPECT_EQ(a.creaseAngle, b.creaseAngle);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.cameraFile, b.cameraFile);
    EXPECT_EQ(a.lights, b.lights);
    EXPECT_EQ(a.materials, b.materials);
    EXPECT_EQ(a.parts, b.parts);
    EXPECT_EQ(a.environments, b.environments);
    EXPECT_EQ(a.sky, b.sky);
    EXPECT_EQ(a.sun, b.sun);
    EXPECT_EQ(a.fog.kind, b.fog.kind);
    EXPECT_EQ(a.fog.density, b.fog.density);
    EXPECT_EQ(a.fog.scaleHeight, b.fog.scaleHeight);
    EXPECT_EQ(a.fog.groundHeight, b.fog.groundHeight);
    EXPECT_EQ(a.fog.colour, b.fog.colour);
    EXPECT_EQ(a.fog.albedo, b.fog.albedo);
    EXPECT_EQ(a.fog.surroundings, b.fog.surroundings);
    EXPECT_EQ(a.fog.emission, b.fog.emission);
    EXPECT_EQ(a.walk.height, b.walk.height);
    EXPECT_EQ(a.walk.speed, b.walk.speed);
    EXPECT_EQ(a.walk.jumpHeight, b.walk.jumpHeight);
    EXPECT_EQ(a.walk.stepHeight, b.walk.stepHeight);
    EXPECT_EQ(a.walk.gravity, b.walk.gravity);
    EXPECT_EQ(a.live, b.live);
    EXPECT_EQ(a.still, b.still);
}

TEST(ScnRoundTrip, RandomScenesSurviveBitForBit) {
    Random random(41);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        const SceneFile scene = randomScene(random);
        const std::string text = rtcore::formatSceneFile(scene, "/somewhere/x.scn");
        SCOPED_TRACE(text);
        expectEqual(rtcore::parseSceneFile(text, "/somewhere/x.scn"), scene);
    }
}

TEST(ScnRoundTrip, WhatWasWrittenIsKnownUntilItIsChangedByHand) {
    Random random(43);
    const std::string text = rtcore::formatSceneFile(randomScene(random), "/somewhere/x.scn");
    EXPECT_TRUE(rtcore::hasWrittenMark(text));
    EXPECT_FALSE(rtcore::hasWrittenMark(text + "# the sun of June\n"));
    EXPECT_FALSE(rtcore::hasWrittenMark(text.substr(text.find('\n') + 1)));
    EXPECT_FALSE(rtcore::hasWrittenMark(text.substr(0, text.find('\n'))));
    EXPECT_FALSE(rtcore::hasWrittenMark(""));
}

TEST(ScnRoundTrip, PathsBelowTheSceneAreWrittenRelative) {
    const test::TemporaryFolder folder;
    SceneFile scene;
    scene.model = folder / "models/a.obj";
    scene.settings = folder.path().parent_path() / "b.set";
    scene.output = folder / "deep/../c.png";
    rtcore::writeSceneFile(folder / "x.scn", scene);
    const std::string text = test::fileContent(folder / "x.scn");
    EXPECT_NE(text.find("model = \"models/a.obj\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("settings = \"" + scene.settings->string() + "\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("output = \"c.png\"\n"), std::string::npos) << text;
    EXPECT_EQ(rtcore::readSceneFile(folder / "x.scn").model, scene.model);
    EXPECT_EQ(rtcore::readSceneFile(folder / "x.scn").settings, scene.settings);
}

TEST(ScnRoundTrip, PathsUpwardsBehindALinkStayWhatTheyAre) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "there/below");
    std::filesystem::create_directories(folder / "here");
    std::filesystem::create_directory_symlink(folder / "there/below", folder / "here/link");
    SceneFile scene;
    scene.model = folder / "here/link/../a.obj"; // there/a.obj
    for (const char* name : {"there/a.obj", "here/a.obj"}) {
        rtcore::writeSceneFile(folder / "here/x.scn", scene);
        EXPECT_EQ(rtcore::readSceneFile(folder / "here/x.scn").model, scene.model) << name;
        std::ofstream(folder / name) << "v 0 0 0";
    }
}

TEST(ScnRoundTrip, PathsOfASceneInTheCurrentFolderAreRelativeToIt) {
    SceneFile scene;
    scene.model = "a/b.obj";
    const SceneFile again = rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "x.scn"), "x.scn");
    EXPECT_EQ(again.model, scene.model);
}

TEST(ScnRoundTrip, WhatCouldNotBeReadIsNotWritten) {
    const test::TemporaryFolder folder;
    SceneFile good;
    good.model = "a.obj";
    std::vector<SceneFile> bad(18, good);
    bad[0].model = "";
    bad[1].up = {0, 1, 1};
    bad[2].fog.density = -1;
    bad[3].environments.resize(1);
    bad[4].camera.emplace();
    bad[4].cameraFile = "a.cam";
    bad[5].model = "\xFF.obj";
    bad[6].materials.resize(1);
    bad[7].walk.gravity = std::numeric_limits<float>::infinity();
    bad[8].bookmarks.resize(1);
    bad[9].bookmarks = {{"a", {}}, {"a", {}}};
    bad[14].measures.all.resize(1);
    bad[15].measures.decimals = 7;
    bad[16].notes.resize(1); // without a text
    bad[17].flights = {{.name = "a"}};
    for (std::size_t i = 10; i < 14; ++i) bad[i].sky.emplace();
    bad[10].sky->turbidity = 1;
    bad[11].sky->date->day = 31; // of June
    bad[12].sky->date->latitude = 91;
    bad[13].sky->date.reset();
    bad[13].sky->direction = {};
    for (const SceneFile& scene : bad) {
        EXPECT_THROW(rtcore::writeSceneFile(folder / "x.scn", scene), rtcore::FileError);
        EXPECT_FALSE(std::filesystem::exists(folder / "x.scn"));
    }
    rtcore::writeSceneFile(folder / "x.scn", good);
    EXPECT_TRUE(std::filesystem::exists(folder / "x.scn"));
}

} // namespace
