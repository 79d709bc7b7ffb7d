#include "rtcore/io/images/environment_file.h"

#include "test_images.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::TemporaryFolder;

constexpr int kSide = 8;

Colour sky(Vec3 direction) {
    const Vec3 d = normalize(direction);
    return {1 + 0.5F * d.x, 1 + 0.6F * d.y, 1 + 0.7F * d.z};
}

Colour texel(int face, int x, int y) {
    return sky(
        cubeDirection(face, (static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide));
}

struct Place {
    int face, column, row;
    bool turned = false;
};

/// An image of squares, each showing a face of the sky.
HdrImage layOut(int columns, int rows, const std::vector<Place>& places) {
    HdrImage image(columns * kSide, rows * kSide, {-5, -5, -5});
    for (const Place& p : places) {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const Colour c = p.turned ? texel(p.face, kSide - 1 - x, kSide - 1 - y) : texel(p.face, x, y);
                image.at(p.column * kSide + x, p.row * kSide + y) = c;
            }
        }
    }
    return image;
}

void expectSky(const Environment& map) {
    EXPECT_TRUE(map.isCube());
    EXPECT_EQ(map.images().front().width, kSide + 2);
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < kSide * kSide; ++i) {
            const int x = i % kSide, y = i / kSide;
            const float s = (static_cast<float>(x) + 0.5F) / kSide,
                        t = (static_cast<float>(y) + 0.5F) / kSide;
            EXPECT_EQ(map.radiance(cubeDirection(face, s, t), TexelFilter::Nearest), texel(face, x, y))
                << face;
        }
    }
}

TEST(CubeFiles, WideCross) {
    const TemporaryFolder folder;
    writeHdrImage(folder / "night sky.pfm",
                  layOut(4, 3, {{2, 1, 0}, {1, 0, 1}, {4, 1, 1}, {0, 2, 1}, {5, 3, 1}, {3, 1, 2}}));
    const Environment map = loadCubeCross(folder / "night sky.pfm");
    expectSky(map);
    EXPECT_EQ(map.name(), "night sky");
}

TEST(CubeFiles, TallCross) {
    const TemporaryFolder folder;
    writeHdrImage(folder / "sky.pfm",
                  layOut(3, 4, {{2, 1, 0}, {1, 0, 1}, {4, 1, 1}, {0, 2, 1}, {3, 1, 2}, {5, 1, 3, true}}));
    expectSky(loadCubeCross(folder / "sky.pfm"));
}

TEST(CubeFiles, Strips) {
    const TemporaryFolder folder;
    writeHdrImage(folder / "row.pfm",
                  layOut(6, 1, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {4, 4, 0}, {5, 5, 0}}));
    writeHdrImage(folder / "column.pfm",
                  layOut(1, 6, {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {3, 0, 3}, {4, 0, 4}, {5, 0, 5}}));
    expectSky(loadCubeStrip(folder / "row.pfm"));
    expectSky(loadCubeStrip(folder / "column.pfm"));
}

std::array<std::filesystem::path, 6> writeFaces(const TemporaryFolder& folder) {
    std::array<std::filesystem::path, 6> paths;
    for (int face = 0; face < 6; ++face) {
        const auto i = static_cast<std::size_t>(face);
        paths[i] = folder / ("face" + std::to_string(face) + ".pfm");
        writeHdrImage(paths[i], layOut(1, 1, {{face, 0, 0}}));
    }
    return paths;
}

TEST(CubeFiles, SixFiles) {
    const TemporaryFolder folder;
    const Environment map = loadCubeFaces(writeFaces(folder));
    expectSky(map);
    EXPECT_EQ(map.name(), "face0");
}

TEST(EquirectangularFiles, EveryFormat) {
    const TemporaryFolder folder;
    const HdrImage image(8, 4, {0.25F, 0.5F, 4});
    for (const char* name : {"sky.hdr", "sky.exr", "sky.pfm"}) {
        if (!isWritableFormat(name)) continue;
        writeHdrImage(folder / name, image);
        const Environment map = loadEquirectangular(folder / name);
        EXPECT_FALSE(map.isCube());
        EXPECT_EQ(map.name(), "sky");
        EXPECT_EQ(map.radiance({1, 2, 3}, TexelFilter::Bilinear), (Colour{0.25F, 0.5F, 4})) << name;
    }
    writeImage(folder / "grey.png", LdrImage(8, 4, {188, 188, 188, 255}));
    EXPECT_NEAR(loadEquirectangular(folder / "grey.png").radiance({1, 0, 0}, TexelFilter::Nearest).r, 0.5029F,
                1e-4F);
}

TEST(EquirectangularFiles, NegativeValuesBecomeZero) {
    const TemporaryFolder folder;
    writeHdrImage(folder / "sky.pfm", HdrImage(2, 1, {-3, 1, -0.5F}));
    EXPECT_EQ(loadEquirectangular(folder / "sky.pfm").radiance({1, 0, 0}, TexelFilter::Nearest),
              (Colour{0, 1, 0}));
}

template <typename Load>
void expectRefused(Load load, const std::string& hint) {
    try {
        load();
        ADD_FAILURE() << "accepted; expected " << hint;
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
    }
}

TEST(EnvironmentFiles, WrongShapesSayWhatIsExpected) {
    const TemporaryFolder folder;
    const auto path = folder / "sky.pfm";
    for (const auto& [w, h] :
         {std::array{7, 5}, std::array{4, 4}, std::array{1, 1}, std::array{12, 8}, std::array{5, 1}}) {
        writeHdrImage(path, HdrImage(w, h));
        expectRefused([&] { loadEquirectangular(path); }, "twice as wide");
        expectRefused([&] { loadCubeCross(path); }, "4 x 3 or 3 x 4");
        expectRefused([&] { loadCubeStrip(path); }, "6 x 1 or 1 x 6");
    }
    std::array<std::filesystem::path, 6> paths = writeFaces(folder);
    writeHdrImage(paths[4], HdrImage(kSide, kSide + 1));
    expectRefused([&] { loadCubeFaces(paths); }, "face4");
    paths[2] = folder / "missing.png";
    EXPECT_THROW(loadCubeFaces(paths), FileError);
    EXPECT_THROW(loadEquirectangular(folder / "missing.hdr"), FileError);
}

} // namespace
} // namespace rtcore
