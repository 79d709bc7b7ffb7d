// Texts of files of which Assimp alone would lose something.
#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/assimp/dxf_text.h"
#include "rtcore/io/import/assimp/format_quirks.h"

#include "import_support.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <array>
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

} // namespace
