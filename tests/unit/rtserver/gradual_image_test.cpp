#include "rtserver/frames/gradual_image.h"

#include <gtest/gtest.h>

#include <chrono>

namespace {

using namespace std::chrono_literals;
using rtcore::HdrImage;
using rtcore::LdrImage;

constexpr int kSide = 48;

class Gradual : public testing::Test {
  protected:
    Gradual() {
        settings.width = settings.height = kSide;
        settings.dithering = false;
    }
    const LdrImage* stepAfter(std::chrono::milliseconds time) {
        now += time;
        return image.step(
            after,
            [this](float times) {
                brightening = times;
                return exposure;
            },
            now);
    }
    void begin() { image.begin(before, settings, exposure, 1, now); }
    static rtcore::Frame frameOf(int side, float grey) {
        rtcore::Frame frame;
        frame.radiance = {side, side, {grey, grey, grey}};
        frame.covered.assign(frame.radiance.pixels.size(), 255);
        return frame;
    }
    static int top(const LdrImage& shown) { return shown.at(kSide / 2, 0).r; }
    static int bottom(const LdrImage& shown) { return shown.at(kSide / 2, kSide - 1).r; }

    rtcore::RenderSettings settings;
    rtcore::Frame before = frameOf(kSide / 2, 0.1F);
    HdrImage after{kSide, kSide, {2, 2, 2}};
    float exposure = 1, brightening = 0; ///< the one it is given, the one it tells
    rtserver::GradualImage::Clock::time_point now;
    rtserver::GradualImage image;
};

TEST_F(Gradual, ShowsNothingBeforeAndAfterAFrame) {
    EXPECT_EQ(stepAfter(20ms), nullptr);
    begin();
    EXPECT_EQ(stepAfter(0ms), nullptr) << "what was seen is still there";
    image.end();
    EXPECT_EQ(stepAfter(20ms), nullptr);
}

TEST_F(Gradual, TilesComeInTwoSteps) {
    begin();
    const LdrImage* shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr) << "at the size of the frame";
    EXPECT_EQ(shown->width, kSide);
    const int dark = top(*shown);
    EXPECT_EQ(bottom(*shown), dark);
    image.finished().add({0, 0, kSide, kSide / 2});
    shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    const int half = top(*shown);
    EXPECT_GT(half, dark);
    EXPECT_EQ(bottom(*shown), dark);
    image.finished().add({0, kSide / 2, kSide, kSide / 2});
    shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_GT(top(*shown), half);
    EXPECT_EQ(bottom(*shown), half);
}

TEST_F(Gradual, FewTilesWaitForOthers) {
    begin();
    ASSERT_NE(stepAfter(20ms), nullptr);
    image.finished().add({0, 0, kSide / 2, 1});
    EXPECT_EQ(stepAfter(20ms), nullptr);
    image.finished().add({0, 1, kSide, 3});
    EXPECT_NE(stepAfter(0ms), nullptr);
    image.finished().add({0, 4, kSide / 2, 1});
    EXPECT_NE(stepAfter(260ms), nullptr) << "but not for long";
}

TEST_F(Gradual, TheExposureGoesOn) {
    begin();
    const LdrImage* shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    const int dark = top(*shown);
    exposure = 0.25F;
    shown = stepAfter(110ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_GT(top(*shown), dark);
}

TEST_F(Gradual, TheExposureHearsWhatIsFinished) {
    begin();
    ASSERT_NE(stepAfter(20ms), nullptr);
    EXPECT_FLOAT_EQ(brightening, 1);
    image.finished().add({0, 0, kSide, kSide});
    ASSERT_NE(stepAfter(20ms), nullptr);
    stepAfter(20ms);
    EXPECT_NEAR(brightening, 10.5F, 0.1F) << "half of what was seen, half of what follows";
    image.finished().add({0, 0, kSide, 1});
    ASSERT_NE(stepAfter(260ms), nullptr);
    stepAfter(20ms);
    EXPECT_NEAR(brightening, 20, 0.1F);
    before.covered.assign(before.covered.size(), 0);
    begin();
    ASSERT_NE(stepAfter(20ms), nullptr);
    image.finished().add({0, 0, kSide, kSide});
    ASSERT_NE(stepAfter(20ms), nullptr);
    stepAfter(20ms);
    EXPECT_FLOAT_EQ(brightening, 1) << "no surface is seen";
}

TEST_F(Gradual, ABetterImageTakesThePartOfThatBefore) {
    begin();
    const LdrImage* shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    const int dark = top(*shown);
    const rtcore::Frame better = frameOf(kSide, 0.4F);
    image.finished().add({0, 0, kSide, kSide});
    image.beginAgain(better, settings, 1);
    shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr) << "at once, as soon as steps may come";
    const int half = top(*shown);
    EXPECT_GT(half, dark);
    EXPECT_EQ(bottom(*shown), half);
    EXPECT_NEAR(brightening, 4, 0.1F) << "so many times what the exposure was for";
    EXPECT_EQ(stepAfter(20ms), nullptr) << "nothing of the frame is finished";
    image.finished().add({0, 0, kSide, kSide});
    shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_GT(top(*shown), half);
    stepAfter(20ms);
    EXPECT_NEAR(brightening, 12, 0.2F) << "half of it is seen";
}

TEST_F(Gradual, BeginsAgainAfterItsMemoryWasGivenBack) {
    begin();
    ASSERT_NE(stepAfter(20ms), nullptr);
    image.end();
    image.drop();
    EXPECT_EQ(stepAfter(20ms), nullptr);
    begin();
    const LdrImage* shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(shown->width, kSide);
}

TEST_F(Gradual, AnotherFrameBeginsWithWhatIsSeenThen) {
    begin();
    ASSERT_NE(stepAfter(20ms), nullptr);
    image.finished().add({0, 0, kSide, kSide});
    image.end();
    begin();
    const LdrImage* shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(top(*shown), bottom(*shown));
    image.finished().add({0, 0, kSide, kSide / 2});
    shown = stepAfter(20ms);
    ASSERT_NE(shown, nullptr);
    EXPECT_GT(top(*shown), bottom(*shown)) << "no tile of the frame before";
}

} // namespace
