#include "rtcore/io/import/mesh/equal_triangles.h"

#include "import_support.h"

#include "rtcore/scene/closed_surfaces.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;

/// Triangles of five vertices, each with its own shading entries; of materials 0 and 1.
ModelBuffers modelOf(const std::vector<Triangle>& triangles,
                     const std::vector<std::uint32_t>& materials = {}) {
    ModelBuffers b;
    for (int i = 0; i < 5; ++i)
        b.vertices.push_back({static_cast<float>(i), static_cast<float>(i * i), 0, 0});
    b.triangles = triangles;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        b.shading.push_back({{3 * t, 3 * t + 1, 3 * t + 2}, t < materials.size() ? materials[t] : 0});
        for (int i = 0; i < 3; ++i) b.normals.push_back({0, 0, 1});
    }
    b.materials.resize(2);
    return b;
}

std::vector<std::uint32_t> keptOf(const ModelBuffers& b) {
    std::vector<std::uint32_t> kept;
    for (const ShadingTriangle& s : b.shading) kept.push_back(s.v[0] / 3);
    return kept;
}

using Kept = std::vector<std::uint32_t>;
constexpr Triangle kAbc{{0, 1, 2}}, kBca{{1, 2, 0}}, kAcb{{0, 2, 1}}, kAbd{{0, 1, 3}};

TEST(EqualTriangles, TwoStayAndTheFirstIsAmongThem) {
    ModelBuffers b = modelOf({kAbd, kAbc, kAbc, kAbd, kAbc, kAbc});
    EXPECT_EQ(removeEqualTriangles(b), 2U);
    EXPECT_EQ(keptOf(b), (Kept{0, 1, 2, 3}));
    EXPECT_EQ(b.triangles, (std::vector{kAbd, kAbc, kAbc, kAbd}));
}

TEST(EqualTriangles, OtherOrdersOfCornersStay) {
    ModelBuffers b = modelOf({kAbc, kAcb, kBca, kAbc, kAcb, kBca});
    EXPECT_EQ(removeEqualTriangles(b), 0U);
    EXPECT_EQ(b.triangles.size(), 6U);
}

TEST(EqualTriangles, OtherMaterialsStay) {
    ModelBuffers b = modelOf({kAbc, kAbc, kAbc, kAbc, kAbc}, {0, 1, 0, 1, 1});
    EXPECT_EQ(removeEqualTriangles(b), 1U);
    EXPECT_EQ(keptOf(b), (Kept{0, 1, 2, 3}));
}

TEST(EqualTriangles, OtherPartsStayAndTheirRangesFollow) {
    ModelBuffers b = modelOf(std::vector(10, kAbc));
    b.parts = {{0, 0, 3}, {0, 3, 0}, {0, 4, 5}};
    EXPECT_EQ(removeEqualTriangles(b), 4U);
    EXPECT_EQ(keptOf(b), (Kept{0, 1, 3, 4, 5, 9})) << "3 and 9 belong to no part";
    EXPECT_EQ(b.parts, (std::vector<ModelPart>{{0, 0, 2}, {0, 2, 0}, {0, 3, 2}}));
}

// A tetrahedron of glass, and the same with one side or all sides many times.
TEST(EqualTriangles, WhatIsClosedStaysSo) {
    const std::vector<Triangle> faces{{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
    for (const std::size_t repeated : {0U, 1U, 4U}) {
        for (const int times : {1, 2, 5}) {
            std::vector<Triangle> triangles = faces;
            for (int i = 1; i < times; ++i)
                triangles.insert(triangles.end(), faces.begin(),
                                 faces.begin() + static_cast<std::ptrdiff_t>(repeated));
            ModelBuffers b = modelOf(triangles);
            b.materials[0].opacity = 0.1F;
            const Model before = makeModel(b);
            const auto wasClosed = findClosedSurfaces(before.mesh, before.materials);
            removeEqualTriangles(b);
            const Kept kept = keptOf(b);
            const Model after = makeModel(std::move(b));
            const auto isClosed = findClosedSurfaces(after.mesh, after.materials);
            for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(isClosed->at(i), wasClosed->at(kept[i]));
        }
    }
}

TEST(EqualTriangles, TheImportCountsThemAndKeepsNormals) {
    std::string copies = test::kCubeObj;
    for (int i = 0; i < 1000; ++i) copies += "f 4 3 2\n";
    const ImportedModel m = test::importText("m.obj", copies);
    // The quad 4 3 2 1 is cut into 4 3 2 and 4 2 1, or into others.
    EXPECT_GE(m.report.equalTriangles, 998U);
    EXPECT_EQ(m.model.mesh.triangles.size() + m.report.equalTriangles, 1012U);
    ASSERT_EQ(m.report.warnings.size(), 1U);
    EXPECT_NE(m.report.warnings[0].english().find("the third or a further one of the same corners"),
              std::string::npos);
    ASSERT_EQ(m.model.parts.size(), 1U);
    EXPECT_EQ(m.model.parts[0].triangleCount, m.model.mesh.triangles.size());
}

} // namespace
