#include "rtcore/shading/light_wave.h"

#include "rtcore/shading/phong.h"

#include <limits>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light_wave.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_circle-inl.h"
#include "rtcore/shading/vector_materials-inl.h"

#ifndef RTCORE_SHADING_LIGHT_WAVE_TYPES
#define RTCORE_SHADING_LIGHT_WAVE_TYPES
namespace rtcore {

/// Where shadow rays go: arrays with room for every point and a block more.
struct ShadowArrays {
    float *ox, *oy, *oz, *dx, *dy, *dz, *tMax;
    std::uint32_t* point;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// shading/lighting.h
struct Illuminations {
    Vectors toLight;
    Floats distance;
    Vectors irradiance;
    Floats spread; ///< of the part of a lamp with a size: its solid angle over pi
};

HWY_INLINE Floats spotFactors(const Light& light, Floats cosine) {
    const Floats range = constant(light.cosInner - light.cosOuter);
    const Floats share = hn::Div(hn::Sub(cosine, constant(light.cosOuter)), range);
    const Floats x = smaller(larger(share, constant(0)), constant(1));
    return hn::Mul(hn::Mul(x, x), hn::Sub(constant(3), hn::Mul(constant(2), x)));
}

/// Numbers 0..1, without 1.
struct Places {
    Floats u, v;
};
HWY_INLINE Places placesOn(const LampPart* part, std::size_t i) {
    const FloatTag d;
    const BitsTag du;
    if (part == nullptr) return {constant(0.5F), constant(0.5F)};
    const auto unit = [&](const std::uint32_t* bits, std::uint32_t added) {
        const Bits sum = hn::Add(hn::LoadU(du, bits + i), hn::Set(du, added));
        const hn::RebindToSigned<FloatTag> di;
        return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<8>(sum))), constant(0x1p-24F));
    };
    return {unit(part->u, part->du), unit(part->v, part->dv)};
}

/// A place on the sphere, uniform in the cone that it fills; with 1 - cos of small angles to full precision.
HWY_INLINE Illuminations illuminateFromSphere(const Light& light, Vectors offset, const LampPart* part,
                                              Places place) {
    const Floats one = constant(1), zero = constant(0);
    const Floats radius = constant(light.radius);
    const Floats distance = hn::Sqrt(dot(offset, offset));
    const Vectors axis = select(hn::Gt(distance, zero), offset / distance, constant(0, 1, 0));
    const Floats counted = larger(larger(distance, radius), constant(1e-18F));
    const Floats sine = hn::Div(radius, counted);
    const Floats whole = hn::Add(one, hn::Sqrt(larger(hn::Sub(one, hn::Mul(sine, sine)), zero)));
    const Floats widest = hn::Div(hn::Mul(sine, sine), whole);
    const Floats bent = part != nullptr ? hn::Mul(place.u, widest) : zero; // 1 - cosine
    const Floats squareSine = hn::Mul(bent, hn::Sub(constant(2), bent));
    const Vectors across = aroundAxis(axis, unitCircle(place.v));
    const Vectors toLight = axis * hn::Sub(one, bent) + across * hn::Sqrt(squareSine);
    const Floats aside = hn::Mul(hn::Mul(distance, distance), squareSine);
    const Floats depth = hn::Sqrt(larger(hn::Sub(hn::Mul(radius, radius), aside), zero));
    const Floats near = hn::Sub(hn::Mul(distance, hn::Sub(one, bent)), depth);
    const Floats scale = hn::Div(constant(part != nullptr ? 2 * part->share : 2.0F),
                                 hn::Mul(hn::Mul(counted, counted), whole));
    const Vectors intensity = constant(light.intensity.r, light.intensity.g, light.intensity.b);
    return {toLight, larger(hn::Mul(near, constant(0.9999F)), zero), intensity * scale,
            hn::Mul(hn::Mul(sine, sine), constant(part != nullptr ? part->ofAll : 0.0F))};
}

HWY_INLINE Vectors placeOnRectangle(const Light& light, Places place) {
    const auto everywhere = [](Vec3 v) { return constant(v.x, v.y, v.z); };
    const Floats half = constant(0.5F);
    return everywhere(light.right * light.width) * hn::Sub(place.u, half) +
           everywhere(rtcore::cross(light.direction, light.right) * light.height) * hn::Sub(place.v, half);
}

template <LightKind kind>
HWY_INLINE Illuminations illuminateAll(const Light& light, const LampPart* part, std::size_t i,
                                       Vectors position) {
    const Vectors intensity = constant(light.intensity.r, light.intensity.g, light.intensity.b);
    if constexpr (kind == LightKind::Directional) {
        return {constant(-light.direction.x, -light.direction.y, -light.direction.z),
                constant(std::numeric_limits<float>::max()), intensity, constant(0)};
    }
    Vectors offset = constant(light.position.x, light.position.y, light.position.z) - position;
    if constexpr (kind == LightKind::Sphere)
        return illuminateFromSphere(light, offset, part, placesOn(part, i));
    if constexpr (kind == LightKind::Rectangle) offset = offset + placeOnRectangle(light, placesOn(part, i));
    const Floats distance = hn::Sqrt(dot(offset, offset));
    const Lanes apart = hn::Gt(distance, constant(0));
    const Vectors toLight = select(apart, offset / distance, constant(0, 1, 0));
    const Floats counted = larger(larger(distance, constant(light.radius)), constant(1e-18F));
    const Floats square = hn::Mul(counted, counted);
    Vectors irradiance;
    irradiance.x = hn::Div(intensity.x, square);
    // Most lights are white: a division less for each of the others.
    irradiance.y = light.intensity.g == light.intensity.r ? irradiance.x : hn::Div(intensity.y, square);
    irradiance.z = light.intensity.b == light.intensity.r ? irradiance.x : hn::Div(intensity.z, square);
    if constexpr (kind == LightKind::Spot) {
        const Vectors axis = constant(light.direction.x, light.direction.y, light.direction.z);
        irradiance = irradiance * spotFactors(light, hn::Neg(dot(toLight, axis)));
    }
    Floats spread = constant(0);
    if constexpr (kind == LightKind::Rectangle) {
        const float area = part != nullptr ? light.width * light.height * part->ofAll / kPi : 0.0F;
        const Vectors axis = constant(light.direction.x, light.direction.y, light.direction.z);
        const Floats front = larger(hn::Neg(dot(toLight, axis)), constant(0));
        irradiance = irradiance * hn::Mul(front, constant(part != nullptr ? part->share : 1.0F));
        spread = hn::Div(hn::Mul(constant(area), front), square);
    }
    const Floats almost = hn::Sub(hn::Mul(distance, constant(0.9999F)), constant(light.radius));
    return {toLight, larger(almost, constant(0)), irradiance, spread};
}

/// shading/phong.h; `geometric` and `shading` are the cosines of the light with the normals, both > 0.
HWY_INLINE Floats terminatorFactors(Vectors geometricNormal, Vectors shadingNormal, Floats geometric,
                                    Floats shading) {
    const Floats between = larger(dot(geometricNormal, shadingNormal), constant(1e-6F));
    const Floats g = smaller(constant(1), hn::Div(geometric, hn::Mul(shading, between)));
    return hn::Mul(g, hn::Add(constant(1), hn::Mul(g, hn::Sub(constant(1), g))));
}

/// The glossy part of the reflected share: k_s times the Phong lobe, zero where there is none. Of a lamp with
/// a size the lobe is as wide as the part of it that is looked at, or the part would be hit by chance alone.
template <LightKind kind>
HWY_INLINE Vectors glossyShare(const MaterialRow* rows, const std::uint32_t* material, Lanes glossy,
                               const Illuminations& arriving, Vectors normal, Vectors toViewer,
                               Floats cosine) {
    const FloatTag d;
    const Vectors toLight = arriving.toLight;
    const Vectors mirrored = normal * hn::Mul(constant(2), cosine) - toLight;
    const Floats lobe = dot(mirrored, toViewer);
    const Lanes seen = hn::And(glossy, hn::Gt(lobe, constant(0)));
    if (hn::AllFalse(d, seen)) return constant(0, 0, 0);
    const Rows ofPoints(rows, material, seen);
    constexpr std::size_t kMost = HWY_MAX(hn::MaxLanes(FloatTag()), 2);
    HWY_ALIGN float power[kMost] = {};
    HWY_ALIGN float exponent[kMost] = {};
    hn::StoreU(hn::IfThenElse(seen, lobe, constant(1)), d, power);
    Floats shininess = ofPoints.get(&MaterialRow::shininess);
    Floats lobeScale = ofPoints.get(&MaterialRow::lobeScale);
    if constexpr (kind == LightKind::Sphere || kind == LightKind::Rectangle) {
        const Floats two = constant(2);
        const Floats wider = hn::Div(shininess, hn::Add(constant(1), hn::Mul(shininess, arriving.spread)));
        lobeScale = hn::Mul(lobeScale, hn::Div(hn::Add(wider, two), hn::Add(shininess, two)));
        shininess = wider;
    }
    hn::StoreU(shininess, d, exponent);
    powArray(power, exponent, hn::Lanes(d));
    const Floats scale = hn::Mul(lobeScale, hn::LoadU(d, power));
    return selectOrZero(seen, ofPoints.get(&MaterialRow::specular) * scale);
}

/// The part that the rough lobe reflects, phong.h; zero where there is none.
HWY_INLINE Vectors roughShare(const MaterialRow* rows, const std::uint32_t* material, Lanes rough,
                              Floats toLight, Floats toViewer) {
    const Rows ofPoints(rows, material, rough);
    const Floats both = larger(hn::Add(toLight, larger(toViewer, constant(0))), constant(kLeastCosines));
    return selectOrZero(rough, ofPoints.get(&MaterialRow::specular) *
                                   hn::Div(ofPoints.get(&MaterialRow::roughScale), both));
}

HWY_INLINE void storeSome(Floats v, Lanes lanes, bool all, float* HWY_RESTRICT to) {
    hn::StoreU(all ? v : hn::Compress(v, lanes), FloatTag(), to);
}

template <LightKind kind>
HWY_INLINE std::size_t lightAll(const Light& light, const LampPart* part, const MaterialRow* rows,
                                const SurfaceWave& s, const ShadowArrays* shadows) {
    const FloatTag d;
    const BitsTag du;
    const Floats zero = hn::Zero(d);
    const Bits lane = hn::Iota(du, 0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Bits traits = hn::LoadU(du, s.traits + i);
        Lanes lit = hasTrait(traits, traits::kPoint);
        const auto nothing = [&] {
            storeVectors({zero, zero, zero}, s.added.x + i, s.added.y + i, s.added.z + i);
        };
        if (hn::AllFalse(d, lit)) {
            nothing();
            continue;
        }
        const Vectors position = loadVectors(s.position.x + i, s.position.y + i, s.position.z + i);
        const Illuminations arriving = illuminateAll<kind>(light, part, i, position);
        const Vectors geometricNormal =
            loadVectors(s.geometricNormal.x + i, s.geometricNormal.y + i, s.geometricNormal.z + i);
        const Vectors normal =
            loadVectors(s.shadingNormal.x + i, s.shadingNormal.y + i, s.shadingNormal.z + i);
        const Floats geometric = dot(geometricNormal, arriving.toLight);
        const Floats cosine = dot(normal, arriving.toLight);
        lit = hn::And(lit, hn::And(hn::Gt(geometric, zero), hn::Gt(cosine, zero)));
        if (hn::AllFalse(d, lit)) {
            nothing();
            continue;
        }
        Vectors share = loadVectors(s.diffuse.x + i, s.diffuse.y + i, s.diffuse.z + i);
        const Lanes glossy = hn::And(lit, hasTrait(traits, traits::kGlossy));
        const Lanes rough = hn::And(lit, hasTrait(traits, traits::kRough));
        if (!hn::AllFalse(d, hn::Or(glossy, rough))) {
            const Vectors toViewer = loadVectors(s.toViewer.x + i, s.toViewer.y + i, s.toViewer.z + i);
            if (!hn::AllFalse(d, glossy)) {
                share = share +
                        glossyShare<kind>(rows, s.material + i, glossy, arriving, normal, toViewer, cosine);
            }
            if (!hn::AllFalse(d, rough))
                share = share + roughShare(rows, s.material + i, rough, cosine, dot(normal, toViewer));
        }
        share = share * hn::Mul(cosine, terminatorFactors(geometricNormal, normal, geometric, cosine));
        const Vectors scale = loadVectors(s.share.x + i, s.share.y + i, s.share.z + i);
        const Vectors added = selectOrZero(lit, scale * share * arriving.irradiance);
        storeVectors(added, s.added.x + i, s.added.y + i, s.added.z + i);
        if (shadows == nullptr) continue;

        lit = hn::AndNot(isZero(added), lit);
        const bool all = hn::AllTrue(d, lit);
        const Floats clearance = hn::LoadU(d, s.clearance + i);
        const Vectors origin = position + geometricNormal * clearance;
        storeSome(origin.x, lit, all, shadows->ox + count);
        storeSome(origin.y, lit, all, shadows->oy + count);
        storeSome(origin.z, lit, all, shadows->oz + count);
        storeSome(arriving.toLight.x, lit, all, shadows->dx + count);
        storeSome(arriving.toLight.y, lit, all, shadows->dy + count);
        storeSome(arriving.toLight.z, lit, all, shadows->dz + count);
        storeSome(larger(hn::Sub(arriving.distance, clearance), zero), lit, all, shadows->tMax + count);
        const Bits index = hn::Add(lane, hn::Set(du, static_cast<std::uint32_t>(i)));
        hn::StoreU(hn::BitCast(du, hn::Compress(hn::BitCast(d, index), lit)), du, shadows->point + count);
        count += hn::CountTrue(d, lit);
    }
    return count;
}

/// Returns the number of shadow rays.
std::size_t lightSurfaces(const Light& light, const LampPart* part, const MaterialRow* rows,
                          const SurfaceWave& surfaces, const ShadowArrays* shadows) {
    switch (light.kind) {
    case LightKind::Directional:
        return lightAll<LightKind::Directional>(light, part, rows, surfaces, shadows);
    case LightKind::Spot:
        return lightAll<LightKind::Spot>(light, part, rows, surfaces, shadows);
    case LightKind::Sphere:
        return lightAll<LightKind::Sphere>(light, part, rows, surfaces, shadows);
    case LightKind::Rectangle:
        return lightAll<LightKind::Rectangle>(light, part, rows, surfaces, shadows);
    default:
        return lightAll<LightKind::Point>(light, part, rows, surfaces, shadows);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(lightSurfaces);

namespace {

void addLight(const Light& light, const LampPart* part, const MaterialTable& materials, SurfaceWave& surfaces,
              ShadowRays* shadows) {
    if (shadows == nullptr) {
        HWY_DYNAMIC_DISPATCH(lightSurfaces)(light, part, materials.rows(), surfaces, nullptr);
        return;
    }
    RayWave& rays = shadows->rays;
    const std::size_t room = surfaces.size() + kWaveBlock;
    rays.resize(room);
    if (shadows->point.size() < room) shadows->point.resize(room);
    const ShadowArrays arrays{rays.ox.data(), rays.oy.data(), rays.oz.data(),   rays.dx.data(),
                              rays.dy.data(), rays.dz.data(), rays.tMax.data(), shadows->point.data()};
    rays.resize(HWY_DYNAMIC_DISPATCH(lightSurfaces)(light, part, materials.rows(), surfaces, &arrays));
}

} // namespace

void addLight(const Light& light, const MaterialTable& materials, SurfaceWave& surfaces,
              ShadowRays* shadows) {
    addLight(light, nullptr, materials, surfaces, shadows);
}

void addLight(const Light& light, const LampPart& part, const MaterialTable& materials, SurfaceWave& surfaces,
              ShadowRays* shadows) {
    addLight(light, &part, materials, surfaces, shadows);
}

} // namespace rtcore
#endif
