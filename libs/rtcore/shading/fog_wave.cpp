#include "rtcore/shading/fog_wave.h"

#include <algorithm>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog_wave.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/fog_math-inl.h"
#include "rtcore/shading/vector_materials-inl.h"

#ifndef RTCORE_SHADING_FOG_WAVE_TYPES
#define RTCORE_SHADING_FOG_WAVE_TYPES
namespace rtcore {

/// Arrays of FogWave.
struct FogArrays {
    std::size_t count;
    ArraysOf3 origin, direction;
    float *distance, *from, *to, *transmittance;
    ArraysOf3 scattered;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// What lies beyond this optical depth, or this many scale heights above the thickest of a ray, is not seen.
constexpr float kDeepest = 16;

struct Stretches {
    Floats from, to;
};

/// Where on a ray of exponential fog there is any that counts.
HWY_INLINE Stretches thickStretch(const VectorFog& fog, Floats height, Floats slope, Floats distance) {
    const Floats steepness = larger(hn::Abs(slope), constant(1e-20F));
    const Lanes rising = hn::Gt(slope, constant(0));
    // x = kDeepest * slope / extinction at the origin; rising, tau ends at 1/x, and the depth is reached at
    // -ln(1 - x); falling, at ln(1 + x).
    const Floats logX =
        hn::Add(logOf(larger(hn::Div(hn::Mul(constant(kDeepest), steepness), fog.density), constant(1e-30F))),
                height);
    const Floats x = expOf(logX);
    const Floats up = hn::IfThenElse(hn::Lt(x, constant(1)), minusLogOfRest(smaller(x, constant(0.999999F))),
                                     constant(kDeepest));
    const Floats down =
        hn::IfThenElse(hn::Gt(logX, constant(15)), logX,
                       hn::IfThenElse(hn::Lt(x, constant(0.01F)), x,
                                      logOf(hn::Add(smaller(x, constant(1e8F)), constant(1)))));
    const Floats depth = hn::Div(hn::IfThenElse(rising, smaller(up, constant(kDeepest)), down), steepness);
    const Floats to = smaller(distance, depth);
    const Floats from = larger(hn::Sub(to, hn::Div(constant(kDeepest), steepness)), constant(0));
    return {hn::IfThenElseZero(hn::Not(rising), from), to};
}

template <bool exponential>
HWY_INLINE void enterAll(const FogMedium& medium, const FogArrays& a) {
    const FloatTag d;
    const VectorFog fog(medium);
    const Vectors source = constant(medium.source.r, medium.source.g, medium.source.b);
    for (std::size_t i = 0; i < a.count; i += hn::Lanes(d)) {
        const Floats distance = hn::LoadU(d, a.distance + i);
        Floats length = distance;
        Stretches stretch{hn::Zero(d), smaller(distance, hn::Div(constant(kDeepest), fog.density))};
        if constexpr (exponential) {
            const Floats height = fog.height(loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i));
            const Floats slope =
                fog.slope(loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i));
            length = exponentialLength(height, slope, distance);
            stretch = thickStretch(fog, height, slope, distance);
        }
        const Floats tau = hn::Mul(fog.density, length);
        hn::StoreU(expOf(hn::Neg(tau)), d, a.transmittance + i);
        hn::StoreU(stretch.from, d, a.from + i);
        hn::StoreU(stretch.to, d, a.to + i);
        storeVectors(source * opacityOf(tau), a.scattered.x + i, a.scattered.y + i, a.scattered.z + i);
    }
}

void enterFog(const FogMedium& medium, const FogArrays& a) {
    medium.exponential ? enterAll<true>(medium, a) : enterAll<false>(medium, a);
}

void dimAll(const float* HWY_RESTRICT transmittance, const SurfaceWave& s) {
    const FloatTag d;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Vectors share = loadVectors(s.share.x + i, s.share.y + i, s.share.z + i);
        storeVectors(share * hn::LoadU(d, transmittance + i), s.share.x + i, s.share.y + i, s.share.z + i);
    }
}

template <bool exponential>
HWY_INLINE void dimLightAll(const FogMedium& medium, const Light& light, const SurfaceWave& s) {
    const FloatTag d;
    const VectorFog fog(medium);
    const bool directional = light.kind == LightKind::Directional;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Vectors position = loadVectors(s.position.x + i, s.position.y + i, s.position.z + i);
        Vectors toLight = constant(-light.direction.x, -light.direction.y, -light.direction.z);
        Floats distance = constant(kEndless);
        if (!directional) {
            const Vectors offset = constant(light.position.x, light.position.y, light.position.z) - position;
            distance = hn::Sqrt(dot(offset, offset));
            toLight = offset / larger(distance, constant(1e-30F));
        }
        const Floats length = lengthOf<exponential>(fog, position, toLight, distance);
        const Floats left = expOf(hn::Neg(hn::Mul(fog.density, length)));
        const Vectors added = loadVectors(s.added.x + i, s.added.y + i, s.added.z + i);
        // Where there is no point, the position may be anything.
        const Vectors dimmed = select(isZero(added), added, added * left);
        storeVectors(dimmed, s.added.x + i, s.added.y + i, s.added.z + i);
    }
}

void dimLightOf(const FogMedium& medium, const Light& light, const SurfaceWave& s) {
    medium.exponential ? dimLightAll<true>(medium, light, s) : dimLightAll<false>(medium, light, s);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(enterFog);
HWY_EXPORT(dimAll);
HWY_EXPORT(dimLightOf);

void FogWave::enter(const RayWave& rays, const HitWave& hits, const std::uint32_t* traits,
                    const std::uint32_t* bounces) {
    size_ = rays.size();
    ArraysOf3* const vectors[] = {&origin_, &direction_, &scattered_};
    float** const values[] = {&distance_, &from_, &to_, &transmittance_};
    memory_.resize(3 * std::size(vectors) + std::size(values), size_);
    std::size_t next = 0;
    for (ArraysOf3* const v : vectors) {
        for (float** const array : {&v->x, &v->y, &v->z}) *array = memory_.array(next++);
    }
    for (float** const value : values) *value = memory_.array(next++);

    // Beyond the last ray there is none of any length.
    const std::size_t room = (size_ + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    const auto copy = [&](const std::vector<float>& from, float* to) {
        std::fill(std::copy(from.begin(), from.end(), to), to + room, 0.0F);
    };
    copy(rays.ox, origin_.x), copy(rays.oy, origin_.y), copy(rays.oz, origin_.z);
    copy(rays.dx, direction_.x), copy(rays.dy, direction_.y), copy(rays.dz, direction_.z);
    for (std::size_t i = 0; i < size_; ++i) distance_[i] = traits[i] != 0 ? hits.t[i] : kEndless;
    if (bounces != nullptr) {
        for (std::size_t i = 0; i < size_; ++i) {
            if (isInside(bounces[i])) distance_[i] = 0;
        }
    }
    std::fill(distance_ + size_, distance_ + room, 0.0F);
    const FogArrays arrays{room, origin_, direction_, distance_, from_, to_, transmittance_, scattered_};
    HWY_DYNAMIC_DISPATCH(enterFog)(medium_, arrays);
}

void FogWave::dimShares(SurfaceWave& surfaces) const {
    HWY_DYNAMIC_DISPATCH(dimAll)(transmittance_, surfaces);
}

void FogWave::dimLight(const Light& light, SurfaceWave& surfaces) const {
    if (light.kind == LightKind::Directional && !medium_.exponential) return;
    HWY_DYNAMIC_DISPATCH(dimLightOf)(medium_, light, surfaces);
}

} // namespace rtcore
#endif
