// Rays along axes, inside planes of the tree and faces of the mesh, from surfaces, with denormal components.
#include "rtcore/kernels/single_ray.h"

#include "kernel_support.h"

#include "rtcore/math/triangle.h"

#include <algorithm>
#include <vector>

using rtcore::Ray;
using rtcore::Vec3;
using test::rayFrom;
using test::TracedMesh;

namespace {

/// Boxes of many sizes on a lattice, all faces parallel to the axes, many shared.
test::SampleMesh boxes(std::uint64_t seed) {
    test::Random random(seed);
    test::SampleMesh mesh;
    for (int i = 0; i < 40; ++i) {
        const auto step = [&] { return 0.125F * static_cast<float>(random.index(17)) - 1; };
        const float size = 0.0625F * static_cast<float>(1 + random.index(4));
        const Vec3 at{step(), step(), step()};
        mesh.append(test::boxGrid(2).scale(size).move(at));
    }
    return mesh;
}

/// Every split position of the tree along each axis.
std::vector<std::pair<int, float>> planesOf(const rtcore::KdTree& tree) {
    std::vector<std::pair<int, float>> planes;
    for (const rtcore::KdNode node : tree.nodes) {
        if (!node.isLeaf()) planes.emplace_back(node.axis(), node.split);
    }
    return planes;
}

/// How far from a triangle the rays start that leave it.
float clearanceOf(const rtcore::Mesh& mesh, std::uint32_t triangle, Vec3 normal) {
    return rtcore::surfaceClearance(mesh.position(triangle, 0), mesh.position(triangle, 1),
                                    mesh.position(triangle, 2), normal);
}

/// A direction of which one or two components are zero, of either sign.
Vec3 flatDirection(test::Random& random) {
    Vec3 d = random.coin() ? random.vector(1) : Vec3{1, 1, 1};
    const int zero = static_cast<int>(random.index(3));
    d[zero] = random.coin() ? 0.0F : -0.0F;
    if (random.coin()) d[(zero + 1) % 3] = random.coin() ? 0.0F : -0.0F;
    if (random.coin()) d = d * -1.0F;
    return d;
}

} // namespace

TEST(AwkwardRays, WithZeroComponents) {
    test::Random random(1);
    for (const bool axisParallel : {true, false}) {
        const TracedMesh scene(axisParallel ? boxes(2) : test::soup(1500, 0.2F, 3));
        for (int i = 0; i < 6000; ++i) {
            const Ray ray = rayFrom(random.vector(1.2F), flatDirection(random));
            scene.expectBruteForce(ray);
            if (i % 15 == 0) scene.expectRight(ray);
        }
        EXPECT_GT(scene.hits(), 2000);
    }
}

TEST(AwkwardRays, InsideSplitPlanesAndFaces) {
    test::Random random(4);
    for (const bool axisParallel : {true, false}) {
        const TracedMesh scene(axisParallel ? boxes(5) : test::soup(1500, 0.2F, 6));
        const auto planes = planesOf(scene.tree());
        ASSERT_FALSE(planes.empty());
        for (int i = 0; i < 6000; ++i) {
            const auto [axis, position] = planes[random.index(planes.size())];
            Ray ray = rayFrom(random.vector(1.2F), random.unitVector());
            ray.origin[axis] = position;
            ray.direction[axis] = random.coin() ? 0.0F : -0.0F;
            if (i % 3 == 0) { // in a second plane as well: along their common line
                const auto [other, place] = planes[random.index(planes.size())];
                if (other != axis) {
                    ray.origin[other] = place;
                    ray.direction[other] = 0;
                }
            }
            scene.expectBruteForce(ray);
        }
        EXPECT_GT(scene.hits(), 1000);
    }
}

TEST(AwkwardRays, ThroughTheLatticeOfAxisParallelBoxes) {
    const TracedMesh scene(boxes(7));
    test::Random random(8);
    const auto step = [&](std::size_t count) {
        return 0.0625F * static_cast<float>(random.index(count)) - 1;
    };
    for (int i = 0; i < 8000; ++i) {
        const Vec3 origin{step(33), step(33), step(33)};
        const Vec3 direction{step(33), step(33), step(33)};
        if (direction == Vec3{}) continue;
        scene.expectBruteForce(rayFrom(origin, direction));
    }
    EXPECT_GT(scene.hits(), 4000);
}

TEST(AwkwardRays, AlongTheFacesOfTheSceneBox) {
    const TracedMesh scene(test::boxGrid(6));
    test::Random random(9);
    for (int i = 0; i < 3000; ++i) {
        const int axis = static_cast<int>(random.index(3));
        Ray ray = rayFrom(random.vector(1.5F), flatDirection(random));
        ray.origin[axis] = random.coin() ? 1.0F : -1.0F;
        ray.direction[axis] = 0;
        if (ray.direction == Vec3{}) continue;
        scene.expectBruteForce(ray);
    }
    EXPECT_GT(scene.hits(), 300);
}

// Where two triangles of one tilted plane overlap, rounding decides which is nearer, and the cell of the one
// may begin just behind the hit on the other: it must not be passed over.
TEST(AwkwardRays, WhereOneOfTwoTrianglesOfAPlaneBegins) {
    test::Random random(21);
    constexpr float kBegin = 0.4371F;
    const auto on = [](float x, float y) { return Vec3{x, y, 0.31F * x + 0.17F * y}; };
    test::SampleMesh mesh;
    mesh.addTriangle(on(kBegin, -1.1F), on(2.9F, 0.3F), on(kBegin, 1.7F));
    mesh.addTriangle(on(-3, -2.7F), on(4.1F, -2.3F), on(0.2F, 5.3F));
    rtcore::BuildOptions options;
    options.intersectionCost = 1000; // any split pays
    const rtcore::KdTree tree = buildKdTree(mesh.view(), options);
    const auto planes = planesOf(tree);
    ASSERT_NE(std::find(planes.begin(), planes.end(), std::pair(0, kBegin)), planes.end());
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 target = on(kBegin + std::pow(10.0F, random.number(-8, -4)), random.number(-0.8F, 1.2F));
        Vec3 direction = on(1, random.number(-0.5F, 0.5F));
        direction.z -= std::pow(10.0F, random.number(-3, -1));
        direction = normalize(direction);
        const Ray ray = rayFrom(target - direction * random.number(1, 3), direction);
        rtcore::Hit expected;
        rtcore::Hit hit;
        const bool exists = test::bruteForce(mesh.view(), ray, expected);
        const bool found = intersect(tree, mesh.view(), ray, hit);
        if (found != exists || !test::sameBits(hit, expected)) ++wrong;
    }
    EXPECT_EQ(wrong, 0);
}

TEST(AwkwardRays, FromSurfaces) {
    test::Random random(10);
    for (const bool axisParallel : {true, false}) {
        const TracedMesh scene(axisParallel ? boxes(11) : test::torus(40, 20).rotate(12));
        const rtcore::Mesh& mesh = scene.mesh();
        for (int i = 0; i < 5000; ++i) {
            const std::uint32_t triangle = random.index(mesh.triangles.size());
            const float u = random.number(0, 1);
            const float v = random.number(0, 1 - u);
            const Vec3 p = mesh.position(triangle, 0) * (1 - u - v) + mesh.position(triangle, 1) * u +
                           mesh.position(triangle, 2) * v;
            const Vec3 normal = normalize(mesh.geometricNormal(triangle));
            Ray ray = rayFrom(p, random.unitVector());
            if (i % 2 == 0) ray.origin = p + normal * clearanceOf(mesh, triangle, normal);
            if (i % 5 == 0) ray.origin = mesh.position(triangle, 0);
            scene.expectBruteForce(ray);
        }
        EXPECT_GT(scene.hits(), 1500);
    }
}

TEST(AwkwardRays, TheOffsetLeavesItsOwnSurface) {
    const TracedMesh scene(test::icosphere(3).rotate(13));
    const rtcore::Mesh& mesh = scene.mesh();
    test::Random random(14);
    for (int i = 0; i < 3000; ++i) {
        const std::uint32_t triangle = random.index(mesh.triangles.size());
        const Vec3 p =
            (mesh.position(triangle, 0) + mesh.position(triangle, 1) + mesh.position(triangle, 2)) *
            (1.0F / 3);
        Vec3 normal = normalize(mesh.geometricNormal(triangle));
        if (dot(normal, p) < 0) normal = -normal;
        Vec3 direction = random.unitVector();
        if (dot(direction, normal) < 0) direction = -direction;
        const Ray ray = rayFrom(p + normal * clearanceOf(mesh, triangle, normal), direction);
        EXPECT_EQ(scene.expectBruteForce(ray).triangle, rtcore::kNoTriangle);
    }
}

TEST(AwkwardRays, WithDenormalComponents) {
    test::Random random(15);
    for (const bool axisParallel : {true, false}) {
        const TracedMesh scene(axisParallel ? boxes(16) : test::soup(1500, 0.2F, 17));
        const auto planes = planesOf(scene.tree());
        for (int i = 0; i < 4000; ++i) {
            Ray ray = rayFrom(random.vector(1.2F), random.unitVector());
            const int axis = static_cast<int>(random.index(3));
            const float small = random.coin() ? 1e-45F : 1e-39F;
            ray.direction[axis] = random.coin() ? small : -small;
            if (i % 2 == 0) ray.direction[(axis + 1) % 3] = random.coin() ? 1e-42F : -1e-38F;
            if (i % 3 == 0) {
                const auto [planeAxis, position] = planes[random.index(planes.size())];
                ray.origin[planeAxis] = position;
            }
            scene.expectBruteForce(ray);
        }
        EXPECT_GT(scene.hits(), 1000);
    }
}

TEST(AwkwardRays, FromFarAwayAndOnTheWayOut) {
    const TracedMesh scene(test::soup(1000, 0.2F, 18));
    test::Random random(19);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 origin = random.unitVector() * random.number(2, 1000);
        const Vec3 towards = random.vector(1) - origin;
        scene.expectBruteForce(rayFrom(origin, towards));
        const Ray away = rayFrom(origin, -towards);
        EXPECT_EQ(scene.expectBruteForce(away).triangle, rtcore::kNoTriangle);
    }
    EXPECT_GT(scene.hits(), 1000);
}
