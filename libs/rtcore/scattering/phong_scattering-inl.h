// All lobes of the Phong model together: what they scatter, and directions sampled for it, over the number F:
// float or Float. Included once for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/scattering/lambert-inl.h"
#include "rtcore/scattering/phong-inl.h"

#if defined(RTCORE_SCATTERING_PHONG_SCATTERING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_PHONG_SCATTERING_INL_H_
#undef RTCORE_SCATTERING_PHONG_SCATTERING_INL_H_
#else
#define RTCORE_SCATTERING_PHONG_SCATTERING_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// A point's lobes, in the terms of phong-inl.h.
template <typename F>
struct PhongLobes {
    Vec3Of<F> diffuseBrdf; ///< albedo / pi
    Vec3Of<F> specular;
    F shininess;  ///< at least kMinShininess
    F lobeScale;  ///< (n + 2) / 2 pi times the Phong lobe's fraction of `specular`
    F roughScale; ///< 1 / 2 pi times the rough lobe's
};

/// The probability that samplePhongScattering() follows the Phong lobe: near its part of all that is
/// scattered to a viewer with this cosine. The rough lobe is sampled as the diffuse one is.
template <typename F>
HWY_INLINE F phongProbability(const PhongLobes<F>& lobes, F cosine) {
    const F c = clamp(cosine, 0.0F, 1.0F), rest = 1.0F - c;
    // The albedo of the lobe, to 0.03; within 1 % at right angles.
    const F albedo = c + rest * rest * (0.399F / sqrt(lobes.shininess + 0.56F));
    const F specular = luminance<F>(lobes.specular) * (2.0F * kPi);
    const F gloss = specular * (lobes.lobeScale / (lobes.shininess + 2.0F)) * albedo;
    const F all = gloss + luminance<F>(lobes.diffuseBrdf) * kPi + specular * lobes.roughScale;
    return selectOrZero(all > 0.0F, gloss / all);
}

/// The sum of the lobes' formulas for a point light, and the density of samplePhongScattering().
template <typename F>
HWY_INLINE Scattering<F> scatterPhong(const PhongLobes<F>& lobes, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                      Vec3Of<F> toLight) {
    const F cosine = dot(normal, toLight), viewer = dot(normal, toViewer);
    const auto above = cosine > 0.0F;
    const Vec3Of<F> mirrored = normal * (2.0F * cosine) - toLight;
    const F lobe = dot(mirrored, toViewer);
    const auto seen = above & (lobe > 0.0F) & (maxComponent(lobes.specular) > 0.0F);
    // Most surfaces are matte: this saves the power for them.
    const F power = none(seen) ? F(0) : phongLobe<F>(select(seen, lobe, F(1)), lobes.shininess, F(1));
    const F gloss = selectOrZero(seen, lobes.lobeScale * power);
    const auto isRough = lobes.roughScale > 0.0F;
    const F rough = none(isRough)
                        ? F(0)
                        : selectOrZero(isRough, roughLobe<F>(max(cosine, F(0)), viewer, lobes.roughScale));
    const F probability = phongProbability<F>(lobes, viewer);
    const F density = (1.0F - probability) * lambertDensity<F>(cosine) +
                      probability * selectOrZero(seen, phongDensityScale<F>(lobes.shininess) * power);
    return {selectOrZero(above, lobes.diffuseBrdf + lobes.specular * gloss + lobes.specular * rough),
            selectOrZero(above, density)};
}

/// A direction of unit length with the density of scatterPhong(); it may be below the surface, where nothing
/// is scattered. `lobe`: a random number in 0..1.
template <typename F>
HWY_INLINE Vec3Of<F> samplePhongScattering(const PhongLobes<F>& lobes, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                           F lobe, SquarePointOf<F> point) {
    const F cosine = dot(normal, toViewer);
    const auto glossy = lobe < phongProbability<F>(lobes, cosine);
    if (none(glossy)) return sampleLambert<F>(normal, point);
    const Vec3Of<F> mirrored = normal * (2.0F * cosine) - toViewer;
    const Vec3Of<F> reflected = samplePhong<F>(mirrored, lobes.shininess, point);
    if (all(glossy)) return reflected;
    return select(glossy, reflected, sampleLambert<F>(normal, point));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
