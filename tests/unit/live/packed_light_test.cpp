#include "rtcore/live/live_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace rtcore {
namespace {

TEST(PackedLight, IsWithinAPartOfItsLargestChannel) {
    for (const float scale : {1e-3F, 0.5F, 0.9999F, 1.0F, 37.0F, 60000.0F}) {
        const Colour light = Colour{1, 0.31F, 0.002F} * scale;
        const Colour kept = unpackLight(packLight(light));
        const float max = scale / 511;
        EXPECT_NEAR(kept.r, light.r, max);
        EXPECT_NEAR(kept.g, light.g, max);
        EXPECT_NEAR(kept.b, light.b, max);
        EXPECT_EQ(packLight(kept), packLight(light)) << "kept once, it stays as it is";
    }
}

TEST(PackedLight, OutOfRangeIsTheNearestThatIsInRange) {
    EXPECT_EQ(unpackLight(packLight({})), Colour{});
    EXPECT_EQ(unpackLight(packLight({-1, -2, -3})), Colour{});
    EXPECT_EQ(unpackLight(packLight({1e-9F, 0, 0})), Colour{});
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const Colour bright = unpackLight(packLight({kInfinite, 1e9F, 1}));
    EXPECT_EQ(bright.r, 65408);
    EXPECT_EQ(bright.g, 65408);
    const Colour broken = unpackLight(packLight({std::nanf(""), 2, 1}));
    EXPECT_EQ(broken, (Colour{0, 2, 1}));
}

TEST(LiveSamples, EachPixelOfASquareHasItsTurn) {
    std::set<std::uint32_t> turns;
    for (int y = 8; y < 72; ++y) {
        for (int x = 16; x < 80; ++x) turns.insert(turnOf(x, y));
    }
    EXPECT_EQ(turns.size(), kTurns);
    EXPECT_EQ(*turns.rbegin(), kTurns - 1);
}

} // namespace
} // namespace rtcore
