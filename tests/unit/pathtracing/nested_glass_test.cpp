// Media that lie in each other, overlap and touch: closed forms of stacked layers, by both integrators.

#include "path_support.h"

#include "rtcore/scene/media_crossing.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {
namespace {

using test::SceneBuilder;

/// Of light along an angle in air: what a stack of layers lets through and mirrors, with all reflections
/// between them, each of unpolarised light.
struct Layer {
    double index, thickness, extinction;
};

double fresnel(double sine, double n1, double n2) {
    const double s1 = sine / n1, s2 = sine / n2;
    const double c1 = std::sqrt(1 - s1 * s1), c2 = std::sqrt(1 - s2 * s2);
    const double rs = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    const double rp = (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2);
    return (rs * rs + rp * rp) / 2;
}

struct Stack {
    double through = 1, front = 0, back = 0; ///< mirrored of light from the viewer's side, and the other

    void add(double t, double r) { ///< a boundary, or with r = 0 a way through a medium
        const double between = 1 / (1 - back * r);
        front += through * through * r * between;
        back = r + t * t * back * between;
        through *= t * between;
    }
};

Stack stackOf(const std::vector<Layer>& layers, double degrees) {
    const double sine = std::sin(degrees * test::kPi / 180);
    Stack stack;
    double before = 1;
    for (const Layer& layer : layers) {
        const double r = fresnel(sine, before, layer.index);
        if (layer.index != before) stack.add(1 - r, r);
        const double cosine = std::sqrt(1 - std::pow(sine / layer.index, 2));
        stack.add(std::exp(-layer.extinction * layer.thickness / cosine), 0);
        before = layer.index;
    }
    const double r = fresnel(sine, before, 1);
    stack.add(1 - r, r);
    return stack;
}

double shiftOf(const std::vector<Layer>& layers, double degrees) {
    const double sine = std::sin(degrees * test::kPi / 180);
    double shift = 0;
    for (const Layer& layer : layers) shift += layer.thickness * std::tan(std::asin(sine / layer.index));
    return shift;
}

constexpr float kWater = 1.33F, kGlass = 1.5F;
constexpr double kWaterExtinction = 0.2, kGlassExtinction = 0.1;

Material medium(float index, double extinction, float priority = 0) {
    Material m = test::glass(index);
    m.transmission = kWhite * 0.5F;
    m.attenuationDistance = static_cast<float>(std::log(2) / extinction);
    m.priority = priority;
    return m;
}

/// Layers of glass, water, glass, 1 thick each, their top at y = 0.
const std::vector<Layer> kLayers{
    {kGlass, 1, kGlassExtinction}, {kWater, 1, kWaterExtinction}, {kGlass, 1, kGlassExtinction}};

enum class Built { ByPriority, ByPriorityWaterFirst, ByNesting, Touching };
constexpr Built kBuilt[] = {Built::ByPriority, Built::ByPriorityWaterFirst, Built::ByNesting,
                            Built::Touching};

void addLayers(SceneBuilder& b, Built built) {
    const bool priority = built == Built::ByPriority || built == Built::ByPriorityWaterFirst;
    const auto glass = b.material(medium(kGlass, kGlassExtinction, priority ? 2 : 0));
    const auto water = b.material(medium(kWater, kWaterExtinction, priority ? 1 : 0));
    const auto box = [&](float lo, float hi, std::uint32_t material) {
        b.box({-50, lo, -50}, {50, hi, 50}, material);
    };
    if (built == Built::ByPriorityWaterFirst) box(-2.03F, -0.96F, water);
    if (built == Built::ByNesting) {
        box(-3, 0, glass);
        b.box({-49, -2, -49}, {49, -1, 49}, water);
        return;
    }
    box(-1, 0, glass);
    box(-3, -2, glass);
    if (built == Built::ByPriority) box(-2.03F, -0.96F, water);
    if (built == Built::Touching) box(-2, -1, water);
}

/// Above a floor of light.
Scene layersOverLight(Built built, float half = 1000, float x = 0) {
    SceneBuilder b;
    addLayers(b, built);
    b.square({x, -4, 0}, {0, 1, 0}, half, b.material(test::emitter({1, 1, 1})));
    return b.finish();
}

test::PathLimits limits() { return test::bouncesAlone(4); }

TEST(NestedGlass, LetsThroughWhatTheClosedFormSays) {
    for (const Built built : kBuilt) {
        const test::PathScene scene(layersOverLight(built), test::exactSettings(16));
        for (const double degrees : {0.0, 45.0, 70.0}) {
            const double expected = stackOf(kLayers, degrees).through;
            const Vec3 eye = test::atAngle(-degrees) * 3, down = -test::atAngle(-degrees);
            EXPECT_NEAR(scene.traced.trace(eye, down, test::exactSettings(10)).radiance.r / expected, 1, 2e-3)
                << static_cast<int>(built) << ' ' << degrees;
            const auto seen = scene.see(eye, down, 30000, limits());
            EXPECT_LT(seen.error[0], 0.005 * expected);
            EXPECT_NEAR(seen.mean[0], expected, 4 * seen.error[0])
                << static_cast<int>(built) << ' ' << degrees;
        }
    }
}

TEST(NestedGlass, BendsBySnellsLawOfNeighbours) {
    const double degrees = 45, beyond = std::tan(degrees * test::kPi / 180);
    const auto x = static_cast<float>(shiftOf(kLayers, degrees) + beyond);
    for (const Built built : kBuilt) {
        const test::PathScene scene(layersOverLight(built, 0.01F, x), test::exactSettings(16));
        for (const float aside : {-0.011F, -0.009F, 0.009F, 0.011F}) {
            const Vec3 eye = test::atAngle(-degrees) * 2 + Vec3{aside, 0, 0};
            const float seen =
                scene.traced.trace(eye, -test::atAngle(-degrees), test::exactSettings(4)).radiance.r;
            const auto path = scene.see(eye, -test::atAngle(-degrees), 200, limits());
            EXPECT_EQ(seen > 0.1F, std::abs(aside) < 0.01F) << static_cast<int>(built) << ' ' << aside;
            EXPECT_EQ(path.mean[0] > 0.1, std::abs(aside) < 0.01F) << static_cast<int>(built) << ' ' << aside;
        }
    }
}

TEST(NestedGlass, MirrorsAtTheWaterAsOneThirtyThreeOverOneFifty) {
    // Bright surroundings, and black below: all that is seen was mirrored somewhere.
    for (const Built built : kBuilt) {
        SceneBuilder b;
        addLayers(b, built);
        b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::matte(0)));
        b.scene.background = {1, 1, 1};
        const test::PathScene scene(b.finish(), test::exactSettings(16));
        const Stack expected = stackOf(kLayers, 0);
        const Vec3 eye{0.3F, 3, 0.1F}, down{0, -1, 0};
        const float seen = scene.traced.trace(eye, down, test::exactSettings(10)).radiance.r;
        EXPECT_NEAR(seen / expected.front, 1, 2e-3) << static_cast<int>(built);
        const auto path = scene.see(eye, down, 60000, limits());
        EXPECT_NEAR(path.mean[0], expected.front, 5 * path.error[0]) << static_cast<int>(built);
    }
}

/// Light that goes straight through the layers to a floor below them, by the shadow rays of both.
TEST(NestedGlass, ShadowsTakeEachBoundaryAndTheMediumBetween) {
    const double outer = 1 - fresnel(0, 1, kGlass), inner = 1 - fresnel(0, kGlass, kWater);
    const double absorbed = std::exp(-2 * kGlassExtinction - kWaterExtinction);
    for (const Built built : kBuilt) {
        SceneBuilder b;
        addLayers(b, built);
        b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::matte(1)));
        b.scene.lights.emplace_back(test::pointLight({0, 6, 0}, 100));
        const test::PathScene scene(b.finish(), test::exactSettings(16));
        const Vec3 eye{0.0F, -3.9F, 0}, down{0, -1, 0};
        const double expected = outer * outer * inner * inner * absorbed / test::kPi;
        EXPECT_NEAR(scene.traced.trace(eye, down).radiance.r / expected, 1, 1e-4) << static_cast<int>(built);
        test::PathLimits direct = test::bouncesAlone(0);
        const auto seen = scene.see(eye, down, 100, direct);
        EXPECT_NEAR(seen.mean[0] / expected, 1, 1e-4) << static_cast<int>(built);
    }
}

/// A stone in the water: what it is in is known by what the light leaves.
TEST(NestedGlass, ShadowsOfWhatLiesInWaterBeginInTheWater) {
    const double outer = 1 - fresnel(0, 1, kGlass), inner = 1 - fresnel(0, kGlass, kWater);
    const double absorbed = std::exp(-kGlassExtinction - 0.5 * kWaterExtinction);
    for (const Built built : kBuilt) {
        SceneBuilder b;
        addLayers(b, built);
        b.square({0, -1.5F, 0}, {0, 1, 0}, 1, b.material(test::matte(1)));
        b.scene.lights.emplace_back(test::pointLight({0, 8.5F, 0}, 100));
        const test::PathScene scene(b.finish(), test::exactSettings(4));
        const double expected = outer * inner * absorbed / test::kPi;
        const Vec3 eye{0.1F, -1.4F, 0}, to{0, -1.5F, 0};
        const double begun = std::exp(-length(eye - to) * kWaterExtinction);
        EXPECT_NEAR(scene.traced.see(eye, to) / expected, begun, 1e-4) << static_cast<int>(built);
        const auto path = scene.see(eye, to - eye, 50, test::bouncesAlone(0));
        EXPECT_NEAR(path.mean[0] / expected, begun, 1e-4) << static_cast<int>(built);
        // Seen from outside, straight down: the same boundaries and lengths once more.
        const float seen = scene.traced.trace({0, 3, 0}, {0, -1, 0}, test::exactSettings(4)).radiance.r;
        EXPECT_NEAR(seen / (expected * outer * inner * absorbed), 1, 2e-3) << static_cast<int>(built);
    }
}

double throughAir(Scene scene, int depth) {
    const test::PathScene traced(std::move(scene), test::exactSettings(depth));
    return traced.traced.trace({0.3F, 3, 0.1F}, {0, -1, 0}, test::exactSettings(depth)).radiance.r;
}

TEST(NestedGlass, ABubbleOfAirIsOneHoweverItIsModelled) {
    const std::vector<Layer> layers{{kGlass, 1, kGlassExtinction}, {1, 1, 0}, {kGlass, 1, kGlassExtinction}};
    Material air = test::glass(1);
    const auto sceneOf = [&](bool ofAir) {
        SceneBuilder b;
        const auto glass = b.material(medium(kGlass, kGlassExtinction));
        b.box({-50, -3, -50}, {50, 0, 50}, glass);
        const auto first = b.buffers.triangles.size();
        b.box({-49, -2, -49}, {49, -1, 49}, ofAir ? b.material(air) : glass);
        for (std::size_t i = first; i < b.buffers.triangles.size() && !ofAir; ++i) {
            std::swap(b.buffers.triangles[i].v[1], b.buffers.triangles[i].v[2]);
            std::swap(b.buffers.shading[i].v[1], b.buffers.shading[i].v[2]);
        }
        if (!ofAir)
            for (std::size_t i = 3 * first; i < b.buffers.normals.size(); ++i)
                b.buffers.normals[i] = -b.buffers.normals[i];
        b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
        return b.finish();
    };
    const double expected = stackOf(layers, 0).through;
    EXPECT_NEAR(throughAir(sceneOf(true), 12) / expected, 1, 2e-3);
    EXPECT_NEAR(throughAir(sceneOf(false), 12) / expected, 1, 2e-3);
}

TEST(NestedGlass, PartsOfOneMaterialThatOverlapAreOneSolid) {
    SceneBuilder b;
    const auto glass = b.material(medium(kGlass, kGlassExtinction));
    b.box({-50, -2, -50}, {50, 0, 50}, glass);
    b.box({-40, -3, -40}, {40, -1, 40}, glass);
    b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
    EXPECT_NEAR(throughAir(b.finish(), 12) / stackOf({{kGlass, 3, kGlassExtinction}}, 0).through, 1, 1e-4);
}

/// Media in each other: four that a ray remembers, and more.
TEST(NestedGlass, FourMediaInEachOtherComeOutInOrder) {
    for (const int count : {4, 6}) {
        SceneBuilder b;
        std::vector<Layer> layers;
        for (int i = 0; i < count; ++i) {
            const auto depth = 0.3F * static_cast<float>(i);
            const float index = 1.1F + 0.1F * static_cast<float>(i);
            b.box({-50 + depth, -4 + depth, -50 + depth}, {50 - depth, -depth, 50 - depth},
                  b.material(medium(index, 0.1)));
            layers.push_back({index, i < count - 1 ? 0.3 : 4 - 2 * 0.3 * (count - 1), 0.1});
        }
        for (int i = count - 2; i >= 0; --i)
            layers.push_back({1.1F + 0.1F * static_cast<float>(i), 0.3, 0.1});
        b.square({0, -5, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
        // Behind the fourth it counts as in air again: two boundaries of six are wrong, and two ways.
        EXPECT_NEAR(throughAir(b.finish(), 14) / stackOf(layers, 0).through, 1, count == 4 ? 2e-3 : 0.06)
            << count;
    }
}

/// The highest priority wins, whichever a ray comes into first; equal ones go by nesting.
TEST(NestedGlass, ThePriorityWinsWhereMediaOverlap) {
    const auto through = [&](float first, float second) {
        SceneBuilder b;
        b.box({-50, -2, -50}, {50, 0, 50}, b.material(medium(kGlass, kGlassExtinction, first)));
        b.box({-40, -3, -40}, {40, -1, 40}, b.material(medium(kWater, kWaterExtinction, second)));
        b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
        return throughAir(b.finish(), 12);
    };
    const Layer glass{kGlass, 1, kGlassExtinction}, water{kWater, 1, kWaterExtinction};
    const double glassWins = stackOf({glass, glass, water}, 0).through,
                 waterWins = stackOf({glass, water, water}, 0).through;
    EXPECT_GT(std::abs(glassWins / waterWins - 1), 0.05);
    EXPECT_NEAR(through(2, 1) / glassWins, 1, 1e-3);
    EXPECT_NEAR(through(1, 2) / waterWins, 1, 1e-3);
    EXPECT_NEAR(through(0, 0) / waterWins, 1, 1e-3);
    EXPECT_NEAR(through(7, 7) / waterWins, 1, 1e-3);
    EXPECT_NEAR(through(100, 0) / glassWins, 1, 1e-3);
}

/// Balls whose boxes overlap, but not they themselves; a stone, a mirror, fog and a frosted ball beside them.
Scene separateBalls(bool together) {
    SceneBuilder b;
    Material tinted = test::glass();
    tinted.transmission = {0.5F, 0.8F, 0.9F};
    Material frosted = medium(1.4F, 0.3);
    frosted.roughness = 0.3F;
    b.sphere({-0.8F, -0.8F, 0}, 1, 10, b.material(medium(kGlass, 0.4)));
    b.sphere({0.8F, 0.8F, 0}, 1, 10, b.material(tinted));
    b.sphere({0.9F, -0.9F, 1}, 0.7F, 10, b.material(frosted));
    if (together) b.sphere({-1, 0.3F, 0.4F}, 0.8F, 10, b.material(medium(kWater, 0.5, 3)));
    if (together) b.sphere({-1, -0.6F, 0.2F}, 0.3F, 10, b.material(test::mirror(0.7F)));
    b.square({0, -2.5F, 0}, {0, 1, 0}, 20, b.material(test::matte(0.7F)));
    b.square({0, 0, -3}, {0, 0, 1}, 20, b.material(test::mirror(0.5F)));
    b.scene.background = {0.4F, 0.5F, 0.7F};
    b.scene.lights.emplace_back(test::pointLight({2, 5, 3}, 60));
    return b.finish();
}

std::vector<std::uint32_t> bitsOf(const test::PathScene& scene) {
    std::vector<std::uint32_t> bits;
    const auto add = [&](Colour c) {
        for (const float value : {c.r, c.g, c.b}) bits.push_back(std::bit_cast<std::uint32_t>(value));
    };
    RayWave rays;
    std::vector<SampleId> ids;
    for (std::uint16_t y = 0; y < 24; ++y) {
        for (std::uint16_t x = 0; x < 32; ++x) {
            const Vec3 to{0.15F * (static_cast<float>(x) - 16), 0.15F * (static_cast<float>(y) - 12), 0};
            rays.push({{0, 0.4F, 7}, 0, normalize(to - Vec3{0, 0.4F, 7}), std::numeric_limits<float>::max()});
            ids.push_back({x, y, 0});
        }
    }
    for (const Colour c : scene.trace(rays, ids, {})) add(c);
    RenderSettings settings;
    settings.maxDepth = 6;
    WhittedIntegrator integrator(scene.traced.scene, scene.traced.tracer, settings);
    integrator.trace(rays, ids);
    for (std::size_t i = 0; i < rays.size(); ++i) add(integrator.radiance().colourAt(i));
    return bits;
}

TEST(NestedGlass, SeparateSolidsKeepTheirBits) {
    test::PathScene scene(separateBalls(false));
    ASSERT_TRUE(scene.traced.scene.solids->overlap) << "their boxes do";
    const auto nested = bitsOf(scene);
    scene.traced.scene.solids = nullptr;
    EXPECT_EQ(bitsOf(scene), nested);
}

TEST(NestedGlass, HasTheSameBitsOnEveryInstructionSet) {
    const test::PathScene scene(separateBalls(true));
    EXPECT_TRUE(useInstructionSet("scalar"));
    const auto expected = bitsOf(scene);
    for (const std::string& name : instructionSets()) {
        EXPECT_TRUE(useInstructionSet(name));
        EXPECT_EQ(bitsOf(scene), expected) << name;
    }
    useInstructionSet("auto");
}

/// A camera in the water of a glass, which looks out through it.
TEST(NestedGlass, ACameraBeginsInWhatIsAroundIt) {
    const double outer = 1 - fresnel(0, 1, kGlass), inner = 1 - fresnel(0, kGlass, kWater);
    for (const Built built : kBuilt) {
        const test::PathScene scene(layersOverLight(built), test::exactSettings(16));
        const double once = outer * inner * std::exp(-kGlassExtinction - 0.5 * kWaterExtinction);
        const Vec3 eye{0.3F, -1.5F, 0.1F}, down{0, -1, 0};
        const float seen = scene.traced.trace(eye, down, test::exactSettings(2)).radiance.r;
        EXPECT_NEAR(seen / once, 1, 1e-4) << static_cast<int>(built);
        // With what is mirrored: at first back into the water.
        const float all = scene.traced.trace(eye, down, test::exactSettings(10)).radiance.r;
        const auto path = scene.see(eye, down, 30000, limits());
        EXPECT_NEAR(path.mean[0], all, 4 * path.error[0] + 1e-4) << static_cast<int>(built);
        EXPECT_GT(all / once, 1.0005) << static_cast<int>(built);
    }
}

TEST(NestedGlass, ACameraInOneSolidSeesItAbsorb) {
    SceneBuilder b;
    b.box({-50, -3, -50}, {50, 0, 50}, b.material(medium(kGlass, kGlassExtinction)));
    b.square({0, -4, 0}, {0, 1, 0}, 1000, b.material(test::emitter({1, 1, 1})));
    const test::PathScene scene(b.finish(), test::exactSettings(16));
    EXPECT_FALSE(scene.traced.scene.solids->overlap);
    const double once = (1 - fresnel(0, 1, kGlass)) * std::exp(-2 * kGlassExtinction);
    EXPECT_NEAR(scene.traced.trace({0, -1, 0}, {0, -1, 0}, test::exactSettings(1)).radiance.r / once, 1,
                1e-4);
}

TEST(GlassSolids, DoNotOverlapWhereBoxesDoNot) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.box({2, 0, 0}, {3, 1, 1}, b.material(test::glass(1.33F)));
    b.box({0.2F, 0.2F, 0.2F}, {0.4F, 0.4F, 0.4F}, b.material(test::matte(1)));
    const Scene scene = b.finish();
    ASSERT_NE(scene.solids, nullptr);
    EXPECT_FALSE(scene.solids->overlap);
}

/// As importers weld it: all share vertices.
TEST(GlassSolids, StayClosedWhereTheyShareAFace) {
    SceneBuilder b;
    b.box({0, 0, 0}, {1, 1, 1}, b.material(test::glass()));
    b.box({0, 1, 0}, {1, 2, 1}, b.material(test::glass(1.33F)));
    for (Triangle& t : b.buffers.triangles) {
        for (std::uint32_t& v : t.v) {
            for (std::uint32_t k = 0; k < v; ++k) {
                if (b.buffers.vertices[k] == b.buffers.vertices[v]) v = k;
            }
        }
    }
    const Scene scene = b.finish();
    ASSERT_NE(scene.closed, nullptr);
    EXPECT_EQ(std::count(scene.closed->begin(), scene.closed->end(), 1), 24);
    ASSERT_TRUE(scene.solids != nullptr && scene.solids->overlap);
    EXPECT_EQ(scene.solids->twins.size(), 4U) << "two triangles, in both orders";
    EXPECT_FALSE(scene.solids->twins[0].sameSide);
}

} // namespace
} // namespace rtcore
