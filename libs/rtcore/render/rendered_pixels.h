/// Some pixels of a frame, anywhere in it.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/render/seen_point.h"
#include "rtcore/shading/light/light_visibility.h"

#include <cstddef>
#include <span>

namespace rtcore {

/// What becomes of some pixels, in their order.
struct RenderedPixels {
    std::span<Colour> radiance;
    /// What is known of lights at what each pixel sees, taken for true; gets what shadow rays found. With one
    /// sample per pixel only. Empty: all is traced.
    std::span<LightVisibility> visibility = {};
    /// Gets what the pixels see, with one sample per pixel only. Empty: it is not asked for.
    std::span<SeenPoint> seen = {};

    RenderedPixels part(std::size_t first, std::size_t count) const {
        const auto of = [&](auto all) { return all.empty() ? all : all.subspan(first, count); };
        return {of(radiance), of(visibility), of(seen)};
    }
};

} // namespace rtcore
