// Clouds of points: discs that meet, face along the surface, and stay small where points are alone.
#include "rtcore/io/import/scan/point_discs.h"
#include "rtcore/io/import/scan/scan_import.h"

#include "import_support.h"
#include "scan_files.h"
#include "support/damaged_text.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace rtcore;
using test::PlyFile;
using test::TemporaryFolder;

FileImport cloudOf(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    test::writeText(folder / name, text);
    auto import = importScan(folder / name, {});
    EXPECT_TRUE(import);
    return std::move(*import);
}

std::string cloudComplaint(const std::string& name, const std::string& text) {
    try {
        cloudOf(name, text);
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        return error.what();
    }
    return "none";
}

std::string cloudWarnings(const FileImport& import) {
    std::string all;
    for (const Sentence& warning : import.report.warnings) all += warning.english() + "\n";
    return all;
}

/// A plane of `side` rows and columns at distances of 1, z = 0.
std::string plane(int side, const std::string& behind = "") {
    std::string text;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) text += fmt::format("{} {} 0{}\n", x, y, behind);
    return text;
}

Vec3 discPosition(const FileImport& cloud, std::size_t triangle, std::size_t corner) {
    return cloud.model.vertices[cloud.model.triangles[triangle].v[corner]].position();
}

/// The farthest corner of the disc of a point from its middle.
float reachOf(const FileImport& cloud, std::size_t disc, std::size_t trianglesEach) {
    Vec3 lo{1e30F, 1e30F, 1e30F}, hi{-1e30F, -1e30F, -1e30F};
    for (std::size_t t = disc * trianglesEach; t < (disc + 1) * trianglesEach; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3 p = discPosition(cloud, t, c);
            for (int axis = 0; axis < 3; ++axis) {
                lo[axis] = std::min(lo[axis], p[axis]);
                hi[axis] = std::max(hi[axis], p[axis]);
            }
        }
    }
    return length(hi - lo) / 2;
}

bool covers(const FileImport& cloud, float x, float y) {
    for (std::size_t t = 0; t < cloud.model.triangles.size(); ++t) {
        bool inside = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3 a = discPosition(cloud, t, c), b = discPosition(cloud, t, (c + 1) % 3);
            const Vec3 n = cloud.model.normals[cloud.model.shading[t].v[0]];
            inside = inside && ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) * n.z >= 0;
        }
        if (inside) return true;
    }
    return false;
}

TEST(PointCloud, DiscsOfASurfaceMeet) {
    const FileImport cloud = cloudOf("a.xyz", plane(12));
    ASSERT_EQ(cloud.model.triangles.size(), 4U * 144);
    ASSERT_EQ(cloud.model.normals.size(), 144U);
    for (const Vec3 n : cloud.model.normals) EXPECT_NEAR(std::fabs(n.z), 1, 1e-5);
    for (float y = 2; y < 9; y += 0.13F)
        for (float x = 2; x < 9; x += 0.13F) EXPECT_TRUE(covers(cloud, x, y)) << x << " " << y;
    EXPECT_EQ(cloud.model.parts.size(), 1U);
    EXPECT_EQ(cloud.model.materials[0].diffuse, (Colour{0.6F, 0.6F, 0.6F}));
}

TEST(PointCloud, OutliersStaySmall) {
    const FileImport cloud = cloudOf("a.xyz", plane(12) + "5000 0 0\n5000.5 0 0\n0 -300 9\n");
    ASSERT_EQ(cloud.model.triangles.size(), 4U * 147);
    for (std::size_t i = 0; i < 147; ++i) EXPECT_LT(reachOf(cloud, i, 4), 5) << i;
}

/// Scattered ones, far from each other, which have no neighbours on the surface.
TEST(PointCloud, ManyOutliersStaySmallToo) {
    std::string stray;
    for (int i = 0; i < 20; ++i)
        stray += fmt::format("{} {} {}\n", i * 97 % 71 * 50, i * 31 % 17 * 90, 500 + i);
    const FileImport cloud = cloudOf("a.xyz", plane(12) + stray);
    for (std::size_t i = 0; i < 164; ++i)
        EXPECT_LT(reachOf(cloud, i, 4), 14) << i; // eight discs of the surface
}

TEST(PointCloud, NormalsOfTheFileCount) {
    PlyFile file{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}};
    file.attributes = {{"float", "nx", {0, 3}}, {"float", "ny", {0, 4}}, {"float", "nz", {0, 0}}};
    for (const bool bigEndian : {false, true}) {
        file.bigEndian = bigEndian;
        const FileImport cloud = cloudOf("a.ply", file.text());
        ASSERT_EQ(cloud.model.normals.size(), 5U);
        EXPECT_TRUE(test::near(cloud.model.normals[1], {0.6F, 0.8F, 0}));
        EXPECT_NEAR(std::fabs(cloud.model.normals[0].z), 1, 1e-5) << "zero is none";
        for (std::size_t t = 0; t < cloud.model.triangles.size(); ++t) {
            const Vec3 across = cross(discPosition(cloud, t, 1) - discPosition(cloud, t, 0),
                                      discPosition(cloud, t, 2) - discPosition(cloud, t, 0));
            EXPECT_GT(dot(across, cloud.model.normals[cloud.model.shading[t].v[0]]), 0) << t;
        }
    }
}

Colour pointColour(const FileImport& cloud, std::size_t point) {
    return cloud.model.colours.empty() ? cloud.model.materials[0].diffuse : cloud.model.colours[point];
}

TEST(PointCloud, ColumnsOfText) {
    const Colour red{1, 0, 0}, blue{0, 0, 1};
    const auto colours = [&](const std::string& name, const std::string& first, const std::string& second) {
        const FileImport cloud = cloudOf(name, first + "\n" + second + "\n0 5 0 " + "0 0 0 0 0 0 0\n");
        EXPECT_EQ(cloudWarnings(cloud), "") << first;
        return std::pair(pointColour(cloud, 0), pointColour(cloud, 1));
    };
    const std::pair both(red, blue);
    EXPECT_EQ(colours("a.xyz", "0 0 0 255 0 0", "1 0 0 0 0 255"), both);
    EXPECT_EQ(colours("a.xyz", "0 0 0 1 0 0", "1 0 0 .5 .5 0").first, red) << "of length 0.7, so no normals";
    EXPECT_EQ(colours("a.xyz", "0,0,0,65535,0,0", "1,0,0,0,0,65535"), both);
    EXPECT_EQ(colours("a.XYZ", "// X Y Z R G B\n0; 0; 0; 255; 0; 0", "1; 0; 0; 0; 0; 255"), both);
    EXPECT_EQ(colours("a.pts", "2\r\n0 0 0 -312 255 0 0\r", "1 0 0 99 0 0 255\r\n1"), both);
    EXPECT_EQ(colours("a.xyz", "0 0 0 255 0 0 -312", "1 0 0 0 0 255 99"), both);
    EXPECT_EQ(colours("a.xyz", "x y z r g b nx ny nz\n0 0 0 255 0 0 0 0 1", "1 0 0 0 0 255 0 1 0"), both);
    EXPECT_EQ(colours("a.xyz", "0 0 0 0 0 1 255 0 0", "1 0 0 0 1 0 0 0 255"), both);
    const FileImport grey = cloudOf("a.pts", "0 0 0 -100\n1 0 0 100\n0 1 0 0\n");
    EXPECT_EQ(pointColour(grey, 0), Colour{});
    EXPECT_EQ(pointColour(grey, 1), kWhite);
    EXPECT_TRUE(test::near(discPosition(cloudOf("a.xyz", "1,5 2,5 3,5\n"), 0, 0), {1.5F, 2.5F, 3.5F}, 2));
}

TEST(PointCloud, WhatIsLeftOutIsSaid) {
    const FileImport cloud = cloudOf("a.xyz", plane(3) + "1 1 0\nnan 0 0\n7 7\nhere 1 2\n1e13 0 0\n");
    EXPECT_EQ(cloud.model.triangles.size(), 4U * 9);
    const std::string warnings = cloudWarnings(cloud);
    EXPECT_NE(warnings.find("'a.xyz', line 12: '7 7' is not understood and passed over, as is 1 line more"),
              std::string::npos)
        << warnings;
    EXPECT_NE(warnings.find("2 of 12 points are left out: their coordinates"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("1 of 12 points are left out: they lie where others do"), std::string::npos)
        << warnings;
}

TEST(PointCloud, FewPoints) {
    for (const char* const text : {"0 0 0\n", "0 0 0\n0 0 0\n", "0 0 0\n1 0 0\n", "0 0 0\n1 0 0\n2 0 0\n",
                                   "1e12 0 0\n-1e12 0 0\n", "0 0 0\n1e-25 0 0\n0 1e-25 0\n"}) {
        const FileImport cloud = cloudOf("a.xyz", text);
        EXPECT_GE(cloud.model.triangles.size(), 4U) << text;
        for (const Vec3 n : cloud.model.normals) EXPECT_NEAR(length(n), 1, 1e-4) << text;
        for (const Vertex& v : cloud.model.vertices) EXPECT_TRUE(std::isfinite(length(v.position()))) << text;
    }
}

TEST(PointCloud, WhatCannotBeIsRefused) {
    EXPECT_NE(cloudComplaint("a.xyz", "3\nwater\nO 0 0 0\nH 1 0 0\nH 0 1 0\n").find("it is a molecule"),
              std::string::npos);
    EXPECT_NE(cloudComplaint("a.pts", "version: 1\nn_points: 68\n{\n1 2\n}\n").find("it holds no points"),
              std::string::npos);
    EXPECT_NE(cloudComplaint("a.xyz", "nan nan nan\n").find("are no numbers"), std::string::npos);
    const std::string many =
        "ply\nformat binary_little_endian 1.0\nelement vertex 10000001\nproperty float x\n"
        "property float y\nproperty float z\nend_header\n";
    EXPECT_NE(cloudComplaint("a.ply", many)
                  .find("it is a cloud of 10000001 points, more than the 10000000 that are shown"),
              std::string::npos);
    EXPECT_NO_THROW(refuseManyPoints(kMaxPoints, 0));
    EXPECT_THROW(refuseManyPoints(1'000'000, 1'000'000), FileError);
}

std::string randomCloud(int points) {
    std::mt19937 random(5);
    std::string text;
    for (int i = 0; i < points; ++i) {
        const auto next = [&] { return static_cast<double>(random() % 4096) / 64; };
        text +=
            fmt::format("{} {} {} {} {} {}\n", next(), next(), next(), random() % 256, random() % 256, 256);
    }
    return text;
}

/// Neighbours by looking at all points.
TEST(PointCloud, DiscsReachLessFarThanTheSixthNeighbour) {
    const std::string text = randomCloud(700);
    const FileImport cloud = cloudOf("a.xyz", text);
    ASSERT_EQ(cloud.model.triangles.size(), 4U * 700);
    std::vector<Vec3> centres;
    for (std::size_t i = 0; i < 700; ++i) {
        Vec3 sum;
        for (std::size_t c = 0; c < 6; ++c) sum = sum + cloud.model.vertices[i * 6 + c].position();
        centres.push_back(sum * (1.0F / 6));
    }
    for (std::size_t i = 0; i < centres.size(); ++i) {
        std::vector<float> distances;
        for (std::size_t k = 0; k < centres.size(); ++k)
            if (k != i) distances.push_back(length(centres[k] - centres[i]));
        std::ranges::nth_element(distances, distances.begin() + 5);
        const float corner = length(cloud.model.vertices[i * 6].position() - centres[i]);
        EXPECT_LE(corner, distances[5] * 0.84F) << i;
    }
}

TEST(PointCloud, ThreadsMakeNoDifference) {
    const TemporaryFolder folder;
    test::writeText(folder / "a.xyz", randomCloud(60'000));
    const auto read = [&](int threads) {
        ImportOptions options;
        options.threads = threads;
        return test::importFile(folder / "a.xyz", options);
    };
    const ImportedModel one = read(1), four = read(4);
    EXPECT_TRUE(std::ranges::equal(one.model.mesh.vertices, four.model.mesh.vertices));
    EXPECT_TRUE(std::ranges::equal(one.model.mesh.normals, four.model.mesh.normals));
    EXPECT_EQ(one.report, four.report);
    EXPECT_EQ(one.report.origin.format, "Point cloud (XYZ, PTS)");
}

TEST(PointCloud, FieldCases) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path path = std::filesystem::path(scenes) / "field3/ply/points.ply";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no field cases";
    const auto cloud = importScan(path, {});
    ASSERT_TRUE(cloud);
    EXPECT_EQ(cloud->model.triangles.size(), 20U);
    EXPECT_EQ(cloud->model.colours[0], (Colour{1, 0, 0}));
}

/// Whatever the bytes: a sound model or a FileError. More of them: RT_MUTATIONS.
TEST(PointCloud, DamagedFilesAreSoundOrRefused) {
    static constexpr std::array<std::string_view, 14> kTokens{
        "\n",   "\r",          ",", ";",       "1e999", "-nan", "1e-45",
        "1e12", "99999999999", "#", "0 0 0\n", "255",   "//",   "\0\xFF"};
    const std::string text = plane(3, " 9 200 3") + "0 0 9 1 2 3 0 0 1\n";
    PlyFile file{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}};
    file.attributes = {{"float", "nx", {0, 3}}, {"uchar", "red", {0, 3}}};
    test::DamagedText texts({text}, kTokens, 31), plys({file.text()}, kTokens, 32);
    const TemporaryFolder folder;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const std::string name = i % 3 == 0 ? "a.xyz" : i % 3 == 1 ? "a.pts" : "a.ply";
        test::writeText(folder / name, i % 3 == 2 ? plys.next() : texts.next());
        try {
            const auto cloud = importScan(folder / name, {});
            if (!cloud) continue;
            for (const Triangle& t : cloud->model.triangles)
                for (const std::uint32_t v : t.v) ASSERT_LT(v, cloud->model.vertices.size());
            for (const Vec3 n : cloud->model.normals) ASSERT_NEAR(length(n), 1, 1e-3);
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData) << error.what();
        }
    }
}

} // namespace
