#include "rtserver/frame_maker.h"

#include "rtcore/post/effects.h"

#include <gtest/gtest.h>

namespace {

using rtcore::RenderSettings;

RenderSettings hundredPixels() {
    RenderSettings settings;
    settings.width = 20;
    settings.height = 5;
    return settings;
}

TEST(FrameMaker, CountsTheMemoryOfTheListOfEffects) {
    const std::size_t plain = rtserver::FrameMaker::bytesOf(hundredPixels());
    EXPECT_EQ(plain, 100 * (sizeof(rtcore::Colour) + sizeof(rtcore::Rgba8)));
    RenderSettings bloom = hundredPixels(), denoised = hundredPixels();
    bloom.bloom.radius = 4;
    denoised.denoise.passes = 1;
    for (const RenderSettings& settings : {bloom, denoised}) {
        EXPECT_EQ(rtserver::FrameMaker::bytesOf(settings),
                  plain + 100 * rtcore::effectBytesPerPixel(settings));
        EXPECT_GT(rtserver::FrameMaker::bytesOf(settings), plain);
    }
}

TEST(FrameMaker, HasMemoryForASmallFrame) {
    EXPECT_NO_THROW(rtserver::FrameMaker::requireMemory(hundredPixels()));
}

} // namespace
