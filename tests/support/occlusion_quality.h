/// How far images by few rays of ambient occlusion are from one by very many.
#pragma once

#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace test {

/// Root mean square errors against the reference, of radiance 0..1.
struct OcclusionErrors {
    double pixels = 0;
    double blurred = 0; ///< of means over 5 x 5 pixels (binomial): what an eye sees of bands and blotches
};

/// A scene lit by nothing but what is occluded.
class OcclusionQuality {
  public:
    OcclusionQuality(rtcore::Scene scene, const rtcore::RayTracer& tracer, const rtcore::Camera& camera)
        : scene_(std::move(scene)), tracer_(tracer), camera_(camera) {
        scene_.lights.clear();
        scene_.background = {};
        scene_.ambient = {};
        for (rtcore::Material& m : scene_.materials) {
            m = rtcore::Material{};
            m.diffuse = {1, 1, 1};
        }
        reference_ = render(rtcore::OcclusionPattern::Rotated, 1024);
        smoothReference_ = blur(reference_);
    }

    OcclusionErrors measure(rtcore::OcclusionPattern pattern, int samples) const {
        const rtcore::HdrImage picture = render(pattern, samples);
        return {distance(picture, reference_), distance(blur(picture), smoothReference_)};
    }

    /// The pattern that turns from point to point is nearer to the truth than a random one, and, once noise
    /// has evened out, nearer than one that is the same for all points, whose error is bands.
    void expectRotatedIsBest(const std::string& name) const {
        using rtcore::OcclusionPattern;
        for (const int samples : {7, 9}) {
            const OcclusionErrors rotated = measure(OcclusionPattern::Rotated, samples);
            const OcclusionErrors regular = measure(OcclusionPattern::Regular, samples);
            const OcclusionErrors random = measure(OcclusionPattern::Random, samples);
            std::printf("%s, %d rays: error rotated %.4f (blurred %.4f), regular %.4f (%.4f), random %.4f "
                        "(%.4f)\n",
                        name.c_str(), samples, rotated.pixels, rotated.blurred, regular.pixels,
                        regular.blurred, random.pixels, random.blurred);
            EXPECT_LT(rotated.pixels * rotated.pixels, 0.5 * random.pixels * random.pixels) << name;
            EXPECT_LT(rotated.blurred, 0.6 * random.blurred) << name;
            EXPECT_LT(rotated.blurred, 0.6 * regular.blurred) << name;
        }
    }

  private:
    rtcore::HdrImage render(rtcore::OcclusionPattern pattern, int samples) const {
        rtcore::RenderSettings settings;
        settings.width = 160;
        settings.height = 120;
        settings.ambientOcclusion.on = true;
        settings.ambientOcclusion.light = 1;
        settings.ambientOcclusion.samples = samples;
        settings.ambientOcclusion.pattern = pattern;
        rtcore::RenderControl control{.threads = 0};
        rtcore::Frame frame;
        test::renderFrame({scene_, tracer_, camera_, settings}, control, frame);
        return std::move(frame.radiance);
    }

    static double distance(const rtcore::HdrImage& a, const rtcore::HdrImage& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const double d = static_cast<double>(a.pixels[i].r - b.pixels[i].r);
            sum += d * d;
        }
        return std::sqrt(sum / static_cast<double>(a.pixels.size()));
    }

    static rtcore::HdrImage blur(const rtcore::HdrImage& image) {
        constexpr float kWeights[] = {1, 4, 6, 4, 1};
        rtcore::HdrImage out(image.width, image.height);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                float sum = 0, weights = 0;
                for (int j = std::max(y - 2, 0); j <= std::min(y + 2, image.height - 1); ++j) {
                    for (int i = std::max(x - 2, 0); i <= std::min(x + 2, image.width - 1); ++i) {
                        const float weight = kWeights[i - x + 2] * kWeights[j - y + 2];
                        sum += weight * image.at(i, j).r;
                        weights += weight;
                    }
                }
                out.at(x, y).r = sum / weights;
            }
        }
        return out;
    }

    rtcore::Scene scene_;
    const rtcore::RayTracer& tracer_;
    rtcore::Camera camera_;
    rtcore::HdrImage reference_, smoothReference_;
};

} // namespace test
