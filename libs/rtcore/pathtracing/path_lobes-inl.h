// How paths go on at a point: by the lobes of its surface, or as its mirror does. Included once for each
// instruction set, inside the loop of foreach_target.h.
#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/shading/surface/lobes-inl.h"

#if defined(RTCORE_PATHTRACING_PATH_LOBES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_PATH_LOBES_INL_H_
#undef RTCORE_PATHTRACING_PATH_LOBES_INL_H_
#else
#define RTCORE_PATHTRACING_PATH_LOBES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Whether a path is mirrored or scattered by lobes.
struct MirrorChoice {
    Float probability; ///< that it is mirrored, 0..1
    Mask possible;     ///< it goes on by one or the other
};

HWY_INLINE MirrorChoice mirrorChoiceOf(const PointLobes& points) {
    const SurfaceWave& s = points.s;
    const Mask mirrors = points.used & hasTrait(load(s.traits + points.i), traits::kSpecular);
    const bool anyMirror = any(mirrors);
    Float mirrored{};
    if (anyMirror)
        mirrored = selectOrZero(mirrors, max(luminance<Float>(loadAt(s.specular, points.i)), 0.0F));
    const Float scattered = max(luminance<Float>(loadAt(s.weight, points.i) * albedoOf(points)), 0.0F);
    const Float both = mirrored + scattered;
    const Mask possible = points.used & ((both > 0.0F) & isFinite(both));
    Float probability{};
    if (anyMirror) probability = selectOrZero(possible, mirrored / select(possible, both, Float(1)));
    return {probability, possible};
}

/// Light from `toLight`, of unit length, with the density of sampleBsdf() where that does not mirror; zero
/// where it is below the surface.
HWY_INLINE Scattered scatteredFrom(const PointLobes& points, const MirrorChoice& mirror, Float3 toLight) {
    const Incidence incidence = incidenceOf(points.normals, toLight);
    const Scattered all =
        scatteredFrom<false, SumOrder::OfPaths>(points, toLight, incidence, {Float(0), Float(1), Float(1)});
    return {selectOrZero(incidence.above, all.value),
            selectOrZero(incidence.above, (1.0F - mirror.probability) * all.density)};
}

struct BsdfSample {
    Float3 direction; ///< unit
    Mask mirrored;    ///< it is the one direction of a mirror
    Mask matte;       ///< LobeSample
};

/// A direction by the random numbers `lobe` and `point`, each 0..1, without 1.
HWY_INLINE BsdfSample sampleBsdf(const PointLobes& points, const MirrorChoice& mirror, Float lobe,
                                 SquarePointOf<Float> point) {
    const Mask mirrored = mirror.possible & (lobe < mirror.probability);
    const Float rest = (lobe - mirror.probability) / max(1.0F - mirror.probability, 1e-6F);
    const LobeSample scattered = sampleLobes(points, rest, point);
    if (none(mirrored)) return {scattered.direction, mirrored, scattered.matte};
    const PointNormals& normals = points.normals;
    const Float3 direction =
        mirrorDirection<Float>(loadAt(points.s.toViewer, points.i), normals.shading, normals.geometric);
    return {select(mirrored, normalize(direction, mirrored), scattered.direction), mirrored, scattered.matte};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
