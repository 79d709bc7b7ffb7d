// Surroundings with a letter on each side, as a panorama and as every kind of cube: what a camera sees of
// them.
#include "rtcore/io/images/environment_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/render/camera_rays.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace rtcore {
namespace {

using test::TemporaryFolder;

constexpr int kSide = 8;
/// No mirror image or turn of it is the same.
constexpr std::array<std::string_view, kSide> kLetter{"........", ".#####..", ".#......", ".####...",
                                                      ".#......", ".#......", ".#......", "........"};

/// Who looks that way, with `up` at the top of his image, reads the letter.
struct Side {
    Vec3 ahead, up;
};
/// In the order of the files of a cube map.
constexpr std::array<Side, 6> kSides{{{{1, 0, 0}, {0, 1, 0}},
                                      {{-1, 0, 0}, {0, 1, 0}},
                                      {{0, 1, 0}, {0, 0, 1}},
                                      {{0, -1, 0}, {0, 0, -1}},
                                      {{0, 0, -1}, {0, 1, 0}},
                                      {{0, 0, 1}, {0, 1, 0}}}};

/// Each side has a colour of its own.
Colour inkOf(std::size_t side, int column, int row) {
    const bool ink = kLetter[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
    const auto number = static_cast<float>(side + 1);
    return ink ? Colour{1, number / 8, 0} : Colour{0, number / 8, 1};
}

HdrImage pictureOf(std::size_t side) {
    HdrImage image(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) image.at(x, y) = inkOf(side, x, y);
    }
    return image;
}

struct Cell {
    std::size_t side;
    int column, row;
    bool onItsHead = false;
};

HdrImage layOut(int columns, int rows, const std::vector<Cell>& cells) {
    HdrImage image(columns * kSide, rows * kSide);
    for (const Cell& cell : cells) {
        const HdrImage picture = pictureOf(cell.side);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                image.at(cell.column * kSide + x, cell.row * kSide + y) =
                    cell.onItsHead ? picture.at(kSide - 1 - x, kSide - 1 - y) : picture.at(x, y);
            }
        }
    }
    return image;
}

/// The colour written in that direction on the cube around the eye.
Colour writtenIn(Vec3 direction) {
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        const auto [ahead, up] = kSides[i];
        const float depth = dot(direction, ahead);
        const Vec3 right = cross(ahead, up);
        const float x = dot(direction, right) / depth, y = -dot(direction, up) / depth;
        if (!(depth > 0) || std::fabs(x) > 1 || std::fabs(y) > 1) continue;
        const auto texel = [](float at) {
            return std::clamp(static_cast<int>((at + 1) / 2 * kSide), 0, kSide - 1);
        };
        return inkOf(i, texel(x), texel(y));
    }
    ADD_FAILURE() << "no side there";
    return {};
}

HdrImage panorama() {
    constexpr int kHeight = 128;
    HdrImage image(2 * kHeight, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < 2 * kHeight; ++x) {
            const double around = std::numbers::pi * ((x + 0.5) / kHeight - 1),
                         polar = std::numbers::pi * (y + 0.5) / kHeight;
            image.at(x, y) = writtenIn({static_cast<float>(std::sin(polar) * std::sin(around)),
                                        static_cast<float>(std::cos(polar)),
                                        static_cast<float>(-std::sin(polar) * std::cos(around))});
        }
    }
    return image;
}

/// Every side fills an image of 90 degrees.
void expectReadable(const Environment& map, const char* layout) {
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        Camera camera;
        camera.forward = kSides[i].ahead;
        camera.up = kSides[i].up;
        camera.horizontalFov = 90;
        const CameraRays rays(camera, kSide, kSide);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                EXPECT_EQ(map.radiance(ray.direction, TexelFilter::Nearest), inkOf(i, x, y))
                    << layout << ", side " << i << ", column " << x << ", row " << y;
            }
        }
    }
}

TEST(WritingInTheSky, ReadsForwardsInEveryLayout) {
    const TemporaryFolder folder;
    const auto write = [&](const char* name, const HdrImage& image) {
        writeHdrImage(folder / name, image);
        return folder / name;
    };
    expectReadable(loadEquirectangular(write("panorama.pfm", panorama())), "panorama");
    const HdrImage wide = layOut(4, 3, {{2, 1, 0}, {1, 0, 1}, {4, 1, 1}, {0, 2, 1}, {5, 3, 1}, {3, 1, 2}});
    expectReadable(loadCubeCross(write("wide.pfm", wide)), "wide cross");
    const HdrImage tall =
        layOut(3, 4, {{2, 1, 0}, {1, 0, 1}, {4, 1, 1}, {0, 2, 1}, {3, 1, 2}, {5, 1, 3, true}});
    expectReadable(loadCubeCross(write("tall.pfm", tall)), "tall cross");
    std::vector<Cell> row, column;
    std::array<std::filesystem::path, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) {
        row.push_back({i, static_cast<int>(i), 0});
        column.push_back({i, 0, static_cast<int>(i)});
        faces[i] = write(("face" + std::to_string(i) + ".pfm").c_str(), pictureOf(i));
    }
    expectReadable(loadCubeStrip(write("row.pfm", layOut(6, 1, row))), "row");
    expectReadable(loadCubeStrip(write("column.pfm", layOut(1, 6, column))), "column");
    expectReadable(loadCubeFaces(faces), "faces");
}

/// In a cross, what lies side by side is seen side by side.
TEST(WritingInTheSky, TheCrossHoldsTogether) {
    const TemporaryFolder folder;
    HdrImage image(4 * kSide, 3 * kSide);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            image.at(x, y) = {static_cast<float>(x), static_cast<float>(y), 0};
        }
    }
    writeHdrImage(folder / "ramp.pfm", image);
    const Environment map = loadCubeCross(folder / "ramp.pfm");
    // Columns grow to the right all around, rows downwards.
    float before = -1;
    for (int i = 0; i < 4 * kSide; ++i) {
        const double around = 2 * std::numbers::pi * ((i + 0.5) / (4 * kSide) - 0.375);
        const Colour seen =
            map.radiance({static_cast<float>(std::sin(around)), 0, static_cast<float>(-std::cos(around))},
                         TexelFilter::Nearest);
        EXPECT_GE(seen.r, before) << i;
        before = seen.r;
    }
    EXPECT_EQ(before, static_cast<float>(image.width - 1));
    before = -1;
    for (int i = 0; i < 3 * kSide; ++i) {
        const double down = 2 * std::numbers::pi * ((i + 0.5) / (4 * kSide) - 0.375);
        const Colour seen =
            map.radiance({0, static_cast<float>(-std::sin(down)), static_cast<float>(-std::cos(down))},
                         TexelFilter::Nearest);
        EXPECT_GE(seen.g, before) << i;
        before = seen.g;
    }
    EXPECT_EQ(before, static_cast<float>(image.height - 1));
}

} // namespace
} // namespace rtcore
