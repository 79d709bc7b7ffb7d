/// Images of one scene by several trees, compared to the bit.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/frame_renderer.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace test {

struct Picture {
    rtcore::Frame frame;
    rtcore::LdrImage developed; ///< with the effects that come after rendering
};

inline Picture pictureOf(const rtcore::Scene& scene, const rtcore::RayTracer& tracer,
                         const rtcore::Camera& camera, const rtcore::RenderSettings& settings) {
    Picture picture;
    rtcore::RenderControl control{.threads = 0};
    rtcore::FrameRenderer renderer;
    renderer.collectAovs(rtcore::effectsNeedAovs(settings));
    renderer.render({scene, tracer, camera, settings}, control, picture.frame);
    rtcore::PictureDeveloper developer;
    const float exposure = developer.exposure(picture.frame, settings.exposure, 0);
    developer.develop(picture.frame, settings, exposure, 0, picture.developed);
    return picture;
}

/// 0..1: of the image that shows surfaces.
inline double coveredFraction(const rtcore::Frame& frame) {
    double sum = 0;
    for (const std::uint8_t covered : frame.covered) sum += covered;
    return sum / (255.0 * static_cast<double>(frame.covered.size()));
}

/// In all that a frame holds of a pixel.
inline std::vector<std::size_t> differingPixels(const rtcore::Frame& a, const rtcore::Frame& b) {
    using Radiance = std::array<std::uint32_t, 3>;
    using Aov = std::array<std::uint32_t, sizeof(rtcore::AovPixel) / sizeof(std::uint32_t)>;
    std::vector<std::size_t> differing;
    for (std::size_t i = 0; i < a.covered.size(); ++i) {
        const bool same =
            a.covered[i] == b.covered[i] &&
            std::bit_cast<Radiance>(a.radiance.pixels[i]) == std::bit_cast<Radiance>(b.radiance.pixels[i]) &&
            (a.aovs.empty() ||
             std::bit_cast<Aov>(a.aovs.pixels()[i]) == std::bit_cast<Aov>(b.aovs.pixels()[i]));
        if (!same) differing.push_back(i);
    }
    return differing;
}

inline std::string describeDifference(const rtcore::Frame& a, const rtcore::Frame& b, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(a.radiance.width);
    const rtcore::Colour p = a.radiance.pixels[pixel], q = b.radiance.pixels[pixel];
    char text[200];
    std::snprintf(text, sizeof text, "(%zu, %zu): %.7g %.7g %.7g and %.7g %.7g %.7g", pixel % width,
                  pixel / width, double{p.r}, double{p.g}, double{p.b}, double{q.r}, double{q.g},
                  double{q.b});
    return text;
}

} // namespace test
