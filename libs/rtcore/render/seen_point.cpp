#include "rtcore/render/seen_point.h"

namespace rtcore {

namespace {

/// Mirrored light does not count below this fraction of all.
constexpr float kLeastMirrored = 0.02F;

float partOf(float own, float all) { return own < all ? own / all : 1; }

} // namespace

SeenPoint::SeenPoint(const PrimaryHit& hit, Colour radiance) {
    if (!hit.any()) return;
    any = true;
    position = hit.position;
    normal = hit.normal;
    if (hit.mirrored < kLeastMirrored) return;
    mirroredLength = hit.mirroredLength;
    tint = hit.tint;
    ownPart = {partOf(hit.own.r, radiance.r), partOf(hit.own.g, radiance.g), partOf(hit.own.b, radiance.b)};
}

} // namespace rtcore
