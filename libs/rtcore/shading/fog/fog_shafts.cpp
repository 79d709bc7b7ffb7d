#include "rtcore/shading/fog/fog_shafts.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog/fog_shafts.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/fog/fog_path-inl.h"

#ifndef RTCORE_SHADING_FOG_FOG_SHAFTS_TYPES
#define RTCORE_SHADING_FOG_FOG_SHAFTS_TYPES
namespace rtcore {

/// Where samples go, with room for a vector more.
struct ShaftSamples {
    ArraysOf3 origin, direction;
    float *tMax, *value;
    std::uint32_t* of;
    std::size_t count;
};
struct ShaftOrder {
    std::size_t first, last; ///< rays
    const float* shift;      ///< of each ray, 0..1
    int samples;
    bool counted;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Appends the samples whose value is not zero, `t` along the rays from `i` on.
HWY_INLINE void append(ShaftSamples& out, std::size_t i, Float value, Float3 position, Float3 toLight,
                       Float tMax) {
    const Mask used = value > 0.0F;
    if (none(used)) return;
    const Compressor some(used);
    const std::size_t at = out.count;
    storeAt(position, some, out.origin, at);
    storeAt(toLight, some, out.direction, at);
    some.store(tMax, out.tMax + at);
    some.store(value, out.value + at);
    some.store(iota(i), out.of + at);
    out.count += some.count();
}

HWY_INLINE Float stratum(const float* shift, int j, float perSample) {
    return (static_cast<float>(j) + load(shift)) * perSample;
}

template <bool exponential, Beam beam>
HWY_INLINE void sampleLocal(const FogMedium& medium, const Light& light, const FogRays& a, std::size_t i,
                            int j, const ShaftOrder& order, ShaftSamples& out) {
    Float from = load(a.from + i), to = load(a.to + i);
    const Float3 origin = loadAt(a.origin, i);
    const Float3 direction = loadAt(a.direction, i);
    const LightPath<exponential, beam> path(medium, light, origin, direction);
    path.clip(from, to);
    const Mask used = from < to;
    if (none(used)) return;
    const float perSample = 1 / static_cast<float>(order.samples);
    const Float first = fastAtan((from - path.foot) / path.apart);
    const Float angle = fastAtan((to - path.foot) / path.apart) - first;
    const Float at = first + angle * stratum(order.shift + i, j, perSample);
    const Float half = fastTan(at * 0.5F);
    const Float square = half * half;
    const Float cosines = path.apart / max(1.0F - square, 1e-12F);
    const Float r = cosines * (1.0F + square);
    const Float along = path.foot + cosines * (half + half);
    const Float t = min(max(along, from), to);
    // The light over r^2 and the density of the samples, apart / (angle r^2).
    const Float value = path.light(t, r, order.counted) * (angle * perSample / path.apart);
    const Float3 position = origin + direction * t;
    const PathToLight<Float> toLight = pathToLight<Float>(light, broadcast(light.position) - position);
    append(out, i, selectOrZero(used, value), position, toLight.direction, toLight.free);
}

/// Where on the ray the length of fog (fogLength()) is `length`; `height` and `slope` in scale heights.
HWY_INLINE Float distanceOf(Float length, Float height, Float slope) {
    const Float steepness = max(abs(slope), 1e-20F);
    const Float product = max(length * steepness, 1e-30F);
    const Float logX = fastLog(min(product, 1e30F)) + height;
    const Float x = fastExp(logX);
    const Float up = fastMinusLogOfRest(min(x, 0.999999F));
    const Float down =
        select(logX > 15.0F, logX, select(x < 0.01F, x * (1.0F - x * 0.5F), fastLog(min(x, 1e8F) + 1.0F)));
    return select(slope > 0.0F, up, down) / steepness;
}

template <bool exponential>
HWY_INLINE void sampleSun(const FogMedium& medium, const Light& light, const FogRays& a, std::size_t i, int j,
                          const ShaftOrder& order, ShaftSamples& out) {
    const float rise = -dot(medium.up, light.direction);
    if (exponential && !(rise > 1e-6F)) return;
    const Float distance = load(a.distance + i);
    if (none(distance > 0.0F)) return;
    const Float3 origin = loadAt(a.origin, i);
    const Float3 direction = loadAt(a.direction, i);
    const float perSample = 1 / static_cast<float>(order.samples);
    const Float opacity =
        fogOpacity(medium.density * fogLength<Float>(exponential, medium, origin, direction, distance));
    const Float weight = opacity * stratum(order.shift + i, j, perSample);
    const Float length = fastMinusLogOfRest(min(weight, 0.999999F)) / medium.density;
    Float value = opacity * perSample;
    Float t = length;
    if constexpr (exponential) {
        t = distanceOf(length, fogHeight<Float>(medium, origin), fogSlope<Float>(medium, direction));
    }
    t = min(t, distance);
    const Float3 position = origin + direction * t;
    if (exponential && order.counted) {
        const Float here = fastExp(-fogHeight<Float>(medium, position));
        const Float depth = medium.density * here * (1 / (rise * medium.perHeight));
        value *= fastExp(-depth);
    }
    append(out, i, value, position, broadcast(-light.direction), kEndless);
}

template <bool exponential>
HWY_INLINE void sampleAll(const FogMedium& medium, const Light& light, const FogRays& a,
                          const ShaftOrder& order, ShaftSamples& out) {
    const LightTraits& traits = traitsOf(light);
    // Samples of neighbours in one stratum are stored side by side: their shadow rays are coherent.
    for (std::size_t block = order.first; block < order.last; block += kWaveBlock) {
        const std::size_t end = HWY_MIN(block + kWaveBlock, order.last);
        for (int j = 0; j < order.samples; ++j) {
            for (std::size_t i = block; i < end; i += lanes()) {
                if (!traits.position) {
                    sampleSun<exponential>(medium, light, a, i, j, order, out);
                    continue;
                }
                forBeam(traits.beam, [&]<Beam beam>() HWY_ATTR {
                    sampleLocal<exponential, beam>(medium, light, a, i, j, order, out);
                });
            }
        }
    }
}

std::size_t sampleShafts(const FogMedium& medium, const Light& light, const FogRays& a,
                         const ShaftOrder& order, ShaftSamples out) {
    medium.exponential ? sampleAll<true>(medium, light, a, order, out)
                       : sampleAll<false>(medium, light, a, order, out);
    return out.count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(sampleShafts);

std::size_t FogShafts::raysAtOnce(int samples) {
    constexpr std::size_t kSamples = 32768;
    const std::size_t rays = kSamples / static_cast<std::size_t>(std::max(samples, 1));
    return std::max(rays / kWaveBlock * kWaveBlock, kWaveBlock);
}

void FogShafts::sample(const FogWave& fog, const Light& light, Rays rays, int samples, const float* shift,
                       bool counted) {
    const std::size_t padded = (rays.count + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    const std::size_t room = padded * static_cast<std::size_t>(samples) + kWaveBlock;
    rays_.resize(room);
    if (value_.size() < room) {
        value_.resize(room);
        of_.resize(room);
    }
    const FogMedium& medium = fog.medium();
    scale_ = light.intensity * medium.scattered * (traitsOf(light).position ? medium.density : 1.0F);
    const ShaftSamples to{rays_.origins(), rays_.directions(), rays_.tMax.data(),
                          value_.data(),   of_.data(),         0};
    const ShaftOrder order{rays.first, rays.first + rays.count, shift, samples, counted};
    rays_.resize(HWY_DYNAMIC_DISPATCH(sampleShafts)(medium, light, fog.rays(), order, to));
}

void FogShafts::addAll(const FogWave& fog) const {
    const ArraysOf3& sum = fog.rays().scattered;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k]);
    }
}

void FogShafts::add(const FogWave& fog, const std::vector<std::uint8_t>& occluded) const {
    const ArraysOf3& sum = fog.rays().scattered;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        if (occluded[k] == 0) sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k]);
    }
}

void FogShafts::add(const FogWave& fog, const std::vector<Colour>& arriving) const {
    const ArraysOf3& sum = fog.rays().scattered;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k] * arriving[k]);
    }
}

} // namespace rtcore
#endif
