#include "rtcore/shading/fog_shafts.h"

#include <algorithm>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog_shafts.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/fog_path-inl.h"

#ifndef RTCORE_SHADING_FOG_SHAFTS_TYPES
#define RTCORE_SHADING_FOG_SHAFTS_TYPES
namespace rtcore {

/// Arrays of FogWave.
struct ShaftArrays {
    ArraysOf3 origin, direction;
    const float *from, *to, *distance, *shift;
};
/// Where samples go, with room for a vector more.
struct ShaftSamples {
    ArraysOf3 origin, direction;
    float *tMax, *value;
    std::uint32_t* of;
    std::size_t count;
};
struct ShaftOrder {
    std::size_t first, last; ///< rays
    int samples;
    bool counted;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Error below 3e-7. (Cephes atanf)
HWY_INLINE Floats arcTangent(Floats x) {
    const Floats size = hn::Abs(x);
    const Lanes high = hn::Gt(size, constant(2.414213562F));
    const Lanes middle = hn::Gt(size, constant(0.4142135624F));
    const Floats over = hn::IfThenElse(high, constant(-1), hn::Sub(size, constant(1)));
    const Floats under = hn::IfThenElse(high, size, hn::Add(size, constant(1)));
    const Floats y = hn::IfThenElse(middle, hn::Div(over, under), size);
    const Floats start =
        hn::IfThenElseZero(middle, hn::IfThenElse(high, constant(1.570796327F), constant(0.785398163F)));
    const Floats z = hn::Mul(y, y);
    static constexpr float kSeries[] = {-3.33329491539e-1F, 1.99777106478e-1F, -1.38776856032e-1F,
                                        8.05374449538e-2F};
    const Floats rest = hn::Add(hn::Mul(hn::Mul(polynomial(kSeries, z), z), y), y);
    return hn::CopySign(hn::Add(start, rest), x);
}

/// Of |x| <= pi / 4. (Cephes tanf)
HWY_INLINE Floats tangent(Floats x) {
    const Floats z = hn::Mul(x, x);
    static constexpr float kSeries[] = {3.33331568548e-1F, 1.33387994085e-1F, 5.34112807005e-2F,
                                        2.44301354525e-2F, 3.11992232697e-3F, 9.38540185543e-3F};
    return hn::Add(hn::Mul(hn::Mul(polynomial(kSeries, z), z), x), x);
}

HWY_INLINE void storeSome(Floats v, Lanes lanes, bool all, float* HWY_RESTRICT to) {
    hn::StoreU(all ? v : hn::Compress(v, lanes), FloatTag(), to);
}

/// Appends the samples whose value is not zero, `t` along the rays from `i` on.
HWY_INLINE void append(ShaftSamples& out, std::size_t i, Floats value, Vectors position, Vectors toLight,
                       Floats tMax) {
    const FloatTag d;
    const BitsTag du;
    const Lanes used = hn::Gt(value, hn::Zero(d));
    if (hn::AllFalse(d, used)) return;
    const bool all = hn::AllTrue(d, used);
    const std::size_t at = out.count;
    storeSome(position.x, used, all, out.origin.x + at);
    storeSome(position.y, used, all, out.origin.y + at);
    storeSome(position.z, used, all, out.origin.z + at);
    storeSome(toLight.x, used, all, out.direction.x + at);
    storeSome(toLight.y, used, all, out.direction.y + at);
    storeSome(toLight.z, used, all, out.direction.z + at);
    storeSome(tMax, used, all, out.tMax + at);
    storeSome(value, used, all, out.value + at);
    const Bits index = hn::Add(hn::Iota(du, 0), hn::Set(du, static_cast<std::uint32_t>(i)));
    hn::StoreU(hn::BitCast(du, hn::Compress(hn::BitCast(d, index), used)), du, out.of + at);
    out.count += hn::CountTrue(d, used);
}

HWY_INLINE Floats stratum(const float* shift, int j, float perSample) {
    const Floats within = hn::LoadU(FloatTag(), shift);
    return hn::Mul(hn::Add(constant(static_cast<float>(j)), within), constant(perSample));
}

template <bool exponential, Beam beam>
HWY_INLINE void drawLamp(const FogMedium& medium, const Light& light, const ShaftArrays& a, std::size_t i,
                         int j, const ShaftOrder& order, ShaftSamples& out) {
    const FloatTag d;
    Floats from = hn::LoadU(d, a.from + i), to = hn::LoadU(d, a.to + i);
    const Vectors origin = loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i);
    const Vectors direction = loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i);
    const LampPath<exponential, beam> path(medium, light, origin, direction);
    path.clip(from, to);
    const Lanes used = hn::Lt(from, to);
    if (hn::AllFalse(d, used)) return;
    const float perSample = 1 / static_cast<float>(order.samples);
    const Floats first = arcTangent(hn::Div(hn::Sub(from, path.foot), path.apart));
    const Floats angle = hn::Sub(arcTangent(hn::Div(hn::Sub(to, path.foot), path.apart)), first);
    const Floats at = hn::Add(first, hn::Mul(angle, stratum(a.shift + i, j, perSample)));
    const Floats half = tangent(hn::Mul(at, constant(0.5F)));
    const Floats square = hn::Mul(half, half);
    const Floats cosines = hn::Div(path.apart, larger(hn::Sub(constant(1), square), constant(1e-12F)));
    const Floats r = hn::Mul(cosines, hn::Add(constant(1), square));
    const Floats along = hn::Add(path.foot, hn::Mul(cosines, hn::Add(half, half)));
    const Floats t = smaller(larger(along, from), to);
    // The light over r^2 and the density of the samples, apart / (angle r^2).
    const Floats value =
        hn::Mul(path.light(t, r, order.counted), hn::Div(hn::Mul(angle, constant(perSample)), path.apart));
    const Vectors position = origin + direction * t;
    const Vectors offset = constant(light.position.x, light.position.y, light.position.z) - position;
    const Floats distance = hn::Sqrt(dot(offset, offset));
    const Floats almost = hn::Sub(hn::Mul(distance, constant(0.9999F)), constant(light.radius));
    const Lanes apart = hn::Gt(distance, hn::Zero(d));
    append(out, i, hn::IfThenElseZero(used, value), position,
           select(apart, offset / distance, constant(0, 1, 0)), larger(almost, constant(0)));
}

/// Where on the ray the length of fog (fogLength()) is `length`; `height` and `slope` in scale heights.
HWY_INLINE Floats distanceOf(Floats length, Floats height, Floats slope) {
    const Floats steepness = larger(hn::Abs(slope), constant(1e-20F));
    const Floats product = larger(hn::Mul(length, steepness), constant(1e-30F));
    const Floats logX = hn::Add(logOf(smaller(product, constant(1e30F))), height);
    const Floats x = expOf(logX);
    const Floats up = minusLogOfRest(smaller(x, constant(0.999999F)));
    const Floats down =
        hn::IfThenElse(hn::Gt(logX, constant(15)), logX,
                       hn::IfThenElse(hn::Lt(x, constant(0.01F)),
                                      hn::Mul(x, hn::Sub(constant(1), hn::Mul(x, constant(0.5F)))),
                                      logOf(hn::Add(smaller(x, constant(1e8F)), constant(1)))));
    return hn::Div(hn::IfThenElse(hn::Gt(slope, constant(0)), up, down), steepness);
}

template <bool exponential>
HWY_INLINE void drawSun(const FogMedium& medium, const Light& light, const ShaftArrays& a, std::size_t i,
                        int j, const ShaftOrder& order, ShaftSamples& out) {
    const FloatTag d;
    const float rise = -dot(medium.up, light.direction);
    if (exponential && !(rise > 1e-6F)) return;
    const VectorFog fog(medium);
    const Floats distance = hn::LoadU(d, a.distance + i);
    if (hn::AllFalse(d, hn::Gt(distance, hn::Zero(d)))) return;
    const Vectors origin = loadVectors(a.origin.x + i, a.origin.y + i, a.origin.z + i);
    const Vectors direction = loadVectors(a.direction.x + i, a.direction.y + i, a.direction.z + i);
    const float perSample = 1 / static_cast<float>(order.samples);
    const Floats opacity =
        opacityOf(hn::Mul(fog.density, lengthOf<exponential>(fog, origin, direction, distance)));
    const Floats share = hn::Mul(opacity, stratum(a.shift + i, j, perSample));
    const Floats length = hn::Div(minusLogOfRest(smaller(share, constant(0.999999F))), fog.density);
    Floats value = hn::Mul(opacity, constant(perSample));
    Floats t = length;
    if constexpr (exponential) {
        t = distanceOf(length, fog.height(origin), fog.slope(direction));
    }
    t = smaller(t, distance);
    const Vectors position = origin + direction * t;
    if (exponential && order.counted) {
        const Floats here = expOf(hn::Neg(fog.height(position)));
        const Floats depth = hn::Mul(hn::Mul(fog.density, here), constant(1 / (rise * medium.perHeight)));
        value = hn::Mul(value, expOf(hn::Neg(depth)));
    }
    append(out, i, value, position, constant(-light.direction.x, -light.direction.y, -light.direction.z),
           constant(kEndless));
}

template <bool exponential>
HWY_INLINE void drawAll(const FogMedium& medium, const Light& light, const ShaftArrays& a,
                        const ShaftOrder& order, ShaftSamples& out) {
    const FloatTag d;
    // Neighbours' samples of one stratum side by side: their shadow rays go the same way.
    for (std::size_t block = order.first; block < order.last; block += kWaveBlock) {
        const std::size_t end = HWY_MIN(block + kWaveBlock, order.last);
        for (int j = 0; j < order.samples; ++j) {
            for (std::size_t i = block; i < end; i += hn::Lanes(d)) {
                switch (light.kind) {
                case LightKind::Directional:
                    drawSun<exponential>(medium, light, a, i, j, order, out);
                    break;
                case LightKind::Spot:
                    drawLamp<exponential, Beam::Cone>(medium, light, a, i, j, order, out);
                    break;
                case LightKind::Rectangle:
                    drawLamp<exponential, Beam::Cosine>(medium, light, a, i, j, order, out);
                    break;
                default:
                    drawLamp<exponential, Beam::Even>(medium, light, a, i, j, order, out);
                }
            }
        }
    }
}

std::size_t drawShafts(const FogMedium& medium, const Light& light, const ShaftArrays& a,
                       const ShaftOrder& order, ShaftSamples out) {
    medium.exponential ? drawAll<true>(medium, light, a, order, out)
                       : drawAll<false>(medium, light, a, order, out);
    return out.count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(drawShafts);

std::size_t FogShafts::raysAtOnce(int samples) {
    constexpr std::size_t kSamples = 32768;
    const std::size_t rays = kSamples / static_cast<std::size_t>(std::max(samples, 1));
    return std::max(rays / kWaveBlock * kWaveBlock, kWaveBlock);
}

void FogShafts::draw(const FogWave& fog, const Light& light, std::size_t first, std::size_t count,
                     int samples, const float* shift, bool counted) {
    const std::size_t padded = (count + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    const std::size_t room = padded * static_cast<std::size_t>(samples) + kWaveBlock;
    rays_.resize(room);
    if (value_.size() < room) {
        value_.resize(room);
        of_.resize(room);
    }
    const float lamp = light.kind == LightKind::Directional ? 1.0F : fog.medium_.density;
    scale_ = light.intensity * fog.medium_.scattered * lamp;
    const ShaftArrays from{fog.origin_, fog.direction_, fog.from_, fog.to_, fog.distance_, shift};
    const ShaftSamples to{{rays_.ox.data(), rays_.oy.data(), rays_.oz.data()},
                          {rays_.dx.data(), rays_.dy.data(), rays_.dz.data()},
                          rays_.tMax.data(),
                          value_.data(),
                          of_.data(),
                          0};
    rays_.resize(HWY_DYNAMIC_DISPATCH(drawShafts)(fog.medium_, light, from,
                                                  {first, first + count, samples, counted}, to));
}

void FogShafts::addAll(const FogWave& fog) const {
    const ArraysOf3& sum = fog.scattered();
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k]);
    }
}

void FogShafts::add(const FogWave& fog, const std::vector<std::uint8_t>& occluded) const {
    const ArraysOf3& sum = fog.scattered();
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        if (occluded[k] == 0) sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k]);
    }
}

void FogShafts::add(const FogWave& fog, const std::vector<Colour>& arriving) const {
    const ArraysOf3& sum = fog.scattered();
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        sum.set(of_[k], sum.colourAt(of_[k]) + scale_ * value_[k] * arriving[k]);
    }
}

} // namespace rtcore
#endif
