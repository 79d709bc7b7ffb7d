// Scans: the same model as Assimp makes, by readers that do not trust their files.
#include "rtcore/io/import/scan/scan_import.h"

#include "import_support.h"
#include "scan_files.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/scan/ply_file.h"
#include "rtcore/io/import/scan/stl_file.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace rtcore;
using test::PlyFile;
using test::TemporaryFolder;

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSame(const FileImport& a, const FileImport& b, const std::string& what) {
    EXPECT_TRUE(sameBytes(a.model.vertices, b.model.vertices)) << what;
    EXPECT_TRUE(sameBytes(a.model.triangles, b.model.triangles)) << what;
    EXPECT_TRUE(sameBytes(a.model.shading, b.model.shading)) << what;
    EXPECT_TRUE(sameBytes(a.model.normals, b.model.normals)) << what;
    EXPECT_TRUE(sameBytes(a.model.texcoords, b.model.texcoords)) << what;
    EXPECT_TRUE(sameBytes(a.model.colours, b.model.colours)) << what;
    EXPECT_TRUE(sameBytes(a.model.materials, b.model.materials)) << what;
    EXPECT_TRUE(sameBytes(a.model.parts, b.model.parts)) << what;
    EXPECT_EQ(a.model.strings, b.model.strings) << what;
    EXPECT_EQ(a.report, b.report) << what;
    EXPECT_FALSE(a.model.triangles.empty()) << what;
}

void expectSameAsAssimp(const std::filesystem::path& path, const std::string& what) {
    const std::optional<FileImport> scan = importScan(path, {});
    ASSERT_TRUE(scan) << what;
    expectSame(*scan, importWithAssimp(path, {}), what);
}

void expectSameAsAssimp(const std::string& name, const std::string& text, const std::string& what) {
    const TemporaryFolder folder;
    test::writeText(folder / name, text);
    expectSameAsAssimp(folder / name, what);
}

/// A tetrahedron.
PlyFile smallPly() {
    return {.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}},
            .faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(ScanImport, IsGreyWithoutColoursAndWhiteBelowThem) {
    const auto diffuseOf = [](const std::string& name, const std::string& text) {
        return test::importText(name, text).model.materials[0].diffuse;
    };
    PlyFile file = smallPly();
    EXPECT_EQ(diffuseOf("a.ply", file.text()), Colour(0.6F, 0.6F, 0.6F));
    for (const char* name : {"red", "green", "blue"})
        file.attributes.push_back({"uchar", name, {0, 1, 3, 100, 27}});
    EXPECT_EQ(diffuseOf("a.ply", file.text()), kWhite);
    EXPECT_EQ(diffuseOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                 "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"),
              Colour(0.6F, 0.6F, 0.6F));
}

TEST(ScanImport, PlyOfEveryTypeAndByteOrder) {
    const std::vector<std::string> integers{"char", "uchar", "short", "ushort",
                                            "int",  "uint",  "uint8", "int32"};
    std::vector<std::string> all = integers;
    all.insert(all.end(), {"float", "double", "float32", "float64"});
    for (const bool bigEndian : {false, true}) {
        for (const std::string& type : all) {
            PlyFile file = smallPly();
            file.bigEndian = bigEndian;
            file.positionType = type;
            for (const char* name : {"nx", "ny", "nz", "red", "green", "blue", "alpha", "s", "t"})
                file.attributes.push_back({type, name, {0, 1, 3, 100, 27}});
            expectSameAsAssimp("a.ply", file.text(), "positions " + type);
        }
        for (const std::string& index : integers) {
            for (const std::string& length : integers) {
                PlyFile file = smallPly();
                file.bigEndian = bigEndian;
                file.indexType = index;
                file.lengthType = length;
                file.indexName = length == "char" ? "vertex_index" : "vertex_indices";
                expectSameAsAssimp("a.ply", file.text(), "indices " + length + " " + index);
            }
        }
    }
}

TEST(ScanImport, PlyOfEverySelectionOfAttributes) {
    const std::vector<std::vector<const char*>> kinds{{},
                                                      {"nx", "ny", "nz"},
                                                      {"red", "green", "blue"},
                                                      {"u", "v"},
                                                      {"r", "g", "b"},
                                                      {"alpha"},
                                                      {"nx"},
                                                      {"texture_u", "texture_v", "nx", "ny", "nz"},
                                                      {"green"},
                                                      {"red", "r"},
                                                      {"tx", "ty"}};
    for (const auto& names : kinds) {
        for (const char* type : {"uchar", "float"}) {
            PlyFile file = smallPly();
            for (const char* name : names)
                file.attributes.push_back(
                    {type, name, {0.25 + static_cast<double>(file.attributes.size()), 200, 0, 13}});
            expectSameAsAssimp("a.ply", file.text(), names.empty() ? "none" : names[0]);
        }
    }
}

TEST(ScanImport, WhatIsNotNeededIsPassedOver) {
    for (const char* type : {"uchar", "double"}) {
        PlyFile file = smallPly();
        file.before = file.between = file.behind = file.otherElement = type;
        file.headLines = "comment one\ncomment another one\nobj_info a scanner\n";
        expectSameAsAssimp("a.ply", file.text(), type);
        expectSameAsAssimp("a.ply", file.text() + "bytes behind the end", type);
    }
}

TEST(ScanImport, ElementsOfUnknownNamesArePassedOver) {
    // Assimp 5.2 takes their bytes for vertices.
    PlyFile file = smallPly();
    const TemporaryFolder folder;
    test::writeText(folder / "a.ply", file.text());
    const std::optional<FileImport> without = importScan(folder / "a.ply", {});
    file.otherElement = "double";
    file.otherName = "camera";
    test::writeText(folder / "a.ply", file.text());
    const std::optional<FileImport> with = importScan(folder / "a.ply", {});
    ASSERT_TRUE(with && without);
    expectSame(*with, *without, "camera");
}

TEST(ScanImport, PolygonsAndWhatIsNone) {
    PlyFile file = smallPly();
    // An arrow, whose fifth corner is concave, in the plane z = 9.
    for (const auto& p : {std::array<double, 2>{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})
        file.positions.push_back({p[0], p[1], 9});
    file.faces.insert(file.faces.begin() + 1, {{4, 5, 6, 7, 8}, {}, {0}, {1, 2}, {0, 1, 2, 3}});
    expectSameAsAssimp("a.ply", file.text(), "polygons");
}

TEST(ScanImport, DamagedAndEqualTriangles) {
    PlyFile file = smallPly();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    file.positions.insert(file.positions.end(),
                          {{nan, 0, 0}, {1e20, 0, 0}, {-0.0, 0, 0}, {1e-35, 0, 0}, {2, 0, -0.0}, {4, 0, 0}});
    file.faces.insert(file.faces.end(), {{0, 1, 4}, {0, 1, 5}, {6, 8, 2}, {7, 2, 1}, {0, 1, 9}, {3, 3, 2}});
    for (int i = 0; i < 5; ++i) file.faces.push_back({0, 2, 1});
    expectSameAsAssimp("a.ply", file.text(), "damaged");
}

/// A grid of many thousands of cells, with vertices of its own for every fourth triangle, in a random order:
/// more than one piece of the file, and work for several threads.
PlyFile largePly(std::uint32_t seed) {
    constexpr int kSide = 150;
    PlyFile file;
    std::mt19937 random(seed);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x)
            file.positions.push_back({0.1 * x, 0.1 * y, 0.001 * static_cast<double>(random() % 100)});
    }
    for (int y = 0; y + 1 < kSide; ++y) {
        for (int x = 0; x + 1 < kSide; ++x) {
            const double a = y * kSide + x;
            file.faces.push_back({a, a + 1, a + kSide + 1});
            file.faces.push_back({a, a + kSide + 1, a + kSide});
        }
    }
    for (std::size_t f = 0; f < file.faces.size(); f += 4) {
        for (double& v : file.faces[f]) {
            file.positions.push_back(file.positions[static_cast<std::size_t>(v)]);
            v = static_cast<double>(file.positions.size() - 1);
        }
    }
    std::shuffle(file.faces.begin(), file.faces.end(), random);
    return file;
}

TEST(ScanImport, LargeMeshes) {
    PlyFile file = largePly(1);
    expectSameAsAssimp("a.ply", file.text(), "plain");
    file.attributes.push_back({"uchar", "red", {0, 255}});
    expectSameAsAssimp("a.ply", file.text(), "coloured");
    std::vector<std::array<Vec3, 3>> triangles;
    for (const auto& face : file.faces) {
        triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& p = file.positions[static_cast<std::size_t>(face[i])];
            triangles.back()[i] = {static_cast<float>(p[0]), static_cast<float>(p[1]),
                                   static_cast<float>(p[2])};
        }
    }
    expectSameAsAssimp("a.stl", test::stlText(triangles), "stl");
    expectSameAsAssimp("a.STL", test::stlText(triangles, "solid, but binary", 0x7FFF), "stl");
}

TEST(ScanImport, RealScans) {
    const char* const folder = std::getenv("RT_TEST_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    for (const char* name : {"dragon/dragon.ply", "sibenik/sibenik.ply", "spot/spot_bin.ply",
                             "spot/spot_bin.stl", "spot/spot.stl"})
        expectSameAsAssimp(std::filesystem::path(folder) / name, name);
}

bool isRead(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    test::writeText(folder / name, text);
    return importScan(folder / name, {}).has_value();
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(ScanImport, WhatIsNoScanIsLeftToAssimp) {
    const std::string text = smallPly().text();
    EXPECT_TRUE(isRead("a.ply", text));
    EXPECT_TRUE(isRead("a.txt", text)) << "the content counts";
    const std::vector<std::array<const char*, 2>> changes{
        {"made by a test", "TextureFile a.png"},
        {"uchar int", "float int"},
        {"uchar int", "uchar float"},
        {"vertex_indices", "corners"},
        {"property float z", "property float w"},
        {"property float z", "property half z"},
        {"ply\n", "ply\r\n"},
        {"element vertex 4", "element vertex four"},
        {"float x", "list uchar float x"},
        {"element face", "element material 0\nproperty float opacity\nelement face"},
        {"end_header", "property list uchar float texcoord\nend_header"},
        {"element face", "element vertex 0\nelement face"}};
    for (const auto& change : changes)
        EXPECT_FALSE(isRead("a.ply", changed(text, change[0], change[1]))) << change[1];
    const std::string lines =
        changed(text.substr(0, text.find("end_header") + 11), "binary_little_endian", "ascii") +
        "0 0 0\n1 0 0\n1 1 0\n\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3";
    EXPECT_TRUE(isRead("a.ply", lines)) << "a whole file of text";
    const std::string stl = test::stlText({{Vec3{}, {1, 0, 0}, {0, 1, 0}}});
    EXPECT_TRUE(isRead("a.stl", stl));
    EXPECT_FALSE(isRead("a.raw", stl)) << "nothing in it says what it is";
    EXPECT_FALSE(isRead("a.stl", stl + "x"));
    EXPECT_FALSE(isRead("a.stl", stl.substr(0, stl.size() - 1)));
    EXPECT_FALSE(isRead("a.stl", ""));
}

constexpr const char* kTwoSolids =
    "solid one two\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 .5\n"
    "  endloop\n endfacet\nendsolid one two\nsolid\nendsolid\nsolid b\nfacet normal 1 0 0\nouter loop\n"
    "vertex 0 0 5\nvertex 1e0 0 5\nvertex 0 1 5\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 1 "
    "0 0\n"
    "vertex 0 0 5\nvertex 0 1 5\nendloop\nendfacet\nendsolid b\n";

TEST(ScanImport, StlOfText) {
    std::string text = kTwoSolids;
    text.replace(text.find(".5"), 2, "0.5"); // as Assimp knows it
    expectSameAsAssimp("a.stl", text, "two solids");
    const auto read = [](const std::string& stl) { return test::importText("a.stl", stl); };
    const ImportedModel plain = read(kTwoSolids);
    EXPECT_EQ(plain.model.mesh.triangles.size(), 3U);
    EXPECT_TRUE(plain.report.warnings.empty());
    std::string capitals;
    for (const char c : std::string(kTwoSolids)) capitals += static_cast<char>(std::toupper(c));
    std::string windows;
    for (const char c : std::string(kTwoSolids)) windows += c == '\n' ? "\r\n" : std::string(1, c);
    for (const std::string& other : {capitals, windows, "\xEF\xBB\xBF" + std::string(kTwoSolids)})
        EXPECT_EQ(read(other).model.mesh.triangles.size(), 3U) << other;
    // Nobody uses the normals.
    for (const char* normal : {"nan nan nan", "-nan(ind) -nan(ind) -1.#IND", "a b c", "0 0"})
        EXPECT_EQ(read(changed(kTwoSolids, "0 0 1", normal)).model.mesh.triangles.size(), 3U) << normal;
}

TEST(ScanImport, AFacetOfAnStlFileThatIsNoneCostsItselfAlone) {
    const auto read = [](const std::string& from, const std::string& to) {
        return test::importText("a.stl", changed(kTwoSolids, from, to));
    };
    const ImportedModel word = read("1 0 0\n   vertex 0 1 .5", "1 0 x\n   vertex 0 1 .5");
    EXPECT_EQ(word.model.mesh.triangles.size(), 2U);
    ASSERT_EQ(word.report.warnings.size(), 1U);
    EXPECT_EQ(word.report.warnings[0].english(),
              "'a.stl', line 5: 'vertex' is not understood and passed over");
    const ImportedModel two = read("   vertex 0 1 .5\n", "");
    EXPECT_EQ(two.model.mesh.triangles.size(), 2U);
    ASSERT_EQ(two.report.warnings.size(), 1U);
    EXPECT_EQ(two.report.warnings[0].english(), "'a.stl', line 2: 'facet' is not understood and passed over");
    EXPECT_EQ(read("   vertex 0 1 .5\n", "   vertex 0 1 .5\nvertex -1 1 .5\n").model.mesh.triangles.size(),
              4U);
    const std::string first(kTwoSolids, std::string(kTwoSolids).find("  endloop"));
    const ImportedModel cut = test::importText("a.stl", first);
    EXPECT_EQ(cut.model.mesh.triangles.size(), 1U);
    ASSERT_EQ(cut.report.warnings.size(), 1U);
    EXPECT_EQ(cut.report.warnings[0].english(),
              "it is cut off: 'endsolid' is missing at its end; copy it again");
}

/// A binary STL file of triangles with these attributes.
std::string colouredStl(const std::string& title, const std::vector<std::uint16_t>& attributes) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        const auto x = static_cast<float>(i);
        triangles.push_back({Vec3{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    }
    std::string text = test::stlText(triangles, title);
    for (std::size_t i = 0; i < attributes.size(); ++i)
        std::memcpy(&text[84 + 50 * i + 48], &attributes[i], 2);
    return text;
}

TEST(ScanImport, ColoursOfStlFiles) {
    const std::vector<std::uint16_t> attributes{0x8000 | 31 << 10, 0x8000 | 31, 0x7FFF, 0, 0x8000 | 9 << 5};
    expectSameAsAssimp("a.stl", colouredStl("VisCAM", attributes), "VisCAM");
    const auto coloursOf = [](const std::string& text) {
        const ImportedModel m = test::importText("a.stl", text);
        std::vector<Colour> colours;
        for (const ShadingTriangle& t : m.model.mesh.shading) colours.push_back(m.model.mesh.colours[t.v[0]]);
        return colours;
    };
    const auto magics = coloursOf(colouredStl("COLOR=\xFF\xFF\x01\xFF", {31, 31 << 5, 31 << 10, 0x8000}));
    ASSERT_EQ(magics.size(), 4U);
    EXPECT_TRUE(test::near(magics[0], {1, 0, 0}));
    EXPECT_TRUE(test::near(magics[1], {0, 1, 0}));
    EXPECT_TRUE(test::near(magics[2], {0, 0, 1}));
    EXPECT_TRUE(test::near(magics[3], {1, 1, 0}, 1e-3F)) << "that of the head";
    expectSameAsAssimp("a.stl", colouredStl("COLOR=\xFF\x80\x01\xFF", {0, 0}), "the head's colour for all");
}

TEST(ScanImport, CasesOfTheField) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path cases = std::filesystem::path(scenes) / "field3";
    const ImportedModel nan = test::importFile(cases / "stl/nan_normal.stl");
    EXPECT_EQ(nan.model.mesh.triangles.size(), 2U);
    EXPECT_TRUE(nan.report.warnings.empty());
    EXPECT_EQ(test::importFile(cases / "ply/strips.ply").model.mesh.triangles.size(), 2U);
    const Model faces = test::importFile(cases / "ply/face_colour.ply").model;
    EXPECT_TRUE(test::near(faces.mesh.colours[faces.mesh.shading[0].v[0]], {1, 0, 0}));
    EXPECT_TRUE(test::near(faces.mesh.colours[faces.mesh.shading[1].v[0]], {0, 1, 0}));
    EXPECT_EQ(test::importFile(cases / "ply/points.ply").model.mesh.triangles.size(), 20U) << "five discs";
    const ImportedModel magics = test::importFile(cases / "stl/magics.stl");
    ASSERT_EQ(magics.model.mesh.triangles.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Colour c = magics.model.mesh.colours[magics.model.mesh.shading[i].v[0]];
        EXPECT_TRUE(test::near(c, {i == 0 ? 1.0F : 0, i == 1 ? 1.0F : 0, i == 2 ? 1.0F : 0})) << i;
    }
}

/// The message of importModel about the file, as a user sees it.
std::string complaint(const std::string& text) {
    const TemporaryFolder folder;
    test::writeText(folder / "a.ply", text);
    try {
        test::importFile(folder / "a.ply");
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        EXPECT_NE(std::string(error.what()).find("a.ply"), std::string::npos) << error.what();
        return error.what();
    }
    return "no error";
}

void expectComplaint(const std::string& text, const std::string& part) {
    const std::string said = complaint(text);
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

const std::string kPlyVertices = "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty float x\n"
                                 "property float y\nproperty float z\n";
const std::string kPlyCorners = "0 0 0\n1 0 0\n1 1 0\n\n0 1 0.5\n";

TEST(ScanImport, PlyOfText) {
    const std::string faces = "element face 3\nproperty list uchar int vertex_indices\nend_header\n";
    expectSameAsAssimp("a.ply", kPlyVertices + faces + kPlyCorners + "3 0 1 2\n4 0 1 2 3\n3 2 3 0\n",
                       "plain");
    const std::string coloured =
        kPlyVertices + "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
        "property float nx\nproperty float ny\nproperty float nz\nproperty float s\n" + "property float t\n" +
        faces;
    std::string rows;
    for (const char* at : {"0 0 0", "1 0 0", "1 1 0", "0 1 0.5"})
        rows += std::string(at) + " 255 " + std::to_string(rows.size()) + " 0 0 0.5 1 0.25 1\n";
    expectSameAsAssimp("a.ply", coloured + rows + "3 0 1 2\n3 0 2 3\n3 3 2 1\n", "all attributes");
    EXPECT_EQ(test::importText("a.ply", kPlyVertices + faces + kPlyCorners + "3 0 1 2\n3 0 1 9\n3 0 2 3\n")
                  .report.unconnectedTriangles,
              1U);
    expectComplaint(kPlyVertices + faces + kPlyCorners + "3 0 1 2\n3 0 1\n3 0 2 3\n",
                    "it ends after 1 of the 3 elements 'face'");
    expectComplaint(kPlyVertices + faces + kPlyCorners + "3 0 1 2\n3 0 1 2\n",
                    "it ends after 2 of the 3 elements 'face'");
    expectComplaint(kPlyVertices + faces + kPlyCorners + "3 0 1 2\n-4 0 1 2\n3 0 1 2\n",
                    "claims to have -1 corners");
}

TEST(ScanImport, ColoursOfPlyFaces) {
    const std::string text = kPlyVertices +
                             "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                             "property uchar green\nproperty uchar blue\nend_header\n" +
                             kPlyCorners + "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n";
    for (const char* name : {"red", "diffuse_red"}) {
        const Model m =
            test::importText("a.ply", changed(text, "uchar red", std::string("uchar ") + name)).model;
        ASSERT_EQ(m.mesh.triangles.size(), 2U);
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_TRUE(test::near(m.mesh.colours[m.mesh.shading[0].v[corner]], {1, 0, 0}));
            EXPECT_TRUE(test::near(m.mesh.colours[m.mesh.shading[1].v[corner]], {0, 1, 0}));
        }
        EXPECT_EQ(m.mesh.vertices.size(), 4U) << "they are still welded";
    }
}

TEST(ScanImport, StripsOfPly) {
    const std::string head =
        kPlyVertices + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    const Model one = test::importText("a.ply", head + kPlyCorners + "4 0 1 3 2\n").model;
    ASSERT_EQ(one.mesh.triangles.size(), 2U);
    for (std::uint32_t t = 0; t < 2; ++t) EXPECT_GT(one.mesh.geometricNormal(t).z, 0) << "both face up";
    EXPECT_EQ(
        test::importText("a.ply", head + kPlyCorners + "7 0 1 3 -1 1 2 3\n").model.mesh.triangles.size(), 2U);
}

TEST(ScanImport, PointsAloneInObjAreCalledThat) {
    try {
        test::importText("a.obj", "v 0 0 0\nv 1 0 0\n");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("a cloud of 2 points"), std::string::npos) << error.what();
    }
}

TEST(ScanImport, FilesThatLieAreErrors) {
    const std::string text = smallPly().text();
    expectComplaint(text.substr(0, text.size() - 1), "ends after 3 of the 4 elements 'face'");
    const std::string controls("f\0\x1B[m", 5);
    expectComplaint(changed(text.substr(0, text.size() - 1), "element face", "element " + controls),
                    "ends after 3 of the 4 elements 'f\\x00\\x1b[m' that its head promises; it is damaged");
    expectComplaint(text.substr(0, text.find("end_header") + 40),
                    "4 elements 'vertex', for which it has no room");
    expectComplaint(changed(text, "vertex 4", "vertex 4000000000"), "4000000000 elements 'vertex'");
    expectComplaint(changed(text, "vertex 4", "vertex 18446744073709551615"), "elements 'vertex'");
    expectComplaint(changed(text, "face 4", "face 999999999"), "999999999 elements 'face'");
    expectComplaint(changed(text, "element vertex", "element camera 9999999\nproperty int a\nelement vertex"),
                    "elements 'camera'");
    PlyFile file = smallPly();
    file.faces[2][1] = 4;
    expectComplaint(file.text(), "face 2 names the vertex 4 of 4");
    file.faces[2][1] = -1;
    expectComplaint(file.text(), "face 2 names the vertex -1 of 4");
    file = smallPly();
    file.lengthType = "int";
    const auto withLength = [&](std::int32_t length) {
        std::string longer = file.text();
        std::memcpy(longer.data() + longer.size() - 4 * 16, &length, sizeof length);
        return longer;
    };
    expectComplaint(withLength(-3), "face 0 claims to have -3 corners");
    expectComplaint(withLength(2'000'000'000), "face 0 claims to have 2000000000 corners");
    file.positions.clear();
    file.faces.clear();
    expectComplaint(file.text(), "holds no triangles");
}

TEST(ScanImport, APlyHeadThatDoesNotEndIsAnError) {
    const std::string whole = smallPly().text();
    const std::string head = whole.substr(0, whole.find("end_header") + 10);
    const std::string ofText = changed(head, "binary_little_endian", "ascii");
    const std::string ofWindows = changed(head, "ply\n", "ply\r\n");
    for (const std::string& text : {head, ofText, ofWindows}) {
        for (std::size_t size = 3; size <= text.size(); ++size)
            EXPECT_THROW(isRead("a.ply", text.substr(0, size)), FileError) << size;
    }
    EXPECT_THROW(isRead("a.ply", changed(whole, "end_header", "end_of_header")), FileError);
    EXPECT_THROW(isRead("a.ply", ofText + "\n"), FileError) << "promises vertices";
    EXPECT_FALSE(isRead("a.ply", ofWindows + "\r\n"));
    EXPECT_FALSE(isRead("a.obj", "plywood"));
    expectComplaint(head, "its head does not end within 191 bytes; it is damaged: copy or export it again");
}

// Assimp would take half a minute for the head, and is not asked.
TEST(ScanImport, APlyHeadOfManyLinesIsReadOrRefusedAtOnce) {
    const std::string whole = smallPly().text();
    const auto with = [&](int lines, const std::string& line) {
        std::string more;
        for (int i = 0; i < lines; ++i)
            more += line + std::to_string(i) + (line == "element e" ? " 0\n" : "\n");
        return changed(whole, "end_header", more + "end_header");
    };
    for (const char* line : {"comment ", "property float p", "element e"}) {
        expectComplaint(with(300'000, line), "its head does not end within 262144 bytes");
        const std::string ofText = changed(with(300'000, line), "binary_little_endian", "ascii");
        expectComplaint(ofText, "its head does not end within 262144 bytes");
    }
    EXPECT_TRUE(isRead("a.ply", with(10'000, "comment ")));
    EXPECT_TRUE(isRead("a.ply", with(10'000, "element e")));
}

TEST(ScanImport, AFileThatShrinksWhileItIsReadIsAnError) {
    const TemporaryFolder folder;
    const std::string ply = largePly(2).text();
    const std::string stl = test::stlText(std::vector<std::array<Vec3, 3>>(20'000));
    test::writeText(folder / "a.ply", ply);
    test::writeText(folder / "a.stl", stl);
    const auto shrink = [&](const char* name, std::size_t size) {
        return [path = folder / name, size] { std::filesystem::resize_file(path, size); };
    };
    const InputFile plyFile(folder / "a.ply"), stlFile(folder / "a.stl");
    const auto header = readPlyHeader(ply);
    ASSERT_TRUE(header);
    shrink("a.ply", ply.size() / 2)();
    EXPECT_THROW(readPly(plyFile, *header, {}, [] {}), FileError);
    EXPECT_TRUE(readStl(stlFile, {}, [] {}));
    shrink("a.stl", stl.size() / 2)();
    EXPECT_THROW(readStl(stlFile, {}, [] {}), FileError);
}

/// Whatever the bytes: a sound mesh, no mesh or a FileError. More of them: RT_MUTATIONS.
class DamagedScan {
  public:
    explicit DamagedScan(std::uint32_t seed) : random_(seed) {}

    void check(const std::string& name, const std::string& text) {
        test::writeText(folder_ / name, text);
        try {
            const auto import = importScan(folder_ / name, {.memoryLimit = 100'000'000});
            if (import) expectSound(import->model);
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData);
            EXPECT_NE(std::string(error.what()).find(';'), std::string::npos) << error.what();
        }
    }
    std::string damaged(std::string text, std::size_t head) {
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
            const std::size_t at = below(below(2) == 0 ? head : text.size());
            switch (below(4)) {
            case 0:
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                break;
            case 1:
                text[at] = "\x00\x01\x7F\x80\xFF 09\n"[below(9)];
                break;
            case 2:
                text.erase(at, below(8));
                break;
            default:
                text[at] = text[below(text.size())];
                break;
            }
            if (text.empty()) text = " ";
        }
        return text;
    }

  private:
    std::size_t below(std::size_t n) { return random_() % std::max<std::size_t>(n, 1); }

    static void expectSound(const ModelBuffers& model) {
        for (const Triangle& t : model.triangles) {
            for (const std::uint32_t v : t.v) ASSERT_LT(v, model.vertices.size());
        }
        for (const ShadingTriangle& t : model.shading) {
            for (const std::uint32_t v : t.v) ASSERT_LT(v, model.normals.size());
        }
        ASSERT_EQ(model.shading.size(), model.triangles.size());
    }

    TemporaryFolder folder_;
    std::mt19937 random_;
};

TEST(ScanImport, DamagedFilesAreSoundOrRefused) {
    const char* const wanted = std::getenv("RT_MUTATIONS");
    const long count = wanted != nullptr ? std::atol(wanted) : 300;
    DamagedScan damage(6);
    PlyFile file = smallPly();
    const std::string plain = file.text();
    for (std::size_t size = 0; size < plain.size(); size += 3) damage.check("a.ply", plain.substr(0, size));
    file.attributes = {{"uchar", "red", {1}}, {"short", "nx", {2}}, {"double", "u", {3}}};
    file.lengthType = "ushort";
    file.behind = "int";
    file.bigEndian = true;
    file.faces.push_back({0, 1, 2, 3});
    const std::string rich = file.text();
    const std::string stl = test::stlText({{Vec3{}, {1, 0, 0}, {0, 1, 0}}, {Vec3{}, {1, 1, 0}, {0, 1, 5}}});
    const std::string ofText = kPlyVertices +
                               "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                               "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                               kPlyCorners + "3 0 1 2 255\n4 0 1 2 3 1\n4 0 1 2 3\n";
    for (long i = 0; i < count; ++i) {
        damage.check("a.ply", damage.damaged(plain, plain.find("end_header")));
        damage.check("a.ply", damage.damaged(rich, rich.find("end_header")));
        damage.check("a.stl", damage.damaged(stl, 84));
        damage.check("a.stl", damage.damaged(kTwoSolids, 40));
        damage.check("a.ply", damage.damaged(ofText, ofText.find("end_header")));
    }
}

} // namespace
