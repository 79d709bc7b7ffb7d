// Which images become blocks, and how near those are.
#include "rtcore/io/import/materials/image_storage.h"

#include "import_support.h"

#include "rtcore/io/images/image_file.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

using namespace rtcore;

constexpr int kLargeSide = 1024;
static_assert(kLargeSide * kLargeSide == static_cast<int>(kWorthBlocks));

/// Waves of colour, and an edge each 32 texels.
LdrImage waves(int width, int height) {
    LdrImage image(width, height);
    const auto wave = [](int i, int period) { return std::abs(i % (2 * period) - period) * 255 / period; };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int shade = (x / 32 + y / 32) % 2 == 0 ? 255 : 90;
            const auto code = [&](int value) { return static_cast<std::uint8_t>(value * shade / 255); };
            image.at(x, y) = {code(wave(x, 200)), code(wave(y, 150)), code(wave(x + 2 * y, 300)), 255};
        }
    }
    return image;
}

/// Red and green of a range around 128, blue of one that ends at 255: normals, unless `range` is large.
LdrImage noise(int range, int rangeOfBlue) {
    test::Random random(6);
    LdrImage image(kLargeSide, kLargeSide);
    const auto code = [&](int base, int size) {
        return static_cast<std::uint8_t>(base +
                                         static_cast<int>(random.index(static_cast<std::size_t>(size))));
    };
    for (Rgba8& p : image.pixels)
        p = {code(128 - range / 2, range), code(128 - range / 2, range), code(256 - rangeOfBlue, rangeOfBlue),
             255};
    return image;
}

void expectPlain(const LdrImage& image, const char* why) {
    ModelBuffers model;
    model.texels.resize(3);
    model.blocks.resize(2);
    const Texture stored = storeImage(image, model);
    EXPECT_EQ(stored.storage, TextureStorage::Texels) << why;
    EXPECT_EQ(stored.firstTexel, 3U);
    EXPECT_EQ(model.blocks.size(), 2U);
    ASSERT_EQ(model.texels.size(), 3 + image.pixels.size());
    EXPECT_TRUE(std::ranges::equal(std::span(model.texels).subspan(3), image.pixels)) << why;
}

bool comesInBlocks(const LdrImage& image) {
    ModelBuffers model;
    return storeImage(image, model).inBlocks();
}

/// The mean squared error of red and the largest one of a code.
void expectBlocksNear(const Model& model, const Texture& texture, const LdrImage& image) {
    ASSERT_TRUE(texture.inBlocks());
    double sum = 0;
    int largest = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t block =
                static_cast<std::size_t>(y / 4) * blocksOf(texture.width) + static_cast<std::size_t>(x / 4);
            const Rgba8 got = texelOf(model.blocks[texture.firstTexel + block],
                                      static_cast<std::uint32_t>(y % 4 * 4 + x % 4));
            const Rgba8 wanted = image.at(x, y);
            const int r = got.r - wanted.r, g = got.g - wanted.g, b = got.b - wanted.b;
            sum += r * r + g * g + b * b;
            largest = std::max({largest, std::abs(r), std::abs(g), std::abs(b)});
        }
    }
    EXPECT_LE(sum / (3.0 * image.width * image.height), 1);
    EXPECT_LE(largest, 4);
}

TEST(ImageStorage, LargeOpaqueImagesComeInBlocks) {
    const LdrImage image = waves(kLargeSide + 2, kLargeSide + 1);
    ModelBuffers model;
    model.blocks.resize(5);
    const Texture stored = storeImage(image, model);
    EXPECT_EQ(stored.firstTexel, 5U);
    EXPECT_TRUE(model.texels.empty());
    EXPECT_EQ(model.blocks.size(), 5U + 257 * 257);
    expectBlocksNear(makeModel(std::move(model)), stored, image);
}

TEST(ImageStorage, SmallAndTransparentOnesAndNoiseStayAsTheyAre) {
    expectPlain(waves(kLargeSide, kLargeSide - 1), "small");
    LdrImage clear = waves(kLargeSide, kLargeSide);
    clear.pixels[12345].a = 254;
    expectPlain(clear, "transparent");
    expectPlain(noise(256, 256), "noise");
}

TEST(ImageStorage, NormalsMustBeNearer) {
    EXPECT_TRUE(comesInBlocks(noise(30, 8))) << "exact";
    const LdrImage rough = noise(64, 16);
    EXPECT_FALSE(comesInBlocks(rough));
    LdrImage colours = rough; // the same errors, but no normals: their length is not 1
    for (Rgba8& p : colours.pixels) p.b = static_cast<std::uint8_t>(p.b - 120);
    EXPECT_TRUE(comesInBlocks(colours));
}

TEST(ImageStorage, TheImporterStoresSo) {
    const test::TemporaryFolder folder;
    const LdrImage large = waves(kLargeSide, kLargeSide), small = waves(8, 8);
    writeImage(folder / "large.png", large);
    writeImage(folder / "small.png", small);
    test::writeText(folder / "m.mtl", "newmtl a\nmap_Kd large.png\nnewmtl b\nmap_Kd small.png\n");
    test::writeText(folder / "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                                      "usemtl a\nf 1/1 2/2 3/1\nusemtl b\nf 1/1 2/2 3/1\n");
    const Model model = test::importFile(folder / "m.obj").model;
    ASSERT_EQ(model.textures.size(), 2U);
    expectBlocksNear(model, model.textures[0], large);
    EXPECT_FALSE(model.textures[1].inBlocks());
    EXPECT_TRUE(std::ranges::equal(model.texels, small.pixels));
}

} // namespace
