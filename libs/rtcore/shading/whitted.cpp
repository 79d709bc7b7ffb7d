#include "rtcore/shading/whitted.h"

#include "rtcore/lights/ambient_light.h"
#include "rtcore/lights/light_hit-inl.h"
#include "rtcore/lights/mirrored_light.h"
#include "rtcore/shading/surface/emission.h"
#include "rtcore/shading/surface/frosted_glass.h"
#include "rtcore/shading/surface/medium.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace rtcore {

WhittedIntegrator::WhittedIntegrator(const Scene& scene, const RayTracer& tracer,
                                     const RenderSettings& settings) {
    ownMaterials_.prepare(scene, settings);
    begin(scene, tracer, settings, ownMaterials_);
}

void WhittedIntegrator::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                              const MaterialTable& materials, bool measureStages) {
    frame_.scene = &scene;
    frame_.tracer = &tracer;
    frame_.settings = &settings;
    frame_.materials = &materials;
    const auto anyLight = [&](auto&& is) {
        return std::ranges::any_of(
            scene.lights, [&](const SceneLight& each) { return each.light.on != 0 && is(each.light); });
    };
    frame_.discs = anyLight(isDisc);
    mirroredLights_ = anyLight(isMirrored);
    statistics_ = {};
    fog_.begin(fogMedium(scene, settings));
    lighting_.begin(frame_, fog_);
    ambient_ = frame_.indirectTaps != nullptr ? Colour{} : unoccludedAmbient(scene, settings);
    clock_.start(measureStages);
}

bool WhittedIntegrator::needsSampleIds(const Scene& scene, const RenderSettings& settings) {
    const auto soft = [](const Light& light) { return light.on != 0 && isAreaLight(light); };
    const bool areaLights =
        settings.areaLights.samples > 0 && std::ranges::any_of(scene.lights, soft, &SceneLight::light);
    const bool shafts = settings.fog.shafts > 0 && fogMedium(scene, settings).on;
    const bool frosted = settings.refractions && std::ranges::any_of(scene.materials, isFrosted);
    return frosted || settings.ambientOcclusion.on || settings.skyLight.on || areaLights || shafts ||
           scene.lights.size() > LightChoice::kAll;
}

void WhittedIntegrator::trace(const RayWave& primary, std::span<const SampleId> samples) {
    frame_.statistics = &statistics_;
    frame_.clock = &clock_;
    secondary_.start();
    taps_.clear();
    if (hitParts_ != PrimaryHitParts::None) primaryHits_.start(primary.size());
    if (collectsNormals_) normals_.start(primary.size());
    wave_.kind = RayKind::Primary;
    wave_.rays = &primary;
    startMedia_.find(*frame_.scene, *frame_.tracer, primary, 0);
    startPaths_.clear();
    for (std::size_t i = 0; startMedia_.any() && i < primary.size(); ++i)
        startPaths_.push(primary.ray(i), startMedia_.pathOf(i));
    wave_.paths = WavePaths(0, startMedia_.any() ? &startPaths_ : nullptr);
    wave_.samples = samples;
    traceWave();
    while (!secondary_.empty()) {
        if (frame_.stopped()) return;
        secondary_.takeNext(wave_);
        traceWave();
    }
    secondary_.evenMemory();
}

void WhittedIntegrator::trace(const RayWave& primary, std::span<Colour> radiance,
                              std::span<std::uint8_t> hit) {
    trace(primary);
    for (std::size_t i = 0; i < primary.size(); ++i) radiance[i] = sums_.radiance().colourAt(i);
    std::copy_n(sums_.hit().begin(), primary.size(), hit.begin());
}

void WhittedIntegrator::traceWave() {
    statistics_.count(wave_.kind, wave_.rays->size());
    frame_.tracer->intersect(wave_.kind, *wave_.rays, wave_.hits);
    clock_.lap(Stage::Trace);
    wave_.surfaces.fill(frame_.scene->mesh(), *frame_.materials, *wave_.rays, wave_.hits);
    if (seesWhite()) wave_.surfaces.whiten(*frame_.materials);
    setWeights();
    if (fog_.on() && !seesWhite()) {
        fog_.enter(*wave_.rays, wave_.hits, wave_.surfaces.traits, wave_.paths);
        fog_.dimWeights(wave_.surfaces);
    }
    addBackground();
    if (frame_.discs && !seesWhite()) addDiscs();
    if (mirroredLights_ && !wave_.paths.primary()) addMirrored();
    special_.complete(frame_, ambient_, wave_, sums_, secondary_);
    divideLight(findEmission());
    if (hitParts_ != PrimaryHitParts::None) primaryHits_.take(wave_, frame_.scene->mesh(), *frame_.materials);
    if (collectsNormals_) normals_.add(wave_);
    clock_.lap(Stage::Surfaces);
    if (fog_.on() && !seesWhite()) lighting_.addFog(frame_, wave_, sums_);
    if (frame_.indirectTaps != nullptr) addTaps();
    lighting_.addLight(frame_, wave_, {sums_, hitParts_ == PrimaryHitParts::All ? &primaryHits_ : nullptr});
    if (hitParts_ != PrimaryHitParts::None) primaryHits_.takeSurfaceLight(wave_, sums_);
    secondary_.makeSecondaryRays(frame_, wave_);
    clock_.lap(Stage::Secondary);
}

void WhittedIntegrator::addTaps() {
    const std::size_t before = taps_.matte.size();
    taps_.add(*frame_.materials, wave_,
              {frame_.pixelSize, frame_.lobeRays, frame_.settings->minContribution});
    if (hitParts_ != PrimaryHitParts::None) primaryHits_.noteTaps(std::span(taps_.matte).subspan(before));
}

void WhittedIntegrator::addIndirect(std::span<const ArrivingLight> arriving) {
    for (std::size_t i = 0; i < taps_.matte.size(); ++i) {
        const IndirectTap& tap = taps_.matte[i];
        const Colour light = tap.light(arriving[i].irradiance);
        sums_.add(tap.sample, light);
        if (tap.primary) primaryHits_.addIndirect(tap.sample, light);
    }
}

void WhittedIntegrator::addAlongLobes(std::span<const Colour> radiance) {
    for (std::size_t i = 0; i < taps_.lobes.size(); ++i)
        sums_.add(taps_.lobes[i].sample, taps_.lobes[i].factor * radiance[i]);
}

/// The weight of each hit in its sample if all light were scattered; and which samples hit something. Starts
/// the sums of the samples.
void WhittedIntegrator::setWeights() {
    SurfaceWave& surfaces = wave_.surfaces;
    if (wave_.paths.primary()) {
        const bool plain = frame_.scene->environment() == nullptr && !fog_.on() && !white_;
        sums_.start(plain ? frame_.scene->background : Colour{}, wave_);
        if (!white_) absorbFromStart(wave_);
        return;
    }
    const PathQueue& queue = *wave_.paths.queue();
    const std::size_t count = surfaces.size();
    std::copy_n(queue.weight[0].data(), count, surfaces.weight.x);
    std::copy_n(queue.weight[1].data(), count, surfaces.weight.y);
    std::copy_n(queue.weight[2].data(), count, surfaces.weight.z);
    // Only where something is transparent, rays are inside of it, or have passed it before they hit.
    if (wave_.kind == RayKind::Mirror && !frame_.materials->tintedShadows()) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (surfaces.traits[i] == 0) continue;
        const Path path = queue.path(i);
        surfaces.weight.set(i, path.weight * absorption(path.extinction, wave_.hits.t[i]));
        if (path.depth == 0 && (surfaces.traits[i] & traits::kGeneral) == 0) sums_.setHit(path.sample, true);
    }
}

/// Whether the background is seen in a straight line there, where it is hidden.
bool WhittedIntegrator::hidesBackground(std::size_t ray) const {
    return sums_.keepsTransmitted() && wave_.paths.path(ray).depth == 0;
}

void WhittedIntegrator::addBackground() {
    const Environment* const environment = frame_.scene->environment();
    const Colour background = frame_.scene->background;
    if (!sums_.keepsTransmitted()) {
        if (seesWhite() || (environment == nullptr && isBlack(background))) return;
        if (environment == nullptr && wave_.paths.primary() && !fog_.on()) return; // the sums began with it
    }
    const float* const transmittance = fog_.on() && !seesWhite() ? fog_.rays().transmittance : nullptr;
    for (std::size_t i = 0; i < wave_.size(); ++i) {
        if (wave_.surfaces.traits[i] != 0 || (transmittance != nullptr && transmittance[i] == 0)) continue;
        if (hidesBackground(i)) {
            const Path straight = wave_.paths.path(i);
            sums_.addTransmitted(straight.sample,
                                 straight.weight * (transmittance != nullptr ? transmittance[i] : 1.0F));
            continue;
        }
        Colour seen = background;
        if (environment != nullptr)
            seen = environment->radiance(wave_.direction(i), frame_.settings->environmentFilter);
        if (transmittance != nullptr) seen = seen * transmittance[i];
        const Path path = wave_.paths.path(i);
        sums_.add(path.sample, path.weight * seen);
    }
}

/// The discs of directional lights, where rays leave the scene.
void WhittedIntegrator::addDiscs() {
    const float* const transmittance = fog_.on() ? fog_.rays().transmittance : nullptr;
    for (const SceneLight& each : frame_.scene->lights) {
        const Light& light = each.light;
        if (light.on == 0 || !isDisc(light)) continue;
        const Colour radiance = HWY_NAMESPACE::radianceOf<LightKind::Directional>(light);
        for (std::size_t i = 0; i < wave_.size(); ++i) {
            if (wave_.surfaces.traits[i] != 0 || (wave_.paths.bounces(i) & kLobeBit) != 0) continue;
            if (hidesBackground(i)) continue;
            if (!HWY_NAMESPACE::meetsDisc<float>(light, wave_.direction(i))) continue;
            const float left = transmittance != nullptr ? transmittance[i] : 1.0F;
            const Path path = wave_.paths.path(i);
            sums_.add(path.sample, path.weight * radiance * left);
        }
    }
}

/// Lights that are seen in mirrors, before what the rays hit that were mirrored or bent.
void WhittedIntegrator::addMirrored() {
    for (const SceneLight& each : frame_.scene->lights) {
        const Light& light = each.light;
        if (light.on == 0 || !isMirrored(light)) continue;
        const Colour radiance = radianceOfMirrored(light);
        for (std::size_t i = 0; i < wave_.size(); ++i) {
            const Path path = wave_.paths.path(i);
            if (path.depth == 0) continue;
            const Ray ray = wave_.rays->ray(i);
            const float end = wave_.hits.isHit(i) ? wave_.hits.t[i] : std::numeric_limits<float>::infinity();
            const std::optional<float> t = distanceToMirrored(light, ray.origin, ray.direction, end);
            if (!t) continue;
            Colour seen = path.weight * radiance * absorption(path.extinction, *t);
            if (fog_.on() && !path.inside)
                seen = seen * fogTransmittance(fog_.medium(), ray.origin, ray.direction, *t);
            sums_.add(path.sample, seen);
        }
    }
}

/// Emission and the ambient light that nothing occludes, of which metal's lobes are yet to reflect theirs.
/// Those of primary rays lie in their sums; null: there are none.
const ArraysOf3* WhittedIntegrator::findEmission() {
    if (!frame_.materials->anyEmission()) return nullptr;
    const SurfaceWave& surfaces = wave_.surfaces;
    const bool primary = wave_.paths.primary();
    const ArraysOf3& emitted = primary ? sums_.radiance() : surfaces.contribution;
    if (!primary) {
        for (float* const array : {emitted.x, emitted.y, emitted.z}) std::fill_n(array, wave_.size(), 0.0F);
    }
    emissionOf(*frame_.materials, surfaces, emitted);
    const std::span<const std::uint32_t> special = surfaces.notPlain();
    for (std::size_t i = 0; i < special.size(); ++i) emitted.set(special[i], special_.emitted()[i]);
    return &emitted;
}

void WhittedIntegrator::divideLight(const ArraysOf3* emitted) {
    division_.divide({*frame_.scene, *frame_.materials, wave_.hits, Mirroring::Faded, ambient_, emitted},
                     wave_.surfaces);
    if (emitted != nullptr && !wave_.paths.primary()) sums_.add(wave_);
}

} // namespace rtcore
