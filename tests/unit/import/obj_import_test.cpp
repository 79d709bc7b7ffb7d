// OBJ files: the same model as Assimp makes of what it understands, and the right one of the rest.
#include "rtcore/io/import/obj/obj_import.h"

#include "import_support.h"
#include "support/damaged_text.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <random>

namespace {

using namespace rtcore;
using test::importText;
using test::near;
using test::TemporaryFolder;
using test::writeText;

FileImport objOf(const std::filesystem::path& path) {
    auto import = importObj(path, {});
    if (!import) throw std::runtime_error("not taken");
    return std::move(*import);
}

std::string warningsOf(const ImportReport& report) {
    std::string text;
    for (const Sentence& warning : report.warnings) text += warning.english() + "\n";
    return text;
}

std::string partsOf(const ModelBuffers& model) {
    std::string text;
    for (const ModelPart& part : model.parts)
        text +=
            std::string(&model.strings[part.nameOffset]) + " " + std::to_string(part.triangleCount) + "\n";
    return text;
}

template <typename T>
bool equalBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Steps of floats from one to the other.
int stepsBetween(float a, float b) {
    const auto order = [](float v) {
        const auto bits = std::bit_cast<std::int32_t>(v);
        return bits < 0 ? std::int64_t{-0x7FFFFFFF - 1} - bits : std::int64_t{bits};
    };
    return static_cast<int>(std::abs(order(a) - order(b)));
}

/// Assimp reads both parts of a number by themselves, so that its last bit may be another.
void expectNear(const FileImport& a, const FileImport& b, const std::string& what) {
    ASSERT_EQ(a.model.vertices.size(), b.model.vertices.size()) << what;
    EXPECT_TRUE(equalBytes(a.model.triangles, b.model.triangles)) << what;
    EXPECT_TRUE(equalBytes(a.model.materials, b.model.materials)) << what;
    EXPECT_EQ(partsOf(a.model), partsOf(b.model)) << what;
    EXPECT_EQ(a.model.textures.size(), b.model.textures.size()) << what;
    int steps = 0;
    for (std::size_t i = 0; i < a.model.vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            steps = std::max(steps, stepsBetween(a.model.vertices[i].position()[axis],
                                                 b.model.vertices[i].position()[axis]));
    EXPECT_LE(steps, 1) << what;
}

void expectSameBits(const FileImport& a, const FileImport& b, const std::string& what) {
    EXPECT_TRUE(equalBytes(a.model.vertices, b.model.vertices)) << what;
    EXPECT_TRUE(equalBytes(a.model.triangles, b.model.triangles)) << what;
    EXPECT_TRUE(equalBytes(a.model.shading, b.model.shading)) << what;
    EXPECT_TRUE(equalBytes(a.model.normals, b.model.normals)) << what;
    EXPECT_TRUE(equalBytes(a.model.texcoords, b.model.texcoords)) << what;
    EXPECT_TRUE(equalBytes(a.model.colours, b.model.colours)) << what;
    EXPECT_TRUE(equalBytes(a.model.materials, b.model.materials)) << what;
    EXPECT_EQ(partsOf(a.model), partsOf(b.model)) << what;
    EXPECT_EQ(a.model.strings, b.model.strings) << what;
    EXPECT_EQ(a.report.files, b.report.files) << what;
    EXPECT_EQ(a.report.origin, b.report.origin) << what;
}

/// Random files that Assimp understands.
class ObjWriter {
  public:
    explicit ObjWriter(std::uint32_t seed) : random_(seed) {}

    std::string obj() {
        text_ = "# made by a test\nmtllib m.mtl\nusemtl " + material() + "\n";
        texcoords_ = below(2);
        normals_ = below(2);
        positions_ = 0;
        addPositions(8);
        for (int i = 0; i < 6; ++i) {
            if (texcoords_ != 0) text_ += "vt 0." + number(100) + " 0." + number(100) + "\n";
            if (normals_ != 0) text_ += "vn " + number(9) + " " + number(9) + " 1\n";
        }
        for (int i = 0; i < 12; ++i) addStatement();
        addFace(3);
        return text_;
    }
    std::string mtl() {
        std::string text;
        for (const char* name : {"red", "blue sky", "green"}) {
            text += std::string("newmtl ") + name + "\n";
            for (const char* line :
                 {"Kd 0.5 0.25 0.75", "\tKs 0.25 0.25 0.25", "Ns 20", "illum 2", "illum 7", "d 0.5",
                  "Tr 0.25", "Ni 1.5", "Ke 1 0 0", "Tf 1 0.5 0.25", "Pr 0.25", "Pm 0.75", "Ka 1 1 1"})
                if (below(3) == 0) text += line + std::string("\n");
        }
        return text;
    }

  private:
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_()) % n; }
    std::string number(std::uint32_t n) { return std::to_string(below(n)); }
    std::string material() {
        constexpr std::array kNames{"red", "blue sky", "green", "unknown"};
        return kNames[below(4)];
    }
    void addPositions(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i)
            text_ += "v -" + number(9) + ".25 " + number(9) + ".5 " + number(9) + "\n";
        positions_ += count;
    }
    void addStatement() {
        constexpr std::array kNames{"a", "b", "c d"};
        switch (below(8)) {
        case 0:
            text_ += std::string("g ") + kNames[below(3)] + "\n";
            break;
        case 1:
            text_ += std::string("o ") + kNames[below(2)] + "\n";
            break;
        case 2:
            text_ += "usemtl " + material() + "\n";
            break;
        case 3:
            text_ += "s off\nl 1 2 3\n";
            addPositions(1);
            break;
        default:
            addFace(3 + below(3) / 2 * below(3));
        }
    }
    void addFace(std::uint32_t corners) {
        text_ += "f";
        const std::uint32_t first = below(positions_);
        for (std::uint32_t i = 0; i < corners; ++i) {
            const std::uint32_t at = (first + i) % positions_;
            text_ += below(4) == 0 ? " -" + std::to_string(positions_ - at) : " " + std::to_string(at + 1);
            if (texcoords_ + normals_ > 0) text_ += "/";
            if (texcoords_ > 0) text_ += std::to_string(1 + below(6));
            if (normals_ > 0) text_ += "/" + std::to_string(1 + below(6));
        }
        text_ += "\n";
    }

    std::mt19937 random_;
    std::string text_;
    std::uint32_t positions_ = 0, texcoords_ = 0, normals_ = 0;
};

TEST(ObjImport, WhatAssimpUnderstandsIsTheSameToTheBit) {
    ObjWriter writer(5);
    for (int i = 0; i < 200; ++i) {
        const TemporaryFolder folder;
        writeText(folder / "m.mtl", writer.mtl());
        const std::string text = writer.obj();
        writeText(folder / "m.obj", text);
        expectSameBits(objOf(folder / "m.obj"), importWithAssimp(folder / "m.obj", {}), text);
    }
}

TEST(ObjImport, RealModelsAreTheSameButForTheLastBit) {
    const char* const folder = std::getenv("RT_TEST_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    for (const char* name : {"bunny/bunny.obj", "cornell/CornellBox-Water.obj", "chess/knight.obj",
                             "sponza_crytek/sponza.obj", "teapot/teapot.obj", "spot/spot.obj"}) {
        const auto path = std::filesystem::path(folder) / name;
        expectNear(objOf(path), importWithAssimp(path, {}), name);
    }
}

TEST(ObjImport, NumbersOfEveryKind) {
    const auto read = [](const std::string& word) {
        const std::string line = word + " x\n";
        return StatementText(line).number();
    };
    const std::vector<std::pair<const char*, float>> numbers{
        {"1", 1.0F},
        {".5", 0.5F},
        {"-.5", -0.5F},
        {"+.5", 0.5F},
        {"1.", 1.0F},
        {"1e3", 1000.0F},
        {"1.5E-3", 1.5e-3F},
        {"-0", 0.0F},
        {"1,5", 1.5F},
        {"1e-60", 0.0F},
        {"1e60", INFINITY},
        {"-1e60", -INFINITY},
        {"0.1", 0.1F},
        {"16777217", 16777216.0F},
        {"0.000000000000000000000000000000000000000000000000001", 0.0F}};
    for (const auto& [word, value] : numbers) EXPECT_EQ(read(word), value) << word;
    for (const char* word : {"x", "1x", "1.5.5", "--1", "", "1,5,5", "0x10", "1e", "1/2"})
        EXPECT_FALSE(read(word)) << word;
    EXPECT_TRUE(std::isnan(read("nan").value_or(0)));
    EXPECT_TRUE(std::isnan(read("-nan(ind)").value_or(0)));
}

/// A triangle, with lines before and behind it.
std::string triangle(const std::string& more = "") {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + more + "f 1 2 3\n";
}

TEST(ObjImport, AStatementThatIsNotUnderstoodCostsItselfAlone) {
    const ImportedModel one = importText("m.obj", triangle("hello world\n"));
    EXPECT_EQ(one.model.mesh.triangles.size(), 1U);
    EXPECT_EQ(warningsOf(one.report), "'m.obj', line 4: 'hello' is not understood and passed over\n");
    EXPECT_EQ(warningsOf(importText("m.obj", triangle("f 1 2 x\nf 1/0 2 3\n")).report),
              "'m.obj', line 4: 'f' is not understood and passed over, as is 1 line more\n");
    EXPECT_EQ(warningsOf(importText("m.obj", "cstype bezier\ndeg 3\nsurf 0 1 0 1\n" + triangle()).report),
              "'m.obj', line 1: 'cstype' is not understood and passed over, as are 2 lines more\n");
    EXPECT_EQ(warningsOf(importText("m.obj", triangle("s 1\nmg off\nlod 3\n# any\n\n \t\n")).report), "");
    // Positions, texture coordinates and normals that are none keep their number.
    const ImportedModel odd =
        importText("m.obj", "v 5 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt x\nvt 1 1\nvn 1\nvn 0 0 1\n"
                            "f 2/2/2 3/2/2 4/2/2\nf 1 2 3\n");
    EXPECT_EQ(odd.model.mesh.triangles.size(), 1U);
    EXPECT_EQ(odd.model.mesh.texcoords[0], (Vec2{1, 1}));
    EXPECT_EQ(odd.report.nonFiniteTriangles, 1U);
}

TEST(ObjImport, EveryEndOfLineAndJoinedLines) {
    const std::string plain = "o a b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto with = [&](const std::string& end) {
        std::string text;
        for (const char c : plain) text += c == '\n' ? end : std::string(1, c);
        return text;
    };
    for (const std::string& text :
         {plain, with("\r\n"), with("\r"), "\xEF\xBB\xBF" + plain, plain.substr(0, plain.size() - 1),
          with(" \n"), with("\n\n"), std::string("o a\nv 0 0 0\nv 1 \\\n 0 0\nv 0 1 0\nf 1 \\\r\n 2 \\\n3"),
          "# ends in \\\n" + plain, "  \t" + plain, plain + "\\\n", plain + "\\"}) {
        const ImportedModel m = importText("m.obj", text);
        EXPECT_EQ(m.model.mesh.triangles.size(), 1U) << text;
        EXPECT_EQ(m.model.name(m.model.parts[0].nameOffset), "a") << text;
        EXPECT_EQ(warningsOf(m.report), "") << text;
    }
    EXPECT_EQ(warningsOf(importText("m.obj", "v 0 \\\n 0 0\r\nv 1 0 0\rv 0 1 0\nodd\nf 1 2 3\n").report),
              "'m.obj', line 5: 'odd' is not understood and passed over\n");
}

TEST(ObjImport, CornersOfEveryKind) {
    const std::string lists = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nvt 1 1\nvn 0 0 -1\n";
    const auto face = [&](const std::string& corners) {
        return importText("m.obj", lists + "f " + corners + "\n");
    };
    EXPECT_TRUE(face("1 2 3").model.mesh.texcoords.empty());
    EXPECT_TRUE(near(test::normalOf(face("1//1 2//1 3//1").model.mesh, 0, 1), {0, 0, -1}));
    EXPECT_TRUE(near(test::normalOf(face("-3//-1 -2//-1 -1//-1").model.mesh, 0, 1), {0, 0, -1}));
    const ImportedModel mixed = face("1/1 2//1 3/2/1");
    const Mesh& mesh = mixed.model.mesh;
    EXPECT_EQ(mesh.texcoords[mesh.shading[0].v[0]], (Vec2{0.5F, 0.25F}));
    EXPECT_EQ(mesh.texcoords[mesh.shading[0].v[1]], (Vec2{}));
    EXPECT_EQ(mesh.texcoords[mesh.shading[0].v[2]], (Vec2{1, 1}));
    EXPECT_TRUE(near(test::normalOf(mesh, 0, 0), {0, 0, 1})) << "has none, so gets that of the triangle";
    EXPECT_TRUE(near(test::normalOf(mesh, 0, 1), {0, 0, -1}));
    // What leads nowhere is none.
    EXPECT_EQ(warningsOf(face("1/9/9 2/-9/-9 3/1/1").report), "");
    EXPECT_EQ(importText("m.obj", triangle("f 1 2 9\nf -7 1 2\n")).report.unconnectedTriangles, 2U);
    // Without texture coordinates, the second is the normal.
    const ImportedModel second = importText("m.obj", triangle("vn 1 0 0\n") + "f 1/1 2/1 3/1\n");
    EXPECT_TRUE(near(test::normalOf(second.model.mesh, 1, 0), {1, 0, 0}));
    // Faces may come before what they name.
    EXPECT_EQ(importText("m.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").model.mesh.triangles.size(), 1U);
    // A trailing comment.
    EXPECT_EQ(warningsOf(importText("m.obj", "v 0 0 5 # a\n" + triangle() + "f 1 3 4 # c\n").report), "");
}

TEST(ObjImport, PolygonsOfAnyShape) {
    const ImportedModel arrow =
        importText("m.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
    EXPECT_EQ(arrow.model.mesh.triangles.size(), 3U);
    EXPECT_NEAR(test::areaOf(arrow.model.mesh), 10, 1e-5);
    std::string text, face = "f";
    for (int i = 0; i < 2000; ++i) {
        const double angle = i * 2 * 3.14159265358979 / 2000;
        text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    EXPECT_NEAR(test::areaOf(importText("m.obj", text + face).model.mesh), 3.14159, 1e-3);
}

TEST(ObjImport, LinesAndPointsAreSaidToBeLeftOut) {
    const ImportedModel m = importText("m.obj", triangle("l 1 2 3\np 1 2\n"));
    EXPECT_EQ(warningsOf(m.report), "4 lines and points are left out; only surfaces are shown\n");
    EXPECT_EQ(m.report.ignoredPrimitives, 4U);
}

TEST(ObjImport, ColoursOfVertices) {
    const auto colourAt = [](const std::string& text, int corner) {
        const ImportedModel m = importText("m.obj", text + "f 1 2 3\n");
        const Mesh& mesh = m.model.mesh;
        return mesh.colours.empty() ? Colour{-1, -1, -1} : Colour(mesh.colours[mesh.shading[0].v[corner]]);
    };
    const std::string fractions = "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\n";
    EXPECT_TRUE(near(colourAt(fractions, 0), {1, 0, 0}));
    EXPECT_TRUE(near(colourAt(fractions, 1), {0, 0.2140F, 0})) << "sRGB";
    EXPECT_TRUE(near(colourAt(fractions, 2), kWhite)) << "has none";
    EXPECT_TRUE(near(colourAt("v 0 0 0 255 0 0\nv 1 0 0 0 128 0\nv 0 1 0 0 0 0\n", 0), {1, 0, 0}));
    EXPECT_TRUE(near(colourAt("v 0 0 0 255 0 0\nv 1 0 0 0 128 0\nv 0 1 0 0 0 0\n", 1), {0, 0.2159F, 0}));
    EXPECT_TRUE(near(colourAt("v 0 0 0 1 0 0 1\nv 1 0 0 1 1 1 1\nv 0 1 0 0 0 0 1\n", 0), {1, 0, 0}));
    const ImportedModel weights = importText("m.obj", "v 0 0 0 1\nv 4 0 0 2\nv 0 1 0 0\nf 1 2 3\n");
    EXPECT_EQ(weights.model.mesh.position(0, 1), (Vec3{2, 0, 0}));
    EXPECT_EQ(weights.model.mesh.position(0, 2), (Vec3{0, 1, 0}));
}

TEST(ObjImport, FacesBeforeAnyMaterialAreGrey) {
    const TemporaryFolder folder;
    writeText(folder / "m.mtl", "newmtl red\nKd 1 0 0\n");
    writeText(folder / "m.obj", "mtllib m.mtl\n" + triangle() + "usemtl red\nf 3 2 1\n");
    const ImportedModel m = test::importFile(folder / "m.obj");
    ASSERT_EQ(m.model.materials.size(), 2U);
    EXPECT_TRUE(near(m.model.materials[m.model.mesh.shading[0].material].diffuse, {0.6F, 0.6F, 0.6F}));
    EXPECT_TRUE(near(m.model.materials[m.model.mesh.shading[1].material].diffuse, {1, 0, 0}));
}

TEST(ObjImport, ColoursOfVerticesAreNotDarkenedWhereThereIsNoMaterial) {
    const TemporaryFolder folder;
    writeText(folder / "m.mtl", "newmtl half\nKd .5 .5 .5\n");
    writeText(folder / "d.mtl", "newmtl DefaultMaterial\nKd .6 .6 .6\n");
    const std::string coloured = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
    writeText(folder / "m.obj", "mtllib m.mtl\n" + coloured + "usemtl half\nf 3 2 1\n");
    writeText(folder / "d.obj", "mtllib d.mtl\n" + coloured);
    const auto diffuseOf = [](const FileImport& import, std::size_t triangle) {
        return import.model.materials[import.model.shading[triangle].material].diffuse;
    };
    const FileImport import = objOf(folder / "m.obj");
    ASSERT_EQ(import.model.shading.size(), 2U);
    EXPECT_TRUE(near(diffuseOf(import, 0), kWhite));
    EXPECT_TRUE(near(diffuseOf(import, 1), {0.5F, 0.5F, 0.5F}));
    EXPECT_TRUE(near(diffuseOf(objOf(folder / "d.obj"), 0), {0.6F, 0.6F, 0.6F})) << "described";
    writeText(folder / "u.obj", "mtllib m.mtl\nusemtl gone\n" + coloured);
    EXPECT_TRUE(near(diffuseOf(objOf(folder / "u.obj"), 0), kWhite)) << "named alone";
    writeText(folder / "p.obj", "mtllib m.mtl\nusemtl gone\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(near(diffuseOf(objOf(folder / "p.obj"), 0), {0.6F, 0.6F, 0.6F})) << "no colours";
}

TEST(ObjImport, IsChosenByItsName) {
    const TemporaryFolder folder;
    writeText(folder / "m.txt", triangle());
    EXPECT_FALSE(importObj(folder / "m.txt", {}));
    writeText(folder / "m.OBJ", triangle());
    EXPECT_TRUE(importObj(folder / "m.OBJ", {}));
    writeText(folder / "g.obj", R"({"asset":{"version":"2.0"}})");
    try {
        importObj(folder / "g.obj", {});
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("rename it so that it ends in .gltf"), std::string::npos);
    }
}

constexpr std::array<std::string_view, 22> kObjTokens{
    "\n",        "\r",        "\\\n",  "/",     "//",   " ",       "-1", "0",  "99999999999999999999",
    "1e999",     "nan",       "\nf 1", "\nv 0", "\ng ", "\no a\n", "#",  "\"", "\0\xFF",
    "\nusemtl ", "\nmtllib ", " -s 1", "../"};

/// Whatever the bytes: a sound model or a FileError. More of them: RT_MUTATIONS.
TEST(ObjImport, DamagedFilesAreSoundOrRefused) {
    const TemporaryFolder folder;
    writeText(folder / "a b.mtl", "newmtl red\nKd 1 0 0\n");
    const std::string obj =
        "mtllib a b.mtl \"a b.mtl\"\no one\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 .5 .5 .5\nv 1 1 1e3\n"
        "vt 0 0\nvt 1 .5 0\nvn 0 0 1\ng two\nusemtl red\nf 1/1/1 2/2/1 3/1/1\nf -1 -2 -3 -4\n"
        "usemtl blue\nf 1//1 2//1 \\\n 4//1\nl 1 2\np 1\ns off\nf 1 2 3 4 1\n";
    const std::string mtl =
        "newmtl red\nKd 1 .5 0\nKs 1\nNs 20\nd -halo .5\nTr 1\nillum 7\nPm 1\nPr .5\nTf 1 1 0\n"
        "map_Kd -s 2 2 -o 1 -clamp on \"a b.png\"\nbump x.png -bm 2\nnorm -t 1 n.png\naniso 1\n"
        "map_Bump -imfchan r -mm 0 1 b.png\nnewmtl\nmap_d C:\\a\\b\\c.png\nrefl x\n";
    test::DamagedText objs({obj}, kObjTokens, 11), mtls({mtl}, kObjTokens, 12);
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const bool library = i % 2 == 0;
        writeText(folder / (library ? "a b.mtl" : "m.obj"), library ? mtls.next() : objs.next());
        if (library) writeText(folder / "m.obj", obj);
        try {
            const FileImport import = objOf(folder / "m.obj");
            for (const Triangle& t : import.model.triangles)
                for (const std::uint32_t v : t.v) ASSERT_LT(v, import.model.vertices.size());
            for (const ShadingTriangle& t : import.model.shading) {
                for (const std::uint32_t v : t.v) ASSERT_LT(v, import.model.normals.size());
                ASSERT_LT(t.material, import.model.materials.size());
            }
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData) << error.what();
        }
    }
}

TEST(StatementText, NumbersHaveTheBitsOfFromChars) {
    std::mt19937 random(7);
    const auto digits = [&](std::size_t max) {
        std::string text(random() % (max + 1), ' ');
        for (char& digit : text) digit = static_cast<char>('0' + random() % 10);
        return text;
    };
    std::vector<std::string> words{"16777217", "16777217.0", "8388608.5", "0",   "-0",
                                   ".5",       "5.",         "0.1",       "1e-5"};
    for (int i = 0; i < 20'000; ++i)
        words.push_back((random() % 2 == 0 ? "-" : "") + digits(10) + "7." + digits(12));
    for (const std::string& word : words) {
        float expected = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), expected);
        ASSERT_EQ(error, std::errc()) << word;
        const std::string line = word + "\n";
        const auto number = StatementText(line).number();
        ASSERT_TRUE(number) << word;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(*number), std::bit_cast<std::uint32_t>(expected)) << word;
    }
}

/// Threads read blocks of it; indices that count from the end wait for the blocks before.
TEST(ObjImport, ALongFileIsTheSameHoweverItsCornersCount) {
    const TemporaryFolder folder;
    std::string positive, negative;
    for (int i = 0; i < 20'000; ++i) {
        std::string both = i % 1000 == 0 ? "g part" + std::to_string(i) + "\nusemtl m\n" : "";
        for (const char* corner : {" 0 0.25\n", " 1.5 0\n", " 2 -1\n"})
            both += "v " + std::to_string(i % 7777) + corner + "vt 0.5 0." + std::to_string(i) + "\n";
        positive += both + "f";
        for (int k = 1; k <= 3; ++k)
            positive += " " + std::to_string(3 * i + k) + "/" + std::to_string(3 * i + k);
        positive += "\n";
        negative += both + "f -3/-3 -2/-2 -1/-1\n";
    }
    writeText(folder / "p.obj", positive);
    writeText(folder / "n.obj", negative);
    FileImport a = objOf(folder / "p.obj"), b = objOf(folder / "n.obj");
    EXPECT_EQ(a.model.parts.size(), 20U);
    EXPECT_EQ(a.model.texcoords.size(), 60'000U);
    a.report.files = b.report.files;
    expectSameBits(a, b, "long");
}

} // namespace
