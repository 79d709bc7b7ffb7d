#include "gltf_text.h"
#include "import_support.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace rtcore;
using test::importText;
using test::near;

TEST(ImportGeometry, ACubeOfQuads) {
    const ImportedModel cube = importText("cube.obj", test::kCubeObj);
    const Mesh& mesh = cube.model.mesh;
    EXPECT_EQ(cube.report.origin.format, "Wavefront Object Importer");
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_EQ(mesh.vertices.size(), 8U);
    EXPECT_EQ(mesh.normals.size(), 24U);
    EXPECT_DOUBLE_EQ(test::areaOf(mesh), 24);
    EXPECT_NEAR(test::volumeOf(mesh), 8, 1e-5);
    EXPECT_EQ(cube.model.materials.size(), 1U);
    for (std::uint32_t t = 0; t < 12; ++t) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(near(test::normalOf(mesh, t, i), normalize(mesh.geometricNormal(t))));
        }
    }
}

TEST(ImportGeometry, TheCreaseAngleIsAnOption) {
    ImportOptions options;
    options.creaseAngle = 180;
    EXPECT_EQ(importText("cube.obj", test::kCubeObj, options).model.mesh.normals.size(), 8U);
}

TEST(ImportGeometry, ConcaveAndLargePolygons) {
    // An E of 12 corners (area 9 + 3 * 2), and a regular polygon of 1000.
    const ImportedModel e = importText(
        "e.obj", "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 3 2 0\nv 3 3 0\nv 1 3 0\nv 1 4 0\nv 3 4 0\n"
                 "v 3 5 0\nv 0 5 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
    EXPECT_EQ(e.model.mesh.triangles.size(), 10U);
    EXPECT_NEAR(test::areaOf(e.model.mesh), 11, 1e-5);
    for (std::uint32_t t = 0; t < 10; ++t) EXPECT_GT(e.model.mesh.geometricNormal(t).z, 0);

    std::ostringstream text;
    text.precision(9);
    std::string face = "f";
    for (int i = 0; i < 1000; ++i) {
        const double a = 6.283185307179586 * i / 1000;
        text << "v " << std::cos(a) << ' ' << std::sin(a) << " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const ImportedModel disc = importText("disc.obj", text.str() + face + "\n");
    EXPECT_EQ(disc.model.mesh.triangles.size(), 998U);
    EXPECT_NEAR(test::areaOf(disc.model.mesh), 500 * std::sin(6.283185307179586 / 1000), 1e-4);
}

TEST(ImportGeometry, PointsAndLinesAreCounted) {
    const ImportedModel m = importText("mixed.obj", std::string(test::kCubeObj) + "l 1 2\nl 2 3\np 4\n");
    EXPECT_EQ(m.model.mesh.triangles.size(), 12U);
    EXPECT_EQ(m.report.ignoredPrimitives, 3U);
}

TEST(ImportGeometry, DegenerateAndBrokenTrianglesAreCounted) {
    const ImportedModel m =
        importText("bad.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                              "property float y\nproperty float z\nelement face 4\n"
                              "property list uchar int vertex_indices\nend_header\n"
                              "0 0 0\n1 0 0\n0 1 0\n2 0 0\n1e30 0 0\n"
                              "3 0 1 2\n3 0 1 1\n3 0 1 3\n3 0 2 4\n");
    EXPECT_EQ(m.model.mesh.triangles.size(), 1U);
    EXPECT_EQ(m.report.degenerateTriangles, 2U);
    EXPECT_EQ(m.report.nonFiniteTriangles, 1U);
}

TEST(ImportGeometry, NormalsOfTheFileAreKept) {
    const ImportedModel m =
        importText("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nvn 0 0 1\nf 1//1 2//2 3//1\n");
    EXPECT_TRUE(near(test::normalOf(m.model.mesh, 0, 0), {0, 0.6F, 0.8F}));
    EXPECT_TRUE(near(test::normalOf(m.model.mesh, 0, 1), {0, 0, 1}));
}

TEST(ImportGeometry, StlHasNoVertexNormalsWhateverItsFacetsSay) {
    // Two facets at 10 degrees, stored with their flat normals: smooth under the crease angle.
    const ImportedModel m = importText(
        "roof.stl", "solid s\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 1 0 0\n"
                    "endloop\nendfacet\nfacet normal 0.17365 0.98481 0\nouter loop\nvertex 0 0 0\n"
                    "vertex -1 0.17633 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid s\n");
    ASSERT_EQ(m.model.mesh.triangles.size(), 2U);
    EXPECT_EQ(m.model.mesh.vertices.size(), 4U);
    EXPECT_EQ(m.model.mesh.normals.size(), 4U);
}

TEST(ImportGeometry, ColoursOfOneByteAreDecoded) {
    const ImportedModel m = importText(
        "c.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0 255 0 0\n1 0 0 128 128 128\n0 1 0 0 0 51\n3 0 1 2\n");
    const Mesh& mesh = m.model.mesh;
    ASSERT_EQ(mesh.colours.size(), mesh.normals.size());
    EXPECT_TRUE(near(mesh.colours[mesh.shading[0].v[0]], {1, 0, 0}));
    EXPECT_TRUE(near(mesh.colours[mesh.shading[0].v[1]], {0.215861F, 0.215861F, 0.215861F}));
    EXPECT_TRUE(near(mesh.colours[mesh.shading[0].v[2]], {0, 0, 0.033105F}));
}

TEST(ImportGeometry, ColoursOfObjAreDecodedAndOfGltfLinear) {
    const ImportedModel obj =
        importText("c.obj", "v 0 0 0 1 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 0 0 1\nf 1 2 3\n");
    const Mesh& a = obj.model.mesh;
    ASSERT_EQ(a.colours.size(), a.normals.size());
    EXPECT_NEAR(a.colours[a.shading[0].v[1]].g, 0.214041F, 1e-4F);
    test::GltfScene scene;
    scene.colours = true;
    const ImportedModel gltf = importText("c.gltf", scene.text());
    const Mesh& b = gltf.model.mesh;
    ASSERT_EQ(b.colours.size(), b.normals.size());
    EXPECT_TRUE(near(b.colours[b.shading[0].v[1]], {0.5F, 0.5F, 0.5F}));
}

TEST(ImportGeometry, TexcoordsHaveTheirOriginAtTheLowerLeft) {
    const ImportedModel obj =
        importText("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.125\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    const Mesh& a = obj.model.mesh;
    ASSERT_EQ(a.texcoords.size(), a.normals.size());
    EXPECT_EQ(a.texcoords[a.shading[0].v[0]], (Vec2{0.25F, 0.125F})) << "OBJ counts v upwards";
    const ImportedModel gltf = importText("t.gltf", test::GltfScene{}.text());
    const Mesh& b = gltf.model.mesh;
    ASSERT_EQ(b.texcoords.size(), b.normals.size());
    EXPECT_EQ(b.texcoords[b.shading[0].v[2]], (Vec2{0, 0})) << "glTF counts v downwards";
}

TEST(ImportGeometry, NodesMoveTurnAndRepeat) {
    test::GltfScene scene;
    // A chain: twice as large and at (10, 0, 0), turned by 90 degrees about z; and the same mesh again,
    // unmoved.
    scene.nodes = R"({"children":[1],"translation":[10,0,0],"scale":[2,2,2]},)"
                  R"({"mesh":0,"rotation":[0,0,0.70710678,0.70710678]},{"mesh":0})";
    scene.roots = "0,2";
    const ImportedModel m = importText("nodes.gltf", scene.text());
    const Mesh& mesh = m.model.mesh;
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_TRUE(near(mesh.position(0, 0), {10, 0, 0}));
    EXPECT_TRUE(near(mesh.position(0, 1), {10, 2, 0}));
    EXPECT_TRUE(near(mesh.position(0, 2), {8, 0, 0}));
    EXPECT_TRUE(near(mesh.position(1, 1), {1, 0, 0}));
    EXPECT_GT(mesh.geometricNormal(0).z, 0);
}

TEST(ImportGeometry, MirroredInstancesKeepTheirFront) {
    test::GltfScene scene;
    scene.nodes = R"({"mesh":0,"scale":[-1,1,1]},{"mesh":0,"scale":[1,1,-3]})";
    scene.roots = "0,1";
    const ImportedModel m = importText("mirror.gltf", scene.text());
    const Mesh& mesh = m.model.mesh;
    ASSERT_EQ(mesh.triangles.size(), 2U);
    // Mirrored along x, the front still faces +z; along z it faces -z.
    EXPECT_GT(mesh.geometricNormal(0).z, 0);
    EXPECT_LT(mesh.geometricNormal(1).z, 0);
    for (std::uint32_t t = 0; t < 2; ++t) {
        EXPECT_GT(dot(test::normalOf(mesh, t, 0), mesh.geometricNormal(t)), 0);
    }
}

TEST(ImportGeometry, NormalsFollowTheInverseTranspose) {
    const std::string dae =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 -1</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="n"><float_array id="na" count="3">0 0.70710678 0.70710678</float_array><technique_common>
<accessor source="#na" count="1" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><p>0 0 1 0 2 0</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="a"><scale>1 4 1</scale>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    const ImportedModel m = importText("n.dae", dae);
    const Mesh& mesh = m.model.mesh;
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_TRUE(near(test::normalOf(mesh, 0, 0), normalize({0, 1, 4})));
    EXPECT_TRUE(near(test::normalOf(mesh, 0, 0), normalize(mesh.geometricNormal(0))));
}

TEST(ImportGeometry, TheOrderOfTheFileIsKept) {
    std::ostringstream text;
    for (int i = 0; i < 50; ++i) {
        text << "v " << i << " 0 0\nv " << i << ".5 0 0\nv " << i << " 1 0\nf -3 -2 -1\n";
    }
    const ImportedModel m = importText("row.obj", text.str());
    ASSERT_EQ(m.model.mesh.triangles.size(), 50U);
    for (std::uint32_t t = 0; t < 50; ++t) EXPECT_EQ(m.model.mesh.position(t, 0).x, static_cast<float>(t));
}

} // namespace
