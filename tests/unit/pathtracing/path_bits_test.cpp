// The same bits whatever else is in a wave, and on every instruction set.

#include "path_support.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace rtcore {
namespace {

/// Everything occurs: lobes, mirrors, glass, holes, emission, area lights, fog where there are no more lights
/// than are weighed one by one, and trees of lights and of emissive triangles where there is no fog.
Scene everything(bool foggy) {
    test::SceneBuilder b;
    Material floor = test::matte(0.8F);
    floor.diffuseTexture = b.texture(2, 1, {{255, 200, 90, 255}, {30, 60, 90, 255}});
    Material leaf = test::matte(0.5F);
    leaf.alphaTexture = b.texture(2, 1, {{100, 0, 0, 255}, {240, 0, 0, 255}});
    Material metal = test::mirror(0.5F);
    metal.fresnel = 1;
    metal.diffuse = {0.1F, 0.2F, 0.1F};
    metal.specular = {0.3F, 0.3F, 0.3F};
    metal.shininess = 40;
    b.square({0, -1, 0}, {0, 1, 0}, 6, b.material(floor));
    b.sphere({-1.2F, 0, 0}, 1, 12, b.material(metal));
    b.sphere({1.1F, -0.2F, 0.6F}, 0.8F, 12, b.material(test::glass()));
    b.square({0.2F, 0.6F, 2}, {0, 0, 1}, 0.6F, b.material(leaf));
    b.square({0, 3, -1}, {0, -1, 0}, 0.5F, b.material(test::emitter({5, 4, 3})));
    b.scene.background = {0.2F, 0.3F, 0.5F};
    Light sphere = test::pointLight({2, 2, 3}, 10);
    sphere.kind = LightKind::Sphere;
    sphere.radius = 0.4F;
    Light panel = test::pointLight({-2, 3, 2}, 10);
    panel.kind = LightKind::Rectangle;
    panel.direction = normalize({1, -2, -1});
    panel.right = basisAround(panel.direction).tangent;
    panel.width = panel.height = 0.7F;
    b.scene.lights = {sphere, panel, test::pointLight({0, 4, 1}, 5)};
    if (foggy) {
        b.scene.fog.kind = FogKind::Homogeneous;
        b.scene.fog.density = 0.05F;
        return b.finish();
    }
    for (int i = 0; i < 60; ++i) {
        const auto at = static_cast<float>(i);
        Light more = i % 2 == 0 ? sphere : panel;
        more.position = {0.1F * at - 3, 2 + std::sin(at), 2 * std::cos(at)};
        more.intensity = {0.1F, 0.2F, 0.1F};
        b.scene.lights.emplace_back(more);
    }
    const std::uint32_t shines = b.material(test::emitter({0.5F, 0.3F, 0.2F}));
    for (int i = 0; i < 4; ++i) b.sphere({static_cast<float>(i) - 2, 1.8F, -1}, 0.1F, 40, shines);
    return b.finish();
}

constexpr Vec3 kEye{0.3F, 0.8F, 6};

struct Rays {
    RayWave rays;
    std::vector<SampleId> ids;

    void add(std::uint32_t i) {
        const SampleId id{static_cast<std::uint16_t>(i % 40), static_cast<std::uint16_t>(i / 40 % 30),
                          i / 1200};
        const Vec3 to{0.1F * (static_cast<float>(id.x) - 20), 0.1F * (static_cast<float>(id.y) - 14), 0};
        rays.push({kEye, 0, normalize(to - kEye), std::numeric_limits<float>::max()});
        ids.push_back(id);
    }
};

std::vector<std::uint32_t> bitsInWavesOf(const test::PathScene& scene, std::uint32_t samples,
                                         std::uint32_t size) {
    std::vector<std::uint32_t> bits;
    for (std::uint32_t first = 0; first < samples; first += size) {
        Rays wave;
        for (std::uint32_t i = first; i < std::min(samples, first + size); ++i) wave.add(i);
        for (const Colour c : scene.trace(wave.rays, wave.ids, {})) {
            for (const float value : {c.r, c.g, c.b}) bits.push_back(std::bit_cast<std::uint32_t>(value));
        }
    }
    return bits;
}

TEST(PathBits, DoNotDependOnTheWave) {
    constexpr std::uint32_t kSamples = 3 * PathBatches::kBatch + 100;
    for (const bool foggy : {false, true}) {
        test::PathScene scene(everything(foggy));
        scene.learn(kEye, 4, 30);
        const auto whole = bitsInWavesOf(scene, kSamples, kSamples);
        for (const std::uint32_t size : {61U, 2500U}) {
            const auto parts = bitsInWavesOf(scene, kSamples, size);
            std::size_t others = 0;
            for (std::size_t i = 0; i < whole.size(); ++i) others += parts[i] != whole[i] ? 1 : 0;
            EXPECT_EQ(others, 0U) << "of " << whole.size() << " in waves of " << size << ", fog " << foggy;
        }
    }
}

TEST(PathBits, AreTheSameOnEveryInstructionSet) {
    for (const bool foggy : {false, true}) {
        test::PathScene scene(everything(foggy));
        const auto bitsOf = [&](const std::string& set) {
            EXPECT_TRUE(useInstructionSet(set));
            scene.learn(kEye, 4, 30);
            return bitsInWavesOf(scene, 2500, 1250);
        };
        const auto expected = bitsOf("scalar");
        for (const std::string& name : instructionSets()) EXPECT_EQ(bitsOf(name), expected) << name << foggy;
        useInstructionSet("auto");
    }
}

TEST(PathBits, DifferBySeed) {
    const test::PathScene scene(everything(false));
    Rays wave;
    for (std::uint32_t i = 0; i < 200; ++i) wave.add(i);
    test::PathLimits other;
    other.seed = 1;
    const auto a = scene.trace(wave.rays, wave.ids, {}), b = scene.trace(wave.rays, wave.ids, other);
    EXPECT_NE(a, b);
}

} // namespace
} // namespace rtcore
