// Scenes and settings of random numbers, and of numbers that are too large or none: nothing crashes, and
// values that are not finite are counted and spoil nothing else.
#include "random_scenes.h"

#include "rtcore/render/path_renderer.h"

#include "sample_view.h"
#include "sums_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace rtcore {
namespace random_scenes {
namespace {

struct ByPaths {
    ImageSums sums;
    HdrImage image;
};

ByPaths renderPaths(const test::TracedScene& traced, const RenderSettings& settings, int threads = 1) {
    PathRenderer renderer;
    RenderControl control{.threads = threads};
    Frame frame;
    const Camera camera = test::sampleCamera();
    EXPECT_TRUE(renderer.render({traced.scene, traced.tracer, camera, settings}, control, frame));
    return {renderer.sums(), frame.radiance};
}

/// RT_RANDOM_SCENES: how many, else 40.
std::uint64_t scenesWanted() {
    const char* const wanted = std::getenv("RT_RANDOM_SCENES");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 40;
}

TEST(RandomScenes, AreRenderedByPathsAndByWhitted) {
    std::uint64_t lit = 0;
    for (std::uint64_t seed = 0; seed < scenesWanted(); ++seed) {
        SCOPED_TRACE(seed);
        test::RandomScene random(seed);
        const test::TracedScene traced(random.scene());
        const RenderSettings settings = random.settings();
        const ByPaths paths = renderPaths(traced, settings);
        EXPECT_EQ(test::samplesOf(paths.sums) + paths.sums.dropped(),
                  64U * static_cast<std::uint64_t>(settings.path.samples));
        double sum = 0;
        for (const Colour c : paths.image.pixels) {
            EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
            sum += c.g;
        }
        lit += sum > 0 ? 1 : 0;
        EXPECT_TRUE(renderPaths(traced, settings, 2).sums == paths.sums);
        EXPECT_EQ(test::render(traced, settings).radiance.pixels.size(), 64U);
    }
    EXPECT_GT(lit, scenesWanted() / 2);
}

// --- One thing that is odd ---

/// On the left a square of its own that emits; the right is lit by a light.
Scene twoHalves(const Material& left) {
    test::SceneBuilder b;
    b.square({-1.6F, 0, 0}, {0, 0, 1}, 1.2F, b.material(left));
    b.square({1.6F, 0, 0}, {0, 0, 1}, 1.2F, b.material(test::matte(0.5F)));
    b.scene.lights = {test::pointLight({1.6F, 0, 2}, 3)};
    return b.finish();
}

RenderSettings halvesSettings(EmitterLight emitters) {
    RenderSettings settings = test::sampleSettings(32, 16);
    settings.path.samples = 4;
    settings.path.bounces = 2;
    settings.path.emitters = emitters;
    return settings;
}

constexpr std::array<float, 5> kTooLarge{
    std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity(), 1e30F, std::numeric_limits<float>::max()};

TEST(OddNumbers, OfAMaterialSpoilNothingBesideIt) {
    const RenderSettings settings = halvesSettings(EmitterLight::Off);
    const HdrImage plain = renderPaths(test::TracedScene(twoHalves(test::matte(0))), settings).image;
    for (const float odd : kTooLarge) {
        for (const int field : {0, 1, 2, 3}) {
            Material m = test::matte(0.5F);
            if (field == 0) m.emission = {odd, odd, odd};
            if (field == 1) m.diffuse = {odd, 0, 0};
            if (field == 2) m.specular = {0, odd, 0};
            if (field == 3) m.mirror = {0, 0, odd};
            const ByPaths paths = renderPaths(test::TracedScene(twoHalves(m)), settings);
            EXPECT_EQ(test::samplesOf(paths.sums) + paths.sums.dropped(), 32U * 16 * 4);
            if (field == 0 && !std::isfinite(odd)) {
                EXPECT_GT(paths.sums.dropped(), 0U) << "it is told";
            }
            double difference = 0, light = 0;
            for (int y = 0; y < 16; ++y) {
                for (int x = 17; x < 32; ++x) {
                    difference += std::abs(paths.image.at(x, y).g - plain.at(x, y).g);
                    light += plain.at(x, y).g;
                }
            }
            EXPECT_GT(light, 1);
            EXPECT_LT(difference, 1e-3 * light) << odd << " in " << field;
        }
    }
}

TEST(OddNumbers, OfOneLightSpoilNoOther) {
    const RenderSettings settings = halvesSettings(EmitterLight::On);
    for (const float odd : kTooLarge) {
        Scene scene = twoHalves(test::matte(0.5F));
        Light light = test::pointLight({-1.6F, 0, -5}, odd); // behind both squares
        scene.lights.push_back(light);
        const ByPaths paths = renderPaths(test::TracedScene(std::move(scene)), settings);
        EXPECT_EQ(test::samplesOf(paths.sums) + paths.sums.dropped(), 32U * 16 * 4);
        EXPECT_GT(paths.image.at(24, 8).g, 0.05F) << odd;
    }
}

TEST(OddNumbers, OfOneTexelOfASkySpoilNoOther) {
    const RenderSettings settings = halvesSettings(EmitterLight::On);
    for (const float odd : kTooLarge) {
        Scene scene = twoHalves(test::matte(0.5F));
        HdrImage image(16, 8, kWhite * 0.5F);
        image.at(0, 4) = {odd, odd, odd}; // behind the camera
        scene.environments = {
            std::make_shared<const Environment>(Environment::fromEquirectangular(image, ""))};
        const ByPaths paths = renderPaths(test::TracedScene(std::move(scene)), settings);
        EXPECT_EQ(test::samplesOf(paths.sums) + paths.sums.dropped(), 32U * 16 * 4);
        EXPECT_NEAR(paths.image.at(16, 0).g, 0.5F, 1e-3F) << odd << ": what is seen of it elsewhere";
        EXPECT_GT(paths.image.at(24, 8).g, 0.05F) << odd;
    }
}

} // namespace
} // namespace random_scenes
} // namespace rtcore
