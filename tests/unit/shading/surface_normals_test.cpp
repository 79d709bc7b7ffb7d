// On which side of a face its shading normal lies, in vector code and out of it, and what follows from it.
#include "support/random_numbers.h"
#include "support/small_scene.h"

#include "rtcore/shading/surface/surface_wave.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

/// A floor at y = 0 whose front is up, with one normal all over.
SceneBuilder floorWith(Vec3 normal, const Material& material) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 50, b.material(material));
    for (Vec3& n : b.buffers.normals) n = normalize(normal);
    return b;
}

/// How bright the floor is under a light that the normal looks at.
float litFloor(float height, bool general = false) {
    Material m = test::matte(0.5F);
    if (general) m.opacity = 0.999F; // no vector code
    m.indexOfRefraction = 1;
    SceneBuilder b = floorWith({1, height, 0}, m);
    b.scene.lights.push_back(test::pointLight({10, 10, 0}, 400));
    return TracedScene(b.finish()).see({0, 3, 0}, {});
}

TEST(SurfaceNormals, AHairsBreadthBelowTheFaceIsNoOtherSide) {
    EXPECT_GT(litFloor(0.02F), 0.1F);
    EXPECT_NEAR(litFloor(-0.02F), litFloor(0.02F), 0.05F * litFloor(0.02F));
    EXPECT_NEAR(litFloor(-0.02F, true), litFloor(0.02F, true), 0.05F * litFloor(0.02F));
}

TEST(SurfaceNormals, CornersOnBothSidesMakeNoStep) {
    // One corner leans over the edge; the face is right as a whole.
    SceneBuilder b;
    b.triangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, b.material(test::matte(0.5F)));
    b.buffers.normals = {normalize({1, -0.2F, 0}), normalize({1, 1, 0}), normalize({1, 1, 0})};
    b.scene.lights.push_back(test::pointLight({100, 100, 0}, 40000));
    const TracedScene s(b.finish());
    float before = s.see({1, 5, 1}, {0.01F, 0, 0.01F});
    EXPECT_GT(before, 0.05F);
    for (float x = 0.02F; x < 1.95F; x += 0.01F) {
        const float now = s.see({1, 5, 1}, {x, 0, x});
        EXPECT_NEAR(now, before, 0.01F) << x;
        before = now;
    }
}

TEST(SurfaceNormals, AFaceWithItsCornersInTheWrongOrderIsLitFromOutside) {
    for (const float height : {-1.0F, -0.3F}) {
        SceneBuilder b = floorWith({1, height, 0}, test::matte(0.5F)); // the front is up, its normals are not
        b.scene.lights.push_back(test::pointLight({-10, 10, 0}, 400));
        b.scene.lights.push_back(test::pointLight({10, -10, 0}, 400));
        const TracedScene s(b.finish());
        EXPECT_GT(s.see({0, 3, 0}, {}), 0.1F) << height;
        EXPECT_NEAR(s.see({0, -3, 0}, {}), s.see({0, 3, 0}, {}), 1e-5F) << height;
    }
}

TEST(SurfaceNormals, NoOcclusionRayEntersTheWall) {
    SceneBuilder b = floorWith({1, -0.02F, 0}, test::matte(1));
    b.box({-60, -60, -60}, {60, -0.01F, 60}, b.material(test::matte(1))); // the inside of the wall
    const TracedScene s(b.finish());
    RenderSettings settings = test::exactSettings();
    settings.ambientOcclusion.on = true;
    settings.ambientOcclusion.distance = 1000;
    settings.ambientOcclusion.light = 1;
    settings.ambientOcclusion.samples = 256;
    EXPECT_NEAR(s.see({0, 3, 0}, {}, settings), 1, 1e-5F);
}

TEST(SurfaceNormals, NoMirroredRayEntersTheWall) {
    SceneBuilder b = floorWith({1, -0.02F, 0}, test::mirror(1));
    b.box({-60, -60, -60}, {60, -0.01F, 60}, b.material(test::matte(0)));
    b.scene.background = {1, 1, 1};
    const TracedScene s(b.finish());
    for (const Vec3 eye : {Vec3{3, 1, 0}, Vec3{0, 3, 0}, Vec3{-3, 1, 0}}) EXPECT_EQ(s.see(eye, {}), 1);
}

TEST(SurfaceNormals, AreTheSameInVectorCode) {
    test::Random random(7);
    SceneBuilder b;
    const std::uint32_t material = b.material(test::matte(0.5F));
    constexpr std::uint32_t kTriangles = 300;
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
        const Vec3 corner = random.vector(1);
        b.triangle(corner, corner + random.unitVector(), corner + random.unitVector(), material);
    }
    for (Vec3& n : b.buffers.normals) n = random.number(0, 1) < 0.05F ? Vec3{} : random.unitVector();
    const Scene scene = b.finish();
    MaterialTable materials;
    materials.prepare(scene, RenderSettings());
    RayWave rays;
    HitWave hits;
    constexpr std::uint32_t kRays = 5000;
    hits.resize(kRays);
    for (std::uint32_t i = 0; i < kRays; ++i) {
        rays.push({{}, 0, random.unitVector(), 1});
        hits.t[i] = 1;
        hits.u[i] = random.number(0, 1);
        hits.v[i] = random.number(0, 1 - hits.u[i]);
        hits.triangle[i] = i / 4 % kTriangles;
    }
    SurfaceWave wave;
    wave.fill(scene.mesh(), materials, rays, hits);
    int below = 0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        const Surface s = surfaceAt(scene, true, rays.ray(i).direction, hits.hit(i));
        ASSERT_EQ(wave.shadingNormal.at(i), s.shadingNormal) << i;
        ASSERT_EQ(wave.geometricNormal.at(i), s.geometricNormal) << i;
        if (dot(s.shadingNormal, s.geometricNormal) < 0) ++below;
    }
    EXPECT_GT(below, 100);
}

} // namespace
} // namespace rtcore
