#include "rtcore/kernels/single_ray.h"

#include "kernel_support.h"

using rtcore::Hit;
using rtcore::Ray;
using rtcore::Vec3;
using test::rayFrom;
using test::TracedMesh;

namespace {

/// From anywhere about the cube [-1, 1]^3, half of them aimed at a point of a triangle.
Ray randomRay(const rtcore::Mesh& mesh, test::Random& random, float size = 1) {
    const Vec3 origin = random.vector(1.5F * size);
    if (random.coin()) return rayFrom(origin, random.unitVector());
    const std::uint32_t triangle = random.index(mesh.triangles.size());
    const float u = random.number(0, 1);
    const float v = random.number(0, 1 - u);
    const Vec3 target = mesh.position(triangle, 0) * (1 - u - v) + mesh.position(triangle, 1) * u +
                        mesh.position(triangle, 2) * v;
    return rayFrom(origin, target - origin);
}

} // namespace

TEST(SingleRay, FindsInSoupsWhatBruteForceFinds) {
    test::Random random(1);
    for (const float size : {0.02F, 0.2F, 1.0F}) {
        const TracedMesh scene(test::soup(1200, size, 2));
        for (int i = 0; i < 4000; ++i) scene.expectBruteForce(randomRay(scene.mesh(), random));
        for (int i = 0; i < 400; ++i) scene.expectRight(randomRay(scene.mesh(), random));
        EXPECT_GT(scene.hits(), 1500);
    }
}

TEST(SingleRay, FindsInClosedMeshesWhatBruteForceFinds) {
    test::Random random(3);
    for (const bool round : {true, false}) {
        const TracedMesh scene(round ? test::torus(30, 20).rotate(4) : test::boxGrid(9));
        for (int i = 0; i < 5000; ++i) scene.expectBruteForce(randomRay(scene.mesh(), random));
        for (int i = 0; i < 500; ++i) scene.expectRight(randomRay(scene.mesh(), random));
        EXPECT_GT(scene.hits(), 2500);
    }
}

TEST(SingleRay, FindsTheLowestIndexAmongEqualDistances) {
    // Three layers of the same triangles, shuffled by an odd stride, so that each plane has three owners.
    test::SampleMesh sample = test::sheet(8, 2, 0.25F);
    const test::SampleMesh layer = sample;
    sample.append(layer);
    sample.append(layer);
    const auto original = sample.triangles;
    for (std::size_t i = 0; i < original.size(); ++i) {
        sample.triangles[i] = original[i * 35 % original.size()]; // 384 = 2^7 * 3 and 35 share no factor
    }
    const TracedMesh scene(std::move(sample));
    test::Random random(5);
    for (int i = 0; i < 5000; ++i) {
        Ray ray = randomRay(scene.mesh(), random);
        if (random.coin()) { // through vertices and edges of the lattice: up to 18 triangles tie
            ray.origin.x = 0.25F * static_cast<float>(random.index(9)) - 1;
            ray.direction = {0, 0.125F * static_cast<float>(random.index(9)), 1};
        }
        scene.expectBruteForce(ray);
    }
    EXPECT_GT(scene.hits(), 2000);
}

TEST(SingleRay, LengthOfTheDirectionOnlyScalesTheDistance) {
    const TracedMesh scene(test::soup(800, 0.3F, 6));
    test::Random random(7);
    for (int i = 0; i < 1000; ++i) {
        Ray ray = randomRay(scene.mesh(), random);
        const Hit hit = scene.expectBruteForce(ray);
        for (const float scale : {0x1p-60F, 0x1p-10F, 0x1p20F, 0x1p60F}) {
            Ray scaled = ray;
            scaled.direction = ray.direction * scale;
            const Hit same = scene.expectBruteForce(scaled);
            ASSERT_EQ(same.triangle, hit.triangle);
            if (hit.triangle == rtcore::kNoTriangle) continue;
            EXPECT_EQ(same.t * scale, hit.t); // powers of two: no rounding
            EXPECT_EQ(same.u, hit.u);
            EXPECT_EQ(same.v, hit.v);
        }
    }
}

TEST(SingleRay, LimitsAreInclusive) {
    const TracedMesh scene(test::soup(800, 0.3F, 8));
    test::Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = randomRay(scene.mesh(), random);
        Hit hit; // with the distance that limits are compared with
        if (!findClosest({scene.tree(), scene.mesh()}, ray, hit)) continue;
        const float before = std::nextafter(hit.t, 0.0F);
        const float behind = std::nextafter(hit.t, test::kForever);
        const Hit only = scene.expectBruteForce({ray.origin, hit.t, ray.direction, hit.t});
        EXPECT_EQ(only.triangle, hit.triangle);
        EXPECT_EQ(scene.expectBruteForce({ray.origin, 0, ray.direction, before}).triangle,
                  rtcore::kNoTriangle);
        const Hit next = scene.expectBruteForce({ray.origin, behind, ray.direction, test::kForever});
        EXPECT_TRUE(next.triangle == rtcore::kNoTriangle || next.t >= behind);
        EXPECT_EQ(scene.expectBruteForce({ray.origin, behind, ray.direction, before}).triangle,
                  rtcore::kNoTriangle);
    }
}

TEST(SingleRay, SegmentsFindWhatLiesInside) {
    const TracedMesh scene(test::soup(1500, 0.1F, 10));
    test::Random random(11);
    for (int i = 0; i < 4000; ++i) {
        Ray ray = randomRay(scene.mesh(), random);
        ray.tMin = random.number(0, 1);
        ray.tMax = ray.tMin + random.number(0, 1);
        scene.expectBruteForce(ray);
        if (i % 10 == 0) scene.expectRight(ray);
    }
    EXPECT_GT(scene.hits(), 500);
}

TEST(SingleRay, WorksAtAnyScaleAndPlace) {
    test::Random random(12);
    for (const float scale : {1e-6F, 1e-3F, 1e3F, 1e6F}) {
        const TracedMesh scene(test::soup(800, 0.2F, 13).scale(scale));
        for (int i = 0; i < 1500; ++i) scene.expectBruteForce(randomRay(scene.mesh(), random, scale));
        for (int i = 0; i < 200; ++i) scene.expectRight(randomRay(scene.mesh(), random, scale));
        EXPECT_GT(scene.hits(), 400);
    }
    for (const float offset : {1e2F, 1e4F}) {
        const Vec3 by{offset, -offset, offset};
        const TracedMesh scene(test::soup(800, 0.2F, 14).move(by));
        for (int i = 0; i < 1500; ++i) {
            Ray ray = randomRay(scene.mesh(), random);
            ray.origin = scene.tree().bounds.centre() + random.vector(1.5F);
            if (random.coin()) ray.direction = random.unitVector();
            scene.expectBruteForce(ray);
            if (i % 10 == 0) scene.expectRight(ray);
        }
        EXPECT_GT(scene.hits(), 400);
    }
}

TEST(SingleRay, DegenerateTrianglesHideNothing) {
    test::Random random(15);
    const test::SampleMesh proper = test::soup(600, 0.3F, 16);
    test::SampleMesh sample = proper;
    for (int i = 0; i < 300; ++i) {
        const Vec3 a = random.vector(1);
        const Vec3 b = random.vector(1);
        sample.addTriangle(a, a, a);
        sample.addTriangle(a, b, b);
        sample.addTriangle(a, b, a * 0.5F + b * 0.5F); // nearly: the middle is rounded
    }
    const TracedMesh scene(std::move(sample));
    for (int i = 0; i < 3000; ++i) {
        Ray ray = randomRay(scene.mesh(), random);
        if (i % 3 == 0) ray.direction = scene.mesh().position(600 + random.index(900), 0) - ray.origin;
        Hit expected;
        if (!test::bruteForce(proper.view(), ray, expected)) continue;
        // Where along a sliver it is hit depends on rounding; but what stands alone is found exactly.
        Hit hit;
        ASSERT_TRUE(intersect(scene.tree(), scene.mesh(), ray, hit));
        EXPECT_LE(hit.t, expected.t);
        EXPECT_TRUE(hit.triangle >= 600 || test::sameBits(hit, expected));
        EXPECT_TRUE(occluded(scene.tree(), scene.mesh(), ray));
    }
}

TEST(SingleRay, TheEmptyTreeIsNeverHit) {
    const TracedMesh scene(test::SampleMesh{});
    test::Random random(17);
    for (int i = 0; i < 100; ++i) scene.expectBruteForce(rayFrom(random.vector(1), random.unitVector()));
    EXPECT_EQ(scene.hits(), 0);
}

TEST(SingleRay, AMissLeavesTheHitAlone) {
    const TracedMesh scene(test::sheet(2, 2, 0));
    Hit hit{1.5F, 7, 0.25F, 0.5F};
    const Hit before = hit;
    EXPECT_FALSE(intersect(scene.tree(), scene.mesh(), rayFrom({0, 0, 1}, {0, 0, 1}), hit));
    EXPECT_TRUE(test::sameBits(hit, before));
}
