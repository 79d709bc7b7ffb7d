// Light that microfacets mirror more than once before it leaves, over the number F: float or Float. Included
// once for each instruction set, inside the loop of foreach_target.h, or alone.
//
// How much there is follows from what one reflection loses; which way it leaves was fitted to random walks on
// the microsurface (Heitz, Hanika, d'Eon and Dachsbacher 2016, "Multiple-Scattering Microfacet BSDFs with the
// Smith Model"): a part as the lobe of one reflection does off facets seen straight on, the rest as a
// function of its own cosine alone. `alpha`: of the facets, 0.04..1 in the fits; `cosine`: of the viewer
// unless said.
#include "rtcore/scattering/ggx_albedo-inl.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_SCATTERING_FURTHER_FACETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_FURTHER_FACETS_INL_H_
#undef RTCORE_SCATTERING_FURTHER_FACETS_INL_H_
#else
#define RTCORE_SCATTERING_FURTHER_FACETS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Of even light, what leaves after the second facet or a later one, where each reflects by Schlick's curve
/// from `reflectance` on. All of what one reflection loses where that is 1: so white surfaces are white.
template <typename F>
HWY_INLINE F furtherAlbedo(const GgxAlbedo<F>& albedo, F alpha, F cosine, F reflectance) {
    const F lost = max(1.0F - albedo.straight - albedo.grazing, F(0));
    // Seen at a flat angle, the first facet reflects more.
    const F slant = (1.0F - cosine) * (1.0F - cosine);
    const F curve = 0.059F + 0.379F * slant - alpha * (0.035F + 0.376F * slant);
    const F each = reflectance + (1.0F - reflectance) * curve;
    const F leaving = 1.0F - alpha * (0.189F + 0.267F * cosine); // the chance after each facet
    return lost * (each * each * leaving) / (1.0F - each * (1.0F - leaving));
}

/// The part of it that leaves as one reflection does off facets seen straight on.
template <typename F>
HWY_INLINE F nearFraction(F alpha, F cosine) {
    static constexpr float kWhole[] = {1.025F, -1.888F, 0.621F, 1.118F};
    static constexpr float kByCosine[] = {-0.915F, 2.778F, -3.305F};
    const F both = alpha * cosine;
    return clamp(polynomial(kWhole, alpha) + cosine * polynomial(kByCosine, alpha) + 0.53F * (both * both),
                 0.0F, 1.0F);
}

/// The rest of it, over a matte surface of its albedo. `cosine`: of the light. Above 0, with that
/// integral.
template <typename F>
HWY_INLINE F furtherShape(F alpha, F cosine) {
    static constexpr float kLinear[] = {-10.26F, 60.113F, -90.596F, 43.037F};
    static constexpr float kSquare[] = {6.611F, -41.988F, 66.784F, -32.492F};
    return 1.0F + polynomial(kLinear, alpha) * (cosine - 2.0F / 3) +
           polynomial(kSquare, alpha) * (cosine * cosine - 0.5F);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
