// Small files that stand for large models: what is expanded is counted before memory goes to it.
#include "rtcore/io/import/mesh/instance_graph.h"

#include "import_support.h"
#include "unit/import/gltf_builder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>

namespace {

using namespace rtcore;

/// A chain of nodes, each of which shows the next one ten times; a triangle is in the last.
constexpr int kFan = 10;

std::string gltfChain(int levels) {
    test::GltfBuilder file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const int mesh = file.mesh({{{"attributes", {{"POSITION", positions}}}}});
    for (int i = 0; i < levels; ++i)
        file.node({{"translation", {0, 0, i}}, {"children", std::vector<int>(kFan, i + 1)}});
    file.node({{"mesh", mesh}});
    file.root["scenes"] = {{{"nodes", {0}}}};
    return file.binary();
}

std::string repeated(const std::string& text) {
    std::string all;
    for (int i = 0; i < kFan; ++i) all += text;
    return all;
}

std::string oldGltfChain(int levels) {
    test::Json nodes = {{fmt::format("n{}", levels), {{"meshes", {"m"}}}}};
    for (int i = 0; i < levels; ++i)
        nodes[fmt::format("n{}", i)] = {
            {"children", std::vector<std::string>(kFan, fmt::format("n{}", i + 1))}};
    const test::Json root = {
        {"asset", {{"version", "1.0"}}},
        {"scene", "s"},
        {"scenes", {{"s", {{"nodes", {"n0"}}}}}},
        {"nodes", nodes},
        {"meshes", {{"m", {{"primitives", {{{"attributes", {{"POSITION", "a"}}}, {"mode", 4}}}}}}}},
        {"accessors",
         {{"a",
           {{"bufferView", "v"},
            {"byteOffset", 0},
            {"componentType", 5126},
            {"count", 3},
            {"type", "VEC3"}}}}},
        {"bufferViews", {{"v", {{"buffer", "b"}, {"byteOffset", 0}, {"byteLength", 36}}}}},
        {"buffers",
         {{"b",
           {{"byteLength", 36},
            {"type", "arraybuffer"},
            {"uri",
             "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}}}}};
    return root.dump();
}

std::string colladaChain(int levels) {
    std::string text =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
        R"(<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">)"
        R"(<float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#a" )"
        R"(count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" )"
        R"(type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" )"
        R"(source="#p"/></vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/>)"
        R"(<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_nodes>)";
    for (int i = 0; i < levels; ++i)
        text += fmt::format("<node id=\"n{}\"><translate>0 0 {}</translate>{}</node>", i, i,
                            repeated(fmt::format("<instance_node url=\"#n{}\"/>", i + 1)));
    return text +
           fmt::format(R"(<node id="n{}"><instance_geometry url="#g"/></node></library_nodes>)", levels) +
           R"(<library_visual_scenes><visual_scene id="s"><node><instance_node url="#n0"/></node></visual_scene>)"
           R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

std::string fbxChain(int levels) {
    std::string models, links = "C: \"OO\",10,0\n";
    for (int i = 0; i <= levels; ++i)
        models += fmt::format("Model: {}, \"Model::n{}\", \"{}\" {{\nVersion: 232\n}}\n", 10 + i, i,
                              i == levels ? "Mesh" : "Null");
    for (int i = 0; i < levels; ++i) links += repeated(fmt::format("C: \"OO\",{},{}\n", 11 + i, 10 + i));
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
           "Objects:  {\nGeometry: 1000, \"Geometry::t\", \"Mesh\" {\nVertices: *9 {\na: "
           "0,0,0,1,0,0,0,1,0\n}\n"
           "PolygonVertexIndex: *3 {\na: 0,1,-3\n}\nGeometryVersion: 124\n}\n" +
           models + "}\nConnections:  {\n" + links + fmt::format("C: \"OO\",1000,{}\n", 10 + levels) + "}\n";
}

struct ChainFormat {
    const char* name;
    std::string (*text)(int levels);
};

constexpr std::array kChains{ChainFormat{"a.glb", gltfChain}, ChainFormat{"a.gltf", oldGltfChain},
                             ChainFormat{"a.dae", colladaChain}, ChainFormat{"a.fbx", fbxChain}};

/// Far above what the importer takes without a model, also under sanitizers: more is refused by its own
/// count.
constexpr std::uint64_t kLimit = 400'000'000;

std::string refusalOfChain(const ChainFormat& format, int levels, std::uint64_t memoryLimit) {
    ImportOptions options;
    options.memoryLimit = memoryLimit;
    try {
        test::importText(format.name, format.text(levels), options);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(Instances, AFewAreAllThere) {
    for (const ChainFormat& format : kChains) {
        const ImportedModel m = test::importText(format.name, format.text(2));
        EXPECT_EQ(m.model.parts.size(), 100U) << format.name;
        // Triangles of the same corners count twice at most.
        EXPECT_GE(m.model.mesh.triangles.size(), 2U) << format.name;
    }
}

TEST(Instances, BillionsAreRefusedBeforeMemoryGoes) {
    using Clock = std::chrono::steady_clock;
    for (const ChainFormat& format : kChains) {
        const auto begin = Clock::now();
        const std::string why = refusalOfChain(format, 10, kLimit);
        EXPECT_NE(why.find("1111111111"), std::string::npos) << format.name << ": " << why;
        EXPECT_NE(why.find("export fewer instances"), std::string::npos) << format.name << ": " << why;
        EXPECT_LT(Clock::now() - begin, std::chrono::seconds(20)) << format.name;
    }
}

TEST(Instances, MoreThanMayBeUsedAreRefusedWithNumbersAndRemedy) {
    for (const ChainFormat& format : kChains) {
        const std::string why = refusalOfChain(format, 6, kLimit);
        EXPECT_NE(why.find("has 111111"), std::string::npos) << format.name << ": " << why;
        EXPECT_NE(why.find("the 400 MB that the importer may use; raise that (--memory-limit)"),
                  std::string::npos)
            << format.name << ": " << why;
    }
}

TEST(Instances, NodesThatHoldThemselvesAreRefused) {
    test::GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["children"] = {0};
    file.root["scenes"] = {{{"nodes", {0}}}};
    EXPECT_NE(refusalOf(file).find("no end"), std::string::npos);
    std::string collada = colladaChain(2);
    collada.replace(collada.find("url=\"#n1\""), 9, "url=\"#n0\"");
    EXPECT_THROW(test::importText("a.dae", collada), std::exception);
    try {
        test::importText("a.dae", collada);
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("no end"), std::string::npos) << error.what();
    }
}

TEST(InstanceGraph, CountsEachAsOftenAsItIsNamed) {
    InstanceGraph graph;
    const std::size_t top = graph.addNode({1, 0, 0});
    const std::size_t middle = graph.addNode({1, 4, 2});
    const std::size_t leaf = graph.addNode({2, 30, 10});
    for (int i = 0; i < 3; ++i) graph.addChild(top, middle);
    for (int i = 0; i < 5; ++i) graph.addChild(middle, leaf);
    graph.addChild(top, 99);
    const auto count = graph.count(std::array{top, leaf});
    ASSERT_TRUE(count);
    EXPECT_EQ(count->parts, 1U + 3 * (1 + 5 * 2) + 2);
    EXPECT_EQ(count->vertices, 3U * (4 + 5 * 30) + 30);
    EXPECT_EQ(count->triangles, 3U * (2 + 5 * 10) + 10);
}

TEST(InstanceGraph, LongChainsAndCountsBeyondAllNumbers) {
    InstanceGraph graph;
    constexpr std::size_t kNodes = 300'000;
    for (std::size_t i = 0; i < kNodes; ++i) {
        graph.addNode({1, 3, 1});
        graph.addChild(i, i + 1);
        graph.addChild(i, i + 1);
    }
    const auto count = graph.count(std::array{std::size_t{0}});
    ASSERT_TRUE(count);
    EXPECT_EQ(count->triangles, std::uint64_t{1} << 62U);
    EXPECT_EQ((ExpandedCount{3, 0, 0}.times(std::uint64_t{1} << 62U).parts), std::uint64_t{1} << 62U);
    EXPECT_EQ((ExpandedCount{3, 2, 1}.times(5).vertices), 10U);
}

TEST(InstanceGraph, CyclesHaveNoCount) {
    InstanceGraph graph;
    graph.addNode();
    graph.addNode();
    graph.addChild(0, 1);
    graph.addChild(1, 0);
    EXPECT_FALSE(graph.count(std::array{std::size_t{0}}));
}

} // namespace
