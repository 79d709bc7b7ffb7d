// Light that microfacets mirror more than once before it leaves, over the number F: float or Float. Included
// once for each instruction set, inside the loop of foreach_target.h, or alone.
//
// How much of it white surfaces send follows from what one reflection loses. How much others do, and which
// way, was fitted to random walks on the microsurface (Heitz, Hanika, d'Eon and Dachsbacher 2016,
// "Multiple-Scattering Microfacet BSDFs with the Smith Model"): a part as the lobe of one reflection, with
// factors of its own straight on and at right angles, the rest evenly but for the first terms of a series.
// The walks had roughness 0.14..1 and viewers with a cosine of 0.05..1; beyond, light is neither lost nor
// negative.
#include "rtcore/math/float3-inl.h"
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

/// Factors that stand for what a lobe lacks divide by no less.
inline constexpr float kMinAlbedo = 1e-3F;

/// Light that facets of Schlick's reflectance F0 scatter to one viewer after the first facet.
template <typename F>
struct FurtherFacets {
    /// Added to the GGX lobe's factors: F0 (first + second F0) to that for facets seen straight on, first +
    /// second F0 to that for facets at right angles.
    F straight, straightByBase, grazing, grazingByBase;
    F wide[4];       ///< the albedo of the rest, by F0 to the powers 1 to 4
    Vec3Of<F> shape; ///< of the rest, for furtherFactor()
};

/// c[0] + c[1] y + ... + x (c[length] + c[length + 1] y + ... + x (...)): all terms of x and y of a degree
/// below `length`.
template <std::size_t length, std::size_t first = 0, typename F, std::size_t n>
HWY_INLINE F polynomial(const float (&c)[n], F x, F y) {
    static_assert(first + length * (length + 1) / 2 == n);
    F row = c[first + length - 1];
    for (std::size_t i = length - 1; i-- > 0;) row = c[first + i] + y * row;
    if constexpr (length == 1) {
        return row;
    } else {
        return row + x * polynomial<length - 1, first + length>(c, x, y);
    }
}

/// `albedo`: of one reflection at this roughness and cosine of the viewer.
template <typename F>
HWY_INLINE FurtherFacets<F> furtherFacets(const GgxAlbedo<F>& albedo, F roughness, F cosine) {
    static constexpr float kStraight[] = {4.902F,   -2.623F, -8.449F, 5.217F,  0.441F,
                                          -17.134F, 21.361F, 4.014F,  -6.567F, 18.784F,
                                          -25.87F,  6.182F,  -6.998F, 5.913F,  0.883F};
    static constexpr float kStraightByBase[] = {0.194F, 0.43F, -0.373F, -0.516F, 0.293F, 0.016F};
    static constexpr float kGrazing[] = {1.513F, -1.802F, 0.535F, 2.824F,  -2.567F,
                                         5.72F,  -5.314F, 0.315F, -1.329F, 0.36F};
    static constexpr float kGrazingByBase[] = {-8.961F,  19.677F,   -18.411F, 30.249F,  -413.152F, 503.728F,
                                               40.436F,  -136.429F, 67.479F,  883.164F, -957.732F, -82.209F,
                                               325.816F, -862.614F, 485.862F, 94.003F,  -97.374F,  150.661F,
                                               -75.551F, 34.062F,   20.313F};
    static constexpr float kWide1[] = {0.0821F, 0.012F, -0.1025F};
    static constexpr float kWide2[] = {-0.3971F, 0.5408F,  2.0188F, -0.0811F, 1.7901F,
                                       -4.3041F, -1.7197F, 1.4847F, 3.0634F,  -2.0225F};
    static constexpr float kWide3[] = {-0.4133F, -0.083F, 0.8854F};
    static constexpr float kCosine[] = {-11.99F, 3.999F,  -1.154F, 1.037F, 18.271F,
                                        7.572F,  -9.198F, -2.715F, 4.819F, -8.902F};
    static constexpr float kSquare[] = {8.652F,  -2.031F, -2.426F, -0.729F, -18.122F,
                                        -2.465F, 9.258F,  11.107F, -4.686F, 0.946F};
    static constexpr float kAround[] = {-0.428F, -0.61F, -0.224F, 1.599F, 1.003F, -1.324F};
    const F x = min(max(F(0), roughness), F(1)), y = sqrt(min(max(F(0), cosine), F(1)));
    const F straight = polynomial<5>(kStraight, x, y);
    const F straightByBase = polynomial<3>(kStraightByBase, x, y);
    const F grazing = polynomial<4>(kGrazing, x, y), grazingByBase = polynomial<6>(kGrazingByBase, x, y);
    const F wide1 = polynomial<2>(kWide1, x, y), wide2 = polynomial<4>(kWide2, x, y);
    const F wide3 = polynomial<2>(kWide3, x, y);
    // The parts of white make up all of what one reflection loses.
    const F wide4 = 1.0F - straight - straightByBase - (grazing + grazingByBase) * albedo.grazing -
                    (wide1 + wide2 + wide3);
    const F lost = max(1.0F - albedo.straight - albedo.grazing, F(0));
    const F ofStraight = lost / max(albedo.straight, F(kMinAlbedo));
    return {ofStraight * straight,
            ofStraight * straightByBase,
            lost * grazing,
            lost * grazingByBase,
            {lost * wide1, lost * wide2, lost * wide3, lost * wide4},
            {polynomial<4>(kCosine, x, y), polynomial<4>(kSquare, x, y), polynomial<3>(kAround, x, y)}};
}

/// The albedo of the wide part for facets of reflectance F0.
template <typename F>
HWY_INLINE F wideAlbedo(const FurtherFacets<F>& further, F reflectance) {
    return reflectance * polynomial(further.wide, reflectance);
}

/// The wide part's lobe over that of a matte surface with its albedo. At least 0, with that integral:
/// `around`, the cosine of light and viewer, counts only as far as it changes when the light turns around the
/// normal. All directions are above the surface.
template <typename F>
HWY_INLINE F furtherFactor(Vec3Of<F> shape, F viewerCosine, F lightCosine, F around) {
    return 1.0F + shape.x * (lightCosine - 2.0F / 3) + shape.y * (lightCosine * lightCosine - 0.5F) +
           shape.z * (around - viewerCosine * lightCosine);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
