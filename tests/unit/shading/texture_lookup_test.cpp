#include "rtcore/shading/surface/texture_lookup.h"

#include "support/random_numbers.h"
#include "support/small_scene.h"
#include "support/steps.h"

#include "rtcore/shading/surface/surface.h"
#include "rtcore/shading/surface/texture_wave.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace rtcore {
namespace {

constexpr Rgba8 kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255}, kClear{255, 255, 255, 0};

/// Upper row red, green; lower row blue, clear white.
class TextureLookup : public testing::Test {
  protected:
    TextureLookup() {
        ModelBuffers buffers;
        buffers.materials.resize(1);
        buffers.texels = {{9, 9, 9, 9}, kRed, kGreen, kBlue, kClear, {128, 64, 200, 100}};
        buffers.textures = {{1, 2, 2}, {5, 1, 1}};
        model_ = makeModel(std::move(buffers));
    }
    TextureSample at(float u, float v) const { return sampleTexture(model_, model_.textures[0], {u, v}); }
    Model model_;
};

TEST_F(TextureLookup, TheLowerLeftCornerIsTheOrigin) {
    EXPECT_EQ(at(0.25F, 0.25F).colour, (Colour{0, 0, 1}));
    EXPECT_EQ(at(0.25F, 0.75F).colour, (Colour{1, 0, 0}));
    EXPECT_EQ(at(0.75F, 0.75F).colour, (Colour{0, 1, 0}));
    EXPECT_EQ(at(0.75F, 0.25F).alpha, 0);
    EXPECT_EQ(at(0.25F, 0.25F).alpha, 1);
}

TEST_F(TextureLookup, IsBilinearBetweenTheMiddlesOfTexels) {
    const Colour between = at(0.5F, 0.75F).colour; // red and green
    EXPECT_FLOAT_EQ(between.r, 0.5F);
    EXPECT_FLOAT_EQ(between.g, 0.5F);
    EXPECT_FLOAT_EQ(at(0.375F, 0.75F).colour.r, 0.75F);
    EXPECT_FLOAT_EQ(at(0.5F, 0.5F).alpha, 0.75F);
    EXPECT_FLOAT_EQ(at(0.25F, 0.625F).colour.r, 0.75F);
}

TEST_F(TextureLookup, Repeats) {
    EXPECT_FLOAT_EQ(at(0, 0.75F).colour.r, 0.5F); // red at its right, green across the edge
    EXPECT_FLOAT_EQ(at(0, 0.75F).colour.g, 0.5F);
    for (const float shift : {-3.0F, -1.0F, 1.0F, 100.0F}) {
        EXPECT_EQ(at(0.25F + shift, 0.75F).colour, at(0.25F, 0.75F).colour);
        EXPECT_EQ(at(0.375F, 0.25F + shift).colour, at(0.375F, 0.25F).colour);
    }
    EXPECT_NEAR(at(-1e-9F, 0.75F).colour.r, 0.5F, 1e-6F);
}

/// A row of four greys 0, 51, 102, 153, looked up at u.
float greyAt(float u, TextureWrap wrapU, TextureWrap wrapV = TextureWrap::Repeat, bool turned = false) {
    ModelBuffers buffers;
    buffers.materials.resize(1);
    for (const std::uint8_t grey : std::array<std::uint8_t, 4>{0, 51, 102, 153})
        buffers.texels.push_back({grey, grey, grey, 255});
    buffers.textures = {{0, 4, 1, wrapU, wrapV}};
    if (turned) buffers.textures = {{0, 1, 4, wrapV, wrapU}}; // from the top
    const Model model = makeModel(std::move(buffers));
    return sampleTexture(model, model.textures[0], turned ? Vec2{0.5F, 1 - u} : Vec2{u, 0.5F}).stored.x * 5;
}

TEST(TextureWraps, ClampToTheEdge) {
    for (const bool turned : {false, true}) {
        const auto at = [&](float u) {
            return greyAt(u, TextureWrap::ClampToEdge, TextureWrap::Repeat, turned);
        };
        for (const float u : {-1e9F, -1.0F, -0.1F, 0.0F, 0.1F, 0.125F}) EXPECT_EQ(at(u), 0) << u;
        for (const float u : {0.875F, 0.9F, 1.0F, 1.3F, 1e9F}) EXPECT_FLOAT_EQ(at(u), 3) << u;
        EXPECT_FLOAT_EQ(at(0.375F), 1);
        EXPECT_FLOAT_EQ(at(0.5F), 1.5F);
        EXPECT_TRUE(std::isfinite(at(std::numeric_limits<float>::infinity())));
        EXPECT_TRUE(std::isfinite(at(std::numeric_limits<float>::quiet_NaN())));
    }
}

TEST(TextureWraps, Mirror) {
    for (const bool turned : {false, true}) {
        const auto at = [&](float u) {
            return greyAt(u, TextureWrap::MirroredRepeat, TextureWrap::Repeat, turned);
        };
        for (const float u : {0.125F, 0.25F, 0.5F, 0.8125F}) {
            for (const float same : {-u, 2 - u, u + 2, u - 2, 4 - u, u - 100}) {
                EXPECT_NEAR(at(same), at(u), 1e-4F) << same;
            }
        }
        EXPECT_EQ(at(0), 0); // the texel beyond the edge is that of the edge
        EXPECT_FLOAT_EQ(at(1), 3);
        EXPECT_TRUE(std::isfinite(at(-std::numeric_limits<float>::infinity())));
    }
}

TEST(TextureWraps, EachAxisHasItsOwn) {
    EXPECT_FLOAT_EQ(greyAt(1.375F, TextureWrap::Repeat, TextureWrap::ClampToEdge), 1);
    EXPECT_FLOAT_EQ(greyAt(1.375F, TextureWrap::ClampToEdge, TextureWrap::MirroredRepeat), 3);
    EXPECT_FLOAT_EQ(greyAt(1.375F, TextureWrap::MirroredRepeat, TextureWrap::ClampToEdge), 2);
}

/// Replaces the last texture's texels by blocks of any bytes, the first of which belongs to no texture.
void putInBlocks(ModelBuffers& buffers, test::Random& random) {
    Texture& texture = buffers.textures.back();
    texture.storage = TextureStorage::Blocks;
    if (buffers.blocks.empty()) buffers.blocks.emplace_back();
    texture.firstTexel = buffers.blocks.size();
    const std::size_t count = std::size_t{blocksOf(texture.width)} * blocksOf(texture.height);
    for (std::size_t i = 0; i < count; ++i) {
        TexelBlock& block = buffers.blocks.emplace_back();
        for (std::uint64_t& row : block.rows)
            row = std::uint64_t{random.index(std::size_t{1} << 32U)} << 32U |
                  random.index(std::size_t{1} << 32U);
    }
}

constexpr std::array kWraps{TextureWrap::Repeat, TextureWrap::ClampToEdge, TextureWrap::MirroredRepeat};

/// The textures of the scene are 7 x 5 texels; `inBlocks`: which of the nine are in blocks, of any bytes.
void expectTheSameInVectorCode(std::uint32_t inBlocks) {
    test::Random random(3);
    test::SceneBuilder b;
    std::vector<Rgba8> texels;
    for (int i = 0; i < 35; ++i) {
        const auto code = [&] { return static_cast<std::uint8_t>(random.index(256)); };
        texels.push_back({code(), code(), code(), 255});
    }
    for (const TextureWrap u : kWraps) {
        for (const TextureWrap v : kWraps) {
            Material m = test::matte(0.7F);
            m.diffuseTexture = b.texture(7, 5, texels);
            b.buffers.textures.back().wrapU = u;
            b.buffers.textures.back().wrapV = v;
            if ((inBlocks >> m.diffuseTexture & 1U) != 0) putInBlocks(b.buffers, random);
            b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, b.material(m));
        }
    }
    for (Vec2& uv : b.buffers.texcoords) uv = {random.number(-4, 4), random.number(-4, 4)};
    b.buffers.texcoords.back() = {1e30F, std::numeric_limits<float>::infinity()};
    const Scene scene = b.finish();
    HitWave hits;
    constexpr std::uint32_t kHits = 4096;
    hits.resize(kHits);
    for (std::uint32_t i = 0; i < kHits; ++i) {
        hits.u[i] = random.number(0, 1);
        hits.v[i] = random.number(0, 1 - hits.u[i]);
        hits.triangle[i] = i < kHits / 2 ? 0 : random.index(9); // the first ones all repeat
    }
    for (std::uint32_t first = 0; first < kHits; first += kWaveBlock) {
        std::array<std::uint32_t, kWaveBlock> points{};
        std::iota(points.begin(), points.end(), first);
        std::array<Colour, kWaveBlock> albedo{};
        texturedAlbedos(scene, hits, points, albedo.data());
        for (std::size_t i = 0; i < kWaveBlock; ++i) {
            ASSERT_EQ(albedo[i], diffuseAt(scene, true, hits.hit(points[i]))) << points[i];
        }
    }
}

TEST(TextureWraps, AreTheSameInVectorCode) { expectTheSameInVectorCode(0); }

TEST(TextureBlocks, AreTheSameInVectorCode) {
    expectTheSameInVectorCode(0x1FF);
    expectTheSameInVectorCode(0x155);
}

TEST(TextureBlocks, AreLookedUpAsTheirTexels) {
    test::Random random(9);
    constexpr std::uint32_t kWidth = 11, kHeight = 6;
    ModelBuffers buffers;
    buffers.materials.resize(1);
    buffers.textures = {{0, kWidth, kHeight}};
    putInBlocks(buffers, random);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x)
            buffers.texels.push_back(texelOf(buffers.blocks[1 + y / 4 * 3 + x / 4], y % 4 * 4 + x % 4));
    buffers.textures.push_back({0, kWidth, kHeight});
    const Model model = makeModel(std::move(buffers));
    for (int i = 0; i < 2000; ++i) {
        const Vec2 uv{random.number(-2, 2), random.number(-2, 2)};
        const TextureSample a = sampleTexture(model, model.textures[0], uv);
        const TextureSample b = sampleTexture(model, model.textures[1], uv);
        ASSERT_EQ(a.colour, b.colour);
        ASSERT_EQ(a.stored, b.stored);
        ASSERT_EQ(a.alpha, 1);
        ASSERT_EQ(sampleColour(model, model.textures[0], uv), a.colour);
    }
}

TEST_F(TextureLookup, DecodesSrgbButNotAlphaAndMask) {
    const TextureSample s = sampleTexture(model_, model_.textures[1], {0.3F, 0.9F});
    EXPECT_FLOAT_EQ(s.colour.r, srgbDecode(128.0F / 255));
    EXPECT_FLOAT_EQ(s.colour.g, srgbDecode(64.0F / 255));
    EXPECT_FLOAT_EQ(s.colour.b, srgbDecode(200.0F / 255));
    EXPECT_FLOAT_EQ(s.alpha, 100.0F / 255);
    EXPECT_FLOAT_EQ(s.stored.x, 128.0F / 255);
}

TEST_F(TextureLookup, IsExactWhereAllTexelsAreEqual) {
    for (const float u : test::steps(-2.0F, 2.0F, 0.0137F)) {
        const TextureSample s = sampleTexture(model_, model_.textures[1], {u, 0.77F * u});
        ASSERT_EQ(s.alpha, 100.0F / 255);
        ASSERT_EQ(s.stored.x, 128.0F / 255);
    }
}

TEST_F(TextureLookup, AnyCoordinateIsSafe) {
    const float inf = std::numeric_limits<float>::infinity();
    for (const float bad :
         {inf, -inf, std::numeric_limits<float>::quiet_NaN(), 1e30F, -1e30F, 1e-45F, -1e-45F, 1e9F}) {
        for (const TextureSample& s : {at(bad, 0.5F), at(0.5F, bad), at(bad, bad)}) {
            EXPECT_TRUE(isFinite(s.colour)) << bad;
            EXPECT_GE(s.alpha, 0);
            EXPECT_LE(s.alpha, 1);
        }
    }
}

} // namespace
} // namespace rtcore
