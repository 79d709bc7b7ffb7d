// Luminaires of files as lights: illuminances are the published intensities over the square of the distance.
#include "rtcore/io/photometry/luminaire.h"
#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/platform/error.h"
#include "rtcore/scene/light_power.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rtcore {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A scene file with one light of that file, and further lines for it.
LightDescription lightOf(const std::string& file, const std::string& more = "", float metresPerUnit = 1) {
    const SceneFile scene = parseSceneFile("version = 2\nmodel = \"x.obj\"\n[[light]]\nkind = \"ies\"\n"
                                           "position = [1, 3, 2]\ndirection = [0, -1, 0]\nright = [1, 0, 0]\n"
                                           "file = \"" +
                                               file + "\"\n" + more,
                                           RT_PHOTOMETRIC_FILES "/x.scn");
    LightDescription light = scene.lights.at(0);
    std::vector<Sentence> warnings;
    readLuminaire(light, metresPerUnit, warnings);
    EXPECT_TRUE(warnings.empty());
    return light;
}

/// Lux on a surface that faces the light, so many metres from it, at these angles in degrees.
double luxAt(const LightDescription& description, double gamma, double c, double metres,
             float metresPerUnit = 1) {
    const Light light = tintedLight(description);
    // One looks along the axis, which points to -y: counter-clockwise is from x to -z.
    const double ring = std::sin(gamma * kDegree);
    const Vec3 away{static_cast<float>(ring * std::cos(c * kDegree)),
                    static_cast<float>(-std::cos(gamma * kDegree)),
                    static_cast<float>(-ring * std::sin(c * kDegree))};
    const Vec3 position = light.position + away * static_cast<float>(metres / metresPerUnit);
    const auto sample = HWY_NAMESPACE::sampleLight<LightKind::Ies, float>(light, position);
    return kLumensPerWatt * luminance(Colour{sample.irradiance.x, sample.irradiance.y, sample.irradiance.z});
}

/// Within 0.5 %, at all angles of the file and between them: on the axis and off it.
TEST(Luminaire, ThrowsThePublishedIntensities) {
    for (const char* const file : {"narrow.ies", "batwing.ies", "asymmetric.ldt"}) {
        const LightDescription light = lightOf(file);
        const PhotometricWeb web = readPhotometricFile(std::string(RT_PHOTOMETRIC_FILES "/") + file).web;
        int lit = 0;
        double worst = 0;
        for (std::size_t plane = 0; plane < web.planes.size(); ++plane) {
            for (std::size_t i = 0; i + 1 < web.gammas.size(); ++i) {
                const double published = web.candela[plane * web.gammas.size() + i];
                if (!(published > 1)) continue;
                for (const double metres : {0.5, 2.0, 20.0}) {
                    const double lux = luxAt(light, web.gammas[i], web.planes[plane], metres);
                    worst = std::max(worst, std::fabs(lux * metres * metres / published - 1));
                }
                ++lit;
            }
        }
        EXPECT_LT(worst, 5e-3) << file;
        EXPECT_GT(lit, 10);
        std::printf("%s: %d directions, largest error %.2e\n", file, lit, worst);
    }
}

TEST(Luminaire, IsBilinearBetweenItsAngles) {
    const LightDescription light = lightOf("batwing.ies");
    const PhotometricWeb web = readPhotometricFile(RT_PHOTOMETRIC_FILES "/batwing.ies").web;
    const auto candela = [&](std::size_t plane, std::size_t i) {
        return web.candela[plane * web.gammas.size() + i];
    };
    const double between = 0.25 * (0.6 * candela(2, 7) + 0.4 * candela(2, 8)) +
                           0.75 * (0.6 * candela(3, 7) + 0.4 * candela(3, 8));
    EXPECT_NEAR(luxAt(light, 37, 45 + 0.75 * 22.5, 3) * 9 / between, 1, 1e-5);
    EXPECT_EQ(luxAt(light, 91, 20, 1), 0);
}

/// The power that windows and commands show is the flux of the file, and a unit of centimetres changes no
/// lux.
TEST(Luminaire, HasTheLumensOfItsFile) {
    for (const char* const file : {"narrow.ies", "batwing.ies", "asymmetric.ldt"}) {
        const double flux = lumensOf(readPhotometricFile(std::string(RT_PHOTOMETRIC_FILES "/") + file).web);
        for (const float unit : {1.0F, 0.01F}) {
            const LightDescription light = lightOf(file, "", unit);
            const auto power = double{powerOf(tintedLight(light))};
            EXPECT_NEAR(kLumensPerWatt * radiantWatts(light.light, power, double{unit}) / flux, 1, 1e-5);
            EXPECT_NEAR(luxAt(light, 10, 30, 2, unit) / luxAt(lightOf(file), 10, 30, 2), 1, 1e-4);
        }
    }
}

TEST(Luminaire, TakesLumensAndColourFromTheScene) {
    const auto lumens = [](const LightDescription& light) {
        return kLumensPerWatt * double{powerOf(tintedLight(light))};
    };
    const LightDescription given = lightOf("batwing.ies", "lumens = 1200\nintensity = [1, 0.5, 0.25]\n");
    EXPECT_NEAR(lumens(given), 1200, 0.01);
    EXPECT_NEAR(given.light.intensity.g / given.light.intensity.r, 0.5F, 1e-6F);
    EXPECT_NEAR(lumens(lightOf("batwing.ies", "lumens = 1200\ntemperature = 2700\n")), 1200, 0.01);
    EXPECT_NEAR(lumens(lightOf("batwing.ies", "lumens = 0\nintensity = [1, 0.5, 0.25]\n")),
                lumens(lightOf("batwing.ies")), 0.01);
    const LightDescription plain = lightOf("batwing.ies", "intensity = [7, 8, 9]\n");
    EXPECT_EQ(plain.light.intensity, (Colour{7, 8, 9}));
    EXPECT_FALSE(plain.lumens);
}

/// What was read is written as it shines, with the file's name seen from the scene.
TEST(Luminaire, IsWrittenAsItShines) {
    SceneFile scene;
    scene.model = "x.obj";
    scene.lights = {lightOf("narrow.ies", "temperature = 3000\n")};
    const std::string text = formatSceneFile(scene, RT_PHOTOMETRIC_FILES "/y.scn");
    EXPECT_NE(text.find("\nfile = \"narrow.ies\"\n"), std::string::npos) << text;
    LightDescription again = parseSceneFile(text, RT_PHOTOMETRIC_FILES "/y.scn").lights.at(0);
    std::vector<Sentence> warnings;
    readLuminaire(again, 1, warnings);
    EXPECT_EQ(again, scene.lights[0]);
}

TEST(Luminaire, IsRefusedWithoutItsFile) {
    EXPECT_THROW(lightOf("missing.ies"), FileError);
    const auto refusal = [](const std::string& light) -> std::string {
        try {
            parseSceneFile("version = 2\nmodel = \"x\"\n[[light]]\nposition = [0, 0, 0]\n" + light, "/x.scn");
        } catch (const FileError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("kind = \"point\"\nfile = \"a.ies\"\n"),
              "/x.scn:6:8: only a light of the kind ies has a file and lumens");
    EXPECT_EQ(refusal("kind = \"point\"\nmodelLuminaire = 1\n"),
              "/x.scn:6:18: only a light of the kind ies has a file and lumens");
    EXPECT_EQ(refusal("kind = \"ies\"\ndirection = [0, -1, 0]\nfile = \"a.ies\"\nmodelLuminaire = 1\n"),
              "/x.scn:8:18: it shines either by a file or as a luminaire of the model");
    EXPECT_EQ(refusal("kind = \"ies\"\ndirection = [0, -1, 0]\nlumens = 800\n"),
              "/x.scn:7:10: lumens are those of a file; name it by file, or give an intensity");
}

} // namespace
} // namespace rtcore
