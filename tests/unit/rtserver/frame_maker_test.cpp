#include "rtserver/frames/frame_maker.h"

#include "shown_room.h"

#include "rtcore/post/effects.h"
#include "rtcore/post/false_colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace {

using rtcore::RenderSettings;

RenderSettings hundredPixels() {
    RenderSettings settings;
    settings.width = 20;
    settings.height = 5;
    return settings;
}

TEST(FrameMaker, CountsTheMemoryOfTheListOfEffects) {
    EXPECT_EQ(rtserver::FrameMaker::bytesOf(hundredPixels(), true, 2), 21'400U) << "as docs/live.md says";
    RenderSettings bloom = hundredPixels(), denoised = hundredPixels();
    bloom.bloom.radius = 4;
    denoised.denoise.passes = 1;
    for (const bool live : {false, true}) {
        const std::size_t plain = rtserver::FrameMaker::bytesOf(hundredPixels(), live, 2);
        for (const RenderSettings& settings : {bloom, denoised}) {
            const std::size_t effects = 100 * rtcore::effectBytesPerPixel(settings);
            EXPECT_GT(effects, 0U);
            EXPECT_EQ(rtserver::FrameMaker::bytesOf(settings, live, 2), plain + (live ? 2 : 1) * effects)
                << "what is seen while a whole frame is rendered has effects of its own";
        }
    }
}

TEST(FrameMaker, CountsTheRowsOfFalseColoursOfEachThread) {
    RenderSettings coloured = hundredPixels();
    coloured.falseColours.on = true;
    const auto bytes = [&](int threads) { return rtserver::FrameMaker::bytesOf(coloured, false, threads); };
    const std::size_t rows = bytes(2) - bytes(1);
    EXPECT_GE(rows, 3 * sizeof(float) * 20 * rtcore::kFalseColourRows) << "three lists of rows";
    EXPECT_EQ(bytes(1) - rows, rtserver::FrameMaker::bytesOf(hundredPixels(), false, 1));
}

TEST(FrameMaker, HasMemoryForASmallFrame) {
    for (const bool live : {false, true})
        EXPECT_NO_THROW(rtserver::FrameMaker::requireMemory(hundredPixels(), live, 2));
}

class FramesOfAState : public test::ShownRoom {
  protected:
    rtserver::FrameMaker frames{1};
};

TEST_F(FramesOfAState, SayWhichRevisionTheyShow) {
    EXPECT_EQ(frames.revision(), 0U);
    EXPECT_TRUE(frames.stale(document));
    test::draw(frames, state);
    EXPECT_EQ(frames.revision(), document.revisions().revision());
    EXPECT_FALSE(frames.stale(document));
    const std::uint64_t drawn = frames.revision();
    switchLight(document, 1, false);
    EXPECT_TRUE(frames.stale(document));
    EXPECT_EQ(frames.revision(), drawn);
    test::draw(frames, state, rtserver::kCoarsest);
    EXPECT_FALSE(frames.stale(document)) << "coarse as it is";
    EXPECT_FALSE(frames.whole());
    frames.drop();
    EXPECT_TRUE(frames.stale(document));
    EXPECT_EQ(frames.revision(), 0U);
}

TEST_F(FramesOfAState, ThatAreLeftShowNothingNew) {
    test::draw(frames, state);
    const std::uint64_t drawn = frames.revision();
    walk.turn(10, 0);
    rtcore::RenderControl control;
    control.cancel = true;
    EXPECT_FALSE(frames.trace(state, {}, nullptr, control));
    EXPECT_EQ(frames.revision(), drawn);
    EXPECT_TRUE(frames.stale(document));
    EXPECT_FALSE(frames.image().empty()) << "the last one";
}

TEST_F(FramesOfAState, AdaptToAChangeButNotToAnotherScene) {
    document.assign({{"exposure.brighterSeconds", 1000.0F}, {"exposure.darkerSeconds", 1000.0F}});
    test::draw(frames, state);
    EXPECT_TRUE(frames.settled());
    const float bright = frames.exposure();
    switchLight(document, 1, false);
    test::draw(frames, state);
    EXPECT_FALSE(frames.settled());
    document.show(test::worldOf(test::makeRoom(0.05F)));
    test::draw(frames, state);
    EXPECT_TRUE(frames.settled());
    EXPECT_NE(frames.exposure(), bright);
}

constexpr rtserver::FrameDetail kLive{1, true, 0.1};

// However coarse an image is, and whatever its surfaces are.
TEST_F(FramesOfAState, AreExposedByTheLightAlone) {
    float exposures[3] = {};
    for (int i = 0; i < 3; ++i) {
        const float albedo = i == 2 ? 0.1F : 0.6F;
        document.show(test::worldOf(test::makeRoom(albedo)));
        document.assign({{"exposure.mode", "incident"}});
        rtserver::FrameMaker maker(1);
        test::draw(maker, state, i == 0 ? rtserver::kCoarsest : rtserver::FrameDetail());
        exposures[i] = maker.exposure();
    }
    EXPECT_EQ(exposures[0], exposures[1]);
    EXPECT_NEAR(exposures[2] / exposures[1], 1, 0.02) << "but for what mirrors or shines of itself";
}

TEST_F(FramesOfAState, LiveOnesBeginWithTheLightOfTheWholeOne) {
    state.frameSeconds = 0.03;
    test::draw(frames, state);
    walk.turn(1, 0);
    test::draw(frames, state, kLive);
    EXPECT_FALSE(frames.whole());
    EXPECT_FALSE(frames.stale(document));
    const auto pixels = static_cast<double>(frames.radiance().pixels.size());
    EXPECT_LT(frames.liveCost().samples, 0.3 * pixels);
    rtserver::FrameMaker without(1);
    test::draw(without, state);
    double difference = 0, light = 0;
    for (std::size_t i = 0; i < frames.radiance().pixels.size(); ++i) {
        const float truth = luminance(without.radiance().pixels[i]);
        difference += static_cast<double>(std::fabs(luminance(frames.radiance().pixels[i]) - truth));
        light += static_cast<double>(truth);
    }
    EXPECT_LT(difference, 0.15 * light);
}

TEST_F(FramesOfAState, LiveOnesKeepNoLightThatIsOffNow) {
    const auto brightness = [](const rtserver::FrameMaker& of) {
        double sum = 0;
        for (const rtcore::Colour& pixel : of.radiance().pixels) sum += static_cast<double>(luminance(pixel));
        return sum;
    };
    state.frameSeconds = 0.03;
    test::draw(frames, state);
    const double lit = brightness(frames);
    for (const int light : {1, 2}) switchLight(document, light, false);
    test::draw(frames, state, kLive);
    rtserver::FrameMaker without(1);
    test::draw(without, state);
    const double dark = brightness(without);
    ASSERT_LT(dark, 0.95 * lit);
    EXPECT_LT(brightness(frames), dark + 0.2 * (lit - dark));
}

TEST_F(FramesOfAState, StayLiveWhereALightThatIsSwitchedHardlyReaches) {
    rtcore::LoadedScene room = test::makeRoom();
    room.scene.lights.push_back(test::pointLight({2, 0.1F, -4}, 4e-4F));
    document.show(test::worldOf(std::move(room)));
    document.assign({{"width", 320}, {"height", 200}, {"exposure.mode", "fixed"}});
    state.frameSeconds = 0.03;
    test::draw(frames, state);
    const std::vector<rtcore::Colour> lit = frames.radiance().pixels;
    switchLight(document, 3, false);
    ASSERT_TRUE(frames.drawsLive(document));
    for (int frame = 0; frame < 3; ++frame) test::draw(frames, state, {1, true, 0.05});
    rtserver::FrameMaker without(1);
    test::draw(without, state);
    const auto brightest = [&](const std::vector<rtcore::Colour>& pixels) {
        float worst = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const float truth = luminance(without.radiance().pixels[i]);
            if (truth < 0.1F) continue; // beside the background samples of both are mixed
            worst = std::max(worst, std::fabs(luminance(pixels[i]) - truth) / truth);
        }
        return worst;
    };
    EXPECT_GT(brightest(lit), 0.01F) << "near the light";
    EXPECT_LT(brightest(frames.radiance().pixels), 0.3F * brightest(lit));
    switchLight(document, 1, false);
    EXPECT_FALSE(frames.drawsLive(document));
}

TEST_F(FramesOfAState, EightFramesAfterALightIsSwitchedThereAreNoGhostsOfIt) {
    document.assign({{"width", 320}, {"height", 200}, {"exposure.mode", "fixed"}});
    state.frameSeconds = 0.03;
    const auto truth = [&] {
        rtserver::FrameMaker whole(1);
        test::draw(whole, state);
        return whole.radiance().pixels;
    };
    test::draw(frames, state);
    switchLight(document, 1, false);
    ASSERT_FALSE(frames.drawsLive(document));
    test::draw(frames, state, {0.5, true});
    for (int frame = 2; frame <= 8; ++frame) {
        walk.turn(0.05, 0);
        ASSERT_TRUE(frames.drawsLive(document));
        test::draw(frames, state, {1, true, 0.05});
    }
    const std::vector<rtcore::Colour> shown = frames.radiance().pixels, off = truth();
    switchLight(document, 1, true);
    const std::vector<rtcore::Colour> on = truth();
    double light = 0, error = 0, wrong = 0, relit = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        const auto at = [i](const std::vector<rtcore::Colour>& pixels) {
            return static_cast<double>(luminance(pixels[i]));
        };
        if (std::fabs(at(on) - at(off)) < 0.1 * at(off)) continue;
        light += at(off);
        error += at(shown) - at(off);
        wrong += std::fabs(at(shown) - at(off));
        ++relit;
    }
    ASSERT_GT(relit, 1000);
    EXPECT_LT(std::fabs(error / light), 0.02);
    EXPECT_LT(wrong / light, 0.12);
}

TEST_F(FramesOfAState, LiveOnesGoOnFromAWholeOneThatWasLeft) {
    document.assign({{"width", 320}, {"height", 200}, {"exposure.mode", "fixed"}});
    state.frameSeconds = 0.03;
    rtserver::FrameMaker without(1);
    test::draw(without, state);
    const auto error = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < frames.radiance().pixels.size(); ++i)
            sum += static_cast<double>(
                std::fabs(luminance(frames.radiance().pixels[i] - without.radiance().pixels[i])));
        return sum;
    };
    test::draw(frames, state, rtserver::kCoarsest);
    walk.turn(0, 0);
    test::draw(frames, state, {1, true, 0.02});
    const double before = error();
    rtcore::RenderControl control;
    std::atomic<bool> over = false;
    std::jthread impatient([&] {
        while (!over && (control.tiles == 0 || control.tilesDone * 3 < control.tiles * 2))
            std::this_thread::yield();
        control.cancel = true;
    });
    const bool done = frames.trace(state, {}, nullptr, control);
    over = true;
    if (done) GTEST_SKIP() << "it was quicker";
    test::draw(frames, state, {1, true, 0});
    EXPECT_LT(error(), 0.75 * before);
}

TEST_F(FramesOfAState, KeepAFixedExposureWhileAWholeOneIsDrawn) {
    constexpr float kExposure = 0.3F;
    document.assign({{"width", 640},
                     {"height", 400},
                     {"antialiasing", 8},
                     {"exposure.mode", "fixed"},
                     {"exposure.value", kExposure}});
    test::draw(frames, state, rtserver::kCoarsest);
    int steps = 0, wrong = 0;
    std::atomic<bool> over = false;
    {
        const std::jthread watcher([&] {
            while (!over) {
                if (frames.underWay(document) == nullptr) continue;
                ++steps;
                wrong += frames.exposure() == kExposure ? 0 : 1;
            }
        });
        rtcore::RenderControl control;
        EXPECT_TRUE(frames.trace(state, {}, nullptr, control));
        over = true;
    }
    EXPECT_GE(steps, 3) << "the first ones are of the coarse frame alone";
    EXPECT_EQ(wrong, 0);
}

/// What is shown first leaves no trace in the frame.
TEST_F(FramesOfAState, AreShownAtOnceWhileTheirIndirectLightIsLearned) {
    document.assign({{"width", 60}, {"height", 40}, {"indirect.mode", "live"}});
    test::draw(frames, state);
    const rtcore::HdrImage alone = frames.radiance();
    walk.turn(30, 0);
    test::draw(frames, state, rtserver::kCoarsest);
    walk.turn(-30, 0);
    test::draw(frames, state, rtserver::kCoarsest);
    std::atomic<bool> over = false;
    {
        const std::jthread watcher([&] {
            while (!over) frames.underWay(document);
        });
        rtcore::RenderControl control;
        EXPECT_TRUE(frames.trace(state, {}, nullptr, control));
        over = true;
    }
    EXPECT_TRUE(frames.whole());
    EXPECT_EQ(frames.radiance().pixels, alone.pixels);
}

/// In the light that the walk knows a whole frame is not that of its view alone, and comes much sooner.
TEST_F(FramesOfAState, RestInTheLightOfTheWalkWhereThatIsEnough) {
    document.assign({{"width", 120}, {"height", 80}, {"indirect.mode", "live"}});
    state.frameSeconds = 0.03;
    for (int i = 0; i < 8; ++i) test::draw(frames, state, rtserver::kCoarsest);
    rtserver::FrameDetail detail;
    detail.indirect = rtserver::IndirectOf::Rest;
    test::draw(frames, state, detail);
    EXPECT_TRUE(frames.whole());
    EXPECT_FALSE(frames.exact());
    const auto meanOf = [](const rtcore::HdrImage& image) {
        double sum = 0;
        for (const rtcore::Colour& pixel : image.pixels) sum += rtcore::luminance(pixel);
        return sum / static_cast<double>(image.pixels.size());
    };
    const double known = meanOf(frames.radiance());
    test::draw(frames, state);
    EXPECT_TRUE(frames.exact());
    EXPECT_NEAR(known / meanOf(frames.radiance()), 1, 0.05);
}

/// What the walk knows goes on where parts are hidden and shown again.
TEST_F(FramesOfAState, InTheLightOfTheWalkFollowPartsThatAreHidden) {
    document.assign({{"width", 120}, {"height", 80}, {"indirect.mode", "live"}});
    state.frameSeconds = 0.03;
    for (int i = 0; i < 8; ++i) test::draw(frames, state, rtserver::kCoarsest);
    const auto meanOf = [](const rtcore::HdrImage& image) {
        double sum = 0;
        for (const rtcore::Colour& pixel : image.pixels) sum += rtcore::luminance(pixel);
        return sum / static_cast<double>(image.pixels.size());
    };
    for (const bool hides : {true, false}) {
        hideParts(document, hides ? std::make_shared<const std::vector<std::uint8_t>>(1, 1) : nullptr);
        test::draw(frames, state, rtserver::kCoarsest);
        rtserver::FrameDetail detail;
        detail.indirect = rtserver::IndirectOf::Rest;
        test::draw(frames, state, detail);
        const double known = meanOf(frames.radiance());
        test::draw(frames, state);
        EXPECT_NEAR(known / meanOf(frames.radiance()), 1, 0.02) << hides;
    }
}

TEST_F(FramesOfAState, AreLiveWhereThereIsLightOfAFrameBefore) {
    state.frameSeconds = 0.03;
    EXPECT_FALSE(frames.drawsLive(document)) << "there was none";
    test::draw(frames, state, rtserver::kCoarsest);
    EXPECT_TRUE(frames.drawsLive(document)) << "a coarse one is enough";
    walk.turn(1, 0);
    EXPECT_TRUE(frames.drawsLive(document));
    document.assign({{"exposure.key", 0.3F}});
    EXPECT_TRUE(frames.drawsLive(document));
    switchLight(document, 1, false);
    EXPECT_FALSE(frames.drawsLive(document)) << "it does not hold";
    test::draw(frames, state);
    EXPECT_TRUE(frames.drawsLive(document));
    document.assign({{"shadows", false}});
    EXPECT_FALSE(frames.drawsLive(document));
    test::draw(frames, state);
    rtcore::Camera camera = document.camera();
    camera.kind = rtcore::CameraKind::Orthographic;
    camera.orthographicWidth = 4;
    document.setCamera(camera);
    EXPECT_FALSE(frames.drawsLive(document)) << "of another projection";
    test::draw(frames, state, rtserver::kCoarsest);
    EXPECT_TRUE(frames.drawsLive(document));
    camera.orthographicWidth = 4.4F;
    document.setCamera(camera);
    EXPECT_TRUE(frames.drawsLive(document));
    camera.kind = rtcore::CameraKind::Perspective;
    document.setCamera(camera);
    EXPECT_FALSE(frames.drawsLive(document));
}

TEST_F(FramesOfAState, AreLiveInTheFullSizeWithoutPerspective) {
    state.frameSeconds = 0.03;
    rtcore::Camera camera = document.camera();
    camera.kind = rtcore::CameraKind::Orthographic;
    camera.orthographicWidth = 6;
    document.setCamera(camera);
    test::draw(frames, state);
    const int width = frames.image().width, height = frames.image().height;
    const rtcore::Vec3 aside = rtcore::normalize(rtcore::cross(camera.forward, camera.up));
    for (int step = 1; step <= 3; ++step) { // it moves, turns, and is magnified
        camera.eye += aside * 0.05F;
        camera.forward += aside * 0.01F;
        camera.orthographicWidth *= 0.99F;
        document.setCamera(camera);
        ASSERT_TRUE(frames.drawsLive(document)) << step;
        test::draw(frames, state, {.scale = 1, .cut = true, .newSamples = 0.2});
        EXPECT_TRUE(frames.detail().live());
        EXPECT_GT(frames.kept(), 0.7);
        EXPECT_EQ(frames.image().width, width);
        EXPECT_EQ(frames.image().height, height);
    }
    const auto mean = [&] {
        double sum = 0;
        for (const rtcore::Colour light : frames.radiance().pixels)
            sum += static_cast<double>(rtcore::luminance(light));
        return sum;
    };
    const double live = mean();
    test::draw(frames, state);
    EXPECT_NEAR(live / mean(), 1, 0.05);
}

} // namespace
