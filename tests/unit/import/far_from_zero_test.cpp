// Models on a national grid: read in doubles, less their middle.
#include "gltf_builder.h"
#include "import_support.h"

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/import_forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>

namespace {

using namespace rtcore;
using test::TemporaryFolder;
using test::writeText;

constexpr FilePoint kGrid{458213.37, 5428765.19, 312.4};
constexpr FilePoint kGeocentric{-2694045.21, -4266893.77, 3888310.05};

struct Face {
    std::array<FilePoint, 3> corners;
};

/// A tower of turned floors: 160 triangles within 10 x 10 x 8 units, no coordinate of which is round.
std::vector<Face> tower(const FilePoint& at, double scale = 1) {
    const auto corner = [&](int floor, int i) {
        const double angle = 0.7853981633974483 * (i % 8) + 0.31 * floor, radius = 5 - 0.37 * floor;
        return FilePoint{scale * (at[0] + radius * std::cos(angle)),
                         scale * (at[1] + radius * std::sin(angle)), scale * (at[2] + 0.8 * floor)};
    };
    std::vector<Face> faces;
    for (int floor = 0; floor < 10; ++floor) {
        for (int i = 0; i < 8; ++i) {
            const FilePoint a = corner(floor, i), b = corner(floor, i + 1), c = corner(floor + 1, i + 1),
                            d = corner(floor + 1, i);
            faces.push_back({{a, b, c}});
            faces.push_back({{a, c, d}});
        }
    }
    return faces;
}

std::string numbers(const FilePoint& p) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%.12g %.12g %.12g", p[0], p[1], p[2]);
    return text.data();
}

std::string asObj(const std::vector<Face>& faces) {
    std::string text, last;
    int number = 0;
    for (const Face& face : faces) {
        for (const FilePoint& p : face.corners) text += "v " + numbers(p) + "\n";
        last += "f " + std::to_string(number + 1) + " " + std::to_string(number + 2) + " " +
                std::to_string(number + 3) + "\n";
        number += 3;
    }
    return text + last;
}

std::string asStl(const std::vector<Face>& faces) {
    std::string text = "solid tower\n";
    for (const Face& face : faces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const FilePoint& p : face.corners) text += "vertex " + numbers(p) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid tower\n";
}

std::string plyHead(const char* format, const char* type, std::size_t faces) {
    const std::string t = std::string("property ") + type + " ";
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex " + std::to_string(3 * faces) + "\n" +
           t + "x\n" + t + "y\n" + t + "z\nelement face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string asPlyText(const std::vector<Face>& faces) {
    std::string text = plyHead("ascii", "double", faces.size());
    for (const Face& face : faces)
        for (const FilePoint& p : face.corners) text += numbers(p) + "\n";
    for (std::size_t f = 0; f < faces.size(); ++f)
        text += "3 " + std::to_string(3 * f) + " " + std::to_string(3 * f + 1) + " " +
                std::to_string(3 * f + 2) + "\n";
    return text;
}

template <typename Number>
std::string asPly(const std::vector<Face>& faces) {
    static_assert(std::endian::native == std::endian::little);
    std::string text =
        plyHead("binary_little_endian", sizeof(Number) == 8 ? "double" : "float", faces.size());
    const auto put = [&](auto value) { text.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    for (const Face& face : faces)
        for (const FilePoint& p : face.corners)
            for (const double v : p) put(static_cast<Number>(v));
    for (std::size_t f = 0; f < faces.size(); ++f) {
        put(static_cast<std::uint8_t>(3));
        for (std::size_t i = 0; i < 3; ++i) put(static_cast<std::int32_t>(3 * f + i));
    }
    return text;
}

FileImport importOf(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    writeText(folder / name, text);
    return rtcore::importFile(folder / name, {});
}

FilePoint cornerOf(const FileImport& import, std::size_t triangle, std::size_t corner) {
    const Vec3 p = import.model.vertices[import.model.triangles[triangle].v[corner]].position();
    return import.report.origin.zero.inFile(p);
}

double farthestCorner(const FileImport& import, const std::vector<Face>& faces) {
    double farthest = 0;
    for (std::size_t t = 0; t < faces.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                farthest =
                    std::max(farthest, std::fabs(cornerOf(import, t, i)[axis] - faces[t].corners[i][axis]));
    return farthest;
}

struct Writer {
    const char* name;
    std::function<std::string(const std::vector<Face>&)> write;
};
const std::array<Writer, 4> kPrecise{Writer{"tower.obj", asObj}, Writer{"tower.stl", asStl},
                                     Writer{"text.ply", asPlyText}, Writer{"binary.ply", asPly<double>}};

TEST(FarFromZero, CornersKeepTheirDigits) {
    for (const FilePoint& at : {kGrid, kGeocentric}) {
        for (const double scale : {1.0, 1000.0}) {
            const std::vector<Face> faces = tower(at, scale);
            for (const Writer& writer : kPrecise) {
                const FileImport import = importOf(writer.name, writer.write(faces));
                ASSERT_EQ(import.model.triangles.size(), faces.size()) << writer.name;
                EXPECT_FALSE(import.report.origin.zero.isZero()) << writer.name;
                EXPECT_TRUE(import.report.warnings.empty()) << import.report.warnings.front().english();
                // Twelve digits in the text, then floats of at most 5 units.
                EXPECT_LE(farthestCorner(import, faces), scale * 1e-5) << writer.name;
            }
        }
    }
}

TEST(FarFromZero, VerticesAreWeldedAsNearZero) {
    for (const Writer& writer : kPrecise) {
        const FileImport near = importOf(writer.name, writer.write(tower({}))),
                         far = importOf(writer.name, writer.write(tower(kGrid)));
        EXPECT_TRUE(near.report.origin.zero.isZero());
        ASSERT_EQ(far.model.vertices.size(), near.model.vertices.size()) << writer.name;
        for (std::size_t t = 0; t < near.model.triangles.size(); ++t)
            EXPECT_TRUE(std::ranges::equal(far.model.triangles[t].v, near.model.triangles[t].v)) << t;
    }
}

TEST(FarFromZero, OneCornerAtZeroDoesNoHarm) {
    std::vector<Face> faces = tower(kGrid);
    faces.push_back({{FilePoint{}, FilePoint{1, 0, 0}, FilePoint{0, 1, 0}}});
    const FileImport import = importOf("tower.obj", asObj(faces));
    ASSERT_EQ(import.model.triangles.size(), faces.size());
    faces.pop_back();
    EXPECT_LE(farthestCorner(import, faces), 1e-5);
}

TEST(FarFromZero, CoarseFloatsAreSaid) {
    const FileImport import = importOf("tower.ply", asPly<float>(tower(kGrid)));
    ASSERT_EQ(import.report.warnings.size(), 1U);
    EXPECT_EQ(import.report.warnings[0], say(import_forms::kCoarse, std::string("0.5")));
}

TEST(FarFromZero, NearModelsStayAsTheyAre) {
    const FileImport import = importOf("tower.ply", asPly<float>(tower({40, 0, 0})));
    EXPECT_TRUE(import.report.origin.zero.isZero());
    EXPECT_TRUE(import.report.warnings.empty());
    EXPECT_EQ(cornerOf(import, 0, 0)[0], double{static_cast<float>(tower({40, 0, 0})[0].corners[0][0])});
}

/// A tower in millimetres near zero, below nodes that turn it, bring it to metres and to its grid.
test::GltfBuilder gridFile(const FilePoint& at) {
    test::GltfBuilder file;
    std::vector<float> corners;
    for (const Face& face : tower({}, 1000))
        for (const FilePoint& p : face.corners)
            for (const double v : p) corners.push_back(static_cast<float>(v));
    const int positions = file.accessor(corners, "VEC3");
    const int mesh = file.mesh(test::Json::array({{{"attributes", {{"POSITION", positions}}}}}));
    const int tower = file.node({{"mesh", mesh}, {"rotation", {0, 0, 0.6, 0.8}}, {"name", "tower"}});
    const int metres = file.node({{"children", {tower}}, {"scale", {0.001, 0.001, 0.001}}});
    const int grid = file.node({{"children", {metres}}, {"translation", {at[0], at[1], at[2]}}});
    file.root["scenes"] = {{{"nodes", {grid}}}};
    return file;
}

TEST(FarFromZero, ChainsOfNodesAreDoubles) {
    const FileImport near = importOf("m.glb", gridFile({}).binary()),
                     far = importOf("m.glb", gridFile(kGrid).binary());
    EXPECT_TRUE(near.report.origin.zero.isZero());
    EXPECT_FALSE(far.report.origin.zero.isZero());
    EXPECT_TRUE(far.report.warnings.empty());
    ASSERT_EQ(far.model.triangles.size(), near.model.triangles.size());
    for (std::size_t t = 0; t < near.model.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(cornerOf(far, t, i)[axis], cornerOf(near, t, i)[axis] + kGrid[axis], 2e-6);
}

TEST(FarFromZero, LightsAndCamerasStandWithTheModel) {
    test::GltfBuilder file = gridFile(kGrid);
    file.root["extensionsUsed"] = {"KHR_lights_punctual"};
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 5}}};
    file.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    const FilePoint at{kGrid[0] + 1.5, kGrid[1] - 2.25, kGrid[2] + 9};
    const int light = file.node(
        {{"translation", {at[0], at[1], at[2]}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const int camera = file.node({{"translation", {at[0], at[1], at[2]}}, {"camera", 0}});
    file.root["scenes"][0]["nodes"] = {2, light, camera};
    const FileImport import = importOf("m.glb", file.binary());
    const LocalOrigin& zero = import.report.origin.zero;
    ASSERT_EQ(import.model.lights.size(), 1U);
    ASSERT_EQ(import.model.cameras.size(), 1U);
    EXPECT_EQ(import.model.lights[0].position, zero.local(at));
    EXPECT_EQ(import.model.cameras[0].eye, zero.local(at));
}

TEST(FarFromZero, CoarseFloatsOfMeshesAreSaid) {
    test::GltfBuilder file;
    std::vector<float> corners;
    for (const Face& face : tower(kGrid))
        for (const FilePoint& p : face.corners)
            for (const double v : p) corners.push_back(static_cast<float>(v));
    file.show({{"attributes", {{"POSITION", file.accessor(corners, "VEC3")}}}});
    const FileImport import = importOf("m.glb", file.binary());
    EXPECT_NE(test::warningsOf(import).find("0.5 units coarse"), std::string::npos)
        << test::warningsOf(import);
}

} // namespace
