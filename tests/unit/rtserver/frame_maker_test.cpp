#include "rtserver/frame_maker.h"

#include "shown_room.h"

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

class FramesOfAState : public test::ShownRoom {
  protected:
    rtserver::FrameMaker frames{1};
};

TEST_F(FramesOfAState, SayWhichRevisionTheyShow) {
    EXPECT_EQ(frames.revision(), 0U);
    EXPECT_TRUE(frames.stale(state));
    test::draw(frames, state);
    EXPECT_EQ(frames.revision(), state.revisions().revision());
    EXPECT_FALSE(frames.stale(state));
    const std::uint64_t drawn = frames.revision();
    state.switchLight(0, false);
    EXPECT_TRUE(frames.stale(state));
    EXPECT_EQ(frames.revision(), drawn);
    test::draw(frames, state, rtserver::kCoarsest);
    EXPECT_FALSE(frames.stale(state)) << "coarse as it is";
    EXPECT_FALSE(frames.whole());
    frames.drop();
    EXPECT_TRUE(frames.stale(state));
    EXPECT_EQ(frames.revision(), 0U);
}

TEST_F(FramesOfAState, ThatAreLeftShowNothingNew) {
    test::draw(frames, state);
    const std::uint64_t drawn = frames.revision();
    state.turn(10, 0);
    rtcore::RenderControl control;
    control.cancel = true;
    EXPECT_FALSE(frames.trace(state, {}, nullptr, control));
    EXPECT_EQ(frames.revision(), drawn);
    EXPECT_TRUE(frames.stale(state));
    EXPECT_FALSE(frames.image().empty()) << "the last one";
}

TEST_F(FramesOfAState, AdaptToAChangeButNotToAnotherScene) {
    state.assign({{"exposure.brighterSeconds", 1000.0F}, {"exposure.darkerSeconds", 1000.0F}});
    test::draw(frames, state);
    EXPECT_TRUE(frames.settled());
    const float bright = frames.exposure();
    state.switchLight(0, false);
    test::draw(frames, state);
    EXPECT_FALSE(frames.settled());
    state.show(test::worldOf(test::makeRoom(0.05F)));
    test::draw(frames, state);
    EXPECT_TRUE(frames.settled());
    EXPECT_NE(frames.exposure(), bright);
}

} // namespace
