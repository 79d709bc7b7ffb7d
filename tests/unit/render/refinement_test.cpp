#include "rtcore/render/refinement.h"

#include "sample_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace rtcore {
namespace {

using test::sampleSettings;
using test::TracedScene;

class Refining : public testing::Test {
  protected:
    bool refine(const RenderSettings& settings, int threads, const Refinement::Show& show = nullptr) {
        control.threads = threads;
        return refinement.render(renderer, {s.scene, s.tracer, test::sampleCamera(), settings}, control,
                                 frame, [&](const RefinementPass& pass, const Frame& picture) {
                                     passes.push_back(pass);
                                     if (show) show(pass, picture);
                                 });
    }

    const TracedScene s{test::sampleScene()};
    FrameRenderer renderer;
    Refinement refinement;
    RenderControl control;
    Frame frame;
    std::vector<RefinementPass> passes;
};

double samplesOf(const RefinementPass& pass) {
    const double side = static_cast<double>(pass.antialiasing) / pass.block;
    return side * side;
}

TEST(RefinementPlan, BecomesFinerAndEndsWithThePicture) {
    for (int antialiasing = 1; antialiasing <= 16; ++antialiasing) {
        const auto plan = planRefinement(sampleSettings(640, 480, antialiasing));
        ASSERT_GE(plan.size(), 2U);
        EXPECT_EQ(plan.front(), (RefinementPass{8, 1}));
        EXPECT_EQ(plan.back(), (RefinementPass{1, antialiasing}));
        double before = 0;
        for (std::size_t i = 0; i + 1 < plan.size(); ++i) {
            EXPECT_LT(samplesOf(plan[i]), samplesOf(plan[i + 1]));
            before += samplesOf(plan[i]);
        }
        EXPECT_LT(before, 0.1 * antialiasing * antialiasing);
    }
}

TEST_F(Refining, EndsWithTheBitsOfTheFrameRenderer) {
    for (const int antialiasing : {1, 2, 3, 5}) {
        const RenderSettings settings = sampleSettings(101, 67, antialiasing);
        const Frame expected = test::render(s, settings);
        for (const int threads : {1, 2, 0, 7}) {
            ASSERT_TRUE(refine(settings, threads));
            EXPECT_EQ(frame.radiance.pixels, expected.radiance.pixels) << antialiasing << " " << threads;
            EXPECT_EQ(frame.covered, expected.covered);
            EXPECT_EQ(frame.statistics.rays, expected.statistics.rays) << "of the image alone";
        }
    }
}

TEST_F(Refining, ShowsEachPassButTheLast) {
    const RenderSettings settings = sampleSettings(101, 67, 5);
    ASSERT_TRUE(refine(settings, 2, [&](const RefinementPass& pass, const Frame& picture) {
        EXPECT_EQ(picture.radiance.width, (101 + pass.block - 1) / pass.block);
        EXPECT_EQ(picture.radiance.height, (67 + pass.block - 1) / pass.block);
        for (const Colour c : picture.radiance.pixels) ASSERT_TRUE(isFinite(c));
    }));
    passes.push_back({1, 5});
    EXPECT_EQ(passes, planRefinement(settings));
}

TEST_F(Refining, CoarsePassesSeeTheMiddlesOfTheirSquares) {
    // They are the pixels of an image in which each stands for one square, if the squares fit.
    const RenderSettings settings = sampleSettings(96, 64);
    ASSERT_TRUE(refine(settings, 1, [&](const RefinementPass& pass, const Frame& picture) {
        if (pass.block == 1) return;
        const Frame small = test::render(s, sampleSettings(96 / pass.block, 64 / pass.block));
        int different = 0;
        for (std::size_t i = 0; i < small.radiance.pixels.size(); ++i) {
            const Colour a = small.radiance.pixels[i], b = picture.radiance.pixels[i];
            if (std::fabs(a.g - b.g) > 1e-3F * (1 + a.g)) ++different;
        }
        EXPECT_LE(different, static_cast<int>(small.radiance.pixels.size()) / 50 + 1) << pass.block;
    }));
    EXPECT_FALSE(passes.empty());
}

TEST_F(Refining, TellsEachTileOfTheLastPassOnce) {
    for (const int threads : {1, 3}) {
        ASSERT_TRUE(refine(sampleSettings(101, 67, 3), threads));
        std::vector<int> count(101 * 67);
        for (const PixelArea& tile : refinement.finishedTiles().take()) {
            for (int y = tile.top; y < tile.top + tile.rows; ++y) {
                for (int x = tile.left; x < tile.left + tile.columns; ++x)
                    ++count[static_cast<std::size_t>(y * 101 + x)];
            }
        }
        EXPECT_EQ(count, std::vector<int>(101 * 67, 1));
        EXPECT_TRUE(refinement.finishedTiles().take().empty());
    }
}

// Also for the thread sanitizer: what a finished tile holds is final.
TEST_F(Refining, AnotherThreadWatches) {
    const RenderSettings settings = sampleSettings(301, 203, 3);
    const Frame expected = test::render(s, settings);
    std::atomic<bool> over{false};
    int wrong = 0, backwards = 0;
    std::thread watcher([&] {
        double last = 0;
        for (bool more = true; more;) {
            more = !over;
            const double now = refinement.fraction(control);
            if (now < last || now > 1.000001) ++backwards;
            last = now;
            for (const PixelArea& tile : refinement.finishedTiles().take()) {
                for (int y = tile.top; y < tile.top + tile.rows; ++y) {
                    for (int x = tile.left; x < tile.left + tile.columns; ++x)
                        if (!(frame.radiance.at(x, y) == expected.radiance.at(x, y))) ++wrong;
                }
            }
            std::this_thread::yield();
        }
        EXPECT_NEAR(last, 1, 1e-6);
    });
    EXPECT_TRUE(refine(settings, 2));
    over = true;
    watcher.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(backwards, 0);
}

TEST_F(Refining, StopsInAnyPass) {
    const RenderSettings settings = sampleSettings(301, 203, 5);
    const std::size_t count = planRefinement(settings).size();
    for (std::size_t stopped = 1; stopped < count; ++stopped) {
        passes.clear();
        control.cancel = false;
        EXPECT_FALSE(refine(settings, 2, [&](const RefinementPass&, const Frame&) {
            if (passes.size() == stopped) control.cancel = true;
        }));
        EXPECT_EQ(passes.size(), stopped);
        EXPECT_TRUE(refinement.finishedTiles().take().empty());
    }
    control.cancel = false;
    EXPECT_TRUE(refine(sampleSettings(20, 10), 2)) << "and can be used again";
}

TEST_F(Refining, OddSizes) {
    for (const auto& [w, h, n] : {std::tuple{1, 1, 1}, {7, 9, 4}, {1, 40, 2}, {33, 8, 3}}) {
        ASSERT_TRUE(refine(sampleSettings(w, h, n), 2));
        EXPECT_EQ(frame.radiance.pixels, test::render(s, sampleSettings(w, h, n)).radiance.pixels);
    }
}

} // namespace
} // namespace rtcore
