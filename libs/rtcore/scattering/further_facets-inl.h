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
inline constexpr float kLeastAlbedo = 1e-3F;

/// What facets of Schlick's reflectance F0 send on after the first one, to one viewer.
template <typename F>
struct FurtherFacets {
    F straight;               ///< times F0: added to the GGX lobe's factor for facets seen straight on
    F grazing, grazingByBase; ///< first + second times F0: added to that for facets at right angles
    F wide[4];                ///< the albedo of the rest, by F0 to the powers 1 to 4
    Vec3Of<F> shape;          ///< of the rest, for furtherFactor()
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
    static constexpr float kStraight[] = {5.402F,   -4.669F, -4.665F, 3.176F,  0.707F,
                                          -17.049F, 22.126F, 0.295F,  -5.278F, 17.668F,
                                          -23.261F, 6.876F,  -6.81F,  4.286F,  1.256F};
    static constexpr float kGrazing[] = {1.375F, -1.691F, 3.065F, -2.477F, -2.545F,
                                         1.826F, 0.405F,  1.948F, -1.568F, -0.54F};
    static constexpr float kGrazingByBase[] = {-8.596F,  23.828F,   -46.406F, 101.021F, -467.128F, 523.74F,
                                               32.272F,  -120.236F, 88.59F,   732.653F, -884.209F, -58.654F,
                                               257.382F, -689.49F,  487.626F, 69.767F,  -113.199F, 40.952F,
                                               -51.945F, 82.785F,   6.585F};
    static constexpr float kWide1[] = {0.0509F, 0.003F, -0.0646F};
    static constexpr float kWide2[] = {-0.2557F, 0.3959F,  1.7439F, 0.3768F, 0.7761F,
                                       -3.2983F, -2.7756F, 2.9678F, 3.4545F, -2.9762F};
    static constexpr float kWide3[] = {-0.1939F, 0.1337F, 0.4713F};
    static constexpr float kCosine[] = {-18.987F, 20.915F, -5.526F, -1.968F, 28.787F,
                                        -27.131F, 4.875F,  0.387F,  13.235F, -12.869F};
    static constexpr float kSquare[] = {13.638F, -14.634F, 1.087F, 1.679F,   -24.747F,
                                        23.318F, -1.669F,  6.667F, -11.108F, 5.212F};
    static constexpr float kAround[] = {-0.174F, -1.165F, -0.166F, 1.242F, 1.485F, -1.196F};
    const F x = min(max(F(0), roughness), F(1)), y = sqrt(min(max(F(0), cosine), F(1)));
    const F straight = polynomial<5>(kStraight, x, y);
    const F grazing = polynomial<4>(kGrazing, x, y), grazingByBase = polynomial<6>(kGrazingByBase, x, y);
    const F wide1 = polynomial<2>(kWide1, x, y), wide2 = polynomial<4>(kWide2, x, y);
    const F wide3 = polynomial<2>(kWide3, x, y);
    // The parts of white make up all of what one reflection loses.
    const F wide4 = 1.0F - straight - (grazing + grazingByBase) * albedo.grazing - (wide1 + wide2 + wide3);
    const F lost = max(1.0F - albedo.straight - albedo.grazing, F(0));
    return {lost * straight / max(albedo.straight, F(kLeastAlbedo)),
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
