// A sphere under a point light against its closed form, where the mesh and its normals are exact: at its
// vertices.
#include "support/one_frame.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

constexpr Vec3 kLight{3, 4, 5};
constexpr float kIntensity = 50, kAlbedo = 0.8F;

struct Lit {
    double radiance, cosine;
};
/// The point of the unit sphere with normal n.
Lit closedForm(Vec3 n) {
    const double x = kLight.x - n.x, y = kLight.y - n.y, z = kLight.z - n.z;
    const double d2 = x * x + y * y + z * z;
    const double cosine = (n.x * x + n.y * y + n.z * z) / std::sqrt(d2);
    return {cosine > 0 ? kAlbedo / test::kPi * kIntensity * cosine / d2 : 0, cosine};
}

/// Where light grazes, the facets of a mesh turn away sooner than a sphere: the terminator factor darkens
/// them.
void expectLit(double seen, const Lit& expected, double tolerance) {
    constexpr double kGrazing = 0.2;
    EXPECT_LE(seen, expected.radiance * (1 + tolerance) + 1e-5);
    if (expected.cosine > kGrazing) {
        EXPECT_GE(seen, expected.radiance * (1 - tolerance));
    }
}

Scene litSphere(std::uint32_t rings) {
    test::SceneBuilder b;
    b.sphere({0, 0, 0}, 1, rings, b.material(test::matte(kAlbedo)));
    b.scene.lights.push_back(test::pointLight(kLight, kIntensity));
    return b.finish();
}

TEST(LitSphere, VerticesAsTheClosedFormSays) {
    const test::TracedScene s(litSphere(96));
    int lit = 0, dark = 0;
    for (const Vec3 n : s.scene.mesh().normals) {
        // From a little beside the normal, a hair inside the mesh's silhouette.
        const Vec3 eye = n * 3 + basisAround(n).tangent * 0.3F;
        const Lit expected = closedForm(n);
        expectLit(s.see(eye, n * 0.9999F + normalize(eye) * 1e-5F), expected, 0.02);
        (expected.radiance > 0 ? lit : dark) += 1;
    }
    EXPECT_GT(lit, 1000);
    EXPECT_GT(dark, 1000);
}

TEST(LitSphere, PixelsOfAPicture) {
    const test::TracedScene s(litSphere(256));
    Camera camera;
    camera.eye = {0, 0, 10};
    camera.horizontalFov = 14;
    RenderSettings settings;
    settings.width = 65;
    settings.height = 49;
    RenderControl control{.threads = 2};
    Frame frame;
    ASSERT_TRUE(test::renderFrame({s.scene, s.tracer, camera, settings}, control, frame));
    const double pixel = 2 * std::tan(7 * test::kPi / 180) / settings.width;
    int compared = 0;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const double dx = (x + 0.5 - settings.width / 2.0) * pixel,
                         dy = -(y + 0.5 - settings.height / 2.0) * pixel;
            const double d = std::sqrt(dx * dx + dy * dy + 1);
            const double b = 10 / d, discriminant = b * b - 99;
            const float seen = frame.radiance.at(x, y).r;
            if (discriminant < 0.03) { // outside, or near the silhouette
                if (discriminant < -0.03) {
                    EXPECT_EQ(seen, 0) << x << ' ' << y;
                }
                continue;
            }
            const double t = b - std::sqrt(discriminant);
            const Vec3 n{static_cast<float>(dx * t / d), static_cast<float>(dy * t / d),
                         static_cast<float>(10 - t / d)};
            SCOPED_TRACE(testing::Message() << x << ' ' << y);
            expectLit(seen, closedForm(n), 0.005);
            ++compared;
        }
    }
    EXPECT_GT(compared, 800);
}

} // namespace
} // namespace rtcore
