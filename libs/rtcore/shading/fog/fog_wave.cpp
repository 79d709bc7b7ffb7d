#include "rtcore/shading/fog/fog_wave.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/fog/fog_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/fog/fog_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Fog beyond this optical depth, or this many scale heights above the thickest point of a ray, is neglected.
constexpr float kDeepest = 16;

struct Stretches {
    Float from, to;
};

/// Where on a ray of exponential fog there is any that counts.
HWY_INLINE Stretches thickStretch(const FogMedium& fog, Float height, Float slope, Float distance) {
    const Float steepness = max(abs(slope), 1e-20F);
    const Mask rising = slope > 0.0F;
    // x = kDeepest * slope / extinction at the origin; rising, tau ends at 1/x, and the depth is reached at
    // -ln(1 - x); falling, at ln(1 + x).
    const Float logX = fastLog(max(kDeepest * steepness / fog.density, 1e-30F)) + height;
    const Float x = fastExp(logX);
    const Float up = select(x < 1.0F, fastMinusLogOfRest(min(x, 0.999999F)), kDeepest);
    const Float down = select(logX > 15.0F, logX, select(x < 0.01F, x, fastLog(min(x, 1e8F) + 1.0F)));
    const Float depth = select(rising, min(up, kDeepest), down) / steepness;
    const Float to = min(distance, depth);
    const Float from = max(to - kDeepest / steepness, 0.0F);
    return {selectOrZero(!rising, from), to};
}

template <bool exponential>
HWY_INLINE void enterAll(const FogMedium& medium, const FogRays& a, std::size_t room) {
    const Float3 source = broadcast(medium.source);
    for (std::size_t i = 0; i < room; i += lanes()) {
        const Float distance = load(a.distance + i);
        Float length = distance;
        Stretches stretch{0.0F, min(distance, kDeepest / medium.density)};
        if constexpr (exponential) {
            const Float height = fogHeight<Float>(medium, loadAt(a.origin, i));
            const Float slope = fogSlope<Float>(medium, loadAt(a.direction, i));
            length = exponentialLength(height, slope, distance);
            stretch = thickStretch(medium, height, slope, distance);
        }
        const Float tau = medium.density * length;
        store(fastExp(-tau), a.transmittance + i);
        store(stretch.from, a.from + i);
        store(stretch.to, a.to + i);
        storeAt(source * fogOpacity(tau), a.scattered, i);
    }
}

/// `room`: for whole blocks, whose rest counts as rays, too.
void enterFog(const FogMedium& medium, const FogRays& a, std::size_t room) {
    medium.exponential ? enterAll<true>(medium, a, room) : enterAll<false>(medium, a, room);
}

void dimAll(const float* transmittance, const SurfaceWave& s) {
    for (std::size_t i = 0; i < s.size(); i += lanes())
        storeAt(loadAt(s.weight, i) * load(transmittance + i), s.weight, i);
}

void dimLightOf(const FogMedium& medium, const Light& light, const SurfaceWave& s) {
    const bool directional = !traitsOf(light).position;
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Float3 position = loadAt(s.position, i);
        Float3 toLight = broadcast(-light.direction);
        Float distance = kEndless;
        if (!directional) {
            const Float3 offset = broadcast(light.position) - position;
            distance = sqrt(dot(offset, offset));
            toLight = offset / max(distance, 1e-30F);
        }
        const Float length = fogLength<Float>(medium.exponential, medium, position, toLight, distance);
        const Float left = fastExp(-(medium.density * length));
        const Float3 all = loadAt(s.contribution, i);
        // Where there is no point, the position may be anything.
        storeAt(select(isZero(all), all, all * left), s.contribution, i);
    }
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
                    const WavePaths& paths) {
    const std::size_t count = rays.size();
    ArraysOf3* const vectors[] = {&rays_.origin, &rays_.direction, &rays_.scattered};
    float** const values[] = {&rays_.distance, &rays_.from, &rays_.to, &rays_.transmittance};
    memory_.resize(3 * std::size(vectors) + std::size(values), count);
    std::size_t next = 0;
    for (ArraysOf3* const v : vectors) {
        *v = memory_.arraysOf3(next);
        next += 3;
    }
    for (float** const value : values) *value = memory_.array(next++);
    rays_.count = count;

    // Beyond the last ray there is none of any length.
    const std::size_t room = (count + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    const auto copy = [&](const std::vector<float>& from, float* to) {
        std::fill(std::copy(from.begin(), from.end(), to), to + room, 0.0F);
    };
    const ArraysOf3 &origin = rays_.origin, &direction = rays_.direction;
    copy(rays.ox, origin.x), copy(rays.oy, origin.y), copy(rays.oz, origin.z);
    copy(rays.dx, direction.x), copy(rays.dy, direction.y), copy(rays.dz, direction.z);
    for (std::size_t i = 0; i < count; ++i) {
        const float distance = traits[i] != 0 ? hits.t[i] : kEndless;
        rays_.distance[i] = isInside(paths.bounces(i)) ? 0 : distance;
    }
    std::fill(rays_.distance + count, rays_.distance + room, 0.0F);
    HWY_DYNAMIC_DISPATCH(enterFog)(medium_, rays_, room);
}

void FogWave::dimWeights(SurfaceWave& surfaces) const {
    HWY_DYNAMIC_DISPATCH(dimAll)(rays_.transmittance, surfaces);
}

void FogWave::dimLight(const Light& light, SurfaceWave& surfaces) const {
    if (!traitsOf(light).position && !medium_.exponential) return;
    HWY_DYNAMIC_DISPATCH(dimLightOf)(medium_, light, surfaces);
}

} // namespace rtcore
#endif
