// Surfaces in one plane: the lowest number is hit, everywhere and by every kernel, and rays that leave meet
// none of the others.
#include "rtcore/kernels/one_surface.h"

#include "wave_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fmt/core.h>

#include <functional>

namespace {

using rtcore::Vec3;
using test::SampleMesh;

/// A square [-size, size]^2 in the plane z = 0, of 2 * side^2 triangles, turned about the z axis.
SampleMesh square(float size, std::uint32_t side, float turn = 0, bool facingDown = false) {
    SampleMesh mesh = test::sheet(side, 2, 0);
    const float c = std::cos(turn), s = std::sin(turn);
    mesh.map([=](Vec3 p) { return Vec3{(c * p.x - s * p.y) * size, (s * p.x + c * p.y) * size, 0}; });
    if (facingDown) {
        for (auto& t : mesh.triangles) std::swap(t.v[1], t.v[2]);
    }
    return mesh;
}

struct Stack {
    SampleMesh mesh;
    std::vector<std::uint32_t> ends; ///< of the triangles of each square

    void add(const SampleMesh& other) {
        mesh.append(other);
        ends.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
    }
    std::size_t squareOf(std::uint32_t triangle) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(ends, triangle) - ends.begin());
    }
};

/// A large square of two triangles, a finer one in its middle, one of another turn; all overlap within 0.5.
Stack threeSquares(bool largeFirst) {
    Stack stack;
    if (largeFirst) stack.add(square(10, 1, 0.3F));
    stack.add(square(1, 7, 0.7F, true));
    if (!largeFirst) stack.add(square(10, 1, 0.3F));
    stack.add(square(2, 3, 1.1F));
    return stack;
}

using Move = std::function<Vec3(Vec3)>;

/// As nodes of a file place it: turned, scaled, moved.
std::vector<std::pair<std::string, Move>> placements() {
    std::vector<std::pair<std::string, Move>> all;
    all.emplace_back("as it is", [](Vec3 p) { return p; });
    all.emplace_back("level, far away", [](Vec3 p) { return p + Vec3{3000, -2000, 517.3F}; });
    std::uint64_t seed = 1;
    for (const float scale : {1e-3F, 1.0F, 700.0F}) {
        for (const float away : {0.0F, 1.0F, 300.0F}) {
            test::Random random(++seed);
            const Vec3 z = random.unitVector(), offset = random.vector(away * scale);
            const rtcore::Basis side = rtcore::basisAround(z);
            all.emplace_back(fmt::format("turned, scaled {}, moved {}", scale, away), [=](Vec3 p) {
                return (side.tangent * p.x + side.bitangent * p.y + z * p.z) * scale + offset;
            });
        }
    }
    return all;
}

/// From `eye` to points all over [-reach, reach]^2 of the plane, both as they were before `move`.
rtcore::RayWave raysTo(const Move& move, Vec3 eye, float reach, std::uint64_t seed, int count = 2000) {
    test::Random random(seed);
    rtcore::RayWave wave;
    for (int i = 0; i < count; ++i) {
        const Vec3 to = move({random.number(-reach, reach), random.number(-reach, reach), 0});
        const Vec3 from = move(eye);
        wave.push({from, 0, normalize(to - from), test::kForever});
    }
    return wave;
}

std::vector<Vec3> tenEyes() {
    std::vector<Vec3> eyes;
    for (int i = 0; i < 10; ++i) {
        const float turn = 0.7F * static_cast<float>(i), low = 0.1F + 0.3F * static_cast<float>(i % 5);
        eyes.push_back(Vec3{3 * std::cos(turn), 3 * std::sin(turn), i % 2 == 0 ? low : -low} *
                       (1 + 0.4F * static_cast<float>(i)));
    }
    return eyes;
}

TEST(OneSurface, TheLowestNumberIsHitFromEverySideInEveryPlace) {
    for (const bool largeFirst : {true, false}) {
        for (const auto& [name, move] : placements()) {
            Stack stack = threeSquares(largeFirst);
            stack.mesh.map(move);
            for (const auto method : {rtcore::BuildMethod::Exact, rtcore::BuildMethod::Fast}) {
                rtcore::BuildOptions options;
                options.method = method;
                const rtcore::Mesh mesh = stack.mesh.view();
                const rtcore::KdTree tree = buildKdTree(mesh, options);
                const rtcore::KdRayTracer tracer(tree, mesh);
                std::size_t others = 0, hits = 0;
                for (const Vec3 eye : tenEyes()) {
                    rtcore::HitWave found;
                    tracer.intersect(rtcore::RayKind::Primary, raysTo(move, eye, 0.5F, 9), found);
                    for (const std::uint32_t triangle : found.triangle) {
                        ++hits;
                        others += stack.squareOf(triangle) != 0 ? 1 : 0;
                    }
                }
                EXPECT_EQ(others, 0U)
                    << "of " << hits << ", " << name << (largeFirst ? ", large one first" : "");
            }
        }
    }
}

TEST(OneSurface, EveryKernelFindsTheSameBits) {
    for (const auto& [name, move] : placements()) {
        Stack stack = threeSquares(false);
        stack.mesh.map(move);
        const test::WaveScene scene(stack.mesh);
        for (const Vec3 eye : {Vec3{0.1F, 0.2F, 3}, Vec3{4, 1, -0.3F}}) {
            rtcore::RayWave wave = raysTo(move, eye, 1.5F, 4, 700);
            scene.expectBruteForce(name + ", from a point", wave);
            // The same rays, each from a point of its own: a stream.
            for (std::size_t i = 0; i < wave.size(); ++i) {
                const float t = 0.001F * static_cast<float>(i % 700);
                wave.ox[i] += t * wave.dx[i];
                wave.oy[i] += t * wave.dy[i];
                wave.oz[i] += t * wave.dz[i];
            }
            scene.expectBruteForce(name + ", each from its own", wave);
        }
    }
}

/// Beside each other within the bound, but not all of them within it: the nearest decides.
TEST(OneSurface, ChainsAreNotFollowed) {
    SampleMesh mesh;
    constexpr float kStep = 3e-7F; // of the size: two are within the bound of each other, three are not
    for (int i = 0; i < 6; ++i) {
        SampleMesh sheet = square(1, 2, 0.2F * static_cast<float>(i));
        mesh.append(sheet.move({0, 0, -kStep * static_cast<float>(5 - i)}));
    }
    mesh.append(square(0.3F, 1).move({0, 0, -1}));
    const test::WaveScene scene(mesh);
    const Move stay = [](Vec3 p) { return p; };
    for (const float side : {1.0F, -1.0F})
        scene.expectBruteForce("a chain", raysTo(stay, {0.2F, 0.1F, 2 * side}, 0.5F, 7));
}

/// Two surfaces that are apart by a little more than rounding are not taken for one.
TEST(OneSurface, ADecalInFrontOfAWallStaysInFront) {
    for (const float gap : {1e-5F, 1e-4F}) {
        Stack stack;
        stack.add(square(1, 1));
        SampleMesh decal = square(0.6F, 1, 0.4F);
        stack.add(decal.move({0, 0, gap}));
        const rtcore::Mesh mesh = stack.mesh.view();
        const rtcore::KdTree tree = buildKdTree(mesh, {});
        for (const Vec3 eye : tenEyes()) {
            const rtcore::RayWave wave = raysTo([](Vec3 p) { return p; }, eye, 0.35F, 5, 300);
            for (std::size_t i = 0; i < wave.size(); ++i) {
                rtcore::Hit hit;
                ASSERT_TRUE(intersect(tree, mesh, wave.ray(i), hit));
                EXPECT_EQ(stack.squareOf(hit.triangle), eye.z > 0 ? 1U : 0U) << gap;
            }
        }
    }
}

/// Rays that leave what was hit, in all directions of its side, meet nothing; nor do those that go on behind.
TEST(OneSurface, RaysThatLeaveMeetNoneOfTheOthers) {
    for (const bool largeFirst : {true, false}) {
        for (const auto& [name, move] : placements()) {
            Stack stack = threeSquares(largeFirst);
            stack.mesh.map(move);
            const rtcore::Mesh mesh = stack.mesh.view();
            const rtcore::KdTree tree = buildKdTree(mesh, {});
            const rtcore::KdRayTracer tracer(tree, mesh);
            const rtcore::RayWave wave = raysTo(move, {1, 2, 3}, 0.5F, 11);
            rtcore::HitWave hits;
            tracer.intersect(rtcore::RayKind::Primary, wave, hits);
            test::Random random(12);
            rtcore::RayWave leaving;
            for (std::size_t i = 0; i < wave.size(); ++i) {
                const rtcore::Hit hit = hits.hit(i);
                const Vec3 a = mesh.position(hit.triangle, 0), b = mesh.position(hit.triangle, 1),
                           c = mesh.position(hit.triangle, 2);
                Vec3 normal = normalize(cross(b - a, c - a));
                const Vec3 direction = random.unitVector();
                if (dot(direction, normal) < 0) normal = -normal;
                const float clearance =
                    std::max(rtcore::SurfacePlane(a, b, c).clearance, hits.clearanceOf(i));
                leaving.push({a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v + normal * clearance, 0,
                              direction, test::kForever});
            }
            std::vector<std::uint8_t> occluded;
            tracer.occluded(rtcore::RayKind::Shadow, leaving, occluded);
            EXPECT_EQ(std::ranges::count(occluded, 1), 0) << name << (largeFirst ? ", large one first" : "");
        }
    }
}

} // namespace
