#include "rtcore/shading/texture_lookup.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <limits>

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
