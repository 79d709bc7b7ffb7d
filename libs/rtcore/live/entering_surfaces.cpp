#include "rtcore/live/entering_surfaces.h"

#include "rtcore/platform/parts.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rtcore {

namespace {

constexpr int kSquare = 8;     ///< pixels
constexpr float kMin = 0.01F;  ///< pixels: in less space nothing enters
constexpr float kFlat = 2;     ///< squares: surfaces so much deeper than the one found may be a part of it
constexpr float kSteep = 0.1F; ///< cosine: rays that turned by more are followed as if by this
constexpr float kNone = std::numeric_limits<float>::max();

float middle(int square) { return static_cast<float>(square * kSquare) + 0.5F * kSquare; }

/// How far before the rays of `before` that of `now` through this point starts; less than 0: behind.
float depthOfStart(const ImagePlane& before, const ImagePlane& now, float x, float y) {
    return before.depthOf(now.inDepth(x, y, 0));
}

/// The part of a ray of `now` that lies behind the plane of `before`; empty where none does.
Ray rayThrough(const ImagePlane& before, const ImagePlane& now, float x, float y) {
    const float along = std::max(dot(before.axis, now.axis), kSteep), start = depthOfStart(before, now, x, y);
    return {now.inDepth(x, y, 0), 0, now.axis, start < 0 ? -start / along : -1};
}

/// It is linear over the image.
bool startsBehind(const ImagePlane& before, const ImagePlane& now) {
    const auto width = static_cast<float>(now.width), height = static_cast<float>(now.height);
    const float min =
        std::min({depthOfStart(before, now, 0, 0), depthOfStart(before, now, width, 0),
                  depthOfStart(before, now, 0, height), depthOfStart(before, now, width, height)});
    return min < -kMin * length(now.right);
}

} // namespace

void EnteringSurfaces::find(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer,
                            int threads) {
    any_ = now.parallel && before.parallel && startsBehind(before, now);
    if (!any_) return;
    rows_.resize(static_cast<std::size_t>((now.height + kSquare - 1) / kSquare));
    forEachPart(rows_.size(), threads,
                [&](std::size_t row) { findIn(before, now, tracer, static_cast<int>(row)); });
}

void EnteringSurfaces::findIn(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer,
                              int row) {
    Row& here = rows_[static_cast<std::size_t>(row)];
    here.rays.clear();
    for (int column = 0; column * kSquare < now.width; ++column)
        here.rays.push(rayThrough(before, now, middle(column), middle(row)));
    tracer.intersect(RayKind::Primary, here.rays, here.hits);
    here.depths.resize(here.hits.size());
    for (std::size_t i = 0; i < here.hits.size(); ++i)
        here.depths[i] = here.hits.isHit(i) ? here.hits.t[i] : kNone;
}

bool EnteringSurfaces::coverHalf(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer) {
    constexpr int kSide = 8; // rays
    if (!before.parallel || !now.parallel || !startsBehind(before, now)) return false;
    some_.rays.clear();
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const auto at = [](int k, int pixels) {
                return (static_cast<float>(k) + 0.5F) / kSide * static_cast<float>(pixels);
            };
            some_.rays.push(rayThrough(before, now, at(i, now.width), at(j, now.height)));
        }
    }
    tracer.intersect(RayKind::Primary, some_.rays, some_.hits);
    int hidden = 0;
    for (std::size_t i = 0; i < some_.hits.size(); ++i) hidden += some_.hits.isHit(i) ? 1 : 0;
    return 2 * hidden >= kSide * kSide;
}

void EnteringSurfaces::forgetHidden(LiveLayers& layers, int first, int last) const {
    if (!any_) return;
    const ImagePlane& plane = layers.surface.plane();
    const float margin = kFlat * kSquare * length(plane.right);
    for (int y = first; y < last; ++y) {
        const std::vector<float>& depths = rows_[static_cast<std::size_t>(y / kSquare)].depths;
        for (int x = 0; x < plane.width; ++x) {
            const float depth = depths[static_cast<std::size_t>(x / kSquare)];
            const std::size_t i = layers.surface.index(x, y);
            if (depth == kNone || !layers.surface.known(i)) continue;
            const bool hidden = layers.surface.background(i) ||
                                plane.depthOf(layers.surface.points[i].position) > depth + margin;
            if (!hidden) continue;
            layers.surface.forget(i);
            if (layers.mirrors) layers.specular.forget(i);
        }
    }
}

} // namespace rtcore
