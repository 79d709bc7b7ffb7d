/// Frames of a scene that is edited while one walks on: after a few of them they are right, whatever was
/// edited. RT_EDITS sets how many edits (check-long.sh: 10,000, under sanitizers).
#include "rtserver/frames/frame_maker.h"

#include "shown_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

namespace {

class RandomEdits : public test::ShownRoom {
  protected:
    unsigned below(unsigned count) { return static_cast<unsigned>(random() % count); }
    bool either() { return below(2) == 0; }

    /// Never both off: little would be seen but a strip of the sky.
    void switchOneOfTwo() {
        const int light = static_cast<int>(below(2));
        switchLight(document, light + 1, std::nullopt);
        if (!lightIsOn(0) && !lightIsOn(1)) switchLight(document, 2 - light, true);
    }
    void edit() {
        switch (below(8)) {
        case 0:
        case 1:
            switchOneOfTwo();
            break;
        case 2:
            setEnvironment(document, static_cast<int>(below(2)));
            break;
        case 3:
            document.assign({{"shadows", either()}});
            break;
        case 4:
            document.assign({{"antialiasing", static_cast<int>(below(2) + 1)}});
            break;
        case 5:
            document.assign(
                {{"width", static_cast<int>(60 + below(60))}, {"height", static_cast<int>(40 + below(40))}});
            break;
        case 6:
            document.assign({{"exposure.key", 0.1F + 0.1F * static_cast<float>(below(4))}});
            break;
        default:
            look();
        }
    }
    /// From anywhere over the floor.
    void look() {
        rtcore::Camera camera = document.camera();
        std::uniform_real_distribution<float> between(-1, 1);
        camera.eye = {4 * between(random), 1.8F + 0.8F * between(random), 4 + 2 * between(random)};
        camera.forward = {0.5F * between(random), -0.3F + 0.2F * between(random), -1};
        document.setCamera(camera);
    }
    /// As the server would: a coarse frame where no light holds; sometimes a whole one, or a part of one.
    void drawNext(int frame) {
        walk.turn(0.05, 0);
        if (below(20) == 0) {
            test::draw(frames, state);
        } else if (below(20) == 0) {
            rtcore::RenderControl control;
            control.cancel = true;
            EXPECT_FALSE(frames.trace(state, {}, nullptr, control));
        }
        const bool live = frames.drawsLive(document);
        EXPECT_TRUE(live || frame == 0) << "one coarse frame is enough";
        const double scale = below(4) == 0 ? 0.75 : 1;
        test::draw(frames, state,
                   live ? rtserver::FrameDetail{scale, true, 0.05} : rtserver::FrameDetail{0.5, true});
    }
    /// Mean difference of the last frame from the whole one, of the mean light.
    double error() {
        test::draw(frames, state, {1, true, 0.05});
        document.assign({{"antialiasing", 1}}); // as live frames have it
        rtserver::FrameMaker whole(1);
        test::draw(whole, state);
        double wrong = 0, light = 0;
        for (std::size_t i = 0; i < whole.radiance().pixels.size(); ++i) {
            const auto is = static_cast<double>(luminance(whole.radiance().pixels[i]));
            wrong += std::fabs(static_cast<double>(luminance(frames.radiance().pixels[i])) - is);
            light += is;
        }
        return wrong / light;
    }

    rtserver::FrameMaker frames{1};
    std::mt19937 random{2718}; // always the same: what fails once can be looked at
};

TEST_F(RandomEdits, AreSeenWithinAFewFrames) {
    const char* const wanted = std::getenv("RT_EDITS");
    const int edits = wanted != nullptr ? std::atoi(wanted) : 60;
    constexpr int kFrames = 8;
    // One of 10,000 is above 0.12: a row of bright sky at the edge of the image that is not found at once.
    constexpr double kMax = 0.2, kMaxMean = 0.01;
    state.frameSeconds = 0.03;
    document.assign({{"width", 100}, {"height", 70}});
    double sum = 0;
    for (int i = 0; i < edits; ++i) {
        edit();
        for (int frame = 0; frame < kFrames - 1; ++frame) drawNext(frame);
        const double wrong = error();
        EXPECT_LT(wrong, kMax) << "after edit " << i;
        sum += wrong;
    }
    EXPECT_LT(sum / edits, kMaxMean);
    RecordProperty("meanError", std::to_string(sum / edits));
}

} // namespace
