// Ambient occlusion against closed forms: what a point sees of the ambient light, by many rays.
#include "rtcore/lights/ambient_light.h"
#include "rtcore/sampling/even_shift.h"
#include "rtcore/sampling/hemisphere_pattern.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

constexpr float kFar = 1e30F; ///< no surface is far enough to count less

RenderSettings occlusion(float distance, OcclusionPattern pattern = OcclusionPattern::Random) {
    RenderSettings settings = test::exactSettings();
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.distance = distance;
    settings.ambientOcclusion.light = 1;
    settings.ambientOcclusion.samples = 64;
    settings.ambientOcclusion.pattern = pattern;
    return settings;
}

struct Measured {
    double mean = 0, standardError = 0;
};

/// The radiance of a white surface at `target`, seen from `eye` by kPixels pixels.
Measured look(const TracedScene& s, Vec3 eye, Vec3 target, const RenderSettings& settings) {
    constexpr std::size_t kPixels = 1024;
    RayWave wave;
    std::vector<SampleId> names;
    for (std::size_t i = 0; i < kPixels; ++i) {
        wave.push({eye, 0, normalize(target - eye), std::numeric_limits<float>::max()});
        names.push_back({static_cast<std::uint16_t>(i % 32), static_cast<std::uint16_t>(i / 32), 0});
    }
    WhittedIntegrator integrator(s.scene, s.tracer, settings);
    integrator.trace(wave, names);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
        const double seen = static_cast<double>(integrator.radiance().x[i]);
        sum += seen;
        squares += seen * seen;
    }
    const double n = kPixels, mean = sum / n;
    return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / n)};
}

void expectVisible(const TracedScene& s, Vec3 eye, Vec3 target, float distance, double expected) {
    const Measured random = look(s, eye, target, occlusion(distance));
    EXPECT_NEAR(random.mean, expected, 3 * random.standardError + 1e-5);
    // Shifted patterns err less, but not independently of each other: the same bound holds all the more.
    const Measured rotated = look(s, eye, target, occlusion(distance, OcclusionPattern::Rotated));
    EXPECT_NEAR(rotated.mean, expected, 3 * random.standardError + 1e-5);
    EXPECT_LT(rotated.standardError, random.standardError + 1e-6);
}

/// Floor at y = 0 and a wall at x = 1 that faces -x; both go on for a long way.
SceneBuilder floorAndWall(float height) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    constexpr float far = 200;
    b.quad({-far, 0, far}, {1, 0, far}, {1, 0, -far}, {-far, 0, -far}, white);
    b.quad({1, 0, far}, {1, height, far}, {1, height, -far}, {1, 0, -far}, white);
    return b;
}

TEST(Occlusion, OfAnInfiniteCornerIsAHalf) {
    const TracedScene s(floorAndWall(200).finish());
    expectVisible(s, {-3, 2, 0}, {0, 0, 0}, kFar, 0.5);
    expectVisible(s, {-3, 2, 0}, {0.9F, 0, 0}, kFar, 0.5);
}

TEST(Occlusion, OfALongWallIsItsFormFactor) {
    const TracedScene s(floorAndWall(1).finish());
    expectVisible(s, {-3, 2, 0}, {0, 0, 0}, kFar, 1 - 0.146447);
}

TEST(Occlusion, OfAWallFallsOffLinearly) {
    const TracedScene s(floorAndWall(200).finish());
    expectVisible(s, {-3, 2, 0}, {0, 0, 0}, 4, 1 - 0.168213);
    expectVisible(s, {-3, 2, 0}, {0, 0, 0}, 2, 1 - 0.051965);
    expectVisible(s, {-3, 2, 0}, {0, 0, 0}, 0.999F, 1);
}

TEST(Occlusion, OfACeilingFallsOffLinearly) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 200, white);
    b.square({0.1F, 1, -0.2F}, {0, -1, 0}, 200, white);
    const TracedScene s(b.finish());
    expectVisible(s, {-0.5F, 0.5F, 0}, {0, 0, 0}, 2, 0.75);
    expectVisible(s, {-0.5F, 0.5F, 0}, {0, 0, 0}, kFar, 0);
}

TEST(Occlusion, OfATrench) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    constexpr float far = 200;
    b.square({0.1F, 0, 0.2F}, {0, 1, 0}, far, white);
    b.quad({-1, 0, far}, {-1, 1, far}, {-1, 1, -far}, {-1, 0, -far}, white);
    b.quad({1, 0, far}, {1, 1, far}, {1, 1, -far}, {1, 0, -far}, white);
    const TracedScene s(b.finish());
    expectVisible(s, {0.2F, 3, 0}, {0, 0, 0}, kFar, 0.707107);
    expectVisible(s, {0.2F, 3, 0}, {-0.5F, 0, 0}, kFar, 0.639632);
}

TEST(Occlusion, OfADiscAboveAPlane) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 100, white);
    constexpr int kCorners = 256;
    for (int i = 0; i < kCorners; ++i) {
        const auto corner = [](int k) {
            const double a = 2 * test::kPi * k / kCorners;
            return Vec3{static_cast<float>(std::cos(a)), 2, static_cast<float>(std::sin(a))};
        };
        b.triangle({0, 2, 0}, corner(i), corner(i + 1), white);
    }
    const TracedScene s(b.finish());
    expectVisible(s, {3, 1, 0}, {0, 0, 0}, kFar, 1 - 0.2);
    expectVisible(s, {3, 1, 0}, {1, 0, 0}, kFar, 1 - 0.146447);
}

TEST(Occlusion, InsideASphere) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, 192, b.material(test::matte(1)));
    const TracedScene s(b.finish());
    const Measured seen = look(s, {0.1F, 0.2F, 0}, {0.8F, 0.3F, -0.5F}, occlusion(1));
    EXPECT_NEAR(seen.mean, 1 - 0.083333, 3 * seen.standardError + 1e-3); // it has flat faces
}

TEST(Occlusion, OfAnOpenFloorIsNone) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 10, b.material(test::matte(1)));
    const TracedScene s(b.finish());
    for (const OcclusionPattern pattern :
         {OcclusionPattern::Rotated, OcclusionPattern::Regular, OcclusionPattern::Random}) {
        const Measured seen = look(s, {0, 1, 0.5F}, {0, 0, 0}, occlusion(kFar, pattern));
        EXPECT_EQ(seen.mean, 1);
    }
}

// A low-poly ball: its smooth normals would send rays below the flat face that they leave.
TEST(Occlusion, DoesNotDarkenConvexSolids) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, 6, b.material(test::matte(1)));
    const TracedScene s(b.finish());
    for (const Vec3 target : {Vec3{0.1F, 0.3F, 0.2F}, Vec3{0.4F, -0.2F, 0.1F}, Vec3{-0.1F, 0.45F, 0.3F}}) {
        EXPECT_EQ(look(s, {0.5F, 1, 3}, target, occlusion(kFar)).mean, 1);
    }
}

TEST(Occlusion, TakesPartOfWhatIsHalfTransparent) {
    for (const float opacity : {0.0F, 0.25F, 1.0F}) {
        SceneBuilder b = floorAndWall(200);
        Material pane = test::glass();
        pane.opacity = opacity;
        for (std::size_t i = 2; i < b.buffers.shading.size(); ++i) b.buffers.shading[i].material = 1;
        b.material(pane);
        const TracedScene s(b.finish());
        const Measured seen = look(s, {-3, 2, 0}, {0, 0, 0}, occlusion(kFar));
        const double expected = 1 - 0.5 * static_cast<double>(opacity);
        EXPECT_NEAR(seen.mean, expected, 3 * seen.standardError + 1e-5) << opacity;
    }
}

// Two panes of opacity 1/2 before an opaque wall: what is behind glass occludes too.
TEST(Occlusion, SeesWhatIsBehindGlass) {
    SceneBuilder b = floorAndWall(200);
    Material half = test::glass();
    half.opacity = 0.5F;
    const std::uint32_t pane = b.material(half);
    for (const float x : {0.6F, 0.8F}) {
        b.quad({x, 0.001F, 200}, {x, 200, 200}, {x, 200, -200}, {x, 0.001F, -200}, pane);
    }
    const TracedScene s(b.finish());
    const Measured seen = look(s, {-3, 0.5F, 0}, {0, 0, 0}, occlusion(kFar));
    EXPECT_NEAR(seen.mean, 0.5, 3 * seen.standardError + 2e-3);
}

TEST(Occlusion, PassesTheHolesOfLeaves) {
    SceneBuilder b = floorAndWall(200);
    Material leaf = test::matte(1);
    leaf.alphaTexture = b.texture(1, 1, {{64, 0, 0, 255}});
    const std::uint32_t index = b.material(leaf);
    for (std::size_t i = 2; i < b.buffers.shading.size(); ++i) b.buffers.shading[i].material = index;
    const TracedScene s(b.finish());
    const Measured seen = look(s, {-3, 2, 0}, {0, 0, 0}, occlusion(kFar));
    EXPECT_NEAR(seen.mean, 1 - 0.5 * 64 / 255, 3 * seen.standardError + 1e-5);
}

TEST(Occlusion, DarkensWhatMirrorsAndPanesShow) {
    SceneBuilder b = floorAndWall(200);
    b.square({-2, 1, 0}, {1, 0, 0}, 0.9F, b.material(test::mirror(1)));
    const TracedScene s(b.finish());
    // By way of the mirror to the floor: its own occlusion, and a little by the mirror itself.
    const Measured direct = look(s, {0, 1.5F, 3}, {-0.5F, 0, 0}, occlusion(1, OcclusionPattern::Rotated));
    const Vec3 image{-3.5F, 0, 0};
    const Measured mirrored = look(s, {0, 1.5F, 0.01F}, image, occlusion(1, OcclusionPattern::Rotated));
    EXPECT_NEAR(mirrored.mean, direct.mean, 0.01);
}

TEST(Occlusion, TakesTheSpecularPartToo) {
    SceneBuilder b;
    Material m = test::matte(0.25F);
    m.specular = {0.5F, 0.5F, 0.5F};
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 10, b.material(m));
    TracedScene s(b.finish());
    s.scene.ambient = {0.2F, 0.4F, 0.8F};
    RenderSettings settings = occlusion(1);
    settings.ambientOcclusion.light = 0;
    const Colour open = s.trace({0, 1, 0.5F}, {0, -1, -0.5F}, settings).radiance;
    const Colour plain = s.trace({0, 1, 0.5F}, {0, -1, -0.5F}).radiance;
    EXPECT_NEAR(open.r, plain.r, 1e-6);
    EXPECT_NEAR(open.b, plain.b, 1e-6);
    EXPECT_NEAR(open.b, 0.75 * 0.8, 1e-6);
}

TEST(Occlusion, TracesFewerRaysWhereTheyMatterLess) {
    SceneBuilder b;
    Material m = test::mirror(0.8F);
    m.diffuse = {1, 1, 1};
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 10, b.material(m));
    const TracedScene s(b.finish());
    RenderSettings settings = occlusion(1);
    settings.ambientOcclusion.samples = 9;
    const auto result = s.trace({0, 1, 0.5F}, {0, -1, -0.5F}, settings);
    EXPECT_EQ(result.statistics.rays[static_cast<std::size_t>(RayKind::Occlusion)], 3U);
    EXPECT_NEAR(result.radiance.r, 0.2, 1e-6);
}

TEST(Occlusion, HasFifteenPercentOfTheDiagonalForReach) {
    Box3 bounds;
    bounds.extend(Vec3{0, 0, 0});
    bounds.extend(Vec3{2, 1, 2});
    EXPECT_FLOAT_EQ(occludedLight({}, bounds, {}).distance, 0.45F);
    AmbientOcclusionSettings settings;
    settings.distance = 7;
    EXPECT_FLOAT_EQ(occludedLight({}, bounds, settings).distance, 7);
    EXPECT_GT(occludedLight({}, {}, {}).distance, 0);
}

TEST(AmbientLight, ComesFromWhatTheSceneHas) {
    Box3 bounds;
    bounds.extend(Vec3{-1, -1, -1});
    bounds.extend(Vec3{1, 1, 1});
    AmbientOcclusionSettings settings;
    Scene scene;
    const auto red = [&] { return occludedLight(scene, bounds, settings).radiance.r; };
    EXPECT_EQ(red(), 1); // nothing at all
    Light light = test::pointLight({10, 0, 0}, 100);
    scene.lights = {light};
    EXPECT_NEAR(red(), 0.25 / test::kPi, 1e-6);
    scene.lights[0].light.position = {0, 0, 0}; // counts as a quarter of the diagonal away
    EXPECT_NEAR(red(), 0.25 / test::kPi * 100 / 0.75, 1e-4);
    scene.lights[0].light.on = 0;
    EXPECT_EQ(red(), 1);
    light.kind = LightKind::Directional;
    light.intensity = {4, 4, 4};
    scene.lights.push_back(light);
    EXPECT_NEAR(red(), 1 / test::kPi, 1e-6);
    light.kind = LightKind::Spot; // of half a sphere
    light.position = {10, 0, 0};
    light.cosInner = light.cosOuter = 0;
    light.intensity = {200, 200, 200};
    scene.lights = {light};
    EXPECT_NEAR(red(), 0.25 / test::kPi, 1e-6);
    scene.background = {0.5F, 0, 0};
    EXPECT_EQ(red(), 0.5F);
    HdrImage sky(8, 4);
    for (int x = 0; x < 8; ++x) sky.at(x, 0) = sky.at(x, 1) = {3, 3, 3}; // the upper half
    scene.environments = {std::make_shared<Environment>(Environment::fromEquirectangular(sky, "sky"))};
    EXPECT_NEAR(red(), 1.5, 1e-6);
    scene.ambient = {0.1F, 0, 0};
    EXPECT_EQ(red(), 0.1F);
    settings.light = 7;
    EXPECT_EQ(red(), 7);
}

// Each sample of the pattern, taken over all shifts, goes everywhere alike.
TEST(OcclusionPatterns, ShiftedPatternsAreUnbiased) {
    for (const int count : {1, 7, 9}) {
        std::vector<HemispherePoint> pattern;
        setSpiral(count, pattern);
        double height = 0, x = 0, y = 0, xx = 0;
        constexpr int kSide = 128;
        for (int i = 0; i < kSide * kSide; ++i) {
            const SampleId id{static_cast<std::uint16_t>(i % kSide), static_cast<std::uint16_t>(i / kSide),
                              0};
            const SquarePoint shift = evenShift(id, SampleDimension::Occlusion);
            const HemispherePoint turn = hemispherePoint(shift);
            for (const HemispherePoint& p : pattern) {
                const double u = static_cast<double>(p.u + shift.u / static_cast<float>(count));
                const double cosine = static_cast<double>(p.cosine * turn.cosine - p.sine * turn.sine);
                const double sine = static_cast<double>(p.sine * turn.cosine + p.cosine * turn.sine);
                height += std::sqrt(std::max(0.0, 1 - u));
                x += std::sqrt(u) * cosine;
                y += std::sqrt(u) * sine;
                xx += u * cosine * cosine;
            }
        }
        const double n = static_cast<double>(count) * kSide * kSide;
        EXPECT_NEAR(height / n, 2.0 / 3, 2e-3) << count;
        EXPECT_NEAR(x / n, 0, 2e-3) << count;
        EXPECT_NEAR(y / n, 0, 2e-3) << count;
        EXPECT_NEAR(xx / n, 0.25, 2e-3) << count;
    }
}

TEST(OcclusionPatterns, HilbertsCurveMeetsEachCellAndStepsToNeighbours) {
    std::vector<std::array<int, 2>> cells(4096, {-1, -1});
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            cells[hilbertIndex(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))] = {x, y};
        }
    }
    for (std::size_t i = 1; i < cells.size(); ++i) {
        ASSERT_EQ(std::abs(cells[i][0] - cells[i - 1][0]) + std::abs(cells[i][1] - cells[i - 1][1]), 1) << i;
    }
}

TEST(OcclusionPatterns, TheSamplesOfAPixelAndBouncesAreShiftedApart) {
    std::set<float> seen;
    for (std::uint32_t sub = 0; sub < 16; ++sub) {
        for (std::uint32_t bounce = 0; bounce < 4; ++bounce) {
            seen.insert(evenShift({100, 200, sub}, SampleDimension::Occlusion, bounce).v);
        }
    }
    EXPECT_EQ(seen.size(), 64U);
}

} // namespace
} // namespace rtcore
