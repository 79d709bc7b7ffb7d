// One image's bits, written down: the same with and without OpenMP, with any compiler's optimisation, on
// any processor. When shading or the kernels change on purpose, the numbers change with it.
#include "sample_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

TEST(Golden, TheSamplesOfThePictureHaveTheseBits) {
    const Frame frame =
        test::render(test::TracedScene(test::sampleScene()), test::sampleSettings(160, 120, 2), 0);
    EXPECT_EQ(test::hashOf(std::as_bytes(std::span(frame.radiance.pixels))), 0x7CFCF6AAFF3E3CB9U);
    EXPECT_EQ(test::hashOf(std::as_bytes(std::span(frame.covered))), 0x7E51AE4C726F115CU);
    const RenderSettings settings;
    const LdrImage image = test::develop(frame, settings, test::exposureFor(frame, settings.exposure));
    EXPECT_EQ(test::hashOf(std::as_bytes(std::span(image.pixels))), 0xCCFBBDA6E7520BECU);
}

} // namespace
} // namespace rtcore
