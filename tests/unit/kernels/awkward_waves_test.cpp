// Degenerate input through every kernel: each must find what single rays find, and those what all triangles
// one by one give. RT_WAVE_ROUNDS sets how many times as many rays are tried (1 unless told, 200 in the long
// check), RT_EQUAL_TRIANGLES how many triangles lie in one place (100,000 unless told, there 10,000,000).
#include "wave_support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

using rtcore::Ray;
using rtcore::RayWave;
using rtcore::Vec3;
using test::kForever;
using test::Random;
using test::rayFrom;
using test::WaveScene;

namespace {

constexpr std::size_t kGroup = 64;

/// Boxes of many sizes on a lattice, all faces parallel to the axes, many shared.
test::SampleMesh boxes(std::uint64_t seed) {
    Random random(seed);
    test::SampleMesh mesh;
    for (int i = 0; i < 25; ++i) {
        const auto step = [&] { return 0.125F * static_cast<float>(random.index(17)) - 1; };
        const float size = 0.0625F * static_cast<float>(1 + random.index(4));
        const float x = step();
        const float y = step();
        mesh.append(test::boxGrid(1).scale(size).move({x, y, step()}));
    }
    return mesh;
}

/// Many planes, whatever they cost.
rtcore::BuildOptions deep() {
    rtcore::BuildOptions options;
    options.intersectionCost = 4;
    return options;
}

/// One wave for each way of the kernels: a stream, packets of any directions, of one origin, and of many
/// origins and one way. `makeRay` gives any of the rays in question; packets are of its neighbours, which
/// share all that is special about its direction: zero and tiny components, and the coordinate of its origin
/// on those axes.
template <typename MakeRay>
std::vector<std::pair<std::string, RayWave>> waysOf(Random& random, MakeRay&& makeRay) {
    std::vector<std::pair<std::string, RayWave>> waves(4);
    waves[0].first = "stream";
    for (std::size_t i = 0; i < 11 * kGroup + 5; ++i) waves[0].second.push(makeRay());
    waves[1].first = "few";
    for (std::size_t i = 0; i < 6 * kGroup + 5; ++i) waves[1].second.push(makeRay());
    for (std::size_t way = 2; way < 4; ++way) {
        waves[way].first = way == 2 ? "one origin" : "many origins";
        for (int group = 0; group < 8; ++group) {
            const Ray ray = makeRay();
            const float size = std::max(
                {std::fabs(ray.direction.x), std::fabs(ray.direction.y), std::fabs(ray.direction.z)});
            for (std::size_t i = 0; i < kGroup; ++i) {
                Ray neighbour = ray;
                for (int axis = 0; axis < 3; ++axis) {
                    if (std::fabs(ray.direction[axis]) < 0.001F * size) continue;
                    neighbour.direction[axis] += size * random.number(-0.09F, 0.09F);
                    if (way == 3) neighbour.origin[axis] *= random.number(0.9F, 1.1F);
                }
                waves[way].second.push(neighbour);
            }
        }
    }
    return waves;
}

/// How often waves are made anew: RT_WAVE_ROUNDS, or once.
int rounds() {
    const char* const text = std::getenv("RT_WAVE_ROUNDS");
    return text != nullptr ? std::max(std::atoi(text), 1) : 1;
}

/// Traces all those waves; returns how many rays hit something.
template <typename MakeRay>
std::size_t expectBruteForce(const WaveScene& scene, Random& random, MakeRay&& makeRay) {
    std::size_t hits = 0;
    for (int i = 0; i < rounds() && !testing::Test::HasFailure(); ++i) {
        for (const auto& [name, wave] : waysOf(random, makeRay)) hits += scene.expectBruteForce(name, wave);
    }
    return hits;
}

/// Every split position of the tree along each axis.
std::vector<std::pair<int, float>> planesOf(const rtcore::KdTree& tree) {
    std::vector<std::pair<int, float>> planes;
    for (const rtcore::KdNode node : tree.nodes) {
        if (!node.isLeaf()) planes.emplace_back(node.axis(), node.split);
    }
    return planes;
}

/// Zero, denormal or on the verge of it; of either sign.
float nearlyNothing(Random& random) {
    constexpr float kSizes[] = {0, 0, 0, 1e-45F, 1e-42F, 1e-39F, 1.2e-38F, 1e-37F};
    const float size = kSizes[random.index(std::size(kSizes))];
    return random.coin() ? size : -size;
}

/// One or two components of the direction are next to nothing.
Vec3 flatDirection(Random& random) {
    Vec3 direction = random.coin() ? random.unitVector() : Vec3{1, 1, 1};
    if (random.coin()) direction = direction * -1.0F;
    const int axis = static_cast<int>(random.index(3));
    direction[axis] = nearlyNothing(random);
    if (random.coin()) direction[(axis + 1) % 3] = nearlyNothing(random);
    return direction;
}

std::size_t equalTriangles() {
    const char* const text = std::getenv("RT_EQUAL_TRIANGLES");
    const long long count = text != nullptr ? std::atoll(text) : 0;
    return count > 0 ? static_cast<std::size_t>(count) : 100'000;
}

} // namespace

TEST(AwkwardWaves, WithNextToNothingInTheDirection) {
    Random random(1);
    for (const bool axisParallel : {true, false}) {
        const WaveScene scene(axisParallel ? boxes(2) : test::soup(400, 0.3F, 3), deep());
        std::size_t hits = 0;
        for (int i = 0; i < 3; ++i) {
            hits += expectBruteForce(scene, random,
                                     [&] { return rayFrom(random.vector(1.2F), flatDirection(random)); });
        }
        EXPECT_GT(hits, 1000U);
    }
}

TEST(AwkwardWaves, InsideSplitPlanesAndFaces) {
    Random random(4);
    for (const bool axisParallel : {true, false}) {
        const WaveScene scene(axisParallel ? boxes(5) : test::soup(400, 0.3F, 6), deep());
        const auto planes = planesOf(scene.tree());
        ASSERT_FALSE(planes.empty());
        std::size_t hits = 0;
        for (int i = 0; i < 3; ++i) {
            hits += expectBruteForce(scene, random, [&] {
                Ray ray = rayFrom(random.vector(1.2F), random.unitVector());
                const auto [axis, position] = planes[random.index(planes.size())];
                ray.origin[axis] = position;
                ray.direction[axis] = nearlyNothing(random);
                const auto [other, place] = planes[random.index(planes.size())];
                if (other != axis && random.coin()) { // along the line that two planes share
                    ray.origin[other] = place;
                    ray.direction[other] = nearlyNothing(random);
                }
                return ray;
            });
        }
        EXPECT_GT(hits, 500U);
    }
}

TEST(AwkwardWaves, AlongTheFacesOfTheSceneBox) {
    const WaveScene scene(test::boxGrid(4), deep());
    Random random(7);
    std::size_t hits = 0;
    for (int i = 0; i < 3; ++i) {
        hits += expectBruteForce(scene, random, [&] {
            const int axis = static_cast<int>(random.index(3));
            Ray ray = rayFrom(random.vector(1.5F), random.unitVector());
            ray.origin[axis] = random.coin() ? 1.0F : -1.0F;
            ray.direction[axis] = nearlyNothing(random);
            return ray;
        });
    }
    EXPECT_GT(hits, 300U);
}

TEST(AwkwardWaves, ThroughTheLatticeOfBoxes) {
    const WaveScene scene(boxes(8), deep());
    Random random(9);
    const auto point = [&](std::size_t steps) {
        const auto step = [&] { return 0.0625F * static_cast<float>(random.index(steps)) - 1; };
        const float x = step();
        const float y = step();
        return Vec3{x, y, step()};
    };
    std::size_t hits = 0;
    for (int i = 0; i < 3; ++i) {
        hits += expectBruteForce(scene, random, [&] {
            Vec3 direction = point(33);
            if (direction == Vec3{}) direction.x = 1;
            return rayFrom(point(33), direction);
        });
    }
    EXPECT_GT(hits, 1000U);
}

TEST(AwkwardWaves, FromInsideClosedMeshes) {
    Random random(10);
    for (const bool box : {true, false}) {
        const WaveScene scene(box ? test::boxGrid(5) : test::icosphere(2), deep());
        for (const auto& [name, wave] :
             waysOf(random, [&] { return rayFrom(random.vector(0.5F), random.unitVector()); })) {
            EXPECT_EQ(scene.expectBruteForce(name, wave), wave.size());
        }
    }
}

TEST(AwkwardWaves, FromSurfaces) {
    Random random(11);
    const WaveScene scene(test::torus(16, 8).rotate(12), deep());
    const std::size_t hits = expectBruteForce(scene, random, [&] {
        const std::uint32_t triangle = random.index(scene.mesh().triangles.size());
        const float u = random.number(0, 1);
        const float v = random.number(0, 1 - u);
        const Vec3 p = scene.mesh().position(triangle, 0) * (1 - u - v) +
                       scene.mesh().position(triangle, 1) * u + scene.mesh().position(triangle, 2) * v;
        return rayFrom(random.coin() ? p : scene.mesh().position(triangle, 0), random.unitVector());
    });
    EXPECT_GT(hits, 500U);
}

TEST(AwkwardWaves, OntoAFlatSheet) {
    Random random(13);
    for (int axis = 0; axis < 3; ++axis) {
        const WaveScene scene(test::sheet(9, axis, 0.25F), deep());
        const std::size_t hits = expectBruteForce(scene, random, [&] {
            Ray ray = rayFrom(random.vector(1.5F), random.unitVector());
            switch (random.index(4)) {
            case 0: // within it
                ray.origin[axis] = 0.25F;
                ray.direction[axis] = nearlyNothing(random);
                break;
            case 1: // from it
                ray.origin[axis] = 0.25F;
                break;
            case 2: // straight onto it, some along the lines between its triangles
                ray.origin = {std::round(4.5F * ray.origin.x) / 4.5F, std::round(4.5F * ray.origin.y) / 4.5F,
                              std::round(4.5F * ray.origin.z) / 4.5F};
                ray.direction = {nearlyNothing(random), nearlyNothing(random), nearlyNothing(random)};
                ray.direction[axis] = ray.origin[axis] < 0.25F ? 1.0F : -1.0F;
                break;
            default:
                break;
            }
            return ray;
        });
        EXPECT_GT(hits, 300U);
    }
}

TEST(AwkwardWaves, OfAwkwardIntervals) {
    const WaveScene scene(test::soup(400, 0.3F, 14), deep());
    Random random(15);
    std::size_t hits = 0;
    for (int i = 0; i < 3; ++i) {
        hits += expectBruteForce(scene, random, [&] {
            Ray ray = rayFrom(random.vector(1.2F), random.unitVector());
            rtcore::Hit hit;
            const bool exists = intersect(scene.tree(), scene.mesh(), ray, hit);
            const float t = exists ? hit.t : 1;
            switch (random.index(10)) {
            case 0: // exactly to the hit, or from it on
                ray.tMax = t;
                break;
            case 1:
                ray.tMin = t;
                break;
            case 2: // nothing but the hit
                ray.tMin = ray.tMax = t;
                break;
            case 3: // the numbers next to it
                ray.tMax = std::nextafter(t, 0.0F);
                break;
            case 4:
                ray.tMin = std::nextafter(t, kForever);
                break;
            case 5: // empty
                ray.tMin = 2 * t;
                ray.tMax = random.coin() ? t : 0;
                break;
            case 6:
                ray.tMax = random.coin() ? -t : -1e-30F;
                break;
            case 7:
                ray.tMax = random.coin() ? 0.0F : -0.0F;
                break;
            case 8:
                ray.tMin = 1e30F;
                ray.tMax = random.coin() ? kForever : std::numeric_limits<float>::max();
                break;
            default: // all
                break;
            }
            return ray;
        });
    }
    EXPECT_GT(hits, 900U);
}

TEST(AwkwardWaves, ThroughATreeOfOneLeaf) {
    Random random(16);
    for (const std::size_t triangles : {1U, 2U, 5U, 17U, 40U, 200U}) {
        rtcore::BuildOptions options;
        options.intersectionCost = 1e-6F;
        options.emptyBonus = 0;
        const WaveScene scene(test::soup(triangles, 1, triangles), options);
        ASSERT_EQ(scene.tree().nodes.size(), 1U);
        const std::size_t hits =
            expectBruteForce(scene, random, [&] { return rayFrom(random.vector(2), random.unitVector()); });
        EXPECT_GT(hits, 5U);
    }
}

TEST(AwkwardWaves, ThroughNothing) {
    const WaveScene scene(test::SampleMesh{});
    Random random(17);
    EXPECT_EQ(
        expectBruteForce(scene, random, [&] { return rayFrom(random.vector(2), flatDirection(random)); }),
        0U);
}

TEST(AwkwardWaves, ThroughTrianglesWithoutArea) {
    Random random(18);
    test::SampleMesh mesh = test::soup(100, 0.5F, 19);
    for (int i = 0; i < 200; ++i) { // points and lines
        const Vec3 a = random.vector(1);
        const Vec3 b = random.coin() ? a : random.vector(1);
        mesh.addTriangle(a, b, random.coin() ? a : (a + b) * 0.5F);
    }
    const WaveScene scene(mesh, deep());
    const std::size_t hits = expectBruteForce(scene, random, [&] {
        const Vec3 from = random.vector(1.2F);
        const Vec3 to = mesh.vertices[random.index(mesh.vertices.size())].position();
        return rayFrom(from, random.coin() ? to - from : random.unitVector());
    });
    EXPECT_GT(hits, 500U);
}

TEST(AwkwardWaves, InHugeAndTinyScenes) {
    Random random(20);
    for (const float scale : {1e-12F, 1e-6F, 1e6F, 1e12F}) {
        for (const bool axisParallel : {true, false}) {
            test::SampleMesh mesh = axisParallel ? boxes(21) : test::soup(400, 0.3F, 22);
            const WaveScene scene(mesh.scale(scale), deep());
            const std::size_t hits = expectBruteForce(scene, random, [&] {
                const Vec3 direction = random.coin() ? random.unitVector() : flatDirection(random);
                return rayFrom(random.vector(1.2F) * scale, direction);
            });
            EXPECT_GT(hits, 300U);
        }
    }
}

// t counts lengths of the direction.
TEST(AwkwardWaves, OfAnyLengthOfDirection) {
    Random random(23);
    const WaveScene scene(test::soup(400, 0.3F, 24), deep());
    for (const float length : {1e-30F, 1e-20F, 1e-10F, 1e10F, 1e20F, 1e30F}) {
        const std::size_t hits = expectBruteForce(
            scene, random, [&] { return rayFrom(random.vector(1.2F), random.unitVector() * length); });
        EXPECT_GT(hits, 300U);
    }
}

// Where distances overflow or vanish, answers are still answers.
TEST(AwkwardWaves, BeyondTheRangeOfDistances) {
    Random random(27);
    for (const float scale : {1.0F, 1e12F}) {
        const WaveScene scene(test::soup(400, 0.3F, 28).scale(scale), deep());
        for (const float length : {1e-45F, 1e-42F, 1e-40F, 1e-38F, 1e-36F, 1e38F}) {
            const auto makeRay = [&] {
                Vec3 direction = random.unitVector() * length;
                if (direction == Vec3{}) direction.y = length;
                return rayFrom(random.vector(1.2F) * scale, direction);
            };
            for (const auto& [name, wave] : waysOf(random, makeRay)) scene.expectAnswers(name, wave);
        }
    }
}

// The distance itself, 2e17, has room: the sum that it is divided from has not. A ray to infinity, too, then
// meets nothing, whether the closest hit is asked for or any.
TEST(AwkwardWaves, WhoseDistancesOverflow) {
    Random random(29);
    test::SampleMesh mesh;
    mesh.addTriangle({-1e12F, -1e12F, 1e12F}, {1e12F, -1e12F, 1e12F}, {0, 1e12F, 1e12F});
    const WaveScene scene(std::move(mesh));
    for (const bool overflows : {true, false}) {
        for (const auto& [name, wave] : waysOf(random, [&] {
                 const Vec3 aside{random.number(-0.2F, 0.2F), random.number(-0.2F, 0.2F), 1};
                 return rayFrom(random.vector(1e11F), aside * (overflows ? 5e-6F : 1.0F));
             }))
            EXPECT_EQ(scene.expectBruteForce(name, wave), overflows ? 0 : wave.size());
    }
}

// The leaf test's distance of a large wall is off by more than planes are widened: rays that end there must
// look further than their ends, and those that begin there before their beginnings.
TEST(AwkwardWaves, ThatEndOrBeginAtLargeWalls) {
    Random random(31);
    test::SampleMesh mesh = test::soup(300, 0.2F, 32);
    for (const float z : {0.25F, 0.5F, 0.75F})
        mesh.addTriangle({-700, -900, z}, {800, -500, z}, {100, 1300, z});
    const WaveScene scene(std::move(mesh), deep());
    RayWave wave;
    for (int group = 0; group < 3000; ++group) {
        const Vec3 eye{random.number(-1, 1), random.number(-1, 1), random.number(-1, 0.2F)};
        Ray ray = rayFrom(eye, {1, random.number(0.1F, 0.6F), random.number(0.2F, 0.6F)});
        rtcore::Hit hit;
        if (!intersect(scene.tree(), scene.mesh(), ray, hit)) continue;
        const float near = hit.t * (1 + random.number(-3e-5F, 3e-5F));
        if (group % 2 == 0) {
            ray.tMax = near;
        } else {
            ray.tMin = near;
            ray.tMax = near * 1.001F;
        }
        for (std::size_t i = 0; i < kGroup; ++i) wave.push(ray);
    }
    EXPECT_GT(scene.expectBruteForce("walls", wave), 10000U);
}

// Two large walls in one plane, the second of which begins at a plane of the tree: rays that hit both there
// find the first in the nearer cell, but the leaf test's distance of the second may be the smaller one, by
// more than planes are widened. The hit of the first must not hide it.
TEST(AwkwardWaves, WhereTwoLargeWallsCoincide) {
    Random random(33);
    for (int turn = 0; turn < 3; ++turn) { // which axis is which
        const auto turned = [&](float x, float y, float z) {
            Vec3 p;
            p[turn] = x;
            p[(turn + 1) % 3] = y;
            p[(turn + 2) % 3] = z;
            return p;
        };
        constexpr float kBegin = 0.25F;
        const auto onWall = [&](float x, float y) { return turned(x, y, 0.5F + 0.3F * x + 0.2F * y); };
        test::SampleMesh mesh = test::soup(100, 0.1F, 34);
        mesh.addTriangle(onWall(-800, 900), onWall(300, -700), onWall(250, 1000));
        mesh.addTriangle(onWall(kBegin, 900), onWall(kBegin, -700), onWall(700, -30));
        const WaveScene scene(std::move(mesh), deep());
        RayWave bundles, packets, stream;
        for (int group = 0; group < 160; ++group) {
            const Vec3 eye =
                turned(random.number(-1, -0.5F), random.number(-1, -0.5F), random.number(-1, -0.5F));
            const float y = random.number(0.1F, 0.6F);
            const auto target = [&](float spread) {
                return onWall(kBegin + random.number(0, 3e-6F), y + random.number(-spread, spread));
            };
            for (std::size_t i = 0; i < kGroup; ++i) {
                bundles.push(rayFrom(eye, target(0.1F) - eye));
                const Vec3 beside = eye + random.vector(0.02F);
                packets.push(rayFrom(beside, target(0.1F) - beside));
                const Vec3 anywhere =
                    turned(random.number(-1, 0), random.number(-1, 1), random.number(-1, 0));
                stream.push(rayFrom(anywhere, target(0.8F) - anywhere));
            }
        }
        EXPECT_GT(scene.expectBruteForce("one origin", bundles), 5000U);
        EXPECT_GT(scene.expectBruteForce("many origins", packets), 5000U);
        EXPECT_GT(scene.expectBruteForce("stream", stream), 5000U);
    }
}

// Rays that touch a triangle at one corner only, which is a corner of its cell and of the scene's box as
// well: they pass the planes that meet there at the same distance, but for rounding.
TEST(AwkwardWaves, ThatTouchCorners) {
    Random random(35);
    std::size_t hits = 0;
    for (int round = 0; round < 30 * rounds() && !HasFailure(); ++round) {
        test::SampleMesh mesh;
        const int count = round % 3 == 0 ? 1 : 12;
        for (int i = 0; i < count; ++i) { // each in an octant around its first corner
            const Vec3 corner = random.vector(1);
            const auto inside = [&](Vec3 by) {
                Vec3 p = corner;
                for (int axis = 0; axis < 3; ++axis) p[axis] += i >> axis & 1 ? by[axis] : -by[axis];
                return p;
            };
            const auto some = [&] { return random.number(0.05F, 0.3F); };
            mesh.addTriangle(corner, inside({some(), 0.01F, some()}), inside({0.01F, some(), some()}));
        }
        const WaveScene scene(mesh, deep());
        RayWave same, stream;
        for (int i = 0; i < 60; ++i) {
            const std::uint32_t triangle = random.index(mesh.triangles.size());
            const Vec3 corner = scene.mesh().position(triangle, 0), eye = corner + random.vector(1);
            const Ray ray = rayFrom(eye, corner - eye);
            rtcore::Hit hit;
            if (!test::bruteForce(scene.mesh(), ray, hit)) continue;
            for (std::size_t k = 0; k < kGroup; ++k) same.push(ray);
            for (std::size_t k = 0; k < 16; ++k) stream.push(ray);
        }
        hits += scene.expectBruteForce("packets", same);
        // Scattered, as streams are.
        RayWave shuffled;
        for (std::size_t i = 0; i < stream.size(); ++i)
            shuffled.push(stream.ray(i * 16 % stream.size() + i * 16 / stream.size()));
        hits += scene.expectBruteForce("stream", shuffled);
    }
    EXPECT_GT(hits, 10000U);
}

// Shadow rays that end at corners of triangles in one plane. Seen from where they end, nothing but the
// rounding of their places tells them from rays that pass by.
TEST(AwkwardWaves, ThatEndAtCornersInOnePlane) {
    Random random(36);
    std::size_t hits = 0;
    for (int turn = 0; turn < 3; ++turn) { // the axis across the plane
        // All numbers are exact, so that rays meet the corners themselves.
        const auto exact = [&](Vec3 p, float across) {
            constexpr float kSteps = 1024;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = axis == turn ? across : std::round(p[axis] * kSteps) / kSteps;
            return p;
        };
        rtcore::BuildOptions longLeaves;
        longLeaves.intersectionCost = 0.02F;
        test::SampleMesh mesh = test::soup(400, 0.1F, 37).map([&](Vec3 p) { return exact(p, 0.25F); });
        mesh.addTriangle({-1, -1, -1}, {-0.9F, -0.8F, -1}, {-1, -0.9F, -0.7F}); // so that the box is no plane
        const WaveScene scene(std::move(mesh), longLeaves);
        RayWave wave;
        for (int group = 0; group < 250; ++group) {
            const Vec3 eye = random.vector(1);
            for (std::size_t i = 0; i < kGroup; ++i) {
                if (i % 16 != 0) { // so that their beam is no wider than they are
                    wave.push(wave.ray(wave.size() - 1));
                    continue;
                }
                const std::uint32_t triangle = random.index(scene.mesh().triangles.size() - 1);
                const Vec3 corner = scene.mesh().position(triangle, static_cast<int>(random.index(3)));
                const Vec3 direction = exact(eye * 0.15F + random.vector(0.02F), 1);
                wave.push({corner - direction, 0, direction, 1.00001F});
            }
        }
        hits += scene.expectBruteForce("one plane", wave);
    }
    EXPECT_GT(hits, 10000U);
}

TEST(AwkwardWaves, OntoManyEqualTriangles) {
    const std::size_t count = equalTriangles();
    test::SampleMesh mesh = test::soup(50, 0.2F, 25);
    const auto first = static_cast<std::uint32_t>(mesh.triangles.size());
    const std::uint32_t corner = mesh.addVertex({-0.1F, -0.1F, 0});
    mesh.addVertex({0.1F, -0.1F, 0.05F});
    mesh.addVertex({0, 0.1F, 0.1F});
    mesh.triangles.resize(first + count, {{corner, corner + 1, corner + 2}});
    const WaveScene scene(std::move(mesh));
    Random random(26);
    // Few of a stream's rays meet them: each that does is tested against all.
    RayWave stream;
    for (std::size_t i = 0; i < 10 * kGroup; ++i) {
        const Vec3 from = random.unitVector() * 2;
        stream.push(rayFrom(from, i % 40 == 0 ? Vec3{0, -0.03F, 0.05F} - from : random.unitVector()));
    }
    RayWave packet;
    for (std::size_t i = 0; i < kGroup; ++i) {
        packet.push(rayFrom({0, 0, 2}, Vec3{random.number(-0.2F, 0.2F), random.number(-0.2F, 0.2F), -2}));
    }
    for (const RayWave& wave : {stream, packet}) {
        EXPECT_GT(scene.expectSingleRays("equal triangles", wave), 5U);
        // The first one of all that are equally close is hit.
        const test::WaveAnswer answer = test::bySingleRays(scene.tree(), scene.mesh(), wave);
        for (std::size_t i = 0; i < wave.size(); ++i) {
            if (!answer.hits.isHit(i)) continue;
            EXPECT_LE(answer.hits.triangle[i], first);
        }
    }
}
