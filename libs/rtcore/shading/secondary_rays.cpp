#include "rtcore/shading/secondary_rays.h"

#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/fresnel.h"
#include "rtcore/scene/media_crossing.h"
#include "rtcore/shading/mirror_wave.h"
#include "rtcore/shading/path_medium.h"
#include "rtcore/shading/surface/medium.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

/// Secondary rays traced at once: enough for streams, and a bound on the memory of the queues.
constexpr std::size_t kWaveSize = 16384;
/// Thin walls and holes that a path may pass; it bounds the work of a hostile model.
constexpr std::uint16_t kMaxPasses = 1000;
static_assert(kMaxPasses < 0x7FFF, "PathQueue::bounces has 15 bits for them");

/// Behind a thin wall: as it came, but for a facet, which sends behind what it would mirror.
Vec3 throughWall(const Surface& s) {
    if (!s.facet) return -s.toViewer;
    const Vec3 mirrored =
        HWY_NAMESPACE::mirrorDirection<float>(s.toViewer, s.shadingNormal, s.geometricNormal);
    return normalize(mirrored - s.geometricNormal * (2 * dot(mirrored, s.geometricNormal)));
}

/// `side` is the normal on the side that the ray leaves to.
Ray rayFrom(const Surface& s, Vec3 side, Vec3 direction) {
    return {s.position + side * s.clearance, 0, direction, std::numeric_limits<float>::max()};
}

bool matters(Colour weight, const RenderSettings& settings) {
    const float largest = maxComponent(weight);
    return largest > 0 && largest >= settings.minContribution;
}

} // namespace

std::optional<Ray> rayThroughHole(const Surface& surface, Vec3 direction, Path& path) {
    if (path.passes >= kMaxPasses) return std::nullopt;
    ++path.passes;
    return rayFrom(surface, -surface.geometricNormal, direction);
}

void passUnbent(const Scene& scene, const Surface& s, bool visible, Path& path) {
    if (!visible) {
        path.media = s.media;
    } else if (s.fromInside && !(s.media == path.media)) {
        enterMedium(mediumOf(scene, s.media), s.media, path);
    }
}

std::optional<Ray> rayBehind(const Surface& s, int maxDepth, Path& path) {
    Vec3 direction = -s.toViewer;
    if (!s.closed) {
        direction = throughWall(s);
        path.weight *= s.material->transmission;
        if (++path.passes > kMaxPasses) return std::nullopt;
    } else {
        if (path.depth >= maxDepth) return std::nullopt;
        ++path.depth;
        if (!refract(direction, s.shadingNormal, s.index, direction)) return std::nullopt;
        const float above = dot(direction, s.geometricNormal);
        if (above >= 0 && !s.facet) return std::nullopt; // a smooth normal bent it back out
        if (above >= 0) direction = normalize(direction - s.geometricNormal * (above + 1e-3F));
        if (s.behind != nullptr) path.weight *= tintOnEntering(*s.behind);
        enterMedium(s.behind, s.media, path);
    }
    return rayFrom(s, -s.geometricNormal, direction);
}

void SecondaryRays::start() {
    mirrored_.clear();
    refracted_.clear();
}

void SecondaryRays::takeNext(Wave& wave) {
    const bool mirror = mirrored_.size() >= refracted_.size();
    (mirror ? mirrored_ : refracted_).takeLast(kWaveSize, current_);
    wave.kind = mirror ? RayKind::Mirror : RayKind::Refracted;
    wave.rays = &current_.rays;
    wave.paths = WavePaths(current_);
}

void SecondaryRays::addHole(const FrameContext& frame, const Surface& surface, Vec3 direction, Path path) {
    if (!matters(path.weight, *frame.settings)) return;
    if (const auto ray = rayThroughHole(surface, direction, path)) refracted_.push(*ray, path);
}

void SecondaryRays::addTransparent(const Surface& surface, Colour transmitted, const Path& path) {
    transparent_.push_back({surface, path});
    transparent_.back().path.weight *= transmitted;
}

void SecondaryRays::makeSecondaryRays(const FrameContext& frame, const Wave& wave) {
    if (frame.materials->anySecondary()) addMirroredRays(frame, wave, mirrored_);
    for (const Transparent& point : transparent_) refract(frame, point);
    transparent_.clear();
}

void SecondaryRays::refract(const FrameContext& frame, const Transparent& point) {
    Path path = point.path;
    if (isBlack(path.weight)) return;
    const auto ray = rayBehind(point.surface, frame.settings->maxDepth, path);
    if (ray && matters(path.weight, *frame.settings)) refracted_.push(*ray, path);
}

void SecondaryRays::evenMemory() {
    const std::size_t max = std::max({current_.capacity(), mirrored_.capacity(), refracted_.capacity()});
    for (PathQueue* const queue : {&current_, &mirrored_, &refracted_}) queue->reserve(max);
}

} // namespace rtcore
