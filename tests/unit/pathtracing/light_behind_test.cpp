// Light that arrives straight through panes, holes and solids, and by mirrors and glass that bends it: each
// is counted once, however lights and scattered rays find it.

#include "path_support.h"

#include "rtcore/scattering/fresnel.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

namespace rtcore {
namespace light_behind {
namespace {

constexpr float kTint = 0.6F;

/// Without a change of the index nothing is mirrored or bent: straight light and caustics are the same.
Material clear(Colour transmission) {
    Material m = test::glass(1);
    m.transmission = transmission;
    return m;
}

enum class Source { Emitter, Rectangle, Sphere, Point, Surroundings };
enum class Before { Nothing, Pane, Leaf, Slab, PerforatedSlab };

void addSource(test::SceneBuilder& b, Source source) {
    Light light = test::pointLight({0, 2, 0}, 1);
    switch (source) {
    case Source::Emitter:
        b.quad({-.5F, 2, -.5F}, {.5F, 2, -.5F}, {.5F, 2, .5F}, {-.5F, 2, .5F},
               b.material(test::emitter(kWhite)));
        return;
    case Source::Surroundings:
        b.scene.background = kWhite;
        return;
    case Source::Rectangle:
        light.kind = LightKind::Rectangle;
        light.direction = {0, -1, 0};
        light.right = {1, 0, 0};
        light.width = light.height = 1;
        break;
    case Source::Sphere:
        light.kind = LightKind::Sphere;
        light.radius = 0.5F;
        break;
    case Source::Point:
        break;
    }
    b.scene.lights = {light};
}

/// The radiance of a floor that scatters all light, with nothing before the source.
double unhindered(Source source) {
    switch (source) {
    case Source::Emitter:
    case Source::Rectangle:
        return .073478; // a unit square two units above it
    case Source::Surroundings:
        return 1;
    default:
        return 1 / (4 * test::kPi); // of the intensity 1
    }
}

/// The fraction of the light that passes.
double addBefore(test::SceneBuilder& b, Before before) {
    Material leaf = test::matte(0);
    switch (before) {
    case Before::Nothing:
        return 1;
    case Before::Pane:
        b.box({-3, -1, -3}, {3, 1, 3}, b.material(clear(kWhite * kTint)), 4);
        for (const float z : {-3.0F, 3.0F})
            b.quad({-3, -1, z}, {3, -1, z}, {3, 1, z}, {-3, 1, z}, b.material(clear(kWhite * kTint)));
        return kTint;
    case Before::Leaf:
        leaf.alphaTexture = b.texture(1, 1, {{51, 51, 51, 255}}); // a fifth covers
        b.box({-3, -1, -3}, {3, 1, 3}, b.material(leaf));
        return 0.8;
    case Before::Slab: // around the floor: no ray enters it, so that it tints nothing
        b.box({-3, -1, -3}, {3, 1, 3}, b.material(clear(kWhite)));
        return 1;
    case Before::PerforatedSlab: {
        Material half = clear(kWhite);
        half.opacity = 0.5F; // of what covers; the rest are holes
        half.diffuse = {};
        half.alphaTexture = b.texture(1, 1, {{102, 102, 102, 255}});
        b.box({-3, -1, -3}, {3, 1, 3}, b.material(half));
        return 0.6 + 0.4 * 0.5;
    }
    }
    return 0;
}

TEST(LightBehind, PanesHolesAndClearSolidsIsCountedOnce) {
    for (const Source source :
         {Source::Emitter, Source::Rectangle, Source::Sphere, Source::Point, Source::Surroundings}) {
        for (const Before before :
             {Before::Nothing, Before::Pane, Before::Leaf, Before::Slab, Before::PerforatedSlab}) {
            test::SceneBuilder b;
            b.square({0, 0, 0}, {0, 1, 0}, 2, b.material(test::matte(1)));
            const double passes = addBefore(b, before);
            addSource(b, source);
            const test::PathScene scene(b.finish());
            for (const bool caustics : {false, true}) {
                test::PathLimits limits = test::bouncesAlone(0);
                limits.caustics = caustics;
                test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 4096, limits, passes * unhindered(source),
                                  "source " + std::to_string(static_cast<int>(source)) + ", before it " +
                                      std::to_string(static_cast<int>(before)) + ", caustics " +
                                      std::to_string(caustics));
            }
        }
    }
}

TEST(LightBehind, TintedSlabsArriveTintedOnce) {
    for (const Source source : {Source::Emitter, Source::Rectangle, Source::Sphere, Source::Point}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(test::matte(1)));
        b.box({-9, 0.9F, -9}, {9, 1.1F, 9}, b.material(clear(kWhite * kTint)));
        addSource(b, source);
        const test::PathScene scene(b.finish());
        for (const bool caustics : {false, true}) {
            test::PathLimits limits = test::bouncesAlone(0);
            limits.caustics = caustics;
            test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 8192, limits, kTint * unhindered(source),
                              "source " + std::to_string(static_cast<int>(source)) + ", caustics " +
                                  std::to_string(caustics));
        }
    }
}

/// The fraction of even light that reaches a floor through a transmission that depends on the cosine.
double passing(const std::function<double(float)>& transmission) {
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double square = (i + 0.5) / kSteps; // of the cosine: 2 cos sin d theta = d cos^2
        sum += transmission(static_cast<float>(std::sqrt(square)));
    }
    return sum / kSteps;
}

TEST(LightBehind, GlassThatBendsIsStraightOrACaustic) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 4000, b.material(test::matte(1)));
    b.box({-4000, 0.5F, -4000}, {4000, 0.75F, 4000}, b.material(test::glass()));
    b.scene.background = kWhite;
    const test::PathScene scene(b.finish(), test::exactSettings(100));
    test::PathLimits limits = test::bouncesAlone(0);
    // Straight: both faces let through what they do not mirror.
    test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 32768, limits, passing([](float cosine) {
                          const double passes = 1 - fresnelDielectric(cosine, 1.5F);
                          return passes * passes;
                      }),
                      "straight");
    // All that is mirrored between the faces, too.
    limits.caustics = true;
    test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 32768, limits, passing([](float cosine) {
                          return 1 - thinWallReflectance(fresnelDielectric(cosine, 1.5F));
                      }),
                      "caustic");
}

/// A floor between an emitter or light overhead and a mirror at x = 1.
Scene beforeAMirror(Source source) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 0.5F, b.material(test::matte(1)));
    b.square({1, 0, 0}, {-1, 0, 0}, 40, b.material(test::mirror(0.5F)));
    addSource(b, source);
    return b.finish();
}

TEST(LightBehind, AMirrorIsACausticOfEmittersAndNothingOfLights) {
    // Lambert's formula of the square mirrored at x = 1: its middle is over x = 2.
    const double h = 2;
    const std::array<std::array<double, 3>, 4> corners{
        {{1.5, h, -.5}, {2.5, h, -.5}, {2.5, h, .5}, {1.5, h, .5}}};
    const double image = test::lambertSum(corners, {0, 1, 0});
    EXPECT_GT(image, 0.02);
    for (const Source source : {Source::Emitter, Source::Rectangle, Source::Sphere, Source::Point}) {
        const test::PathScene scene(beforeAMirror(source));
        for (const bool caustics : {false, true}) {
            test::PathLimits limits = test::bouncesAlone(0);
            limits.caustics = caustics;
            const bool found = caustics && source == Source::Emitter;
            test::expectLight(scene, {0, 0.1F, 0}, {0, -1, 0}, 16384, limits,
                              unhindered(source) + (found ? 0.5 * image : 0),
                              "source " + std::to_string(static_cast<int>(source)) + ", caustics " +
                                  std::to_string(caustics));
        }
    }
}

TEST(LightBehind, AMirrorIsACausticOfSurroundings) {
    // It hides half of the sky, and shows the other half in it.
    const test::PathScene scene(beforeAMirror(Source::Surroundings));
    test::PathLimits limits = test::bouncesAlone(0);
    const auto direct = scene.see({0.4F, 0.1F, 0}, {0, -1, 0}, 16384, limits);
    limits.caustics = true;
    test::expectLight(scene, {0.4F, 0.1F, 0}, {0, -1, 0}, 16384, limits, (1 + direct.mean[0]) / 2, "caustics",
                      5 * direct.error[0]);
}

} // namespace
} // namespace light_behind
} // namespace rtcore
