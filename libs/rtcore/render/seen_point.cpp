#include "rtcore/render/seen_point.h"

#include "rtcore/math/packed_direction.h"
#include "rtcore/math/packed_light.h"

namespace rtcore {

namespace {

/// Mirrored light does not count below this fraction of all.
constexpr float kMinMirrored = 0.02F;

float partOf(float surface, float all) { return surface < all ? surface / all : 1; }

} // namespace

SeenPoint::SeenPoint(const PrimaryHit& hit, Colour radiance) {
    if (!hit.any()) return;
    any = true;
    position = hit.position;
    normal = hit.normal;
    if (hit.mirrored < kMinMirrored) return;
    specularDistance = hit.specularDistance;
    tint = hit.tint;
    surfaceFraction = {partOf(hit.surfaceLight.r, radiance.r), partOf(hit.surfaceLight.g, radiance.g),
                       partOf(hit.surfaceLight.b, radiance.b)};
}

SeenMatter::SeenMatter(Colour surface, Colour indirect, const IndirectTap& tap)
    : direct(packLight(surface - indirect)), albedo(packLight(tap.factor)),
      normal(packDirection(tap.receiver.normal)), face(packDirection(tap.receiver.face)) {}

} // namespace rtcore
