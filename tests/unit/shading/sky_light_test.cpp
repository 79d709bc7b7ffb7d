// The light of the sky against closed forms, and against many rays in double precision.
#include "rtcore/sampling/even_shift.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

RenderSettings skyLight(int samples = 64) {
    RenderSettings settings = test::exactSettings();
    settings.skyLight = {.on = true, .samples = samples};
    return settings;
}

std::shared_ptr<const Environment> environmentOf(const std::function<Colour(Vec3)>& sky) {
    constexpr int kHeight = 256;
    HdrImage image(2 * kHeight, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < 2 * kHeight; ++x) {
            const double a = 2 * test::kPi * ((x + 0.5) / (2 * kHeight) - 0.5),
                         polar = test::kPi * (y + 0.5) / kHeight;
            image.at(x, y) =
                sky({static_cast<float>(std::sin(polar) * std::sin(a)), static_cast<float>(std::cos(polar)),
                     static_cast<float>(-std::sin(polar) * std::cos(a))});
        }
    }
    return std::make_shared<Environment>(Environment::fromEquirectangular(image, "sky"));
}

std::shared_ptr<const Environment> evenSky(Colour radiance) {
    return environmentOf([radiance](Vec3) { return radiance; });
}

/// The mean of what a surface at `target` shows, seen as many pixels from `eye`.
Colour seenUnderSky(const TracedScene& s, Vec3 eye, Vec3 target,
                    const RenderSettings& settings = skyLight()) {
    constexpr std::size_t kPixels = 1024;
    RayWave wave;
    std::vector<SampleId> names;
    for (std::size_t i = 0; i < kPixels; ++i) {
        wave.push({eye, 0, normalize(target - eye), std::numeric_limits<float>::max()});
        names.push_back({static_cast<std::uint16_t>(i % 32), static_cast<std::uint16_t>(i / 32), 0});
    }
    WhittedIntegrator integrator(s.scene, s.tracer, settings);
    integrator.trace(wave, names);
    Colour sum;
    for (std::size_t i = 0; i < kPixels; ++i) sum += integrator.radiance().colourAt(i);
    return sum / static_cast<float>(kPixels);
}

void expectLight(Colour found, Colour expected, float part) {
    EXPECT_NEAR(found.r, expected.r, part * expected.r + 1e-6F);
    EXPECT_NEAR(found.g, expected.g, part * expected.g + 1e-6F);
    EXPECT_NEAR(found.b, expected.b, part * expected.b + 1e-6F);
}

SceneBuilder openFloor(float albedo) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.2F}, {0, 1, 0}, 10, b.material(test::matte(albedo)));
    return b;
}

TEST(SkyLight, OfAnEvenSkyOnAnOpenFloorIsItsAlbedo) {
    TracedScene s(openFloor(0.5F).finish());
    s.scene.environments = {evenSky({1, 2, 4})};
    for (const OcclusionPattern pattern :
         {OcclusionPattern::Rotated, OcclusionPattern::Regular, OcclusionPattern::Random}) {
        for (const int samples : {1, 9, 300}) {
            RenderSettings settings = skyLight(samples);
            settings.ambientOcclusion.pattern = pattern;
            expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}, settings), {0.5F, 1, 2}, 1e-3F);
        }
    }
}

// E = pi (a + 2/3 b) of L = a + b cos.
TEST(SkyLight, OfAGradientOnAnOpenFloorIsItsIntegral) {
    TracedScene s(openFloor(0.6F).finish());
    s.scene.environments = {environmentOf([](Vec3 d) { return Colour{1 + d.y, 2 - d.y, 1 + d.x}; })};
    for (const int samples : {1, 4, 64})
        expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}, skyLight(samples)),
                    {0.6F * 5 / 3, 0.6F * 4 / 3, 0.6F}, 0.02F);
}

// Rays that meet nothing tell nothing new: what an open surface gets is known.
TEST(SkyLight, OfAnOpenFloorHasNoNoise) {
    TracedScene s(openFloor(1).finish());
    s.scene.environments = {environmentOf([](Vec3 d) { return Colour{1 + d.y, 2 + d.x, 1 - d.z}; })};
    RayWave wave;
    for (int i = 0; i < 100; ++i)
        wave.push({{0, 1, 0.5F}, 0, normalize(Vec3{0, -1, -0.5F}), std::numeric_limits<float>::max()});
    for (const int samples : {3, 4, 50}) {
        const RenderSettings settings = skyLight(samples);
        WhittedIntegrator integrator(s.scene, s.tracer, settings);
        integrator.trace(wave);
        for (std::size_t i = 0; i < wave.size(); ++i)
            EXPECT_NEAR(integrator.radiance().x[i], 5.0F / 3, 5e-3F) << samples;
    }
}

// From below the horizon it is dark, and a wall sees half of each.
TEST(SkyLight, ComesFromItsOwnDirection) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    b.square({0, 0, 0}, {0, 1, 0}, 1, white);
    b.square({5, 0, 0}, {0, 0, 1}, 1, white);
    TracedScene s(b.finish());
    s.scene.environments = {environmentOf([](Vec3 d) { return d.y > 0 ? Colour{3, 3, 3} : Colour{}; })};
    expectLight(seenUnderSky(s, {0.1F, 2, 0}, {0, 0, 0}), {3, 3, 3}, 0.02F);
    EXPECT_LT(seenUnderSky(s, {0.1F, -2, 0}, {0, 0, 0}).g, 0.03F);
    expectLight(seenUnderSky(s, {5, 0.2F, 2}, {5, 0, 0}), {1.5F, 1.5F, 1.5F}, 0.02F);
}

TEST(SkyLight, OfASunInTheMapHasItsIrradiance) {
    const Vec3 toSun = normalize(Vec3{0.6F, 0.7F, 0.2F});
    const float cosine = std::cos(0.05F);
    TracedScene s(openFloor(1).finish());
    s.scene.environments = {environmentOf([&](Vec3 d) {
        return dot(d, toSun) > cosine ? Colour{5000, 5000, 5000} : Colour{1, 1, 1};
    })};
    const float sun = 5000 * 2 * (1 - cosine) * toSun.y;
    for (const int samples : {4, 64})
        expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}, skyLight(samples)), kWhite * (sun + 1), 0.03F);
}

TEST(SkyLight, DoesNotReachIntoAClosedBox) {
    SceneBuilder b;
    b.box({-1, -1, -1}, {1, 1, 1}, b.material(test::matte(1)));
    TracedScene s(b.finish());
    s.scene.environments = {evenSky({5, 5, 5})};
    EXPECT_EQ(seenUnderSky(s, {0.1F, 0.2F, 0}, {0.5F, -1, 0.3F}), Colour{});
}

TEST(SkyLight, OfHalfOfTheSkyIsHalf) {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    constexpr float far = 200;
    b.quad({-far, 0, far}, {1, 0, far}, {1, 0, -far}, {-far, 0, -far}, white);
    b.quad({1, 0, far}, {1, far, far}, {1, far, -far}, {1, 0, -far}, white);
    TracedScene s(b.finish());
    s.scene.environments = {evenSky({2, 2, 2})};
    expectLight(seenUnderSky(s, {-3, 2, 0}, {0.5F, 0, 0}), kWhite, 0.02F);
}

TEST(SkyLight, IsTheBackgroundWhereThereIsNoEnvironment) {
    TracedScene s(openFloor(0.5F).finish());
    s.scene.background = {0.2F, 0.4F, 1};
    expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}), {0.1F, 0.2F, 0.5F}, 1e-5F);
}

TEST(SkyLight, OfAClosedBoxIsItsAmbientLightAsFarAsRaysGo) {
    SceneBuilder b;
    b.box({-1, -1, -1}, {1, 1, 1}, b.material(test::matte(0.5F)));
    TracedScene s(b.finish());
    s.scene.environments = {evenSky({5, 5, 5})};
    s.scene.ambient = {3, 2, 1};
    RenderSettings settings = skyLight();
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.distance = 1e-3F; // all surfaces are far away
    expectLight(seenUnderSky(s, {0.1F, 0.2F, 0}, {0.5F, -1, 0.3F}, settings), {1.5F, 1, 0.5F}, 1e-4F);
    settings.ambientOcclusion.distance = 4;
    const Colour dim = seenUnderSky(s, {0.1F, 0.2F, 0}, {0.5F, -1, 0.3F}, settings);
    EXPECT_GT(dim.r, 0.3F * 1.5F);
    EXPECT_LT(dim.r, 0.6F * 1.5F);
    settings.skyLight.on = false;
    expectLight(seenUnderSky(s, {0.1F, 0.2F, 0}, {0.5F, -1, 0.3F}, settings), dim, 0.05F);
}

TEST(SkyLight, TakesThePlaceOfAmbientLightAndOfItsOcclusion) {
    TracedScene s(openFloor(0.5F).finish());
    s.scene.environments = {evenSky({1, 1, 1})};
    s.scene.ambient = {3, 3, 3};
    RenderSettings settings = skyLight();
    const Colour alone = seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}, settings);
    expectLight(alone, kWhite * 0.5F, 1e-3F);
    settings.ambientOcclusion.on = true;
    EXPECT_EQ(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}, settings), alone);
}

TEST(SkyLight, FollowsTheIntensity) {
    TracedScene s(openFloor(0.5F).finish());
    auto bright = std::make_shared<Environment>(*evenSky({1, 1, 1}));
    bright->intensity = 6;
    s.scene.environments = {bright};
    expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}), kWhite * 3, 1e-3F);
}

/// The radiance of a white floor below a pane that covers all that it sees, under a sky of radiance 2.
Colour underPane(const std::function<void(SceneBuilder&, Material&)>& make) {
    SceneBuilder b = openFloor(1);
    Material pane = test::glass(1); // no reflection
    make(b, pane);
    b.square({0, 0.01F, 0}, {0, -1, 0}, 50, b.material(pane));
    TracedScene s(b.finish());
    s.scene.environments = {evenSky({2, 2, 2})};
    return seenUnderSky(s, {0.1F, 0.005F, 0.01F}, {0.1F, 0, 0});
}

TEST(SkyLight, PassesAClearPane) {
    const Colour seen = underPane([](SceneBuilder&, Material&) {});
    expectLight(seen, {2, 2, 2}, 0.01F);
}

TEST(SkyLight, IsTintedByAPane) {
    const Colour seen = underPane([](SceneBuilder&, Material& m) { m.transmission = {0.9F, 0.5F, 0.1F}; });
    expectLight(seen, {1.8F, 1, 0.2F}, 0.01F);
}

// A wall of two faces of glass lets (1 - R) / (1 + R) through; weighed by the cosine, 0.849 of n = 1.5.
TEST(SkyLight, LosesWhatGlassReflects) {
    const Colour seen = underPane([](SceneBuilder&, Material& m) { m.indexOfRefraction = 1.5F; });
    double through = 0;
    constexpr int kSteps = 10'000;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = std::sqrt((i + 0.5) / kSteps),
                     root = std::sqrt(1.5 * 1.5 - 1 + cosine * cosine);
        const double across = (cosine - root) / (cosine + root),
                     along = (2.25 * cosine - root) / (2.25 * cosine + root);
        const double reflected = (across * across + along * along) / 2;
        through += (1 - reflected) / (1 + reflected) / kSteps;
    }
    expectLight(seen, kWhite * static_cast<float>(2 * through), 0.01F);
}

TEST(SkyLight, PassesHoles) {
    const Colour seen = underPane([](SceneBuilder& b, Material& m) {
        m = test::matte(1);
        m.alphaTexture = b.texture(1, 1, {{64, 0, 0, 255}});
    });
    expectLight(seen, kWhite * (2 * 191.0F / 255), 0.01F);
}

// Homogeneous fog hides the sky, and is all that is seen in its place.
TEST(SkyLight, ComesThroughFog) {
    TracedScene s(openFloor(1).finish());
    s.scene.environments = {evenSky({2, 2, 2})};
    s.scene.ambient = {9, 9, 9};
    s.scene.fog.kind = FogKind::Homogeneous;
    s.scene.fog.density = 1e-3F;
    s.scene.fog.colour = {0.1F, 0.2F, 0.3F};
    const float seen = std::exp(-1e-3F * 1.118F);
    const Colour floor = seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0});
    EXPECT_NEAR(floor.g, 0.2F * seen + 0.2F * (1 - seen), 1e-4);
    s.scene.fog.kind = FogKind::Exponential;
    s.scene.fog.scaleHeight = 1e-3F; // so low that nothing of it is above the floor's first millimetres
    expectLight(seenUnderSky(s, {0, 1, 0.5F}, {0, 0, 0}), {2, 2, 2}, 0.01F);
}

// --- Rooms ---

/// A room with a window in the wall at x = -4: 8 deep, 4 wide, 3 high; a block stands on its floor.
Scene windowRoom() {
    SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(1));
    constexpr float w = 2, h = 3;
    b.quad({-4, 0, w}, {4, 0, w}, {4, 0, -w}, {-4, 0, -w}, white);
    b.quad({-4, h, -w}, {4, h, -w}, {4, h, w}, {-4, h, w}, white);
    b.quad({4, 0, w}, {4, h, w}, {4, h, -w}, {4, 0, -w}, white);
    b.quad({-4, 0, -w}, {4, 0, -w}, {4, h, -w}, {-4, h, -w}, white);
    b.quad({-4, 0, w}, {-4, h, w}, {4, h, w}, {4, 0, w}, white);
    b.quad({-4, 0, -w}, {-4, 1, -w}, {-4, 1, w}, {-4, 0, w}, white);
    b.quad({-4, 2.5F, -w}, {-4, h, -w}, {-4, h, w}, {-4, 2.5F, w}, white);
    b.quad({-4, 1, -w}, {-4, 2.5F, -w}, {-4, 2.5F, -1}, {-4, 1, -1}, white);
    b.quad({-4, 1, 1}, {-4, 2.5F, 1}, {-4, 2.5F, w}, {-4, 1, w}, white);
    b.box({-1, 0, -0.5F}, {0, 1, 0.5F}, white);
    return b.finish();
}
/// Brighter above and to one side, dark below the horizon.
Colour skyOf(Vec3 d) {
    const float blue = 1 + 2 * std::max(d.y, 0.0F);
    return d.y > 0 ? Colour{1 + 0.5F * d.z, 1, blue} : Colour{0.2F, 0.15F, 0.1F};
}

TEST(SkyLight, IsBrightBelowTheWindowAndDimInTheFarCorner) {
    TracedScene s(windowRoom());
    s.scene.environments = {environmentOf(skyOf)};
    for (const int samples : {16, 256}) {
        const float below = seenUnderSky(s, {-3, 1.5F, 0}, {-3.2F, 0, 0}, skyLight(samples)).g;
        const float corner = seenUnderSky(s, {3, 1.5F, 0}, {3.7F, 0, 1.8F}, skyLight(samples)).g;
        EXPECT_GT(below, 0.02F);
        EXPECT_GT(corner, 0);
        EXPECT_GT(below, 5 * corner);
    }
}

bool hits(const Mesh& mesh, std::uint32_t triangle, Vec3d origin, Vec3d direction) {
    const auto corner = [&](int i) {
        const Vec3 p = mesh.position(triangle, i);
        return Vec3d{p.x, p.y, p.z};
    };
    const Vec3d e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), p = cross(direction, e2);
    const double area = dot(e1, p);
    if (std::fabs(area) < 1e-14) return false;
    const Vec3d s = origin - corner(0), q = cross(s, e1);
    const double u = dot(s, p) / area, v = dot(direction, q) / area;
    return u >= 0 && v >= 0 && u + v <= 1 && dot(e2, q) / area > 1e-6;
}

/// The mean sky over the hemisphere by cosine, as far as it is seen: 10^5 rays at random.
std::array<double, 3> byManyRays(const Scene& scene, Vec3 position, Vec3 normal) {
    constexpr int kRays = 100'000;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const Vec3d origin{position.x, position.y, position.z}, up{normal.x, normal.y, normal.z};
    const auto basis = basisAround(normal);
    const Vec3d t{basis.tangent.x, basis.tangent.y, basis.tangent.z},
        b{basis.bitangent.x, basis.bitangent.y, basis.bitangent.z};
    std::array<double, 3> sum{};
    for (int i = 0; i < kRays; ++i) {
        const double u = unit(random), a = 2 * test::kPi * unit(random), across = std::sqrt(u);
        const Vec3d d = t * (across * std::cos(a)) + b * (across * std::sin(a)) + up * std::sqrt(1 - u);
        bool free = true;
        for (std::uint32_t k = 0; free && k < scene.mesh().triangles.size(); ++k)
            free = !hits(scene.mesh(), k, origin, d);
        if (!free) continue;
        const Colour sky = skyOf({static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)});
        sum[0] += static_cast<double>(sky.r) / kRays;
        sum[1] += static_cast<double>(sky.g) / kRays;
        sum[2] += static_cast<double>(sky.b) / kRays;
    }
    return sum;
}

TEST(SkyLight, InARoomIsThatOfManyRaysInDouble) {
    TracedScene s(windowRoom());
    s.scene.environments = {environmentOf(skyOf)};
    struct Place {
        Vec3 eye, position, normal;
    };
    const Place places[] = {{{-3, 1.5F, 0}, {-3.2F, 0, 0.1F}, {0, 1, 0}},  // below the window
                            {{-2, 1.5F, 0}, {-2, 0, 1.5F}, {0, 1, 0}},     // beside it
                            {{-2, 1.5F, 0}, {-2, 3, 0.3F}, {0, -1, 0}},    // the ceiling, lit from below
                            {{-2, 1.5F, 0}, {-1, 0.6F, 0.1F}, {-1, 0, 0}}, // the block's front
                            {{3, 1.5F, 0}, {4, 1.2F, 0.4F}, {-1, 0, 0}}};  // the wall at the back
    const auto near = [](double e) { return 0.03 * e + 2e-3; };
    for (const Place& place : places) {
        const std::array<double, 3> expected = byManyRays(s.scene, place.position, place.normal);
        const Colour found = seenUnderSky(s, place.eye, place.position, skyLight(256));
        const Colour byFew = seenUnderSky(s, place.eye, place.position, skyLight(4)); // live
        EXPECT_NEAR(static_cast<double>(byFew.g), expected[1], 2 * near(expected[1])) << place.position.x;
        EXPECT_NEAR(static_cast<double>(found.r), expected[0], near(expected[0])) << place.position.x;
        EXPECT_NEAR(static_cast<double>(found.g), expected[1], near(expected[1])) << place.position.x;
        EXPECT_NEAR(static_cast<double>(found.b), expected[2], near(expected[2])) << place.position.x;
    }
}

} // namespace
} // namespace rtcore
