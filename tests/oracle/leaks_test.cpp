// Do closed meshes leak? Rays from inside are aimed where cells and triangles meet; each must hit something.
// RT_LEAK_RAYS sets how many (1,000,000 unless told; 100,000,000 in the long check).
#include "rtcore/accel/builder.h"
#include "rtcore/kernels/single_ray.h"
#include "rtcore/math/ray_offset.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

using rtcore::Ray;
using rtcore::Vec3;

namespace {

enum class Solid { Box, Sphere, Torus };

/// A closed mesh, and a point inside it for each vertex such that all between the two is inside as well.
struct ClosedMesh {
    test::SampleMesh surface, inside;
};

ClosedMesh makeSolid(Solid solid, float offset) {
    ClosedMesh mesh;
    switch (solid) {
    case Solid::Box:
        mesh.surface = test::boxGrid(24);
        break;
    case Solid::Sphere:
        mesh.surface = test::icosphere(5);
        break;
    case Solid::Torus:
        mesh.surface = test::torus(125, 80);
        break;
    }
    mesh.inside.vertices = mesh.surface.vertices;
    mesh.inside.map([=](Vec3 p) {
        return solid == Solid::Torus ? normalize(Vec3{p.x, p.y, 0}) * 0.7F : Vec3{};
    });
    for (test::SampleMesh* part : {&mesh.surface, &mesh.inside}) {
        if (solid != Solid::Box) part->rotate(2023);
        part->move({offset, -offset, offset});
    }
    return mesh;
}

std::uint64_t rayCount() {
    const char* const text = std::getenv("RT_LEAK_RAYS");
    const long long count = text != nullptr ? std::atoll(text) : 0;
    return count > 0 ? static_cast<std::uint64_t>(count) : 1'000'000;
}

class Aim {
  public:
    explicit Aim(const ClosedMesh& mesh) : mesh_(mesh), view_(mesh.surface.view()) {
        for (int axis = 0; axis < 3; ++axis) {
            auto& sorted = coordinates_[static_cast<std::size_t>(axis)];
            for (const rtcore::Vertex& v : mesh.surface.vertices) sorted.push_back(v.position()[axis]);
            std::sort(sorted.begin(), sorted.end());
        }
    }

    /// One of eight in turn: from the depth or from the surface, at a vertex (direction normalised or not),
    /// at an edge, or at an edge where a plane of the tree may cut it.
    Ray ray(std::uint64_t number, test::Random& random) const {
        const Vec3 origin = number / 4 % 2 == 0 ? pointInside(random) : pointOnSurface(random);
        Vec3 direction;
        switch (number % 4) {
        case 0:
            direction = corner(random) - origin;
            break;
        case 1:
            direction = normalize(corner(random) - origin);
            break;
        case 2:
            direction = edgePoint(random) - origin;
            break;
        default:
            direction = edgePointAtPlane(random) - origin;
            break;
        }
        return {origin, 0, direction, std::numeric_limits<float>::infinity()};
    }

  private:
    Vec3 corner(test::Random& random) const {
        return mesh_.surface.vertices[random.index(mesh_.surface.vertices.size())].position();
    }
    Vec3 pointInside(test::Random& random) const {
        const std::uint32_t vertex = random.index(mesh_.surface.vertices.size());
        const float depth = random.number(0.1F, 1);
        return mesh_.surface.vertices[vertex].position() * (1 - depth) +
               mesh_.inside.vertices[vertex].position() * depth;
    }
    /// Where a ray goes on after a hit: moved inwards by the offset that secondary rays get.
    Vec3 pointOnSurface(test::Random& random) const {
        const std::uint32_t triangle = random.index(view_.triangles.size());
        const float u = random.number(0.1F, 0.8F);
        const float v = random.number(0.1F, 0.9F - u);
        const Vec3 a = view_.position(triangle, 0);
        const Vec3 b = view_.position(triangle, 1);
        const Vec3 c = view_.position(triangle, 2);
        const Vec3 p = a * (1 - u - v) + b * u + c * v;
        const Vec3 normal = normalize(view_.geometricNormal(triangle));
        const Vec3 inwards = mesh_.inside.vertices[view_.triangles[triangle].v[0]].position() - p;
        const float step = rtcore::surfaceClearance(a, b, c, normal);
        return p + normal * (dot(normal, inwards) > 0 ? step : -step);
    }
    std::array<Vec3, 2> edge(test::Random& random) const {
        const std::uint32_t triangle = random.index(view_.triangles.size());
        const int first = static_cast<int>(random.index(3));
        return {view_.position(triangle, first), view_.position(triangle, (first + 1) % 3)};
    }
    Vec3 edgePoint(test::Random& random) const {
        const auto [a, b] = edge(random);
        return a + (b - a) * random.number(0, 1);
    }
    /// Splits are at coordinates of vertices: the point of an edge that has one of those.
    Vec3 edgePointAtPlane(test::Random& random) const {
        const auto [a, b] = edge(random);
        const int axis = static_cast<int>(random.index(3));
        const auto& sorted = coordinates_[static_cast<std::size_t>(axis)];
        const auto from = std::lower_bound(sorted.begin(), sorted.end(), std::min(a[axis], b[axis]));
        const auto to = std::upper_bound(sorted.begin(), sorted.end(), std::max(a[axis], b[axis]));
        const float plane = from[random.index(static_cast<std::size_t>(to - from))];
        const float length = b[axis] - a[axis];
        Vec3 p = length != 0 ? a + (b - a) * ((plane - a[axis]) / length) : a;
        p[axis] = plane;
        return p;
    }

    const ClosedMesh& mesh_;
    rtcore::Mesh view_;
    std::array<std::vector<float>, 3> coordinates_;
};

void describe(const Ray& ray, bool closest) {
    std::printf("leak (%s hit): origin %a %a %a direction %a %a %a\n", closest ? "closest" : "any",
                double{ray.origin.x}, double{ray.origin.y}, double{ray.origin.z}, double{ray.direction.x},
                double{ray.direction.y}, double{ray.direction.z});
}

/// Closest and any hit by turns. The rays do not depend on the number of threads.
std::uint64_t countLeaks(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, const Aim& aim,
                         std::uint64_t rays, std::uint64_t seed) {
    constexpr std::uint64_t kChunk = 4096;
    std::uint64_t leaks = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : leaks)
    for (std::uint64_t first = 0; first < rays; first += kChunk) {
        test::Random random(seed + first);
        for (std::uint64_t i = first; i < std::min(rays, first + kChunk); ++i) {
            const Ray ray = aim.ray(i, random);
            const bool closest = i / 8 % 2 == 0;
            rtcore::Hit hit;
            const bool found = closest ? intersect(tree, mesh, ray, hit) : occluded(tree, mesh, ray);
            if (found) continue;
            if (++leaks <= 3) describe(ray, closest);
        }
    }
    return leaks;
}

std::string nameOfCase(const testing::TestParamInfo<std::tuple<Solid, float>>& testCase) {
    const auto [solid, offset] = testCase.param;
    const std::string name = solid == Solid::Box ? "box" : solid == Solid::Sphere ? "sphere" : "torus";
    return name + std::to_string(static_cast<int>(offset));
}

class Leaks : public testing::TestWithParam<std::tuple<Solid, float>> {};

} // namespace

TEST_P(Leaks, noneInTheExactNorInTheFastTree) {
    const auto [solid, offset] = GetParam();
    const ClosedMesh closed = makeSolid(solid, offset);
    const rtcore::Mesh mesh = closed.surface.view();
    const Aim aim(closed);
    for (const auto method : {rtcore::BuildMethod::Exact, rtcore::BuildMethod::Fast}) {
        rtcore::BuildOptions options;
        options.method = method;
        const rtcore::KdTree tree = buildKdTree(mesh, options);
        const std::uint64_t rays = rayCount() / 18 + 1;
        const auto start = std::chrono::steady_clock::now();
        const std::uint64_t leaks = countLeaks(tree, mesh, aim, rays, 7);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("%zu triangles, %s tree: %llu rays, %.2f million a second, %llu leaks\n",
                    mesh.triangles.size(), method == rtcore::BuildMethod::Exact ? "exact" : "fast",
                    static_cast<unsigned long long>(rays), static_cast<double>(rays) / seconds * 1e-6,
                    static_cast<unsigned long long>(leaks));
        EXPECT_EQ(leaks, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(ClosedMeshes, Leaks,
                         testing::Combine(testing::Values(Solid::Box, Solid::Sphere, Solid::Torus),
                                          testing::Values(0.0F, 1e2F, 1e4F)),
                         nameOfCase);
