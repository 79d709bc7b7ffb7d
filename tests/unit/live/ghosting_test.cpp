/// Nothing of the past stays where it is not any more.
#include "rtcore/live/live_renderer.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace rtcore {
namespace {

constexpr int kWidth = 320, kHeight = 200;
constexpr double kNew = 0.05; ///< of the pixels of a frame
constexpr float kDegree = 3.14159265F / 180;

/// A hall with walls of different brightness, a pillar in its middle and two lights.
Scene hall() {
    test::SceneBuilder b;
    const auto stone = [&](float albedo) { return b.material(test::matte(albedo)); };
    b.square({0, 0, 0}, {0, 1, 0}, 8, stone(0.4F));
    b.square({0, 4, 0}, {0, -1, 0}, 8, stone(0.8F));
    b.square({-6, 2, 0}, {1, 0, 0}, 8, stone(0.7F));
    b.square({6, 2, 0}, {-1, 0, 0}, 8, stone(0.25F));
    b.square({0, 2, -6}, {0, 0, 1}, 8, stone(0.5F));
    b.square({0, 2, 6}, {0, 0, -1}, 8, stone(0.6F));
    b.box({-0.4F, 0, -0.4F}, {0.4F, 4, 0.4F}, stone(0.6F));
    for (int i = 0; i < 5; ++i) { // blocks that throw shadows behind it
        const float x = -3 + 1.5F * static_cast<float>(i);
        b.box({x, 0, -4}, {x + 0.5F, 1 + 0.4F * static_cast<float>(i), -3.5F}, stone(0.5F));
    }
    b.scene.lights = {test::pointLight({-3, 3.5F, 2}, 40), test::pointLight({3, 3, -1}, 30)};
    b.scene.ambient = {0.05F, 0.05F, 0.05F};
    return b.finish();
}

Camera camera(Vec3 eye, float yaw) {
    Camera result;
    result.eye = eye;
    result.forward = {std::sin(yaw * kDegree), 0, -std::cos(yaw * kDegree)};
    result.horizontalFov = 70;
    return result;
}

class Ghosts : public testing::Test {
  protected:
    Ghosts() {
        settings.width = kWidth;
        settings.height = kHeight;
    }
    View view(const Camera& of) const { return {traced.scene, traced.tracer, of, settings}; }
    Frame whole(const Camera& of) const {
        FrameRenderer renderer;
        renderer.collectSeen(true);
        RenderControl unwatched{.threads = 1};
        Frame result;
        renderer.render(view(of), unwatched, result);
        return result;
    }
    void begin(const Camera& of) { live.seed(LiveRenderer::planeOf(view(of)), whole(of), 1); }
    void draw(const Camera& of) { ASSERT_TRUE(live.render(view(of), kNew, control, frame)); }
    /// Light is 2 % and its errors are 12 % of the mean at most, over all pixels that `counts`.
    template <typename Counts>
    void expectTruth(const Frame& truth, Counts&& counts) const {
        double sum = 0, off = 0, wrong = 0, pixels = 0;
        for (std::size_t i = 0; i < truth.radiance.pixels.size(); ++i) {
            if (!counts(i)) continue;
            const auto should = static_cast<double>(luminance(truth.radiance.pixels[i]));
            const double error = static_cast<double>(luminance(frame.radiance.pixels[i])) - should;
            sum += should;
            off += error;
            wrong += std::fabs(error);
            ++pixels;
        }
        EXPECT_GT(pixels, 300);
        EXPECT_LT(std::fabs(off / sum), 0.02) << pixels << " pixels";
        EXPECT_LT(wrong / sum, 0.12) << pixels << " pixels";
    }

    test::TracedScene traced{hall()};
    RenderSettings settings;
    RenderControl control{.threads = 1};
    LiveRenderer live;
    Frame frame;
};

TEST_F(Ghosts, FourFramesAfterAQuickTurnThereAreNone) {
    constexpr Vec3 kEye{-2, 1.7F, 3};
    begin(camera(kEye, 0));
    for (int step = 1; step <= 10; ++step) draw(camera(kEye, 9 * static_cast<float>(step)));
    Camera last;
    for (int step = 1; step <= 4; ++step) draw(last = camera(kEye, 90 + 0.07F * static_cast<float>(step)));
    expectTruth(whole(last), [](std::size_t) { return true; });
}

TEST_F(Ghosts, FourFramesAfterAStepPastAPillarThereAreNone) {
    const auto at = [](int step) {
        return camera({-0.25F + 0.1F * static_cast<float>(step), 1.7F, 2.5F}, 0);
    };
    begin(at(0));
    const Frame first = whole(at(0));
    for (int step = 1; step <= 5; ++step) draw(at(step));
    Camera last = at(5);
    for (int step = 1; step <= 4; ++step) {
        last.forward.x += 0.001F;
        draw(last);
    }
    // Only points that the pillar hid before count.
    const CameraRays rays(at(0), kWidth, kHeight);
    const ImagePlane before(rays, kWidth, kHeight);
    const Frame truth = whole(last);
    expectTruth(truth, [&](std::size_t i) {
        const Vec3 offset = truth.seen[i].position - before.eye;
        const float depth = dot(before.axis, offset);
        if (!(depth > 0)) return false;
        const int x = static_cast<int>(dot(before.column, offset) / depth),
                  y = static_cast<int>(dot(before.row, offset) / depth);
        if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return false;
        const std::size_t there = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
        return dot(before.axis, first.seen[there].position - before.eye) < 0.8F * depth;
    });
}

/// Root mean square of the change of what a display shows.
double change(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.radiance.pixels.size(); ++i) {
        const auto shown = [](Colour c) { return static_cast<double>(luminance(c) / (luminance(c) + 0.3F)); };
        const double d = shown(a.radiance.pixels[i]) - shown(b.radiance.pixels[i]);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.radiance.pixels.size()));
}

TEST_F(Ghosts, CreepingFlickersNoMoreThanWholeFramesDo) {
    const float pixel = 70.0F / kWidth;
    const auto at = [&](int step) { return camera({-2, 1.7F, 3}, 0.3F * pixel * static_cast<float>(step)); };
    begin(at(0));
    double seen = 0, truth = 0;
    Frame before = whole(at(0)), wholeBefore = before;
    for (int step = 1; step <= 12; ++step) {
        draw(at(step));
        Frame now = whole(at(step));
        seen += change(frame, before);
        truth += change(now, wholeBefore);
        before = frame;
        wholeBefore = std::move(now);
    }
    EXPECT_GT(seen, 0.1 * truth);
    EXPECT_LE(seen, truth);
}

} // namespace
} // namespace rtcore
