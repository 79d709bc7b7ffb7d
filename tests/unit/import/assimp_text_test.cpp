// Texts of files of which Assimp alone would lose something.
#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/assimp/dxf_text.h"
#include "rtcore/io/import/assimp/format_quirks.h"

#include "import_support.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace {

using namespace rtcore;
using test::TemporaryFolder;
using test::writeText;

FileImport assimpImport(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    writeText(folder / name, text);
    return importWithAssimp(folder / name, {});
}

std::string dxfVertex(const std::string& flags, const std::string& numbers) {
    return "  0\nVERTEX\n  8\n0\n 70\n" + flags + "\n" + numbers;
}

std::string dxfFace(const std::array<int, 4>& corners) {
    std::string numbers = " 10\n0.0\n 20\n0.0\n 30\n0.0\n";
    for (int i = 0; i < 4; ++i)
        if (corners[i] != 0)
            numbers += " " + std::to_string(71 + i) + "\n   " + std::to_string(corners[i]) + "\n";
    return dxfVertex("   128", numbers);
}

/// A polyface mesh of four corners, the first of them at x = -1.
std::string dxfMesh(const std::array<int, 4>& first, const std::array<int, 4>& second) {
    std::string text =
        "  0\nSECTION\n  2\nENTITIES\n  0\nPOLYLINE\n  8\n0\n 66\n1\n 70\n64\n 71\n4\n 72\n2\n";
    for (const char* const corner : {" 10\n-1\n 20\n0\n 30\n0\n", " 10\n1\n 20\n0\n 30\n0\n",
                                     " 10\n1\n 20\n1\n 30\n0\n", " 10\n-1\n 20\n1\n 30\n0\n"})
        text += dxfVertex("192", corner);
    return text + dxfFace(first) + dxfFace(second) + "  0\nSEQEND\n  8\n0\n  0\nENDSEC\n  0\nEOF\n";
}

TEST(DxfText, InvisibleEdgesAreEdges) {
    const FileImport visible = assimpImport("m.dxf", dxfMesh({1, 2, 3, 0}, {1, 3, 4, 0}));
    ASSERT_EQ(visible.model.triangles.size(), 2U);
    const FileImport invisible = assimpImport("m.DXF", dxfMesh({1, 2, -3, 0}, {-1, 3, -4, 0}));
    EXPECT_EQ(invisible.model.triangles, visible.model.triangles);
    ASSERT_EQ(invisible.model.vertices.size(), visible.model.vertices.size());
    EXPECT_EQ(invisible.model.vertices[0].position().x, -1) << "a position is none";
    EXPECT_EQ(assimpImport("m.dxf", dxfMesh({-1, -2, -3, -4}, {1, 3, 4, 0})).model.triangles.size(), 3U);
}

TEST(DxfText, OthersStay) {
    const TemporaryFolder folder;
    writeText(folder / "m.dxf", dxfMesh({1, 2, 3, 0}, {1, 3, 4, 0}));
    EXPECT_EQ(dxfForAssimp(folder / "m.dxf"), std::nullopt);
    writeText(folder / "m.txt", dxfMesh({1, 2, -3, 0}, {1, 3, 4, 0}));
    EXPECT_EQ(dxfForAssimp(folder / "m.txt"), std::nullopt);
    writeText(folder / "m.dxf", "  0\nVERTEX\n 70\n128\n 71\n-");
    EXPECT_EQ(dxfForAssimp(folder / "m.dxf"), "  0\nVERTEX\n 70\n128\n 71\n") << "cut off";
}

std::string daeOf(const std::string& colour) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse>)" +
           colour + R"(</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(ColladaText, ColoursMayStandBehindBlanks) {
    for (const char* const colour : {"<color>0.25 0.5 0.75 1</color>", "<color>  0.25 0.5 0.75 1 </color>",
                                     "<color sid=\"diffuse\">\n\t0.25\n0.5 0.75 1\n</color>",
                                     "<color sid='a > b'>  0.25 0.5 0.75 1</color>"}) {
        const FileImport import = assimpImport("m.dae", daeOf(colour));
        ASSERT_EQ(import.model.materials.size(), 1U) << colour;
        EXPECT_TRUE(test::near(import.model.materials[0].diffuse, {0.25F, 0.5F, 0.75F})) << colour;
    }
}

TEST(ColladaText, NumbersOfJointsMayStandBehindBlanks) {
    const auto skinned = [](const std::string& blanks) {
        std::string text = daeOf("<color>1 1 1 1</color>");
        const auto insert = [&](const std::string& before, const std::string& piece) {
            text.insert(text.find(before), piece);
        };
        insert("<library_visual_scenes>",
               R"(<library_controllers><controller id="c"><skin source="#g">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="j"><Name_array id="ja" count="1">bone</Name_array><technique_common><accessor source="#ja" count="1" stride="1">
<param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="w"><float_array id="wa" count="1">1</float_array><technique_common><accessor source="#wa" count="1" stride="1">
<param name="WEIGHT" type="float"/></accessor></technique_common></source>
<source id="b"><float_array id="ba" count="16">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</float_array><technique_common>
<accessor source="#ba" count="1" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#b"/></joints>
<vertex_weights count="3"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/>
<vcount>)" + blanks +
                   "1 1 1</vcount><v>" + blanks +
                   "0 0 0 0 0 0</v></vertex_weights></skin></controller></library_controllers>\n");
        insert("<node><instance_geometry",
               R"(<node id="n" sid="bone" name="bone" type="JOINT"><translate>5 0 0</translate></node>)");
        text.replace(text.find("<instance_geometry url=\"#g\">"), 28,
                     "<instance_controller url=\"#c\"><skeleton>#n</skeleton>");
        text.replace(text.find("</instance_geometry>"), 20, "</instance_controller>");
        return assimpImport("m.dae", text);
    };
    for (const char* const blanks : {"", " ", "\n\t"}) {
        const FileImport import = skinned(blanks);
        ASSERT_EQ(import.model.vertices.size(), 3U);
        for (const Vertex& v : import.model.vertices) EXPECT_GE(v.position().x, 5) << "moved by its joint";
    }
}

std::string acOf(const std::string& texture, const std::string& subdivision) {
    return "AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\nOBJECT world\n"
           "kids 1\nOBJECT poly\nname \"quad\"\n" +
           subdivision + texture +
           "numvert 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nnumsurf 1\nSURF 0x20\nmat 0\nrefs 4\n"
           "0 0 0\n1 1 0\n2 1 1\n3 0 1\nkids 0\n";
}

TEST(Ac3dText, TexturedSurfacesAreNotSubdivided) {
    const auto triangles = [](const std::string& texture, const std::string& subdivision) {
        return assimpImport("m.ac", acOf(texture, subdivision)).model.triangles.size();
    };
    const std::string texture = "texture \"t.png\"\n", twice = "subdiv 2\n";
    EXPECT_EQ(triangles("", ""), 2U);
    EXPECT_EQ(triangles("", twice), 32U);
    EXPECT_EQ(triangles(texture, twice), 2U);
    EXPECT_EQ(triangles(texture, "subdiv 0\n"), 2U);
    const auto told = [&](const std::string& subdivision) {
        bool found = false;
        for (const Sentence& warning : assimpImport("m.ac", acOf(texture, subdivision)).report.warnings)
            found = found || warning.english().find("not subdivided") != std::string::npos;
        return found;
    };
    EXPECT_TRUE(told(twice));
    EXPECT_FALSE(told("subdiv 0\n"));
}

TEST(FormatQuirks, VertexColoursOfBlenderFilesAreIgnored) {
    EXPECT_TRUE(quirksOf("Blender 3D Importer (http://www.blender3d.org)").ignoredColours);
    EXPECT_FALSE(quirksOf("Collada Importer").ignoredColours);
}

/// Big-endian.
std::string lwoNumber(std::uint32_t number, unsigned bytes) {
    std::string text;
    for (unsigned i = bytes; i-- > 0;) text += static_cast<char>(number >> (8 * i));
    return text;
}
std::string lwoFloats(std::initializer_list<float> numbers) {
    std::string text;
    for (const float number : numbers) text += lwoNumber(std::bit_cast<std::uint32_t>(number), 4);
    return text;
}
std::string lwoChunk(const std::string& name, const std::string& content, unsigned sizeBytes = 4) {
    return name + lwoNumber(static_cast<std::uint32_t>(content.size()), sizeBytes) + content;
}

/// A triangle of red corners, whose surface has these further chunks.
std::string lwoTriangle(const std::string& surface) {
    using namespace std::string_literals;
    std::string colours = "RGB "s + lwoNumber(3, 2) + "c\0"s;
    for (std::uint32_t corner = 0; corner < 3; ++corner)
        colours += lwoNumber(corner, 2) + lwoFloats({1, 0, 0});
    const std::string chunks =
        lwoChunk("TAGS", "s\0"s) + lwoChunk("LAYR", std::string(18, '\0')) +
        lwoChunk("PNTS", lwoFloats({0, 0, 0, 1, 0, 0, 0, 1, 0})) + lwoChunk("VMAP", colours) +
        lwoChunk("POLS", "FACE" + lwoNumber(3, 2) + lwoNumber(0, 2) + lwoNumber(1, 2) + lwoNumber(2, 2)) +
        lwoChunk("PTAG", "SURF" + lwoNumber(0, 4)) + lwoChunk("SURF", "s\0\0\0"s + surface);
    return "FORM" + lwoNumber(static_cast<std::uint32_t>(chunks.size() + 4), 4) + "LWO2" + chunks;
}

TEST(LightWave, ColoursOfVerticesAreSeenWhetherASurfaceNamesThemOrNot) {
    using namespace std::string_literals;
    const std::string named = lwoChunk("VCOL", lwoFloats({1}) + lwoNumber(0, 2) + "RGB c\0"s, 2);
    for (const std::string& surface : {named, ""s}) {
        const FileImport import = assimpImport("m.lwo", lwoTriangle(surface));
        ASSERT_EQ(import.model.colours.size(), import.model.normals.size());
        for (const Colour& colour : import.model.colours) EXPECT_EQ(colour, (Colour{1, 0, 0}));
        EXPECT_TRUE(import.report.warnings.empty());
    }
}

} // namespace
