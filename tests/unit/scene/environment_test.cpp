#include "rtcore/scene/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace rtcore {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr TexelFilter kFilters[] = {TexelFilter::Bilinear, TexelFilter::Nearest};

float distance(Colour a, Colour b) {
    return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

/// A smooth sky without any symmetry of the cube.
Colour sky(Vec3 direction) {
    const Vec3 d = normalize(direction);
    return {1 + 0.5F * d.x + 0.2F * d.y * d.z, 1 + 0.7F * d.y - 0.3F * d.x * d.x,
            1 + d.z * d.y * d.x + 0.1F * d.z};
}

std::array<HdrImage, 6> skyFaces(int n) {
    std::array<HdrImage, 6> faces;
    for (int face = 0; face < 6; ++face) {
        HdrImage& image = faces[static_cast<std::size_t>(face)] = HdrImage(n, n);
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const float s = (static_cast<float>(x) + 0.5F) / static_cast<float>(n);
                const float t = (static_cast<float>(y) + 0.5F) / static_cast<float>(n);
                image.at(x, y) = sky(cubeDirection(face, s, t));
            }
        }
    }
    return faces;
}

HdrImage skySphere(int height) {
    HdrImage image(2 * height, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const double phi = 2 * kPi * ((x + 0.5) / (2 * height) - 0.5), theta = kPi * (y + 0.5) / height;
            image.at(x, y) =
                sky({static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)),
                     static_cast<float>(-std::sin(theta) * std::cos(phi))});
        }
    }
    return image;
}

HdrImage noise(int w, int h, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0, 10);
    HdrImage image(w, h);
    for (Colour& c : image.pixels) c = {value(random), value(random), value(random)};
    return image;
}

std::array<HdrImage, 6> noiseFaces(int n) {
    std::array<HdrImage, 6> faces;
    for (unsigned i = 0; i < 6; ++i) faces[i] = noise(n, n, i + 1);
    return faces;
}

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return normalize({normal(random), normal(random), normal(random)});
}

struct KnownCoordinate {
    Vec3 direction;
    CubeCoordinate expected;
};

/// OpenGL's table, z turned round.
TEST(CubeCoordinates, AgreeWithOpenGl) {
    const KnownCoordinate known[] = {
        {{1, 0.5F, -0.25F}, {0, 0.625F, 0.25F}}, {{-0.3F, 1, 0.6F}, {2, 0.35F, 0.8F}},
        {{0.2F, -0.4F, -1}, {5, 0.4F, 0.7F}},    {{-1, 0.5F, -0.25F}, {1, 0.375F, 0.25F}},
        {{0.5F, -1, 0.25F}, {3, 0.75F, 0.375F}}, {{0.5F, 0.25F, 1}, {4, 0.75F, 0.375F}},
    };
    for (const KnownCoordinate& k : known) {
        const Vec3 d = k.direction;
        const CubeCoordinate c = cubeCoordinate(Vec3{d.x, d.y, -d.z} * 37.0F);
        EXPECT_EQ(c.face, k.expected.face);
        EXPECT_FLOAT_EQ(c.s, k.expected.s);
        EXPECT_FLOAT_EQ(c.t, k.expected.t);
    }
}

TEST(CubeCoordinates, DirectionsAreTheInverse) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.001F, 0.999F);
    for (int i = 0; i < 6000; ++i) {
        const int face = i % 6;
        const float s = unit(random), t = unit(random);
        const CubeCoordinate c = cubeCoordinate(cubeDirection(face, s, t));
        EXPECT_EQ(c.face, face);
        EXPECT_NEAR(c.s, s, 1e-6);
        EXPECT_NEAR(c.t, t, 1e-6);
    }
}

/// The middle of an edge texel's outer side shows half of it and half of its neighbour across the edge.
TEST(CubeMap, NeighboursAcrossEdgesAreTheRightTexels) {
    const std::array<HdrImage, 6> faces = noiseFaces(4);
    const Environment map = Environment::fromCube(faces, "noise");
    const Colour top = map.radiance(cubeDirection(0, 1.5F / 4, 0), TexelFilter::Bilinear);
    EXPECT_LT(distance(top, 0.5F * (faces[0].at(1, 0) + faces[2].at(3, 2))), 1e-5F);
    const Colour left = map.radiance(cubeDirection(0, 0, 1.5F / 4), TexelFilter::Bilinear);
    EXPECT_LT(distance(left, 0.5F * (faces[0].at(0, 1) + faces[4].at(3, 1))), 1e-5F);
}

TEST(CubeMap, TexelCentresAreExact) {
    const std::array<HdrImage, 6> faces = noiseFaces(4);
    const Environment map = Environment::fromCube(faces, "noise");
    EXPECT_EQ(map.images().front().width, 4 + 2) << "a border of one texel around it";
    EXPECT_TRUE(map.isCube());
    EXPECT_EQ(map.name(), "noise");
    for (int i = 0; i < 96; ++i) {
        const int face = i / 16, y = i / 4 % 4, x = i % 4;
        const Vec3 d =
            cubeDirection(face, (static_cast<float>(x) + 0.5F) / 4, (static_cast<float>(y) + 0.5F) / 4);
        const Colour texel = faces[static_cast<std::size_t>(face)].at(x, y);
        EXPECT_EQ(map.radiance(d, TexelFilter::Nearest), texel);
        EXPECT_LT(distance(map.radiance(d, TexelFilter::Bilinear), texel), 1e-5F);
    }
}

/// Two directions 1e-6 apart, on both sides of whatever lies between, differ by no more than a texel's slope
/// allows.
void expectNoSeam(const Environment& map, Vec3 direction, std::mt19937& random) {
    const Vec3 a = direction + 1e-6F * randomDirection(random),
               b = direction - 1e-6F * randomDirection(random);
    const float difference =
        distance(map.radiance(a, TexelFilter::Bilinear), map.radiance(b, TexelFilter::Bilinear));
    EXPECT_LT(difference, 1e-2F) << direction.x << ' ' << direction.y << ' ' << direction.z;
}

TEST(CubeMap, HasNoSeams) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> along(-1, 1);
    for (const int n : {1, 2, 5, 16}) {
        const Environment map = Environment::fromCube(noiseFaces(n), "noise");
        for (int i = 0; i < 3000; ++i) {
            const float first = i % 2 == 0 ? 1.0F : -1.0F, second = i % 4 < 2 ? 1.0F : -1.0F;
            Vec3 edge{first, second, first};
            if (i % 8 != 7) edge[i % 3] = along(random); // else a corner
            expectNoSeam(map, edge, random);
        }
    }
}

TEST(CubeMap, LargeFacesFindTheirNeighbours) {
    // Face +X black, the others white: along its edges the map must be half grey, whatever the rounding.
    const int n = 2048;
    std::array<HdrImage, 6> faces;
    faces.fill(HdrImage(n, n, kWhite));
    faces[0] = HdrImage(n, n);
    const Environment map = Environment::fromCube(std::move(faces), "large");
    for (int i = 0; i < n; ++i) {
        const float s = (static_cast<float>(i) + 0.5F) / static_cast<float>(n);
        EXPECT_NEAR(map.radiance(cubeDirection(0, s, 0), TexelFilter::Bilinear).r, 0.5F, 1e-3F) << i;
        EXPECT_NEAR(map.radiance(cubeDirection(0, 1, s), TexelFilter::Bilinear).r, 0.5F, 1e-3F) << i;
    }
}

TEST(CubeMap, RefusesOddFaces) {
    std::array<HdrImage, 6> faces = noiseFaces(4);
    faces[3] = HdrImage(4, 5);
    EXPECT_THROW(Environment::fromCube(faces, ""), std::invalid_argument);
    faces[3] = HdrImage(3, 3);
    EXPECT_THROW(Environment::fromCube(faces, ""), std::invalid_argument);
    EXPECT_THROW(Environment::fromCube({}, ""), std::invalid_argument);
    EXPECT_THROW(Environment::fromEquirectangular({}, ""), std::invalid_argument);
}

/// u and v as they are seen in an image whose red grows with u and whose green grows with v.
TEST(Equirectangular, KnownDirections) {
    const int w = 2000, h = 1000;
    HdrImage ramp(w, h);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            ramp.at(x, y) = {(static_cast<float>(x) + 0.5F) / w, (static_cast<float>(y) + 0.5F) / h, 0};
        }
    }
    const Environment map = Environment::fromEquirectangular(std::move(ramp), "ramp");
    EXPECT_EQ(map.images().front().width, w + 2);
    EXPECT_FALSE(map.isCube());
    const Colour a = map.radiance({1, 2, 3}, TexelFilter::Bilinear);
    EXPECT_NEAR(a.r, 0.948792F, 2e-6F);
    EXPECT_NEAR(a.g, 0.320491F, 2e-6F);
    const Colour b = map.radiance({10, 10, -10}, TexelFilter::Bilinear);
    EXPECT_NEAR(b.r, 0.625F, 2e-6F);
    EXPECT_NEAR(b.g, 0.304087F, 2e-6F);
}

TEST(Equirectangular, HasNoSeamsAtTheWrapNorAtThePoles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> height(-1, 1);
    for (const int h : {1, 2, 9, 32}) {
        const Environment map = Environment::fromEquirectangular(noise(2 * h, h, 7), "noise");
        for (int i = 0; i < 3000; ++i) {
            const float y = i % 3 == 0 ? height(random) : i % 3 == 1 ? 1000.0F : -1000.0F;
            const Vec3 d{1e-7F * height(random), y, std::fabs(height(random)) * (i % 3 == 0 ? 1.0F : 1e-7F)};
            if (d.z > 1e-9F) expectNoSeam(map, normalize(d), random);
        }
    }
}

TEST(Equirectangular, PolesShowTheMeanOfTheirRow) {
    HdrImage image = noise(8, 4, 11);
    Colour top, bottom;
    for (int x = 0; x < 8; ++x) {
        top += image.at(x, 0) / 8.0F;
        bottom += image.at(x, 3) / 8.0F;
    }
    const Environment map = Environment::fromEquirectangular(std::move(image), "noise");
    EXPECT_LT(distance(map.radiance({0, 1, 0}, TexelFilter::Bilinear), top), 1e-5F);
    EXPECT_LT(distance(map.radiance({0, -2, 0}, TexelFilter::Bilinear), bottom), 1e-5F);
}

TEST(Environments, ConstantMapsAreConstant) {
    const Colour c{0.3F, 20, 1e-4F};
    std::array<HdrImage, 6> faces;
    faces.fill(HdrImage(3, 3, c));
    Environment cube = Environment::fromCube(faces, "");
    cube.intensity = 2;
    const Environment sphere = Environment::fromEquirectangular(HdrImage(7, 5, c), "");
    std::mt19937 random(4);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 d = randomDirection(random) * 100.0F;
        for (const TexelFilter filter : kFilters) {
            const Colour a = cube.radiance(d, filter), b = sphere.radiance(d, filter);
            EXPECT_NEAR(a.g, 40, 2e-5F);
            EXPECT_NEAR(b.r, 0.3F, 1e-6F);
            EXPECT_NEAR(b.b, 1e-4F, 1e-9F);
        }
    }
}

TEST(Environments, BothKindsShowTheSameSky) {
    const Environment cube = Environment::fromCube(skyFaces(64), "");
    const Environment sphere = Environment::fromEquirectangular(skySphere(128), "");
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 d = randomDirection(random);
        for (const Environment* map : {&cube, &sphere}) {
            EXPECT_LT(distance(map->radiance(d, TexelFilter::Bilinear), sky(d)), 3e-3F);
            EXPECT_LT(distance(map->radiance(d, TexelFilter::Nearest), sky(d)), 5e-2F);
        }
    }
}

TEST(Environments, ExtremeDirectionsAreSafe) {
    const Environment cube = Environment::fromCube(noiseFaces(4), "");
    const Environment sphere = Environment::fromEquirectangular(noise(8, 4, 1), "");
    const float values[] = {0, -0.0F, 1e-45F, -1e-38F, 1, -1e30F, 3e38F};
    for (const float x : values) {
        for (const float y : values) {
            for (const float z : values) {
                if (x == 0 && y == 0 && z == 0) continue;
                for (const TexelFilter filter : kFilters) {
                    for (const Environment* map : {&cube, &sphere}) {
                        const Colour c = map->radiance({x, y, z}, filter);
                        EXPECT_TRUE(isFinite(c) && c.r >= -1e-5F && c.r <= 10.001F)
                            << x << ' ' << y << ' ' << z;
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace rtcore
