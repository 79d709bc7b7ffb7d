/// Modes, nodes, instances, poses: where triangles of a glTF file stand.
#include "unit/import/gltf_builder.h"

#include <array>
#include <cmath>

namespace {

using namespace rtcore;
using test::GltfBuilder;
using test::Json;
using test::meshOf;
using test::near;

/// Corners (x y 0) of a strip of two triangles.
FileImport drawn(int mode, const std::vector<std::uint32_t>& corners) {
    GltfBuilder file;
    const int positions =
        file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0}, "VEC3");
    Json primitive{{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
    if (!corners.empty()) primitive["indices"] = file.accessor(corners, "SCALAR");
    file.show(primitive);
    // A second mesh, so that a file of points alone is not refused.
    const int square = file.accessor(test::kSquare, "VEC3");
    file.show(
        {{"attributes", {{"POSITION", square}}}, {"indices", file.accessor(test::kSquareCorners, "SCALAR")}});
    return file.import();
}

TEST(GltfModes, MakeTriangles) {
    const FileImport strip = drawn(5, {0, 1, 2, 3});
    const Mesh mesh = meshOf(strip.model);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    for (std::uint32_t t = 0; t < 4; ++t) EXPECT_GT(mesh.geometricNormal(t).z, 0) << t;
    EXPECT_EQ(drawn(6, {0, 1, 3, 2}).model.triangles.size(), 4U);
    EXPECT_GT(meshOf(drawn(6, {0, 1, 3, 2}).model).geometricNormal(1).z, 0);
    EXPECT_EQ(drawn(4, {0, 1, 2, 1, 3, 2}).model.triangles.size(), 4U);
    EXPECT_EQ(drawn(4, {0, 1, 2, 1, 3}).model.triangles.size(), 3U) << "the rest makes none";
    EXPECT_EQ(drawn(4, {}).model.triangles.size(), 3U);
    EXPECT_EQ(drawn(5, {}).model.triangles.size(), 5U) << "a strip of five vertices";
}

TEST(GltfModes, PointsAndLinesAreCounted) {
    EXPECT_EQ(drawn(0, {}).report.ignoredPrimitives, 5U);
    EXPECT_EQ(drawn(1, {0, 1, 2, 3}).report.ignoredPrimitives, 2U);
    EXPECT_EQ(drawn(2, {0, 1, 2, 3}).report.ignoredPrimitives, 4U);
    EXPECT_EQ(drawn(3, {0, 1, 2, 3}).report.ignoredPrimitives, 3U);
    EXPECT_EQ(drawn(9, {0, 1, 2, 3}).model.triangles.size(), 2U);
}

TEST(GltfModes, CornersThatDoNotExistCostTheirTriangles) {
    const FileImport read = drawn(5, {0, 1, 2, 9, 3});
    EXPECT_EQ(read.report.unconnectedTriangles, 2U);
    EXPECT_EQ(read.model.triangles.size(), 3U);
}

TEST(GltfNodes, TurnScaleAndMove) {
    GltfBuilder file = test::squareFile();
    const float half = std::sqrt(0.5F);
    file.root["nodes"][0]["rotation"] = {0, 0, half, half}; // 90 degrees about z
    file.root["nodes"][0]["scale"] = {2, 3, 1};
    file.root["nodes"][0]["translation"] = {10, 0, 0};
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    EXPECT_TRUE(near(mesh.position(0, 1), {10, 2, 0})) << "(1 0 0)";
    EXPECT_TRUE(near(mesh.position(0, 2), {7, 2, 0})) << "(1 1 0)";
}

TEST(GltfNodes, RotationsOfOtherLengthsTurnOnly) {
    GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["rotation"] = {0, 0, 3, 3};
    EXPECT_TRUE(near(meshOf(file.import().model).position(0, 1), {0, 1, 0}));
}

TEST(GltfNodes, ThatMirrorTurnTheirTrianglesOver) {
    GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["scale"] = {-1, 1, 1};
    const FileImport read = file.import();
    EXPECT_GT(meshOf(read.model).geometricNormal(0).z, 0) << "the front stays the front";
    file.root["nodes"][0]["scale"] = {-1, -1, 1};
    EXPECT_GT(meshOf(file.import().model).geometricNormal(0).z, 0);
}

TEST(GltfNodes, InACircleAreRefused) {
    GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["children"] = {1};
    file.node({{"children", {0}}});
    file.root["scenes"] = {{{"nodes", {0}}}};
    EXPECT_NE(test::refusalOf(file).find("no end"), std::string::npos);
}

TEST(GltfNodes, OfAnyDepthAreWalked) {
    GltfBuilder file = test::squareFile();
    for (int i = 1; i <= 20'000; ++i) file.node({{"children", {i - 1}}, {"translation", {0.5, 0, 0}}});
    file.root["scenes"] = {{{"nodes", {20'000}}}};
    EXPECT_EQ(test::cornerInFile(file.import(), 0, 0), (Vec3{10'000, 0, 0}));
}

TEST(GltfNodes, ThatDoNotExistAreNotShown) {
    GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["children"] = {77, -1, "a"};
    file.root["scenes"] = {{{"nodes", {0, 99}}}};
    EXPECT_EQ(file.import().model.triangles.size(), 2U);
}

TEST(GltfNodes, ThatAreHiddenStayOut) {
    GltfBuilder file = test::squareFile();
    const int child = file.node({{"mesh", 0}});
    file.node({{"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}, {"children", {child}}});
    file.root["scenes"] = {{{"nodes", {0, 2}}}};
    file.root["extensionsUsed"] = {"KHR_node_visibility"};
    const FileImport read = file.import();
    EXPECT_EQ(read.model.triangles.size(), 2U);
    EXPECT_EQ(test::warningsOf(read), "");
}

TEST(GltfScenes, TheStatedOneIsShownElseTheFirstElseAll) {
    GltfBuilder file = test::squareFile();
    file.node({{"mesh", 0}, {"translation", {5, 0, 0}}});
    EXPECT_EQ(file.import().model.triangles.size(), 4U) << "no scenes";
    file.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {0, 1}}}};
    EXPECT_EQ(file.import().model.triangles.size(), 2U);
    file.root["scene"] = 1;
    EXPECT_EQ(file.import().model.triangles.size(), 4U);
    file.root.erase("scenes");
    file.root.erase("nodes");
    EXPECT_EQ(file.import().model.triangles.size(), 2U) << "a file of meshes alone";
}

TEST(GltfInstances, AreShownEach) {
    GltfBuilder file = test::squareFile();
    const int where = file.accessor(std::vector<float>{0, 0, 0, 3, 0, 0, 6, 0, 0}, "VEC3");
    const int turned =
        file.accessor(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 90, 90, 0, 0, 127, 0}, "VEC4", true);
    const int size = file.accessor(std::vector<float>{1, 1, 1, 2, 2, 2, -1, 1, 1}, "VEC3");
    file.root["nodes"][0]["name"] = "tree";
    file.root["nodes"][0]["extensions"] = {
        {"EXT_mesh_gpu_instancing",
         {{"attributes", {{"TRANSLATION", where}, {"ROTATION", turned}, {"SCALE", size}}}}}};
    file.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.node({{"name", "b"}});
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 6U);
    EXPECT_TRUE(near(mesh.position(2, 1), {3, 2, 0}, 0.01F)) << "twice as large, turned by 90 degrees";
    EXPECT_GT(mesh.geometricNormal(4).z, 0) << "mirrored and turned over";
    ASSERT_EQ(read.model.parts.size(), 3U);
    EXPECT_EQ(std::string(read.model.strings.data() + read.model.parts[1].nameOffset), "tree/2");
    EXPECT_EQ(test::warningsOf(read), "");
}

/// A bar from y = 0 to 2 of which the upper half follows the joint 1.
GltfBuilder barFile(float angle) {
    GltfBuilder file;
    const int positions =
        file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 2, 0, 1, 2, 0}, "VEC3");
    const int normals =
        file.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int joints = file.accessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
        "VEC4");
    std::vector<std::uint8_t> ones;
    for (int i = 0; i < 6; ++i) ones.insert(ones.end(), {255, 0, 0, 0});
    const int weights = file.accessor(ones, "VEC4", true);
    const int corners =
        file.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4}, "SCALAR");
    file.mesh(
        {{{"attributes",
           {{"POSITION", positions}, {"NORMAL", normals}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
          {"indices", corners}}});
    file.node({{"mesh", 0}, {"skin", 0}, {"scale", {100, 100, 100}}}); // which does not count
    file.node({{"children", {2}}});
    file.node({{"translation", {0, 1, 0}}, {"rotation", {std::sin(angle / 2), 0, 0, std::cos(angle / 2)}}});
    std::vector<float> bind{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                            1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
    file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor(bind, "MAT4")}}};
    file.root["scenes"] = {{{"nodes", {0, 1}}}};
    return file;
}

TEST(GltfSkins, FollowTheirJointsAndNotTheirNode) {
    const FileImport read = barFile(1.5707963F).import();
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    EXPECT_TRUE(near(mesh.position(0, 1), {1, 0, 0}));
    EXPECT_TRUE(near(mesh.position(3, 2), {0, 1, 1})) << "(0 2 0), turned about x at y = 1";
    EXPECT_TRUE(near(test::normalOf(mesh, 0, 0), {0, 0, 1}));
    EXPECT_TRUE(near(test::normalOf(mesh, 3, 2), {0, -1, 0}));
}

TEST(GltfSkins, OneMeshWithTwoOfThemIsTwoMeshes) {
    GltfBuilder file = barFile(0);
    file.node({{"mesh", 0}, {"skin", 1}});
    file.root["skins"].push_back({{"joints", {4, 4}}});
    file.node({{"translation", {7, 0, 0}}});
    file.root["scenes"] = {{{"nodes", {0, 1, 3, 4}}}};
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 8U);
    EXPECT_TRUE(near(mesh.position(0, 1), {1, 0, 0}));
    EXPECT_TRUE(near(mesh.position(4, 1), {8, 0, 0}));
}

TEST(GltfSkins, HoldWhereTheMeshAlsoStandsWithoutOne) {
    GltfBuilder file = barFile(1.5707963F);
    file.node({{"mesh", 0}});
    file.root["scenes"] = {{{"nodes", {3, 0, 1}}}};
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 8U);
    EXPECT_TRUE(near(mesh.position(3, 2), {0, 2, 0}));
    EXPECT_TRUE(near(mesh.position(7, 2), {0, 1, 1}));
}

TEST(GltfSkins, DamagedOnesDoNoHarm) {
    for (const char* const name : {"joints", "inverseBindMatrices"}) {
        for (const Json& value : {Json(), Json(99), Json::array({99, 98}), Json("x"), Json::array()}) {
            GltfBuilder file = barFile(1);
            file.root["skins"][0][name] = value;
            EXPECT_GE(file.import().model.triangles.size(), 2U) << name << value;
        }
    }
    GltfBuilder circle = barFile(1);
    circle.root["nodes"][2]["children"] = {1};
    EXPECT_NE(test::refusalOf(circle), "");
}

TEST(GltfMorphs, MoveByTheWeightsOfNodeOrMesh) {
    GltfBuilder file = test::squareFile();
    Json& primitive = file.root["meshes"][0]["primitives"][0];
    const int up = file.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int right = file.accessor(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
    EXPECT_EQ(meshOf(file.import().model).position(0, 0), (Vec3{0, 0, 0})) << "no weights";
    file.root["meshes"][0]["weights"] = {0.5, 0};
    EXPECT_EQ(meshOf(file.import().model).position(0, 0), (Vec3{0, 0, 0.5F}));
    file.root["nodes"][0]["weights"] = {1, 2};
    EXPECT_EQ(meshOf(file.import().model).position(0, 0), (Vec3{2, 0, 1}));
    file.node({{"mesh", 0}});
    const FileImport both = file.import();
    EXPECT_EQ(meshOf(both.model).position(2, 0), (Vec3{0, 0, 0.5F})) << "by the mesh's own weights";
}

TEST(GltfNormals, AreFlatWhereTheFileHasNone) {
    GltfBuilder file;
    const int positions = file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0.1F, 1, 1, 0, 0, 1, 0.1F}, "VEC3");
    file.show({{"attributes", {{"POSITION", positions}}},
               {"indices", file.accessor(test::kSquareCorners, "SCALAR")}});
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    for (std::uint32_t t = 0; t < 2; ++t)
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(near(test::normalOf(mesh, t, i), normalize(mesh.geometricNormal(t)), 1e-6F));
}

TEST(GltfTexcoords, AreTransformedAsTheImageSays) {
    GltfBuilder file = test::squareFile();
    Json& primitive = file.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_1"] = file.accessor(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, "VEC2");
    primitive["material"] = 0;
    file.root["images"] = {{{"uri", "no.png"}}};
    file.root["textures"] = {{{"source", 0}}};
    const auto seen = [&](const Json& transform) {
        file.root["materials"] = {
            {{"pbrMetallicRoughness",
              {{"baseColorTexture",
                {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}};
        const FileImport read = file.import();
        const Mesh mesh = meshOf(read.model);
        return std::array{mesh.texcoords[mesh.shading[0].v[0]], mesh.texcoords[mesh.shading[0].v[1]]};
    };
    const auto plain = seen({{"texCoord", 1}});
    EXPECT_EQ(plain[0], (Vec2{0, 1})) << "ours count v upwards";
    const auto scaled = seen({{"texCoord", 1}, {"scale", {2, 4}}, {"offset", {0.25, 0.5}}});
    EXPECT_EQ(scaled[0], (Vec2{0.25F, 0.5F}));
    EXPECT_EQ(scaled[1], (Vec2{2.25F, 0.5F}));
    // Counter-clockwise where v counts downwards.
    const auto turned = seen({{"texCoord", 1}, {"rotation", 1.57079633}});
    EXPECT_NEAR(turned[1].x, 0, 1e-6F);
    EXPECT_NEAR(turned[1].y, 2, 1e-6F);
}

} // namespace
