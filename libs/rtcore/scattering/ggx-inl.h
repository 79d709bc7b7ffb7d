// Reflection by rough microfacets, over the number F: float or Float. All directions are of unit length and
// point away from the surface. Included once for each instruction set, inside the loop of foreach_target.h,
// or alone.
#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/sampling/owen-inl.h"
#include "rtcore/scattering/ggx.h"

#if defined(RTCORE_SCATTERING_GGX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_GGX_INL_H_
#undef RTCORE_SCATTERING_GGX_INL_H_
#else
#define RTCORE_SCATTERING_GGX_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// `roughness`: 0..1.
template <typename F>
HWY_INLINE F ggxAlpha(F roughness) {
    return max(roughness * roughness, F(kMinAlpha));
}

/// Alpha of a lobe no narrower than the stratum of the light that is looked at, as widenLobe() has it for
/// Phong's: of the same width, that has the exponent 1 / 2 alpha^2.
template <typename F>
HWY_INLINE F widenedAlpha(F alpha, F spread) {
    return min(sqrt(alpha * alpha + 0.5F * spread), F(1));
}

/// The viewer's direction, brought to kMinViewerCosine where it is below: what the functions here are to be
/// given.
template <typename F>
HWY_INLINE Vec3Of<F> liftedViewer(Vec3Of<F> toViewer, Vec3Of<F> normal) {
    const F cosine = dot(toViewer, normal);
    const auto low = cosine < kMinViewerCosine;
    if (none(low)) return toViewer;
    const Vec3Of<F> lifted = toViewer + normal * (kMinViewerCosine - cosine);
    return select(low, lifted / sqrt(dot(lifted, lifted)), toViewer);
}

/// Microfacets by solid angle of their normals `facet`. The sine comes from the cross product, since 1 -
/// cos^2 has no digits left where alpha is small.
template <typename F>
HWY_INLINE F ggxDistribution(Vec3Of<F> normal, Vec3Of<F> facet, F alpha) {
    const F cosine = dot(normal, facet);
    const Vec3Of<F> across = cross(normal, facet);
    const F square = alpha * alpha;
    const F width = cosine * cosine * square + dot(across, across);
    return square / (kPi * width * width);
}

/// cos (1 + 2 Lambda), with Smith's Lambda = (sqrt(1 + alpha^2 tan^2) - 1) / 2: finite at right angles, too.
template <typename F>
HWY_INLINE F smithRoot(F cosine, F alpha) {
    const F square = alpha * alpha;
    return sqrt(square + (1.0F - square) * (cosine * cosine));
}

/// The lobe's response to light from a direction; all 0 where that is below the surface.
template <typename F>
struct GgxScattering {
    F lobe;          ///< f_r of a perfect mirror's facets: D G2 / 4 cos i cos o
    F density;       ///< by solid angle, of sampleGgx(): D G1 / 4 cos o
    F fresnelCosine; ///< of light and viewer with the facets that mirror one to the other
};

template <typename F>
HWY_INLINE GgxScattering<F> scatterGgx(Vec3Of<F> normal, Vec3Of<F> toViewer, Vec3Of<F> toLight, F alpha) {
    const F light = dot(normal, toLight), viewer = dot(normal, toViewer);
    const auto above = light > 0.0F;
    const Vec3Of<F> sum = toLight + toViewer;
    const Vec3Of<F> facet = sum / sqrt(dot(sum, sum));
    const F facets = ggxDistribution<F>(normal, facet, alpha);
    const F viewerRoot = smithRoot<F>(viewer, alpha);
    const F masked = 2.0F * (light * viewerRoot + viewer * smithRoot<F>(light, alpha));
    return {selectOrZero(above, facets / masked),
            selectOrZero(above, facets / (2.0F * (viewer + viewerRoot))),
            selectOrZero(above, dot(toViewer, facet))};
}

/// The normal of a microfacet that the viewer sees (Heitz 2018, "Sampling the GGX Distribution of Visible
/// Normals").
template <typename F>
HWY_INLINE Vec3Of<F> sampleFacet(Vec3Of<F> normal, Vec3Of<F> toViewer, F alpha, SquarePointOf<F> point) {
    // The facets of a hemisphere: the surface stretched to alpha = 1.
    const auto basis = basisAround(normal);
    Vec3Of<F> viewer{alpha * dot(toViewer, basis.tangent), alpha * dot(toViewer, basis.bitangent),
                     dot(toViewer, normal)};
    viewer = viewer / sqrt(dot(viewer, viewer));
    const F flat = viewer.x * viewer.x + viewer.y * viewer.y;
    const auto slanting = flat > 1e-12F;
    const F length = sqrt(flat);
    const Vec3Of<F> aside{select(slanting, -viewer.y / length, F(1)),
                          selectOrZero(slanting, viewer.x / length), F(0)};
    const Vec3Of<F> along = cross(viewer, aside);

    // A point of the disc as that the viewer sees the hemisphere; its farther half is narrower.
    const auto disc = onDisc<F>(point.u, point.v);
    const F seen = 0.5F + 0.5F * viewer.z;
    const F free = max(1.0F - disc.x * disc.x, F(0));
    const F y = (1.0F - seen) * sqrt(free) + seen * disc.y;
    const F z = sqrt(max(free - y * y, F(0)));
    const Vec3Of<F> stretched = aside * disc.x + along * y + viewer * z;

    const Vec3Of<F> local{alpha * stretched.x, alpha * stretched.y, max(stretched.z, F(0))};
    const Vec3Of<F> facet = basis.tangent * local.x + basis.bitangent * local.y + normal * local.z;
    return facet / sqrt(dot(facet, facet));
}

/// A direction of light that the lobe sends to the viewer, of unit length; with rough surfaces it may be
/// below them, where nothing is scattered.
template <typename F>
HWY_INLINE Vec3Of<F> sampleGgx(Vec3Of<F> normal, Vec3Of<F> toViewer, F alpha, SquarePointOf<F> point) {
    const Vec3Of<F> facet = sampleFacet<F>(normal, toViewer, alpha, point);
    return facet * (2.0F * dot(toViewer, facet)) - toViewer;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
