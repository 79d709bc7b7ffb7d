#include "rtcore/shading/light/occlusion_rays.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/occlusion_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_SHADING_LIGHT_OCCLUSION_RAYS_TYPES
#define RTCORE_SHADING_LIGHT_OCCLUSION_RAYS_TYPES
namespace rtcore {

struct OcclusionTargets {
    ArraysOf3 origin, direction;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Of the points from `i` on. `u` is not shifted yet.
HWY_INLINE void aimVector(const OcclusionFrames& f, std::size_t i, Float u, Float cosine, Float sine,
                          const OcclusionTargets& to) {
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

void aimAllAlike(const OcclusionFrames& f, HemispherePoint direction, const OcclusionTargets& to) {
    for (std::size_t i = 0; i < f.count; i += lanes())
        aimVector(f, i, direction.u, direction.cosine, direction.sine, to);
}

void aimAllApart(const OcclusionFrames& f, const HemispherePoint* directions, const OcclusionTargets& to) {
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

/// What of the light comes past a hit at `t`, over `distance`.
template <typename F>
HWY_INLINE F passing(F t, float distance) {
    return min(t / distance, F(1));
}

/// The last vector may be cut off: `hits` ends with the rays.
void addAllVisible(const OcclusionFrames& f, const float* t, const std::uint32_t* triangle, float distance) {
    const std::size_t whole = f.count / lanes() * lanes();
    for (std::size_t i = 0; i < whole; i += lanes()) {
        const Mask free = load(triangle + i) == kNoTriangle;
        store(load(f.visible + i) + select(free, 1.0F, passing(load(t + i), distance)), f.visible + i);
    }
    for (std::size_t i = whole; i < f.count; ++i)
        f.visible[i] += triangle[i] == kNoTriangle ? 1 : passing(t[i], distance);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(aimAllAlike);
HWY_EXPORT(aimAllApart);
HWY_EXPORT(addAllVisible);

namespace {

OcclusionTargets targetsIn(RayWave& rays, std::size_t first) {
    return {{&rays.ox[first], &rays.oy[first], &rays.oz[first]},
            {&rays.dx[first], &rays.dy[first], &rays.dz[first]}};
}

} // namespace

void aimAlike(const OcclusionFrames& frames, HemispherePoint direction, RayWave& rays, std::size_t first) {
    HWY_DYNAMIC_DISPATCH(aimAllAlike)(frames, direction, targetsIn(rays, first));
}

void aimEach(const OcclusionFrames& frames, const HemispherePoint* directions, RayWave& rays,
             std::size_t first) {
    HWY_DYNAMIC_DISPATCH(aimAllApart)(frames, directions, targetsIn(rays, first));
}

void addVisible(const OcclusionFrames& frames, const HitWave& hits, std::size_t first, float distance) {
    HWY_DYNAMIC_DISPATCH(addAllVisible)(frames, &hits.t[first], &hits.triangle[first], distance);
}

} // namespace rtcore
#endif
