#include "rtcore/shading/light/hemisphere_rays.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/hemisphere_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_SHADING_LIGHT_HEMISPHERE_RAYS_TYPES
#define RTCORE_SHADING_LIGHT_HEMISPHERE_RAYS_TYPES
namespace rtcore {

struct HemisphereTargets {
    ArraysOf3 origin, direction;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Aims a ray from each of the points from `i` on. `u` is not shifted yet.
HWY_INLINE void aimVector(const HemisphereFrames& f, std::size_t i, Float u, Float cosine, Float sine,
                          const HemisphereTargets& to) {
    u = min(u + load(f.shift + i), 1.0F); // rounded, the last ring may end above 1
    const Float across = sqrt(u);
    const Float along = sqrt(1.0F - u);
    const Float3 direction = loadAt(f.tangent, i) * (across * cosine) +
                             loadAt(f.bitangent, i) * (across * sine) + loadAt(f.normal, i) * along;
    const Float3 side = loadAt(f.side, i);
    const Float height = dot(direction, side);
    storeAt(loadAt(f.origin, i), to.origin, i);
    storeAt(select(height < 0.0F, direction - side * (2.0F * height), direction), to.direction, i);
}

void aimAllAlike(const HemisphereFrames& f, HemispherePoint direction, const HemisphereTargets& to) {
    for (std::size_t i = 0; i < f.count; i += lanes())
        aimVector(f, i, direction.u, direction.cosine, direction.sine, to);
}

void aimAllApart(const HemisphereFrames& f, const HemispherePoint* directions, const HemisphereTargets& to) {
    HWY_ALIGN float u[kLanes] = {}, cosine[kLanes] = {}, sine[kLanes] = {};
    for (std::size_t i = 0; i < f.count; i += lanes()) {
        for (std::size_t lane = 0; lane < lanes() && i + lane < f.count; ++lane) {
            u[lane] = directions[i + lane].u;
            cosine[lane] = directions[i + lane].cosine;
            sine[lane] = directions[i + lane].sine;
        }
        aimVector(f, i, load(u), load(cosine), load(sine), to);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(aimAllAlike);
HWY_EXPORT(aimAllApart);

namespace {

HemisphereTargets targetsIn(RayWave& rays, std::size_t first) {
    return {{&rays.ox[first], &rays.oy[first], &rays.oz[first]},
            {&rays.dx[first], &rays.dy[first], &rays.dz[first]}};
}

} // namespace

void aimAlike(const HemisphereFrames& frames, HemispherePoint direction, RayWave& rays, std::size_t first) {
    HWY_DYNAMIC_DISPATCH(aimAllAlike)(frames, direction, targetsIn(rays, first));
}

void aimEach(const HemisphereFrames& frames, const HemispherePoint* directions, RayWave& rays,
             std::size_t first) {
    HWY_DYNAMIC_DISPATCH(aimAllApart)(frames, directions, targetsIn(rays, first));
}

} // namespace rtcore
#endif
