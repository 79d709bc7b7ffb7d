// Texels in blocks: exact where colours are close to each other, near everywhere, harmless whatever the
// bytes.
#include "rtcore/scene/block_encoder.h"

#include "support/random_numbers.h"

#include "rtcore/scene/image_summary.h"

#include <gtest/gtest.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace rtcore {
namespace {

using Texels = std::array<Rgba8, kBlockTexels>;

/// Codes of one channel, of a range of `range` at most that begins anywhere.
class Codes {
  public:
    Codes(test::Random& random, std::uint32_t range)
        : random_(random), range_(range), base_(random.index(256 - range)) {}
    std::uint8_t operator()() { return static_cast<std::uint8_t>(base_ + random_.index(range_ + 1)); }

  private:
    test::Random& random_;
    std::uint32_t range_, base_;
};

Texels texelsWithin(test::Random& random, std::array<std::uint32_t, 3> ranges) {
    Codes r(random, ranges[0]), g(random, ranges[1]), b(random, ranges[2]);
    Texels texels;
    for (Rgba8& p : texels) p = {r(), g(), b(), 255};
    return texels;
}

Texels decoded(const TexelBlock& block) {
    Texels texels;
    for (std::uint32_t i = 0; i < kBlockTexels; ++i) texels[i] = texelOf(block, i);
    return texels;
}

int difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

/// The largest difference of a code.
int difference(const Texels& a, const Texels& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, difference(a[i], b[i]));
    return largest;
}

TEST(TexelBlock, IsExactWhereTheRangesFitAMode) {
    test::Random random(1);
    for (const BlockMode& mode : kBlockModes) {
        if (mode.lumaChroma) continue;
        std::array<std::uint32_t, 3> ranges{};
        for (std::size_t c = 0; c < 3; ++c) ranges[c] = (1U << mode.bits[c]) - 1;
        for (int i = 0; i < 200; ++i) {
            const Texels texels = texelsWithin(random, ranges);
            ASSERT_EQ(decoded(encodeBlock(texels)), texels);
        }
    }
}

TEST(TexelBlock, IsExactForGreysAndTintsOfAWideRange) {
    test::Random random(2);
    for (int i = 0; i < 500; ++i) {
        Codes grey(random, 127);
        Codes tint(random, 3);
        const std::uint8_t r = tint(), b = tint();
        Texels texels;
        for (Rgba8& p : texels) {
            const int y = grey();
            const auto shifted = [&](int by) { return static_cast<std::uint8_t>(std::min(255, y + by % 4)); };
            p = {shifted(r), static_cast<std::uint8_t>(y), shifted(b), 255};
        }
        ASSERT_EQ(decoded(encodeBlock(texels)), texels) << i;
    }
}

TEST(TexelBlock, IsNearWhateverTheColours) {
    test::Random random(3);
    double sum = 0;
    int largest = 0;
    constexpr int kBlocks = 2000;
    for (int i = 0; i < kBlocks; ++i) {
        const Texels texels = texelsWithin(random, {255, 255, 255}), got = decoded(encodeBlock(texels));
        largest = std::max(largest, difference(texels, got));
        for (std::size_t t = 0; t < kBlockTexels; ++t) {
            const int red = texels[t].r - got[t].r;
            sum += red * red;
        }
    }
    EXPECT_LE(largest, 12);
    EXPECT_LE(sum / (kBlocks * kBlockTexels), 25.0) << "32.3 dB of noise";
}

TEST(TexelBlock, OfTwoColoursKeepsBoth) {
    for (const Rgba8 other : {Rgba8{255, 255, 255, 255}, Rgba8{255, 0, 0, 255}, Rgba8{0, 255, 0, 255},
                              Rgba8{0, 0, 255, 255}, Rgba8{255, 0, 255, 255}}) {
        Texels texels;
        texels.fill({0, 0, 0, 255});
        texels[5] = texels[10] = other;
        EXPECT_LE(difference(decoded(encodeBlock(texels)), texels), 5);
    }
}

TEST(TexelBlock, AnyBytesAreOpaqueTexels) {
    test::Random random(4);
    std::array<std::array<bool, 256>, 3> seen{};
    for (int i = 0; i < 5000; ++i) {
        TexelBlock block;
        for (std::uint64_t& row : block.rows)
            row = std::uint64_t{random.index(std::size_t{1} << 32U)} << 32U |
                  random.index(std::size_t{1} << 32U);
        if (i < 4) block.rows.fill(i % 2 == 0 ? ~std::uint64_t{0} : 0);
        for (const Rgba8 p : decoded(block)) {
            ASSERT_EQ(p.a, 255);
            seen[0][p.r] = seen[1][p.g] = seen[2][p.b] = true;
        }
    }
    for (const auto& channel : seen)
        EXPECT_EQ(std::ranges::count(channel, true), 256) << "clamped, not wrapped";
}

/// Waves of colour with an edge of noise.
LdrImage wavy(int width, int height) {
    test::Random random(5);
    LdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool noise = (x + y) % 64 < 3;
            const auto code = [&](int wave) {
                return static_cast<std::uint8_t>(noise ? random.index(256)
                                                       : 40U + static_cast<unsigned>(wave % 96));
            };
            image.at(x, y) = {code(x / 3), code(x / 5 + y / 4), code(y / 3), 255};
        }
    }
    return image;
}

#ifdef _OPENMP
TEST(BlockEncoder, OfAnyNumberOfThreadsGivesTheSameBits) {
    const LdrImage image = wavy(203, 118);
    const int threads = omp_get_max_threads();
    std::vector<TexelBlock> one, many;
    omp_set_num_threads(1);
    const double error = appendBlocks(image, one);
    omp_set_num_threads(5);
    EXPECT_EQ(appendBlocks(image, many), error);
    omp_set_num_threads(threads);
    EXPECT_EQ(one, many);
    EXPECT_GT(error, 0);
}
#endif

TEST(BlockEncoder, StoresRowsOfBlocksBehindWhatIsThere) {
    const LdrImage image = wavy(10, 7);
    std::vector<TexelBlock> blocks(2);
    appendBlocks(image, blocks);
    ASSERT_EQ(blocks.size(), 2U + 3 * 2);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 10; ++x) {
            const TexelBlock& block = blocks[static_cast<std::size_t>(2 + y / 4 * 3 + x / 4)];
            EXPECT_LE(
                difference(texelOf(block, static_cast<std::uint32_t>(y % 4 * 4 + x % 4)), image.at(x, y)), 12)
                << x << " " << y;
        }
    }
}

TEST(BlockEncoder, TellsTheMeanSquaredError) {
    const LdrImage image = wavy(64, 64);
    std::vector<TexelBlock> blocks;
    const double told = appendBlocks(image, blocks);
    double sum = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const Rgba8 wanted = image.at(x, y);
            const Rgba8 got = texelIn(
                blocks.data(), static_cast<std::uint32_t>((y / 4 * 16 + x / 4) * 16 + y % 4 * 4 + x % 4));
            for (const int d : {wanted.r - got.r, wanted.g - got.g, wanted.b - got.b}) sum += d * d;
        }
    }
    EXPECT_DOUBLE_EQ(told, sum / (64 * 64 * 3));
}

TEST(ImageSummary, OfBlocksIsThatOfTheirTexels) {
    const LdrImage image = wavy(10, 7);
    ModelBuffers buffers;
    appendBlocks(wavy(4, 4), buffers.blocks);
    appendBlocks(image, buffers.blocks);
    Texture texture{1, 10, 7};
    texture.storage = TextureStorage::Blocks;
    std::vector<Rgba8> texels;
    for (std::uint32_t y = 0; y < 7; ++y)
        for (std::uint32_t x = 0; x < 10; ++x)
            texels.push_back(texelOf(buffers.blocks[1 + y / 4 * 3 + x / 4], y % 4 * 4 + x % 4));
    const ImageSummary expected = summarise(texels), got = summarise(makeModel(std::move(buffers)), texture);
    EXPECT_EQ(got.meanColour, expected.meanColour);
    EXPECT_EQ(got.meanChannel, expected.meanChannel);
    EXPECT_FALSE(got.transparent);
    EXPECT_TRUE(got.dark);
}

} // namespace
} // namespace rtcore
