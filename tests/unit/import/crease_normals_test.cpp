#include "rtcore/io/import/mesh/crease_normals.h"

#include "rtcore/simd/instruction_set.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace rtcore;

/// Triangles over shared vertices, every normal missing.
ModelBuffers bare(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
    ModelBuffers model;
    for (const Vec3 p : positions) model.vertices.push_back({p.x, p.y, p.z, 0});
    model.normals.resize(positions.size());
    model.triangles = triangles;
    for (const Triangle& t : triangles) model.shading.push_back({{t.v[0], t.v[1], t.v[2]}, 0});
    return model;
}

ModelBuffers cube() {
    std::vector<Vec3> p;
    p.reserve(8);
    for (int i = 0; i < 8; ++i)
        p.push_back({i & 1 ? 1.0F : -1.0F, i & 2 ? 1.0F : -1.0F, i & 4 ? 1.0F : -1.0F});
    std::vector<Triangle> t;
    for (const auto& q : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                          {4, 5, 7, 6},
                          {0, 1, 5, 4},
                          {2, 6, 7, 3},
                          {0, 4, 6, 2},
                          {1, 3, 7, 5}}) {
        t.push_back({{q[0], q[1], q[2]}});
        t.push_back({{q[0], q[2], q[3]}});
    }
    return bare(p, t);
}

ModelBuffers sphere(int rings) {
    const double pi = 3.14159265358979;
    std::vector<Vec3> p;
    std::vector<Triangle> t;
    const int around = 2 * rings;
    for (int i = 1; i < rings; ++i) {
        for (int j = 0; j < around; ++j) {
            const double a = pi * i / rings, b = 2 * pi * j / around;
            p.push_back({static_cast<float>(std::sin(a) * std::cos(b)), static_cast<float>(std::cos(a)),
                         static_cast<float>(std::sin(a) * std::sin(b))});
        }
    }
    for (int i = 0; i + 2 < rings; ++i) {
        for (int j = 0; j < around; ++j) {
            const auto at = [&](int r, int c) { return static_cast<std::uint32_t>(r * around + c % around); };
            t.push_back({{at(i, j), at(i, j + 1), at(i + 1, j + 1)}});
            t.push_back({{at(i, j), at(i + 1, j + 1), at(i + 1, j)}});
        }
    }
    return bare(p, t);
}

Vec3 facet(const ModelBuffers& m, std::size_t t) {
    const auto p = [&](int i) { return m.vertices[m.triangles[t].v[i]].position(); };
    return normalize(cross(p(1) - p(0), p(2) - p(0)));
}

TEST(CreaseNormals, HaveTheSameBitsWithEveryInstructionSet) {
    std::vector<Vec3> p;
    std::vector<Triangle> t;
    test::Random random(3);
    // Down to slivers whose area is lost in float and edges whose squares vanish; 19 triangles fill no
    // vector.
    for (std::uint32_t i = 0; i < 19; ++i) {
        const float size = std::pow(10.0F, -30.0F + 2 * static_cast<float>(i));
        const Vec3 from = random.vector(size), along = random.vector(size);
        p.insert(p.end(), {from, from + along, from + along * 0.5F + random.vector(size * 1e-7F)});
        t.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
    }
    std::vector<Vec3> expected;
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        ModelBuffers m = bare(p, t);
        computeMissingNormals(m, 40);
        if (expected.empty()) expected = m.normals;
        EXPECT_EQ(m.normals, expected) << name;
    }
    ASSERT_TRUE(useInstructionSet("auto"));
}

TEST(CreaseNormals, AnAngleOfZeroIsFlat) {
    ModelBuffers m = sphere(500); // neighbours are a third of a degree apart, those at the poles less
    computeMissingNormals(m, 0);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        for (const std::uint32_t i : m.shading[t].v)
            ASSERT_LT(length(m.normals[i] - facet(m, t)), 2e-4F) << "triangle " << t;
    }
}

TEST(CreaseNormals, ACubeStaysSharp) {
    ModelBuffers m = cube();
    computeMissingNormals(m, 40);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        for (const std::uint32_t i : m.shading[t].v) EXPECT_LT(length(m.normals[i] - facet(m, t)), 1e-6F);
    }
    EXPECT_EQ(m.normals.size(), 24U) << "three at every vertex, shared by the two triangles of a side";
}

TEST(CreaseNormals, ACubeIsRoundWhenAsked) {
    ModelBuffers m = cube();
    computeMissingNormals(m, 180);
    EXPECT_EQ(m.normals.size(), 8U);
    for (std::size_t v = 0; v < 8; ++v) {
        // Weighted by angle, not by triangle: along the diagonal however the sides are cut.
        EXPECT_LT(length(m.normals[v] - normalize(m.vertices[v].position())), 1e-3F);
    }
}

TEST(CreaseNormals, ASphereIsSmoothAndShares) {
    ModelBuffers m = sphere(32);
    const std::size_t vertices = m.vertices.size();
    computeMissingNormals(m, 40);
    EXPECT_EQ(m.normals.size(), vertices);
    const std::size_t around = 64;
    for (std::size_t v = around; v + around < vertices; ++v) { // the outermost rings are borders
        EXPECT_GT(dot(m.normals[v], m.vertices[v].position()), 0.998F);
        EXPECT_NEAR(length(m.normals[v]), 1, 1e-5F);
    }
}

TEST(CreaseNormals, TheAngleDecides) {
    // Two triangles that meet at 30 degrees.
    const float c = std::cos(0.5235988F), s = std::sin(0.5235988F);
    const auto roof = [&] {
        return bare({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {c, s, 0}}, {{{0, 2, 1}}, {{0, 1, 3}}});
    };
    ModelBuffers sharp = roof();
    computeMissingNormals(sharp, 29);
    EXPECT_EQ(sharp.normals.size(), 6U);
    EXPECT_LT(length(sharp.normals[sharp.shading[0].v[0]] - facet(sharp, 0)), 1e-6F);
    ModelBuffers smooth = roof();
    computeMissingNormals(smooth, 31);
    EXPECT_EQ(smooth.normals.size(), 4U);
    EXPECT_LT(length(smooth.normals[0] - normalize(facet(smooth, 0) + facet(smooth, 1))), 1e-5F);
}

TEST(CreaseNormals, NormalsOfTheFileStay) {
    ModelBuffers m = cube();
    const Vec3 mine = normalize({1, 2, 3});
    m.normals[0] = mine;
    computeMissingNormals(m, 180);
    EXPECT_EQ(m.normals[0], mine);
    EXPECT_LT(length(m.normals[7] - normalize({1, 1, 1})), 1e-3F);
}

TEST(CreaseNormals, AddedEntriesKeepTextureCoordinatesAndColours) {
    ModelBuffers m = cube();
    for (std::size_t i = 0; i < 8; ++i) {
        m.texcoords.push_back({static_cast<float>(i), 0});
        m.colours.push_back({static_cast<float>(i) / 8, 0, 0});
    }
    const auto before = m.triangles;
    computeMissingNormals(m, 40);
    ASSERT_EQ(m.texcoords.size(), m.normals.size());
    ASSERT_EQ(m.colours.size(), m.normals.size());
    for (std::size_t t = 0; t < before.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(m.texcoords[m.shading[t].v[i]].x, static_cast<float>(before[t].v[i]));
            EXPECT_EQ(m.colours[m.shading[t].v[i]].r, static_cast<float>(before[t].v[i]) / 8);
        }
    }
}

TEST(CreaseNormals, AConeOfAHundredThousandSidesTakesNoTime) {
    std::vector<Vec3> p{{0, 0, 5}};
    std::vector<Triangle> t;
    constexpr std::uint32_t n = 100000;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double a = 6.283185307 * i / n;
        p.push_back({static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)), 0});
        t.push_back({{0, i + 1, (i + 1) % n + 1}});
    }
    ModelBuffers m = bare(p, t);
    const auto start = std::chrono::steady_clock::now();
    computeMissingNormals(m, 10);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 2);
    for (std::uint32_t i = 0; i < n; i += 997) {
        EXPECT_GT(dot(m.normals[m.shading[i].v[0]], facet(m, i)), std::cos(20 * 3.1416F / 180)) << i;
    }
}

TEST(CreaseNormals, TinyTrianglesAndSliversHaveThemToo) {
    ModelBuffers m =
        bare({{0, 0, 0}, {1e-30F, 0, 0}, {0, 1e-30F, 0}, {5, 5, 5}, {6, 5, 5}, {5.5F, 5, 5.000001F}},
             {{{0, 1, 2}}, {{3, 4, 5}}});
    computeMissingNormals(m, 40);
    EXPECT_EQ(m.normals[0], (Vec3{0, 0, 1}));
    EXPECT_NEAR(std::fabs(m.normals[3].y), 1, 1e-3F);
}

} // namespace
