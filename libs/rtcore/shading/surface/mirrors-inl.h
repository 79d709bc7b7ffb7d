// Fraction of the light that mirrors reflect at points. Included once for each instruction set, inside the
// loop of foreach_target.h.
#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"
#include "rtcore/shading/surface/surface_wave.h"

#if defined(RTCORE_SHADING_SURFACE_MIRRORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_SURFACE_MIRRORS_INL_H_
#undef RTCORE_SHADING_SURFACE_MIRRORS_INL_H_
#else
#define RTCORE_SHADING_SURFACE_MIRRORS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The mirrored fraction of the light at points with the trait kMirror, those of `mirrors`: splitLight()
/// (surface_split.h), of opaque mirrors. `row`: theirs.
HWY_INLINE Float3 mirroredFraction(const Rows& row, const SurfaceWave& s, std::size_t i, Mask mirrors) {
    Float3 mirrored = row.get(&MaterialRow::mirror);
    const Mask fresnel = mirrors & hasTrait(load(s.traits + i), traits::kFresnel);
    if (any(fresnel)) {
        const Float cosine = max(dot(loadAt(s.toViewer, i), loadAt(s.shadingNormal, i)), 0.0F);
        mirrored = select(fresnel, fresnelSchlick<Float>(mirrored, cosine), mirrored);
    }
    return mirrored * row.get(&MaterialRow::mirrorScale);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
