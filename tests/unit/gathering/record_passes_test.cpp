// Radii that follow from what the passes of records tell.

#include "rtcore/gathering/record_passes.h"

#include "gathering_support.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

/// Records on a floor; the one in the middle finds so much more light than the others in each of four
/// passes, whose rays differ by `deviation`. Returns its radius over that of the others.
float radiusOfBrighter(float more, float deviation) {
    IrradianceCache cache;
    cache.clear({{-4, -4, -4}, {4, 4, 4}});
    RecordPasses passes;
    for (int i = 0; i < 9; ++i) {
        const Vec3 at{0.1F * static_cast<float>(i % 3 - 1), 0, 0.1F * static_cast<float>(i / 3 - 1)};
        ArrivingLight around;
        around.distance = 2;
        passes.add(cache, test::receiverAt(at, {0, 1, 0}, 0.01F), around, 0);
    }
    constexpr std::uint32_t kMiddle = 4, kOther = 0;
    for (int pass = 0; pass < 4; ++pass) {
        for (std::uint32_t number = 0; number < 9; ++number) {
            PassResult result;
            result.light.irradiance = (number == kMiddle ? 1 + more : 1) * Colour{1, 1, 1};
            result.deviation = deviation;
            result.inverseLengths = kPassRays / 2.0F;
            passes.enter(cache, number, result);
        }
    }
    return cache.record(kMiddle).radius / cache.record(kOther).radius;
}

TEST(RecordPasses, ShrinkWhereLightDiffersFromWhatIsAround) {
    EXPECT_LT(radiusOfBrighter(0.3F, 0.5F), 0.7F);
    EXPECT_EQ(radiusOfBrighter(0.05F, 0.5F), 1);
}

TEST(RecordPasses, DoNotTakeNoiseOfFewRaysForADifference) {
    EXPECT_EQ(radiusOfBrighter(0.3F, 6), 1) << "a small bright patch that some rays met";
    EXPECT_LT(radiusOfBrighter(0.3F, 1), 0.7F) << "even light";
}

} // namespace
} // namespace rtcore
