#include "rtcore/pathtracing/path_integrator.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/lights/mirrored_light.h"
#include "rtcore/pathtracing/light_hits.h"
#include "rtcore/pathtracing/path_weights-inl.h"
#include "rtcore/pathtracing/scatter_wave.h"
#include "rtcore/shading/surface/emission.h"
#include "rtcore/shading/surface/medium.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace rtcore {

void PathIntegrator::begin(const PathFrame& frame) {
    frame_.scene = &frame.scene;
    frame_.tracer = &frame.tracer;
    settings_ = frame.settings;
    settings_.fog.shafts = 1; // of each ray; without, neighbours decide how exactly fog is integrated
    frame_.settings = &settings_;
    frame_.materials = &frame.materials;
    frame_.statistics = &statistics_;
    frame_.clock = &clock_;
    const SectionPlanes& sections = frame.scene.sections;
    cutsSeen_ =
        sections.light == SectionLight::Whole && !SectionClip(sections, frame.tracer.bounds()).empty();
    lights_ = &frame.lights;
    rows_ = frame.lights.rows();
    limits_ = frame.settings.path;
    strategy_ = frame.strategy;
    white_ = frame.white;
    sums_.keepTransmitted(frame.hidesBackground);
    statistics_ = {};
    clock_.start(false);
    fog_.begin(fogMedium(frame.scene, settings_));
    fogLighting_.begin(frame_, fog_);
    const FogMedium* const medium = fog_.on() ? &fog_.medium() : nullptr;
    shadows_.begin(frame.scene, frame.tracer, settings_, frame.materials.clear(), medium);
    RenderSettings opaque = settings_;
    opaque.refractions = false;
    opaqueGlass_.begin(frame.scene, frame.tracer, opaque, frame.materials.clear());
}

void PathIntegrator::nameSamples(std::span<const SampleId> samples) {
    const std::size_t room = samples.size() + kWaveBlock;
    if (pixelNames_.size() < room) {
        pixelNames_.resize(room);
        subs_.resize(room);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        pixelNames_[i] = pixelName(samples[i], static_cast<std::uint32_t>(limits_.seed));
        subs_[i] = samples[i].sub;
    }
}

void PathIntegrator::trace(const RayWave& rays, std::span<const SampleId> samples) {
    nameSamples(samples);
    sums_.resize(rays.size());
    wave_.samples = samples;
    traceCamera(rays);
    traceOnward();
}

void PathIntegrator::traceWhite(std::span<const WhitePoint> points, std::span<const SampleId> samples) {
    nameSamples(samples);
    sums_.resize(points.size());
    wave_.samples = samples;
    wave_.kind = RayKind::Primary;
    paths_ = nullptr;
    wave_.rays = &cameraRays_;
    next_.clear();
    kept_.start(points.size());
    for (std::size_t first = 0; first < points.size() && !frame_.stopped(); first += PathBatches::kBatch) {
        const std::size_t count = std::min(PathBatches::kBatch, points.size() - first);
        startWhite(points.subspan(first, count));
        startInMedia(static_cast<std::uint32_t>(first));
        onward_ = &next_.roomFor(count);
        setWeights();
        scatter();
    }
    addKept();
    traceOnward();
}

/// Rays of no length that look at the points.
void PathIntegrator::startWhite(std::span<const WhitePoint> points) {
    cameraRays_.clear();
    wave_.hits.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        cameraRays_.push({points[i].position, 0, -points[i].normal, 0});
        wave_.hits.set(i, {0, 0, 0, 0});
    }
    wave_.surfaces.fillWhite(points, *frame_.materials);
}

void PathIntegrator::traceGathering(const RayWave& rays, std::span<const SampleId> samples) {
    nameSamples(samples);
    sums_.startEmpty(rays.size());
    wave_.samples = samples;
    next_.clear();
    for (std::size_t first = 0; first < rays.size(); first += PathBatches::kBatch) {
        const std::size_t last = std::min(first + PathBatches::kBatch, rays.size());
        PathBatch& batch = next_.roomFor(last - first);
        for (std::size_t i = first; i < last; ++i)
            batch.pushGathering(rays.ray(i), static_cast<std::uint32_t>(i));
    }
    traceOnward();
}

/// All that follows.
void PathIntegrator::traceOnward() {
    while (!frame_.stopped() && !next_.empty()) {
        std::swap(current_, next_);
        tracePaths();
    }
}

void PathIntegrator::traceCamera(const RayWave& rays) {
    startStep(RayKind::Primary, rays);
    paths_ = nullptr;
    wave_.rays = &cameraRays_;
    // Rays of the light in fog are traced for each part by itself, and few at once are slower.
    const std::size_t part = fog_.on() ? rays.size() : PathBatches::kBatch;
    for (std::size_t first = 0; first < rays.size() && !frame_.stopped(); first += part) {
        const std::size_t count = std::min(part, rays.size() - first);
        cameraRays_.clear();
        cameraRays_.append(rays, first, count);
        startInMedia(static_cast<std::uint32_t>(first));
        shade(first, count);
    }
    addKept();
}

void PathIntegrator::startInMedia(std::uint32_t first) {
    startMedia_.find(*frame_.scene, *frame_.tracer, cameraRays_, first);
    wave_.paths = WavePaths(first, startMedia_.any() ? &startBatch_.queue : nullptr);
    if (!startMedia_.any()) return;
    startBatch_.start(cameraRays_.size());
    for (std::size_t i = 0; i < cameraRays_.size(); ++i)
        startBatch_.pushStraight(cameraRays_.ray(i), startMedia_.pathOf(i), nullptr, 0);
}

void PathIntegrator::tracePaths() {
    const std::span<PathBatch> batches = current_.batches();
    rays_.clear();
    for (const PathBatch& batch : batches) rays_.append(batch.queue.rays, 0, batch.queue.size());
    takeSeen(batches);
    startStep(RayKind::Scattered, rays_);
    traceSeen();
    std::size_t first = 0;
    for (PathBatch& batch : batches) {
        if (frame_.stopped()) return;
        paths_ = &batch;
        wave_.rays = &batch.queue.rays;
        wave_.paths = WavePaths(batch.queue);
        shade(first, batch.queue.size());
        first += batch.queue.size();
    }
    addKept();
}

/// What the camera sees in mirrors and through glass is cut open, too, where light is not: such rays leave
/// `rays_`, where they become empty, for a wave of their own.
void PathIntegrator::takeSeen(std::span<const PathBatch> batches) {
    seenRays_.clear();
    seenIndices_.clear();
    if (!cutsSeen_) return;
    std::size_t first = 0;
    for (const PathBatch& batch : batches) {
        for (std::size_t i = 0; i < batch.queue.size(); ++i) {
            if ((batch.scattered().state[i] & path_state::kScatters) != 0) continue;
            seenRays_.push(rays_.ray(first + i));
            seenIndices_.push_back(first + i);
            rays_.tMax[first + i] = -1;
        }
        first += batch.queue.size();
    }
}

void PathIntegrator::traceSeen() {
    if (seenRays_.empty()) return;
    frame_.tracer->intersectSeen(seenRays_, seenHits_);
    for (std::size_t i = 0; i < seenIndices_.size(); ++i) hits_.put(seenIndices_[i], seenHits_, i);
    clock_.lap(Stage::Trace);
}

/// Finds what the rays of a step hit; nothing follows from them yet.
void PathIntegrator::startStep(RayKind kind, const RayWave& rays) {
    wave_.kind = kind;
    statistics_.count(kind, rays.size());
    frame_.tracer->intersect(kind, rays, hits_);
    clock_.lap(Stage::Trace);
    next_.clear();
    kept_.start(rays.size());
}

PathNames PathIntegrator::names() const {
    return {pixelNames_.data(), subs_.data(), paths_ == nullptr ? wave_.paths.sample(0) : 0};
}

/// From the rays of the wave, whose hits are those from `first` on, to those that follow.
void PathIntegrator::shade(std::size_t first, std::size_t count) {
    wave_.hits.take(hits_, first, count);
    wave_.surfaces.fill(frame_.scene->mesh(), *frame_.materials, *wave_.rays, wave_.hits);
    if (seesWhite()) wave_.surfaces.whiten(*frame_.materials);
    onward_ = &next_.roomFor(count);
    setWeights();
    if (fog_.on() && !seesWhite()) {
        fog_.enter(*wave_.rays, wave_.hits, wave_.surfaces.traits, wave_.paths);
        fogLighting_.addFog(frame_, wave_, sums_);
        fog_.dimWeights(wave_.surfaces);
    }
    addFound();
    division_.divide({*frame_.scene, *frame_.materials, wave_.hits, Mirroring::Exact}, wave_.surfaces);
    clock_.lap(Stage::Surfaces);
    if (!frame_.stopped()) scatter();
}

/// From the points of the wave, whose weights are known, to what follows.
void PathIntegrator::scatter() {
    sampleLights();
    const ScatterTask task{*frame_.materials, *lights_,
                           limits_,           static_cast<std::uint32_t>(frame_.settings->maxDepth),
                           names(),           rows_.candidates() > 0 ? &events_.samples() : nullptr};
    PathBatch* const past = paths_ == nullptr && wave_.paths.past() != nullptr ? &startBatch_ : paths_;
    scatterPaths(task, wave_, past, *onward_);
    clock_.lap(Stage::Secondary);
}

/// The weight of each hit in its sample, and which samples hit something.
void PathIntegrator::setWeights() {
    SurfaceWave& surfaces = wave_.surfaces;
    if (paths_ == nullptr) {
        sums_.startPart({}, wave_);
        if (!white_) absorbFromStart(wave_);
        return;
    }
    const PathQueue& queue = paths_->queue;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        const Path path = queue.path(i);
        surfaces.weight.set(i, path.weight * absorption(path.extinction, wave_.hits.t[i]));
        const bool seen = path.depth == 0 && paths_->scattered().state[i] == 0;
        if (seen && (surfaces.traits[i] & traits::kGeneral) == 0) sums_.setHit(path.sample, true);
    }
}

/// Adds light that the rays meet themselves: area lights, surroundings, emission.
void PathIntegrator::addFound() {
    if (paths_ != nullptr && lights_->anyArea()) {
        addLightHits(rows_, strategy_, *paths_, wave_);
        for (std::size_t i = 0; i < wave_.size(); ++i) {
            const Colour met = wave_.surfaces.contribution.colourAt(i);
            if (!isBlack(met)) addTo(i, met);
        }
    }
    if (sums_.keepsTransmitted()) addTransmitted();
    if (!seesWhite()) {
        addSurroundings();
        addDiscs();
    }
    if (paths_ != nullptr) addMirrored();
    points_.complete({frame_, names(), limits_.caustics, paths_}, wave_, sums_, *onward_);
    addEmission();
}

/// Adds light that the ray finds; from the second bounce on it may be clamped.
void PathIntegrator::addTo(std::size_t ray, Colour light) {
    if (paths_ != nullptr && (paths_->scattered().state[ray] & path_state::kScatters) > 1)
        light = clampedTo(limits_.clampIndirect, light);
    sums_.add(wave_.paths.sample(ray), light);
}

/// MIS weight of emission, surroundings or discs that the ray met, which next event samples with the density
/// `sampled`.
float PathIntegrator::weightOfHit(std::size_t ray, float sampled) const {
    if (paths_ == nullptr) return 1;
    const ScatterState& scattered = paths_->scattered();
    const std::uint32_t state = scattered.state[ray];
    if ((state & path_state::kDropped) != 0) return 0;
    const float density = scattered.density[ray];
    if ((state & path_state::kWhole) != 0 || density == 0) return 1;
    return HWY_NAMESPACE::misWeightOfScatteredRay<float>(strategy_, density, sampled);
}

/// Whether the point that the ray comes from samples lights and emission itself.
bool PathIntegrator::leavesLightsOut(std::size_t ray) const {
    if (paths_ == nullptr) return false;
    const std::uint32_t state = paths_->scattered().state[ray];
    return (state & path_state::kGathers) != 0 && (state & path_state::kWhole) == 0;
}

/// Straight ways through panes, with caustics too: shadow rays pass those.
bool PathIntegrator::leavesDiscsOut(std::size_t ray) const {
    if (leavesLightsOut(ray)) return true;
    if (paths_ == nullptr) return false;
    const bool straight = wave_.paths.path(ray).depth == 0;
    return straight && (paths_->scattered().state[ray] & path_state::kGathers) != 0;
}

/// Whether the background is seen in a straight line there, where it is hidden.
bool PathIntegrator::hidesBackground(std::size_t ray) const {
    if (!sums_.keepsTransmitted() || wave_.paths.path(ray).depth > 0) return false;
    return paths_ == nullptr || (paths_->scattered().state[ray] & path_state::kScatters) == 0;
}

void PathIntegrator::addTransmitted() {
    const float* const transmittance = fog_.on() && !seesWhite() ? fog_.rays().transmittance : nullptr;
    for (std::size_t i = 0; i < wave_.size(); ++i) {
        if (wave_.surfaces.traits[i] != 0 || !hidesBackground(i)) continue;
        const Path path = wave_.paths.path(i);
        sums_.addTransmitted(path.sample, path.weight * (transmittance != nullptr ? transmittance[i] : 1.0F));
    }
}

void PathIntegrator::addSurroundings() {
    const Colour seen = frame_.scene->background;
    const Environment* const environment = frame_.scene->environment();
    const BackgroundLight& background = lights_->background();
    if (paths_ == nullptr && environment == nullptr && isBlack(seen)) return;
    if (paths_ != nullptr && lights_->surroundings().empty()) return;
    const float* const transmittance = fog_.on() ? fog_.rays().transmittance : nullptr;
    if (paths_ != nullptr) {
        densities_.resize(wave_.size() + kWaveBlock);
        densitiesOfEscaped(lights_->surroundings().rows(), rows_.visible, *paths_, wave_, densities_.data());
    }
    for (std::size_t i = 0; i < wave_.size(); ++i) {
        if (wave_.surfaces.traits[i] != 0 || hidesBackground(i)) continue;
        const Vec3 direction = wave_.direction(i);
        const bool scattered =
            paths_ != nullptr && (paths_->scattered().state[i] & path_state::kScatters) != 0;
        // Cameras do not see the ambient light.
        Colour radiance = scattered || environment != nullptr ? background.radiance(direction) : seen;
        if (scattered) {
            const float probability = probabilityOfSurroundings(rows_, *paths_, i);
            radiance = radiance * weightOfHit(i, probability * densities_[i]);
        }
        if (transmittance != nullptr) radiance = radiance * transmittance[i];
        if (!isBlack(radiance)) addTo(i, wave_.paths.path(i).weight * radiance);
    }
}

/// Adds the discs of directional lights, where rays leave the scene. Light of scattered rays passes
/// homogeneous fog, as that of next event does.
void PathIntegrator::addDiscs() {
    for (const std::uint32_t k : lights_->discs()) {
        const Light& light = rows_.light[k];
        for (std::size_t i = 0; i < wave_.size(); ++i) {
            if (wave_.surfaces.traits[i] != 0 || leavesDiscsOut(i) || hidesBackground(i)) continue;
            Colour radiance = discSeen(light, wave_.direction(i));
            if (isBlack(radiance)) continue;
            const bool shared = paths_ != nullptr && paths_->scattered().density[i] > 0;
            radiance = radiance * weightOfHit(i, shared ? densityOfDisc(rows_, *paths_, i, k) : 0);
            if (fog_.on())
                radiance = radiance * (shared ? fogLightTransmittance(fog_.medium(), light,
                                                                      paths_->scattered().point.at(i))
                                              : fog_.rays().transmittance[i]);
            if (!isBlack(radiance)) addTo(i, wave_.paths.path(i).weight * radiance);
        }
    }
}

/// Adds lights that are seen in mirrors and through glass that bends, by rays that next event does not
/// sample.
void PathIntegrator::addMirrored() {
    for (const std::uint32_t k : lights_->mirrored()) {
        const Light& light = rows_.light[k];
        const Colour radiance = radianceOfMirrored(light);
        for (std::size_t i = 0; i < wave_.size(); ++i) {
            if (paths_->scattered().density[i] > 0 || leavesLightsOut(i)) continue;
            const Path path = wave_.paths.path(i);
            const Ray ray = wave_.rays->ray(i);
            if (path.depth == 0 && (paths_->scattered().state[i] & path_state::kScatters) == 0) continue;
            const float end = wave_.hits.isHit(i) ? wave_.hits.t[i] : std::numeric_limits<float>::infinity();
            const std::optional<float> t = distanceToMirrored(light, ray.origin, ray.direction, end);
            const float weight = t ? weightOfHit(i, 0) : 0;
            if (weight == 0) continue;
            Colour seen = path.weight * radiance * absorption(path.extinction, *t) * weight;
            if (fog_.on() && !path.inside)
                seen = seen * fogTransmittance(fog_.medium(), ray.origin, ray.direction, *t);
            addTo(i, seen);
        }
    }
}

void PathIntegrator::addEmission() {
    if (!frame_.materials->anyEmission()) return;
    const SurfaceWave& surfaces = wave_.surfaces;
    const ArraysOf3& emitted = surfaces.contribution;
    for (float* const array : {emitted.x, emitted.y, emitted.z}) std::fill_n(array, wave_.size(), 0.0F);
    emissionOf(*frame_.materials, surfaces, emitted);
    const std::span<const std::uint32_t> special = surfaces.notPlain();
    for (std::size_t k = 0; k < special.size(); ++k) emitted.set(special[k], points_.emitted()[k]);
    for (std::size_t i = 0; i < wave_.size(); ++i) {
        const Colour light = emitted.colourAt(i);
        if (!wave_.hits.isHit(i) || isBlack(light)) continue;
        addTo(i, light * weightOfEmission(i));
    }
}

float PathIntegrator::weightOfEmission(std::size_t i) const {
    if (paths_ == nullptr) return 1;
    if (leavesLightsOut(i)) return 0;
    const ScatterState& scattered = paths_->scattered();
    if ((scattered.state[i] & path_state::kScatters) != 0) {
        const std::uint32_t material = wave_.surfaces.material[i];
        const std::span<const std::uint8_t> emitsNoLight = lights_->emitsNoLight();
        if (material < emitsNoLight.size() && emitsNoLight[material] != 0) return 0;
    }
    if (scattered.density[i] == 0) return weightOfHit(i, 0);
    const Vec3 offset = wave_.surfaces.position.at(i) - scattered.point.at(i);
    const float cosine = dot(wave_.direction(i), wave_.surfaces.geometricNormal.at(i));
    const Emitters& emitters = lights_->emitters();
    const std::uint32_t triangle = wave_.hits.triangle[i];
    const float sampled = emitters.density(triangle, length(offset), cosine);
    if (!(sampled > 0)) return weightOfHit(i, 0); // no emitter, or beyond all numbers
    return weightOfHit(i, sampled * probabilityOfEmitters(rows_, *paths_, i, emitters.clusterOf(triangle)));
}

/// Next event: one light for each point.
void PathIntegrator::sampleLights() {
    if (rows_.candidates() == 0) return;
    const NextEventTask task{*lights_,
                             rows_,
                             *frame_.scene,
                             frame_.settings->textures,
                             names(),
                             paths_ != nullptr ? paths_->scattered().state : nullptr,
                             static_cast<std::uint32_t>(limits_.bounces),
                             strategy_,
                             frame_.settings->shadows && shadows_.tinted()};
    events_.sample(task, wave_);
    events_.add(task, *frame_.materials, wave_, kept_);
    clock_.lap(Stage::Light);
}

/// Adds what arrives; what one bounce after the first adds may be clamped.
void PathIntegrator::addKept() {
    if (frame_.stopped()) return;
    kept_.finish();
    if (frame_.settings->shadows && kept_.size() > 0) takeShadows();
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        const Colour light = kept_.light.colourAt(i);
        sums_.add(kept_.sample[i], kept_.scatters[i] != 0 ? clampedTo(limits_.clampIndirect, light) : light);
    }
    clock_.lap(Stage::Shadows);
}

/// Takes from the kept light what does not arrive.
void PathIntegrator::takeShadows() {
    if (fog_.on()) {
        for (std::uint32_t group = 0; group <= rows_.surroundingGroup(); ++group) {
            takePart([&](std::uint32_t of) { return of == group; });
            if (!part_.rays.empty()) tint(group);
        }
    } else if (!shadows_.tinted()) {
        const std::vector<std::uint8_t>& occluded = shadows_.occluded(kept_.rays, statistics_);
        for (std::size_t i = 0; i < occluded.size(); ++i) {
            if (occluded[i] != 0) kept_.light.set(i, Colour{});
        }
    } else if (limits_.caustics) {
        takePart([&](std::uint32_t of) { return !isSurrounding(of); });
        if (!part_.rays.empty()) tintBy(shadows_, shadows_.transmittance(part_.rays, statistics_));
        takePart([&](std::uint32_t of) { return isSurrounding(of); });
        if (!part_.rays.empty()) tintBy(opaqueGlass_, opaqueGlass_.transmittance(part_.rays, statistics_));
    } else {
        part_.point.resize(kept_.size());
        std::iota(part_.point.begin(), part_.point.end(), 0U);
        tintBy(shadows_, shadows_.transmittance(kept_.rays, statistics_));
    }
}

/// Whether rays that glass has bent find the light of the group: all but lights without a size, and those
/// with a position that are not to be seen in mirrors.
bool PathIntegrator::isSurrounding(std::uint32_t group) const {
    return group >= rows_.lights || isDisc(rows_.light[group]) || isMirrored(rows_.light[group]);
}

/// The shadow rays to some groups of lights become part_.
template <typename Wanted>
void PathIntegrator::takePart(Wanted&& wanted) {
    part_.rays.clear();
    part_.point.clear();
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        if (!wanted(kept_.group[i])) continue;
        part_.rays.push(kept_.rays.ray(i));
        part_.point.push_back(static_cast<std::uint32_t>(i));
    }
}

/// Attenuates the light of one group by fog and shadows, along the rays of part_.
void PathIntegrator::tint(std::uint32_t group) {
    const Light* const light = group < rows_.lights ? &rows_.light[group] : nullptr;
    if (light != nullptr && !(limits_.caustics && isSurrounding(group)))
        return tintBy(shadows_, shadows_.transmittance(part_.rays, *light, statistics_));
    ShadowTracer& tracer = limits_.caustics ? opaqueGlass_ : shadows_;
    tintBy(tracer, tracer.transmittance(part_.rays, statistics_));
    for (std::size_t i = 0; i < part_.rays.size(); ++i) {
        const Ray ray = part_.rays.ray(i);
        const float left = light != nullptr
                               ? fogLightTransmittance(fog_.medium(), *light, ray.origin)
                               : fogTransmittance(fog_.medium(), ray.origin, ray.direction, ray.tMax);
        kept_.light.set(part_.point[i], kept_.light.colourAt(part_.point[i]) * left);
    }
}

/// Attenuates the light of part_ by the transmittance, and weights it against scattered rays: these find none
/// of the light that passes solids of glass, which bend them.
void PathIntegrator::tintBy(const ShadowTracer& tracer, const std::vector<Colour>& arriving) {
    const bool apart = shadows_.tinted();
    for (std::size_t i = 0; i < arriving.size(); ++i) {
        const std::uint32_t kept = part_.point[i];
        Colour left = arriving[i];
        if (apart) left = (left - tracer.unbent()[i]) + tracer.unbent()[i] * kept_.weight[kept];
        kept_.light.set(kept, kept_.light.colourAt(kept) * left);
    }
}

} // namespace rtcore
