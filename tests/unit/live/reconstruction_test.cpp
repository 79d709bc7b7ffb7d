#include "rtcore/live/reconstruction.h"

#include "unit/render/sample_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rtcore {
namespace {

constexpr int kWidth = 531, kHeight = 70; // more than what is shown at a time, and no whole vectors
constexpr Colour kSurface{0.25F, 0.5F, 1}, kSpecular{2, 4, 8};

/// Samples in the middles of their pixels. Those of columns from kMirror on mirror, each with its own tint.
class Picture : public testing::Test {
  protected:
    static constexpr int kMirror = 200;

    Picture() {
        layers.mirrors = true;
        layers.resize(ImagePlane(CameraRays(test::sampleCamera(), kWidth, kHeight), kWidth, kHeight));
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const std::size_t i = at(x, y);
                const Vec3 position = positionOf(x, y, 5);
                layers.surface.set(i, {.position = position, .light = kSurface, .mirrors = x >= kMirror});
                layers.tints[i] = packLight(tintOf(x));
                layers.specular.set(i, {.position = positionOf(x, y, 9), .light = kSpecular});
                if (x < kMirror) layers.specular.forget(i);
            }
        }
        frame.radiance = HdrImage(kWidth, kHeight);
    }
    std::size_t at(int x, int y) const { return layers.surface.index(x, y); }
    Vec3 positionOf(int x, int y, float depth) const {
        const ImagePlane& plane = layers.surface.plane();
        return plane.eye + plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) * depth;
    }
    static Colour tintOf(int x) { return x % 2 == 0 ? Colour{0.5F, 0.25F, 0.125F} : Colour{0.125F, 0.5F, 0}; }
    static Colour wanted(int x) { return x < kMirror ? kSurface : kSurface + tintOf(x) * kSpecular; }
    void expectAll(int threads) {
        picture.show(layers, threads, frame);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const Colour seen = frame.radiance.at(x, y), should = wanted(x);
                ASSERT_NEAR(seen.r, should.r, 0.01F) << x << " " << y;
                ASSERT_NEAR(seen.g, should.g, 0.01F) << x << " " << y;
                ASSERT_NEAR(seen.b, should.b, 0.02F) << x << " " << y;
            }
        }
    }

    LiveLayers layers;
    Frame frame;
    Reconstruction picture;
};

TEST_F(Picture, ShowsEachSampleInTheMiddleOfItsPixel) {
    for (const int threads : {1, 2, 3}) expectAll(threads);
}

TEST_F(Picture, TintsTheMirroredLightOfOthersWhereThatIsMissing) {
    for (int y = 0; y < kHeight; ++y) {
        for (int x = kMirror; x < kWidth; ++x) {
            if (x > 470 || (x + 3 * y) % 11 != 0) layers.specular.forget(at(x, y));
        }
    }
    for (const int threads : {1, 2}) expectAll(threads);
}

TEST_F(Picture, ShowsWhatIsAroundWhereNothingIsKnown) {
    for (int y = 20; y < 40; ++y) {
        for (int x = 30; x < 150; ++x) layers.surface.forget(at(x, y));
    }
    expectAll(2);
}

TEST_F(Picture, WeighsSamplesByTheirDistanceFromThePixelsMiddle) {
    // A bright one a quarter of a pixel off its middle, to the right.
    const ImagePlane& plane = layers.surface.plane();
    const Vec3 aside = plane.eye + plane.towards(100.75F, 30.5F) * 5;
    layers.surface.set(at(100, 30), {.position = aside, .light = {8, 8, 8}});
    picture.show(layers, 1, frame);
    const auto falling = [](double x) { return (1 - x * x) * (1 - x * x); };
    const double here = falling(0.25), beside = falling(0.75), none = 1;
    const Colour right = frame.radiance.at(101, 30);
    EXPECT_NEAR(right.r, (none * 0.25 + beside * 8) / (none + beside), 0.02);
    EXPECT_NEAR(frame.radiance.at(100, 30).r, 8, 1e-3) << here;
    EXPECT_NEAR(frame.radiance.at(99, 30).r, 0.25F, 1e-3) << "more than a pixel away";
}

// Each would be seen for itself, as a stone of a mosaic.
TEST_F(Picture, MixesFewSamples) {
    constexpr float kSlope = 0.01F; // from column to column
    layers.mirrors = false;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float light = 1 + kSlope * static_cast<float>(x);
            layers.surface.set(at(x, y), {.position = positionOf(x, y, 5), .light = {light, light, light}});
            if ((x * 7 + y * 3) % 11 != 0) layers.surface.forget(at(x, y));
        }
    }
    picture.show(layers, 2, frame);
    double steps = 0;
    int count = 0;
    for (int y = 10; y < kHeight - 10; ++y) {
        for (int x = 10; x < kWidth - 10; ++x) {
            const auto here = static_cast<double>(frame.radiance.at(x, y).g);
            EXPECT_NEAR(here, 1 + static_cast<double>(kSlope) * x, 7 * kSlope);
            steps += std::abs(here - static_cast<double>(frame.radiance.at(x - 1, y).g));
            ++count;
        }
    }
    EXPECT_LT(steps / count, 1.6 * static_cast<double>(kSlope));
}

} // namespace
} // namespace rtcore
