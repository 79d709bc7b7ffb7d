#include "rtcore/shading/occlusion_rays.h"

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/occlusion_rays.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_SHADING_OCCLUSION_RAYS_TYPES
#define RTCORE_SHADING_OCCLUSION_RAYS_TYPES
namespace rtcore {

struct OcclusionTargets {
    ArraysOf3 origin, direction;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Vectors loadAt(const ArraysOf3& from, std::size_t i) {
    return loadVectors(from.x + i, from.y + i, from.z + i);
}

/// Of the vector at `i`. `u` is not shifted yet.
HWY_INLINE void aimVector(const OcclusionFrames& f, std::size_t i, Floats u, Floats cosine, Floats sine,
                          const OcclusionTargets& to) {
    const FloatTag d;
    const Floats one = constant(1);
    u = smaller(hn::Add(u, hn::LoadU(d, f.shift + i)), one); // rounded, the last ring may end above 1
    const Floats across = hn::Sqrt(u);
    const Floats along = hn::Sqrt(hn::Sub(one, u));
    Vectors direction = loadAt(f.tangent, i) * hn::Mul(across, cosine) +
                        loadAt(f.bitangent, i) * hn::Mul(across, sine) + loadAt(f.normal, i) * along;
    const Vectors side = loadAt(f.side, i);
    const Floats height = dot(direction, side);
    const Vectors mirrored = direction - side * hn::Mul(constant(2), height);
    direction = select(hn::Lt(height, hn::Zero(d)), mirrored, direction);
    const Vectors origin = loadAt(f.origin, i);
    storeVectors(origin, to.origin.x + i, to.origin.y + i, to.origin.z + i);
    storeVectors(direction, to.direction.x + i, to.direction.y + i, to.direction.z + i);
}

void aimAllAlike(const OcclusionFrames& f, HemispherePoint direction, const OcclusionTargets& to) {
    const Floats u = constant(direction.u);
    const Floats cosine = constant(direction.cosine);
    const Floats sine = constant(direction.sine);
    for (std::size_t i = 0; i < f.count; i += hn::Lanes(FloatTag())) aimVector(f, i, u, cosine, sine, to);
}

void aimAllApart(const OcclusionFrames& f, const HemispherePoint* directions, const OcclusionTargets& to) {
    const FloatTag d;
    constexpr std::size_t kMost = hn::MaxLanes(FloatTag());
    HWY_ALIGN float u[kMost] = {}, cosine[kMost] = {}, sine[kMost] = {};
    for (std::size_t i = 0; i < f.count; i += hn::Lanes(d)) {
        for (std::size_t lane = 0; lane < hn::Lanes(d) && i + lane < f.count; ++lane) {
            u[lane] = directions[i + lane].u;
            cosine[lane] = directions[i + lane].cosine;
            sine[lane] = directions[i + lane].sine;
        }
        aimVector(f, i, hn::Load(d, u), hn::Load(d, cosine), hn::Load(d, sine), to);
    }
}

/// The last vector may be cut off: `hits` ends with the rays.
void addAllVisible(const OcclusionFrames& f, const float* t, const std::uint32_t* triangle, float distance) {
    const FloatTag d;
    const BitsTag du;
    const std::size_t whole = f.count / hn::Lanes(d) * hn::Lanes(d);
    const Floats one = constant(1);
    for (std::size_t i = 0; i < whole; i += hn::Lanes(d)) {
        const auto missed = hn::Eq(hn::LoadU(du, triangle + i), hn::Set(du, kNoTriangle));
        const Lanes free = hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(du, missed)));
        const Floats passing = smaller(hn::Div(hn::LoadU(d, t + i), constant(distance)), one);
        const Floats sum = hn::Add(hn::LoadU(d, f.visible + i), hn::IfThenElse(free, one, passing));
        hn::StoreU(sum, d, f.visible + i);
    }
    for (std::size_t i = whole; i < f.count; ++i) {
        const float passing = t[i] / distance;
        f.visible[i] += triangle[i] == kNoTriangle || passing > 1 ? 1 : passing;
    }
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
