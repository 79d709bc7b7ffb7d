// Scenes whose textures are in blocks look as those whose textures are not, with the same bits by each
// instruction set.
#include "rtcore/scene/block_encoder.h"
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/one_frame.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rtcore {
namespace {

constexpr std::uint32_t kPavedSide = 256;

/// Stones of many colours and joints between them; a little noise on all.
LdrImage stones() {
    test::Random random(8);
    constexpr int kStone = 16, kStones = static_cast<int>(kPavedSide) / kStone;
    std::vector<Rgba8> colours;
    const auto code = [&] { return static_cast<std::uint8_t>(30 + random.index(180)); };
    for (int i = 0; i < kStones * kStones; ++i) colours.push_back({code(), code(), code(), 255});
    LdrImage image(kPavedSide, kPavedSide);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool joint = x % kStone == 0 || y % kStone == 0;
            const Rgba8 stone = colours[static_cast<std::size_t>(y / kStone * kStones + x / kStone)];
            const auto shade = static_cast<std::uint8_t>(random.index(24));
            const auto mixed = [&](std::uint8_t c) {
                return static_cast<std::uint8_t>(joint ? 20 : c + shade);
            };
            image.at(x, y) = {mixed(stone.r), mixed(stone.g), mixed(stone.b), 255};
        }
    }
    return image;
}

std::uint32_t addTexture(test::SceneBuilder& b, const LdrImage& image, bool inBlocks) {
    if (!inBlocks) return b.texture(kPavedSide, kPavedSide, image.pixels);
    Texture texture{b.buffers.blocks.size(), kPavedSide, kPavedSide};
    texture.storage = TextureStorage::Blocks;
    appendBlocks(image, b.buffers.blocks);
    b.buffers.textures.push_back(texture);
    return static_cast<std::uint32_t>(b.buffers.textures.size() - 1);
}

/// A floor of stones, a screen whose holes they are, a metal whose roughness they are, a mirror.
Scene paved(bool inBlocks) {
    test::SceneBuilder b;
    const std::uint32_t image = addTexture(b, stones(), inBlocks);
    Material floor = test::matte(0.8F), screen = test::matte(0.6F), metal = test::matte(0.5F);
    floor.diffuseTexture = screen.alphaTexture = screen.emissionTexture = image;
    screen.emission = {0.2F, 0.1F, 0.1F};
    metal.roughness = metal.metallic = 1;
    metal.metallicRoughnessTexture = image;
    b.square({0, -1, 0}, {0, 1, 0}, 6, b.material(floor));
    b.square({0.2F, 0.4F, 1}, {0, 0, 1}, 1, b.material(screen));
    b.sphere({-1.2F, 0, 0}, 1, 12, b.material(metal));
    b.sphere({1.3F, 0, -0.5F}, 1, 12, b.material(test::mirror(0.8F)));
    b.scene.ambient = {0.1F, 0.1F, 0.1F};
    b.scene.lights = {test::pointLight({2, 3, 3}, 30)};
    return b.finish();
}

class TexelBlocks : public testing::Test {
  protected:
    ~TexelBlocks() override { useInstructionSet("auto"); }
    static HdrImage image(bool inBlocks) {
        return test::render(test::TracedScene(paved(inBlocks)), test::sampleSettings(160, 120)).radiance;
    }
};

TEST_F(TexelBlocks, LookAsTexelsDo) {
    const HdrImage plain = image(false), blocks = image(true);
    double sum = 0, shown = 0;
    float largest = 0;
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        const Colour a = plain.pixels[i], b = blocks.pixels[i];
        const float difference = std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
        largest = std::max(largest, difference);
        sum += static_cast<double>(difference);
        shown += static_cast<double>(luminance(a));
    }
    EXPECT_GT(sum, 0) << "some blocks are not exact";
    EXPECT_LT(sum / shown, 0.005);
    EXPECT_LT(largest, 0.05F);
}

TEST_F(TexelBlocks, GiveTheSameBitsByEachInstructionSet) {
    ASSERT_TRUE(useInstructionSet("scalar"));
    const HdrImage expected = image(true);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_TRUE(std::ranges::equal(image(true).pixels, expected.pixels)) << name;
    }
}

} // namespace
} // namespace rtcore
