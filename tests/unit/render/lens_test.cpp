#include "rtcore/render/lens.h"
#include "rtcore/render/sample_rays.h"

#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtcore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

float degrees(double radians) { return static_cast<float>(radians * 180 / test::kPi); }

/// Radius in pixels of the blurred image of a point at distance x.
double blurRadius(const Lens& lens, double x, double halfTangent, int width) {
    const double radius = length(lens.right),
                 atOne = std::fabs((x == kInfinity ? 0 : 1 / x) - static_cast<double>(lens.inverseFocus));
    return radius * atOne * width / (2 * halfTangent);
}

TEST(Lens, BlursAsTheThinLensEquationSays) {
    // f = 50 mm at 2.8, focused at 2 m: the film is at 51.282 mm.
    const double halfTangent = 18 / (2000.0 * 50 / 1950);
    Camera camera;
    camera.horizontalFov = degrees(2 * std::atan(halfTangent));
    const CameraRays view(camera, 1920, 1080);
    const Lens lens = makeLens(view, camera.horizontalFov, 2.8F, 2, 1);
    EXPECT_NEAR(length(lens.right), .05 / 2.8 / 2, 1e-7);
    EXPECT_NEAR(length(lens.down), .05 / 2.8 / 2, 1e-7);
    EXPECT_NEAR(blurRadius(lens, 4, halfTangent, 1920), 6.105006, 1e-4);
    EXPECT_NEAR(blurRadius(lens, 1, halfTangent, 1920), 12.210012, 2e-4);
    EXPECT_NEAR(blurRadius(lens, kInfinity, halfTangent, 1920), 12.210012, 2e-4);
    EXPECT_NEAR(blurRadius(lens, 2, halfTangent, 1920), 0, 1e-6);
}

TEST(Lens, IsMeasuredInTheUnitsOfTheScene) {
    Camera camera;
    const CameraRays view(camera, 640, 480);
    const Lens metres = makeLens(view, 60, 4, 3, 1), millimetres = makeLens(view, 60, 4, 3000, .001F);
    EXPECT_NEAR(length(millimetres.right), 1000 * length(metres.right), 1e-3);
    EXPECT_NEAR(millimetres.inverseFocus, metres.inverseFocus / 1000, 1e-9);
}

TEST(Lens, AnyNumberGivesALens) {
    Camera camera;
    for (const float fov : {1e-3F, 60.0F, 179.99F}) {
        camera.horizontalFov = fov;
        SampleView view;
        view.camera = CameraRays(camera, 640, 480);
        view.pattern.prepare(SamplingPattern::Jittered, 2);
        view.lensPattern.prepare(2);
        for (const float focus :
             {1e-38F, 1e-10F, 1.0F, 1e10F, 3.4e38F, std::numeric_limits<float>::infinity()}) {
            for (const float unit : {1e-10F, 1.0F, 1e10F}) {
                for (const float fNumber : {.1F, 1000.0F}) {
                    view.lens = makeLens(view.camera, fov, fNumber, focus, unit);
                    RayWave rays;
                    makeSampleRays(view, std::vector<SampleId>{{1, 2, 3}}, rays);
                    EXPECT_TRUE(isFinite(rays.ray(0).origin)) << focus << " " << unit << " " << fov;
                    EXPECT_NEAR(length(rays.ray(0).direction), 1, 1e-5) << focus << " " << unit << " " << fov;
                }
            }
        }
    }
}

TEST(Lens, RaysStartOnItAndMeetInThePlaneOfFocus) {
    Camera camera;
    camera.eye = {3, -2, 5};
    camera.forward = normalize({1, 2, -2});
    camera.horizontalFov = 90;
    SampleView view;
    view.camera = CameraRays(camera, 800, 600);
    view.lens = makeLens(view.camera, 90, .18F, 5, 1); // 5 cm wide: f is 18 mm
    EXPECT_NEAR(length(view.lens.right), .05, .001);
    // All samples of a pixel pass near one point; by the pixels' middles they are exactly in it.
    for (const int blades : {0, 3, 6}) {
        view.aperture.prepare(blades);
        view.pattern.prepare(SamplingPattern::Rotated, 1);
        view.lensPattern.prepare(1);
        std::vector<SampleId> samples;
        for (int i = 0; i < 200; ++i) samples.push_back({static_cast<std::uint16_t>(i * 4), 77, 0});
        RayWave rays;
        makeSampleRays(view, samples, rays);
        ASSERT_EQ(rays.size(), samples.size());
        double widest = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Ray ray = rays.ray(i), through = view.camera.at(static_cast<float>(i) * 4 + .5F, 77.5F);
            const Vec3 offset = ray.origin - camera.eye;
            EXPECT_NEAR(dot(offset, camera.forward), 0, 2e-6);
            widest = std::max(widest, static_cast<double>(length(offset)));
            const Vec3 sharp = camera.eye + through.direction * (5 / dot(through.direction, camera.forward));
            const Vec3 met = ray.origin + ray.direction * (dot(sharp - ray.origin, camera.forward) /
                                                           dot(ray.direction, camera.forward));
            EXPECT_NEAR(length(met - sharp), 0, 2e-5);
        }
        EXPECT_LE(widest, length(view.lens.right) * 1.0001);
        EXPECT_GT(widest, .9 * static_cast<double>(length(view.lens.right)));
    }
}

void expectTheBitsOfTheCamera(const Camera& camera) {
    SampleView view;
    view.camera = CameraRays(camera, 640, 480);
    view.pattern.prepare(SamplingPattern::Poisson, 3);
    std::vector<SampleId> samples;
    for (std::uint32_t i = 0; i < 100; ++i) samples.push_back({static_cast<std::uint16_t>(6 * i), 99, i % 9});
    RayWave rays;
    makeSampleRays(view, samples, rays);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SquarePoint at = view.pattern.at(samples[i]);
        const Ray expected = view.camera.at(static_cast<float>(samples[i].x) + at.u, 99 + at.v);
        EXPECT_EQ(rays.ray(i).direction, expected.direction);
        EXPECT_EQ(rays.ray(i).origin, expected.origin);
    }
}

TEST(SampleRays, WithoutALensHaveTheBitsOfTheCamera) {
    Camera camera = test::sampleCamera();
    expectTheBitsOfTheCamera(camera);
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 7.3F;
    expectTheBitsOfTheCamera(camera);
}

TEST(SampleRays, StartWhereTheApertureSays) {
    SampleView view;
    const Camera camera = test::sampleCamera();
    view.camera = CameraRays(camera, 640, 480);
    view.lens = makeLens(view.camera, camera.horizontalFov, .5F, 4, 1);
    view.pattern.prepare(SamplingPattern::Grid, 4);
    view.lensPattern.prepare(4);
    std::vector<SampleId> samples;
    for (std::uint32_t i = 0; i < 100; ++i)
        samples.push_back({static_cast<std::uint16_t>(i / 9), 99, i % 16});
    for (const int blades : {0, 7}) {
        view.aperture.prepare(blades);
        RayWave rays;
        makeSampleRays(view, samples, rays);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec2 at = view.aperture.at(view.lensPattern.at(samples[i]));
            EXPECT_EQ(rays.ray(i).origin, camera.eye + (view.lens.right * at.x - view.lens.down * at.y));
        }
    }
}

/// Mean of the squares of the distances in pixels of the light in the image from its centre, and all light.
struct Blur {
    double light = 0, x = 0, y = 0, meanSquare = 0;
};

Blur blurOf(const Frame& frame) {
    Blur blur;
    const HdrImage& image = frame.radiance;
    const auto each = [&](auto&& use) {
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) use(x + .5, y + .5, static_cast<double>(image.at(x, y).g));
        }
    };
    each([&](double, double, double g) { blur.light += g; });
    each([&](double x, double y, double g) {
        blur.x += x * g / blur.light;
        blur.y += y * g / blur.light;
    });
    each([&](double x, double y, double g) {
        blur.meanSquare += ((x - blur.x) * (x - blur.x) + (y - blur.y) * (y - blur.y)) * g / blur.light;
    });
    return blur;
}

/// A bright square of `side` scene units at that distance, seen by a lens that is focused at `focus`.
Blur blurOfSquare(double distance, float focus, int blades, double side) {
    test::SceneBuilder b;
    b.square({0, 0, static_cast<float>(-distance)}, {0, 0, 1}, static_cast<float>(side / 2),
             b.material(test::emitter({100, 100, 100})));
    const test::TracedScene s(b.finish());
    RenderSettings settings = test::sampleSettings(80, 80, 12);
    settings.sampling = SamplingPattern::Jittered;
    settings.depthOfField = {.on = true, .fNumber = 4, .focus = focus, .blades = blades};
    Camera camera;
    camera.horizontalFov = 8;
    RenderControl control{.threads = 2};
    Frame frame;
    EXPECT_TRUE(test::renderFrame({s.scene, s.tracer, camera, settings}, control, frame));
    return blurOf(frame);
}

TEST(DepthOfField, TheCircleOfConfusionIsThatOfAThinLens) {
    const double halfTangent = std::tan(4 * test::kPi / 180), film = .018 / halfTangent;
    for (const auto& [distance, focus] : {std::pair{4.0, 2.0}, {1.0, 2.0}, {9.0, 3.0}, {.8, 1.0}}) {
        const double focal = 1 / (1 / film + 1 / focus), aperture = focal / 4;
        // Diameter on the film by the lens equation, in pixels.
        const double blur =
            aperture * focal * std::fabs(distance - focus) / (distance * (focus - focal)) / .036 * 80;
        const double pixel = 2 * halfTangent / 80 * distance, side = 3 * pixel;
        const Blur round = blurOfSquare(distance, static_cast<float>(focus), 0, side);
        // The variance of the disc, of the square, and of a pixel add up.
        const double squares = (9 + 1) / 6.0;
        const double diameter = 2 * std::sqrt(2 * (round.meanSquare - squares));
        EXPECT_NEAR(diameter / blur, 1, .02) << distance << " " << focus << ": " << blur << " pixels";
        EXPECT_NEAR(round.x, 40, .3);
        EXPECT_NEAR(round.y, 40, .3);
        const Blur sharp = blurOfSquare(distance, static_cast<float>(distance), 0, side);
        EXPECT_NEAR(round.light / sharp.light, 1, .02);
        EXPECT_NEAR(sharp.meanSquare, squares, .2);
        const Blur hexagon = blurOfSquare(distance, static_cast<float>(focus), 6, side);
        EXPECT_NEAR((hexagon.meanSquare - squares) / (blur * blur / 4), .416667, .02) << distance;
    }
}

TEST(DepthOfField, WithoutFocusWhatIsInTheMiddleIsSharp) {
    test::SceneBuilder b;
    b.square({0, 0, -3}, {0, 0.5F, 0.8660254F}, .5F, b.material(test::emitter({1, 1, 1})));
    const test::TracedScene s(b.finish());
    Camera camera;
    camera.eye = {0, 0, 1};
    camera.horizontalFov = 40;
    FocusFinder focus;
    const CameraRays view(camera, 60, 40);
    EXPECT_NEAR(focus.distance(s.tracer, view, 30, 20), 4, 1e-5);
    // Along the axis, not along the ray.
    const Ray ray = view.at(33, 25);
    const float t = 4 * .8660254F / dot(ray.direction, {0, -0.5F, -0.8660254F});
    EXPECT_NEAR(focus.distance(s.tracer, view, 33, 25), -t * ray.direction.z, 1e-4);
    EXPECT_EQ(focus.distance(s.tracer, view, 0, 0), kInfiniteFocus);

    RenderSettings settings = test::sampleSettings(60, 40, 2);
    settings.depthOfField = {.on = true, .fNumber = .5F};
    RenderControl control{.threads = 1};
    Frame found, given;
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, settings}, control, found));
    settings.depthOfField.focus = focus.distance(s.tracer, view, 30, 20);
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, settings}, control, given));
    EXPECT_EQ(found.radiance.pixels, given.radiance.pixels);
}

} // namespace
} // namespace rtcore
