#include "rtcore/io/import/mesh/mesh_assembly.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace rtcore;

ModelBuffers assemble(const std::vector<SourceMesh>& meshes, MeshAssembler& assembler) {
    for (const SourceMesh& mesh : meshes) assembler.add(mesh);
    ModelBuffers model;
    assembler.weld();
    assembler.finish(model, 40);
    return model;
}

const std::vector<Triangle> kTwo{{{0, 1, 2}}, {{3, 4, 5}}};

TEST(MeshAssembly, WeldsEqualPositionsAndTheTwoZeros) {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -0.0F, 0}, {1, 1, 0}, {-0.0F, 1, -0.0F}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .triangles = kTwo}}, assembler);
    EXPECT_EQ(m.vertices.size(), 4U);
    EXPECT_EQ(m.triangles[1].v[0], m.triangles[0].v[1]);
    EXPECT_EQ(m.triangles[1].v[2], m.triangles[0].v[2]);
    EXPECT_EQ(m.normals.size(), 4U) << "and shares normals";
}

TEST(MeshAssembly, WeldsAcrossMeshesAndKeepsTheOrder) {
    const std::vector<Vec3> a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, b{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Triangle> one{{{0, 1, 2}}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = a, .triangles = one, .material = 3},
                                     {.positions = b, .triangles = one, .material = 1}},
                                    assembler);
    EXPECT_EQ(m.vertices.size(), 4U);
    ASSERT_EQ(m.shading.size(), 2U);
    EXPECT_EQ(m.shading[0].material, 3U);
    EXPECT_EQ(m.shading[1].material, 1U);
    EXPECT_EQ(m.vertices[m.triangles[1].v[0]].z, 5);
}

TEST(MeshAssembly, DropsAndCountsTrianglesWithoutArea) {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 2, 0}, {3, 0, 0}};
    const std::vector<Triangle> t{{{0, 1, 2}}, {{0, 0, 1}}, {{0, 1, 3}}, {{0, 2, 4}}, {{0, 1, 5}}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .triangles = t}}, assembler);
    EXPECT_EQ(m.triangles.size(), 1U);
    EXPECT_EQ(assembler.degenerateTriangles(), 4U);
}

TEST(MeshAssembly, KeepsTheThinnestSliver) {
    // One unit in the last place high.
    const std::vector<Vec3> p{{1, 1, 0}, {2, 1, 0}, {1.5F, std::nextafter(1.0F, 2.0F), 0}};
    const std::vector<Triangle> one{{{0, 1, 2}}};
    MeshAssembler assembler;
    EXPECT_EQ(assemble({{.positions = p, .triangles = one}}, assembler).triangles.size(), 1U);
}

TEST(MeshAssembly, DropsAndCountsBrokenCoordinates) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {inf, 0, 0}, {0, nan, 0}, {0, 0, 1e30F}};
    const std::vector<Triangle> t{{{0, 1, 2}}, {{0, 1, 3}}, {{0, 1, 4}}, {{0, 1, 5}}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .triangles = t}}, assembler);
    EXPECT_EQ(m.triangles.size(), 1U);
    EXPECT_EQ(m.vertices.size(), 3U);
    EXPECT_EQ(assembler.nonFiniteTriangles(), 3U);
}

TEST(MeshAssembly, NormalsOfTheFileAreMadeUnitAndBrokenOnesComputed) {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vec3> n{{0, 3, 4}, {0, 0, 0}, {std::nanf(""), 0, 1}};
    const std::vector<Triangle> one{{{0, 1, 2}}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .normals = n, .triangles = one}}, assembler);
    EXPECT_LT(length(m.normals[m.shading[0].v[0]] - Vec3{0, 0.6F, 0.8F}), 1e-6F);
    EXPECT_EQ(m.normals[m.shading[0].v[1]], (Vec3{0, 0, 1}));
    EXPECT_EQ(m.normals[m.shading[0].v[2]], (Vec3{0, 0, 1}));
}

TEST(MeshAssembly, AttributesPartEntriesButNotVertices) {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Vec2> uv{{0, 0}, {1, 0}, {0, 1}, {0.5F, 0}, {1, 1}, {0, 1}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .texcoords = uv, .triangles = kTwo}}, assembler);
    EXPECT_EQ(m.vertices.size(), 4U);
    EXPECT_EQ(m.texcoords.size(), 5U) << "only (1, 0, 0) has two";
    EXPECT_EQ(m.texcoords[m.shading[1].v[0]], (Vec2{0.5F, 0}));
}

TEST(MeshAssembly, MeshesWithoutAttributesGetDefaultsWhenOthersHaveThem) {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, q{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
    const std::vector<Vec2> uv{{1, 2}, {3, 4}, {5, 6}};
    const std::vector<Colour> colours{{0.5F, 0, 0}, {7, -1, 0}, {std::nanf(""), 0, 0}};
    const std::vector<Triangle> one{{{0, 1, 2}}};
    MeshAssembler assembler;
    const ModelBuffers m = assemble({{.positions = p, .triangles = one},
                                     {.positions = q, .texcoords = uv, .colours = colours, .triangles = one},
                                     {.positions = p, .triangles = one}},
                                    assembler);
    ASSERT_EQ(m.texcoords.size(), m.normals.size());
    ASSERT_EQ(m.colours.size(), m.normals.size());
    EXPECT_EQ(m.texcoords[m.shading[0].v[0]], (Vec2{}));
    EXPECT_EQ(m.colours[m.shading[2].v[0]], kWhite);
    EXPECT_EQ(m.texcoords[m.shading[1].v[2]], (Vec2{5, 6}));
    EXPECT_EQ(m.colours[m.shading[1].v[1]], (Colour{1, 0, 0})) << "albedos lie in 0..1";
    EXPECT_EQ(m.colours[m.shading[1].v[2]], kWhite);
}

} // namespace
