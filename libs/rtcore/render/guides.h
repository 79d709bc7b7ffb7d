/// Guides of a net that denoises: what each pixel sees of surfaces, also in mirrors and behind glass.
///
/// The albedo is the image that Whitted's rays make under ambient light 1 and no other: what each surface
/// scatters, through all mirrors and panes between it and the eye. What shines, the background and the
/// environment are part of it, dimmed to what surfaces have. Fog only takes away. Neither depends on the
/// seed, the samples or any setting of noise, so that every part of an image makes the same.
#pragma once

#include "rtcore/scene/image.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// By pixel, row by row from the top; means over the rays of each.
struct Guides {
    HdrImage albedo;                   ///< 0..1
    std::vector<Vec3> normals;         ///< in the scene's axes, as NormalSums has them
    std::vector<std::uint8_t> covered; ///< as Frame::covered

    bool empty() const { return albedo.pixels.empty(); }
    static constexpr std::size_t bytesPerPixel() { return sizeof(Colour) + sizeof(Vec3) + 1; }
};

/// How many rays each pixel gets.
enum class GuideRays {
    Few, ///< 4: for a first image that is wanted soon
    All  ///< 16; 64 with a lens, which blurs them
};

/// The scene whose image by guideSettings() is the albedo. Shares the model and the environments' images.
Scene guideScene(const Scene& scene);
/// For it, of an image of those settings.
RenderSettings guideSettings(const RenderSettings& settings, GuideRays rays);

} // namespace rtcore
