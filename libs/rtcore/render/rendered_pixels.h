/// Some pixels of a frame, anywhere in it.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/render/seen_point.h"
#include "rtcore/shading/light/light_visibility.h"

#include <cstddef>
#include <span>

namespace rtcore {

/// Results of rendering some pixels, in their order.
struct RenderedPixels {
    std::span<Colour> radiance;
    /// Known visibility of the lights at the surface that each pixel sees, taken for true; shadow rays add
    /// what they find. Of more than 32 lights some are traced (docs/live.md), and nothing is kept. With one
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
