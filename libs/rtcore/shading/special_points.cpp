#include "rtcore/shading/special_points.h"

#include "rtcore/math/constants.h"
#include "rtcore/sampling/even_shift.h"
#include "rtcore/shading/paths/path_length-inl.h"
#include "rtcore/shading/surface/frosted_glass.h"
#include "rtcore/shading/surface/surface_split.h"

#include <algorithm>

namespace rtcore {

void SpecialPoints::complete(const FrameContext& frame, Colour ambient, Wave& wave, SampleSums& sums,
                             SecondaryRays& secondary) {
    const Task task{frame, ambient, wave, sums, secondary};
    emitted_.resize(wave.surfaces.notPlain().size());
    materials_.visit(
        frame, wave,
        [&](std::uint32_t k, std::uint32_t i, Colour albedo) { emitted_[k] = setAlbedo(task, i, albedo); },
        [&](std::uint32_t k, std::uint32_t i) { emitted_[k] = completeGeneral(task, i); });
}

Colour SpecialPoints::setAlbedo(const Task& task, std::size_t i, Colour albedo) const {
    const SurfaceWave& surfaces = task.wave.surfaces;
    surfaces.diffuseBrdf.set(i, albedo / kPi);
    if (!task.frame.materials->anyEmission()) return {};
    const Material& m = task.frame.scene->material(surfaces.material[i]);
    if (hasRoughness(m)) return surfaces.weight.colourAt(i) * m.emission;
    const Colour ambient = task.ambient * (albedo + m.specular);
    if ((surfaces.traits[i] & traits::kMirror) == 0)
        return surfaces.weight.colourAt(i) * (m.emission + ambient);
    const float cosine = std::max(dot(surfaces.toViewer.at(i), surfaces.shadingNormal.at(i)), 0.0F);
    return surfaces.weight.colourAt(i) * (m.emission + ambient * (kWhite - mirroredOf(m, cosine)));
}

Colour SpecialPoints::completeGeneral(const Task& task, std::size_t i) const {
    const SurfaceWave& surfaces = task.wave.surfaces;
    const RenderSettings& settings = *task.frame.settings;
    Path path = task.wave.paths.path(i);
    path.weight = surfaces.weight.colourAt(i);
    const Vec3 direction = task.wave.direction(i);
    Surface s = surfaceOfPoint(task.frame, task.wave, i);
    const float t = task.wave.hits.t[i];
    const Scene& scene = *task.frame.scene;
    const bool visible = !settings.refractions || setMedia(scene, task.wave.hits.triangle[i], path.media, s);
    if (!visible) s.coverage = 0;
    if (s.coverage < 1) {
        Path through = path;
        through.weight = path.weight * (1 - s.coverage);
        through.length = HWY_NAMESPACE::lengthAfter(path.length, t, true);
        passUnbent(scene, s, visible, through);
        task.secondary.addHole(task.frame, s, direction, through);
        if (s.coverage == 0) {
            surfaces.traits[i] = 0;
            if (task.wave.paths.primary()) task.sums.setHit(i, false);
            return {};
        }
        path.weight = path.weight * s.coverage;
    }
    if (path.depth == 0) task.sums.setHit(path.sample, true);
    if (settings.refractions && isFrosted(*s.material)) {
        const std::uint32_t salt = mixBits(task.wave.paths.bounces(i)) >> 8;
        takeFacet(facetAlpha(*task.frame.scene, settings.textures, task.wave.hits.hit(i)),
                  evenShift(task.wave.sampleId(i), SampleDimension::Facet, salt), s);
    }
    const SurfaceSplit split = splitLight(s, settings);
    surfaces.shadingNormal.set(i, s.shadingNormal);
    surfaces.diffuseBrdf.set(i, s.diffuse / kPi);
    surfaces.weight.set(i, path.weight * split.scattered);
    if (surfaces.tint.x != nullptr) surfaces.tint.set(i, s.specularTint);
    if (!isBlack(split.mirrored)) {
        surfaces.specular.set(i, path.weight * split.mirrored);
        surfaces.traits[i] |= traits::kSpecular;
    }
    const bool straight =
        (!s.closed && !s.facet) || HWY_NAMESPACE::isFlat<float>(s.shadingNormal, s.geometricNormal);
    path.length = HWY_NAMESPACE::lengthAfter(path.length, t, straight);
    if (!isBlack(split.transmitted)) task.secondary.addTransparent(s, split.transmitted, path);
    if (hasRoughness(*s.material)) return path.weight * s.emission;
    const Colour glossy = s.material->specular * s.specularTint;
    const Colour ambient = task.ambient * (s.diffuse + glossy) * split.scattered;
    return path.weight * (s.emission + ambient);
}

} // namespace rtcore
