#include "rtcore/pathtracing/path_points.h"

#include "rtcore/math/constants.h"
#include "rtcore/pathtracing/path_numbers-inl.h"
#include "rtcore/shading/paths/path_length-inl.h"
#include "rtcore/shading/secondary_rays.h"
#include "rtcore/shading/surface/frosted_glass.h"
#include "rtcore/shading/surface/surface_split.h"

#include <algorithm>

namespace rtcore {

namespace {

/// For one use at the point of a path.
SquarePoint numbersFor(const PathPoints::Task& task, const Wave& wave, std::size_t i,
                       SampleDimension dimension) {
    const std::uint32_t sample = wave.paths.sample(i);
    const std::uint32_t scatters =
        task.paths != nullptr ? task.paths->scattered().state[i] & path_state::kScatters : 0U;
    const auto visit = HWY_NAMESPACE::visitOf(scatters, wave.paths.bounces(i));
    const std::uint32_t name = HWY_NAMESPACE::nameOfNumbers(task.names.pixel[sample], dimension, visit);
    const auto pair = owenPair(task.names.sub[sample], name);
    return {unitFloat(pair.u), unitFloat(pair.v)};
}

/// 0 <= u < 1.
float numberFor(const PathPoints::Task& task, const Wave& wave, std::size_t i, SampleDimension dimension) {
    return numbersFor(task, wave, i, dimension).u;
}

/// Updates which light a ray counts, once glass has bent it or a pane has let it pass.
void passGlass(bool bent, bool caustics, const ScatterState& state, std::size_t ray) {
    if (bent) state.density[ray] = 0;
    if ((state.state[ray] & path_state::kScatters) == 0) return;
    if (caustics) {
        state.state[ray] |= path_state::kWhole;
    } else if (bent) {
        state.state[ray] |= path_state::kDropped;
    }
}

} // namespace

void PathPoints::complete(const Task& task, Wave& wave, SampleSums& sums, PathBatch& next) {
    emitted_.resize(wave.surfaces.notPlain().size());
    const SurfaceWave& surfaces = wave.surfaces;
    materials_.visit(
        task.frame, wave,
        [&](std::uint32_t k, std::uint32_t i, Colour albedo) {
            surfaces.diffuseBrdf.set(i, albedo / kPi);
            emitted_[k] =
                surfaces.weight.colourAt(i) * task.frame.scene->material(surfaces.material[i]).emission;
        },
        [&](std::uint32_t k, std::uint32_t i) { emitted_[k] = completeGeneral(task, wave, i, sums, next); });
}

Colour PathPoints::completeGeneral(const Task& task, Wave& wave, std::size_t i, SampleSums& sums,
                                   PathBatch& next) {
    const SurfaceWave& surfaces = wave.surfaces;
    const RenderSettings& settings = *task.frame.settings;
    Path path = wave.paths.path(i);
    const bool fromCamera = path.depth == 0 && task.paths == nullptr;
    path.weight = surfaces.weight.colourAt(i);
    const Vec3 direction = wave.direction(i);
    Surface s = surfaceOfPoint(task.frame, wave, i);
    const float t = wave.hits.t[i];
    const Scene& scene = *task.frame.scene;
    const bool visible = !settings.refractions || setMedia(scene, wave.hits.triangle[i], path.media, s);
    if (!visible) s.coverage = 0;
    if (s.coverage < 1 && !(numberFor(task, wave, i, SampleDimension::Hole) < s.coverage)) {
        path.length = HWY_NAMESPACE::lengthAfter(path.length, t, true);
        surfaces.traits[i] = 0;
        if (fromCamera) sums.setHit(path.sample, false);
        passUnbent(scene, s, visible, path);
        if (const auto ray = rayThroughHole(s, direction, path)) next.pushStraight(*ray, path, task.paths, i);
        return {};
    }
    if (path.depth == 0) sums.setHit(path.sample, true);
    if (settings.refractions && isFrosted(*s.material))
        takeFacet(facetAlpha(scene, settings.textures, wave.hits.hit(i)),
                  numbersFor(task, wave, i, SampleDimension::Facet), s);
    const SurfaceSplit split = splitLight(s, settings);
    const Colour emitted = path.weight * s.emission;
    const float through = luminance(split.transmitted);
    const float rest = luminance(split.mirrored) + luminance(split.scattered);
    float kept = 1; // the chance that the path stays on this side
    if (through > 0) {
        const float passes = through / (through + rest);
        if (numberFor(task, wave, i, SampleDimension::Glass) < passes) {
            const bool straight =
                (!s.closed && !s.facet) || HWY_NAMESPACE::isFlat<float>(s.shadingNormal, s.geometricNormal);
            path.length = HWY_NAMESPACE::lengthAfter(path.length, t, straight);
            path.weight *= split.transmitted / passes;
            surfaces.traits[i] = 0;
            const auto ray = rayBehind(s, settings.maxDepth, path);
            if (ray && !isBlack(path.weight)) {
                next.pushStraight(*ray, path, task.paths, i);
                passGlass(s.closed || s.facet, task.caustics, next.scattered(), next.queue.size() - 1);
            }
            return emitted;
        }
        kept = 1 - passes;
    }
    surfaces.shadingNormal.set(i, s.shadingNormal);
    surfaces.diffuseBrdf.set(i, s.diffuse / kPi);
    if (surfaces.tint.x != nullptr) surfaces.tint.set(i, s.specularTint);
    surfaces.weight.set(i, path.weight * split.scattered / kept);
    if (!isBlack(split.mirrored)) {
        surfaces.specular.set(i, path.weight * split.mirrored / kept);
        surfaces.traits[i] |= traits::kSpecular;
    }
    return emitted;
}

} // namespace rtcore
