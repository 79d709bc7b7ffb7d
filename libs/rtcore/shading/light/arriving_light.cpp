#include "rtcore/shading/light/arriving_light.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/arriving_light.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/octahedron-inl.h"
#include "rtcore/shading/fog/fog_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Fraction of the light that passes a hit at `t`, over `distance`.
template <typename F>
HWY_INLINE F passing(F t, float distance) {
    return min(t / distance, F(1));
}

/// The last vector may be cut off: `hits` ends with the rays.
void addAllVisible(float* visible, std::size_t count, const float* t, const std::uint32_t* triangle,
                   float distance) {
    const std::size_t whole = count / lanes() * lanes();
    for (std::size_t i = 0; i < whole; i += lanes()) {
        const Mask free = load(triangle + i) == kNoTriangle;
        store(load(visible + i) + select(free, 1.0F, passing(load(t + i), distance)), visible + i);
    }
    for (std::size_t i = whole; i < count; ++i)
        visible[i] += triangle[i] == kNoTriangle ? 1 : passing(t[i], distance);
}

/// Directions of the rays from `i` on; the rays end with the last one.
HWY_INLINE Float3 rayVectors(const std::vector<float>& x, const std::vector<float>& y,
                             const std::vector<float>& z, std::size_t i, std::size_t count) {
    if (HWY_LIKELY(count >= lanes())) return load(&x[i], &y[i], &z[i]);
    return {loadSome(&x[i], count), loadSome(&y[i], count), loadSome(&z[i], count)};
}

HWY_INLINE Float3 skyAlong(const SkySource& sky, const RayWave& rays, std::size_t i, std::size_t count) {
    const Float3 direction = rayVectors(rays.dx, rays.dy, rays.dz, i, count);
    const Int texel = octahedronTexel<Float>(direction, sky.light->side());
    const Float3 radiance{gather(sky.light->radiance(0), texel), gather(sky.light->radiance(1), texel),
                          gather(sky.light->radiance(2), texel)};
    const Float3 seen = radiance * broadcast(sky.scale);
    if (sky.fog == nullptr) return seen;
    const Float3 origin = rayVectors(rays.ox, rays.oy, rays.oz, i, count);
    const Float tau = sky.fog->density *
                      fogLength<Float>(sky.fog->exponential, *sky.fog, origin, direction, Float(kEndless));
    return seen * fastExp(-tau) + broadcast(sky.fog->source) * fogOpacity(tau);
}

HWY_INLINE void addAt(const Float3& seen, const Float3& passing, const SkySums& sums, std::size_t i) {
    storeAt(loadAt(sums.arrived, i) + seen * passing, sums.arrived, i);
    storeAt(loadAt(sums.passing, i) + passing, sums.passing, i);
    storeAt(loadAt(sums.whole, i) + seen, sums.whole, i);
}

void addUnoccluded(const SkySource& sky, const SkyRays& r, const std::uint8_t* occluded,
                   const SkySums& sums) {
    HWY_ALIGN float passing[kLanes] = {};
    for (std::size_t i = 0; i < r.count; i += lanes()) {
        const std::size_t count = std::min(lanes(), r.count - i);
        for (std::size_t lane = 0; lane < count; ++lane)
            passing[lane] = occluded[i + lane] != 0 ? 0.0F : 1.0F;
        const Float left = load(passing);
        addAt(skyAlong(sky, r.rays, r.first + i, count), {left, left, left}, sums, i);
    }
}

void addTinted(const SkySource& sky, const SkyRays& r, const Colour* passing, const SkySums& sums) {
    HWY_ALIGN Colour tint[kLanes] = {};
    for (std::size_t i = 0; i < r.count; i += lanes()) {
        const std::size_t count = std::min(lanes(), r.count - i);
        std::copy_n(passing + i, count, tint);
        addAt(skyAlong(sky, r.rays, r.first + i, count), loadInterleaved(&tint[0].r), sums, i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(addAllVisible);
HWY_EXPORT(addUnoccluded);
HWY_EXPORT(addTinted);

void addVisible(float* visible, std::size_t count, const HitWave& hits, std::size_t first, float distance) {
    HWY_DYNAMIC_DISPATCH(addAllVisible)(visible, count, &hits.t[first], &hits.triangle[first], distance);
}

void addSky(const SkySource& sky, const SkyRays& rays, const std::uint8_t* occluded, const SkySums& sums) {
    HWY_DYNAMIC_DISPATCH(addUnoccluded)(sky, rays, occluded, sums);
}

void addSky(const SkySource& sky, const SkyRays& rays, const Colour* passing, const SkySums& sums) {
    HWY_DYNAMIC_DISPATCH(addTinted)(sky, rays, passing, sums);
}

} // namespace rtcore
#endif
