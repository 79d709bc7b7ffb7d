#include "rtcore/shading/whitted.h"

#include "rtcore/math/constants.h"
#include "rtcore/scattering/fresnel.h"
#include "rtcore/shading/medium.h"
#include "rtcore/shading/mirror_wave.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/texture_wave.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

/// Secondary rays traced at once: enough for streams, and a bound on the memory of the queues.
constexpr std::size_t kWaveSize = 16384;
/// Thin walls and holes that a path may pass; it bounds the work of a hostile model.
constexpr std::uint16_t kMaxPasses = 1000;
constexpr float kInfinity = std::numeric_limits<float>::max();

/// `side` is the normal on the side that the ray leaves to.
Ray rayFrom(const Surface& s, Vec3 side, Vec3 direction) {
    return {s.position + side * s.clearance, 0, direction, kInfinity};
}

} // namespace

WhittedIntegrator::WhittedIntegrator(const Scene& scene, const RayTracer& tracer,
                                     const RenderSettings& settings) {
    ownMaterials_.prepare(scene, settings);
    begin(scene, tracer, settings, ownMaterials_);
}

void WhittedIntegrator::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                              const MaterialTable& materials, bool measureStages) {
    scene_ = &scene;
    tracer_ = &tracer;
    settings_ = &settings;
    materials_ = &materials;
    statistics_ = {};
    fog_.begin(fogMedium(scene, settings));
    shadows_.begin(scene, tracer, settings, materials.tintedShadows(), fog_.on() ? &fog_.medium() : nullptr);
    occlusion_.begin(scene, tracer, settings, materials);
    ambient_ = unoccludedAmbient(scene, settings);
    clock_.start(measureStages);
}

bool WhittedIntegrator::drawsSamples(const Scene& scene, const RenderSettings& settings) {
    const auto soft = [](const Light& light) { return light.on != 0 && hasSize(light); };
    const bool lamps = settings.areaLights.samples > 0 && std::ranges::any_of(scene.lights, soft);
    const bool shafts = settings.fog.shafts > 0 && fogMedium(scene, settings).on;
    return settings.ambientOcclusion.on || lamps || shafts;
}

/// Without names, a sample's place in the wave is its pixel.
SampleId WhittedIntegrator::sampleId(std::uint32_t sample) const {
    if (!samples_.empty()) return samples_[sample];
    return {static_cast<std::uint16_t>(sample), static_cast<std::uint16_t>(sample >> 16), 0};
}

void WhittedIntegrator::trace(const RayWave& primary, std::span<const SampleId> samples) {
    const std::size_t count = primary.size();
    samples_ = samples;
    radianceMemory_.resize(3, count);
    radiance_ = {radianceMemory_.array(0), radianceMemory_.array(1), radianceMemory_.array(2)};
    hit_.resize(count + kWaveBlock);
    mirrored_.clear();
    refracted_.clear();

    if (collectFirstHits_) firstHits_.start(count);
    paths_ = WavePaths();
    traceWave(RayKind::Primary, primary);
    paths_ = WavePaths(wave_);
    while (!mirrored_.empty() || !refracted_.empty()) {
        if (stopped()) return;
        const bool mirror = mirrored_.size() >= refracted_.size();
        (mirror ? mirrored_ : refracted_).takeLast(kWaveSize, wave_);
        traceWave(mirror ? RayKind::Mirror : RayKind::Refracted, wave_.rays);
    }
    evenQueues();
}

/// The queues change places as they are emptied: in a steady frame any must have room for the largest.
void WhittedIntegrator::evenQueues() {
    const std::size_t most = std::max({wave_.capacity(), mirrored_.capacity(), refracted_.capacity()});
    for (PathQueue* const queue : {&wave_, &mirrored_, &refracted_}) queue->reserve(most);
}

void WhittedIntegrator::trace(const RayWave& primary, std::span<Colour> radiance,
                              std::span<std::uint8_t> hit) {
    trace(primary);
    for (std::size_t i = 0; i < primary.size(); ++i) radiance[i] = radiance_.colourAt(i);
    std::copy_n(hit_.begin(), primary.size(), hit.begin());
}

void WhittedIntegrator::traceWave(RayKind kind, const RayWave& rays) {
    statistics_.count(kind, rays.size());
    tracer_->intersect(kind, rays, hits_);
    clock_.lap(Stage::Trace);
    surfaces_.fill(scene_->mesh(), *materials_, rays, hits_);
    setShares(kind);
    if (fog_.on()) enterFog(rays);
    addBackground(rays);
    completePoints(rays);
    addGlow();
    if (collectFirstHits_) takeFirstHits();
    clock_.lap(Stage::Surfaces);
    if (fog_.on()) addFog();
    if (occlusion_.on()) lightFromEverywhere();
    for (std::uint32_t i = 0; i < scene_->lights.size(); ++i) {
        if (scene_->lights[i].on != 0 && !stopped()) lightBy(scene_->lights[i], i);
    }
    lit_ = Lit::Not;
    spawn();
    clock_.lap(Stage::Spawn);
}

/// What reaches the samples from each hit, were it all scattered; and which samples hit something. Starts the
/// sums of the samples.
void WhittedIntegrator::setShares(RayKind kind) {
    if (paths_.primary()) {
        const bool plain = scene_->environment() == nullptr && !fog_.on();
        startSums(plain ? scene_->background : Colour{}, surfaces_, radiance_, hit_.data());
        return;
    }
    const std::size_t count = surfaces_.size();
    std::copy_n(wave_.weight[0].data(), count, surfaces_.share.x);
    std::copy_n(wave_.weight[1].data(), count, surfaces_.share.y);
    std::copy_n(wave_.weight[2].data(), count, surfaces_.share.z);
    // Only where something is transparent, rays are inside of it, or have passed it before they hit.
    if (kind == RayKind::Mirror && !materials_->tintedShadows()) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (surfaces_.traits[i] == 0) continue;
        const Path path = wave_.path(i);
        surfaces_.share.set(i, path.weight * absorption(path.extinction, hits_.t[i]));
        if (path.depth == 0 && (surfaces_.traits[i] & traits::kGeneral) == 0) hit_[path.sample] = 1;
    }
}

void WhittedIntegrator::addBackground(const RayWave& rays) {
    const Environment* const environment = scene_->environment();
    if (environment == nullptr && isBlack(scene_->background)) return;
    if (environment == nullptr && paths_.primary() && !fog_.on()) return; // startSums() did it
    const TexelFilter filter = settings_->environmentFilter == EnvironmentFilter::Bilinear
                                   ? TexelFilter::Bilinear
                                   : TexelFilter::Nearest;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (surfaces_.traits[i] != 0 || (fog_.on() && fog_.transmittance()[i] == 0)) continue;
        Colour seen = scene_->background;
        if (environment != nullptr) {
            seen = environment->radiance({rays.dx[i], rays.dy[i], rays.dz[i]}, filter);
        }
        if (fog_.on()) seen = seen * fog_.transmittance()[i];
        const Path path = paths_.path(i);
        radiance_.set(path.sample, radiance_.colourAt(path.sample) + path.weight * seen);
    }
}

/// Colours, textures, holes, glass: what vector code leaves over.
void WhittedIntegrator::completePoints(const RayWave& rays) {
    const std::span<const std::uint32_t> points = surfaces_.notPlain();
    transparent_.clear();
    glow_.resize(points.size());
    const bool colours = !scene_->mesh().colours.empty();
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        const std::uint32_t i = points[k];
        if ((surfaces_.traits[i] & traits::kGeneral) != 0) {
            completeGeneral(rays, i, glow_[k]);
        } else if (colours) {
            setAlbedo(i, diffuseAt(*scene_, settings_->textures, hits_.hit(i)), glow_[k]);
        } else {
            textured_.point[textured_.count] = i;
            textured_.place[textured_.count++] = k;
            if (textured_.count == kWaveBlock) completeTextured();
        }
    }
    completeTextured();
}

void WhittedIntegrator::completeTextured() {
    if (textured_.count == 0) return;
    Colour albedo[kWaveBlock];
    texturedAlbedos(*scene_, hits_, {textured_.point, textured_.count}, albedo);
    for (std::size_t i = 0; i < textured_.count; ++i) {
        setAlbedo(textured_.point[i], albedo[i], glow_[textured_.place[i]]);
    }
    textured_.count = 0;
}

void WhittedIntegrator::setAlbedo(std::size_t i, Colour albedo, Colour& glow) {
    surfaces_.diffuse.set(i, albedo / kPi);
    if (!materials_->anyGlow()) return;
    const Material& m = scene_->materials[surfaces_.material[i]];
    glow = surfaces_.share.colourAt(i) * (m.emission + ambient_ * (albedo + m.specular));
}

void WhittedIntegrator::completeGeneral(const RayWave& rays, std::size_t i, Colour& glow) {
    glow = {};
    Path path = paths_.path(i);
    path.weight = surfaces_.share.colourAt(i);
    const Vec3 direction{rays.dx[i], rays.dy[i], rays.dz[i]};
    const Surface s = surfaceAt(*scene_, settings_->textures, direction, hits_.hit(i));
    if (s.coverage < 1 && !passHole(rays, i, s, path)) return;
    if (path.depth == 0) hit_[path.sample] = 1;
    const SurfaceSplit split = splitLight(s, *settings_);
    surfaces_.shadingNormal.set(i, s.shadingNormal);
    surfaces_.diffuse.set(i, s.diffuse / kPi);
    surfaces_.share.set(i, path.weight * split.scattered);
    const Colour ambient = ambient_ * (s.diffuse + s.material->specular) * split.scattered;
    glow = path.weight * (s.emission + ambient);
    if (!isBlack(split.mirrored)) {
        surfaces_.onward.set(i, path.weight * split.mirrored);
        surfaces_.traits[i] |= traits::kOnward;
    }
    if (!isBlack(split.transmitted)) transparent_.push_back({s, split, path});
}

/// Sends the share that passes an alpha texture on; returns whether anything is left for the surface.
bool WhittedIntegrator::passHole(const RayWave& rays, std::size_t i, const Surface& surface, Path& path) {
    Path through = path;
    through.weight = path.weight * (1 - surface.coverage);
    if (matters(through.weight) && through.passes < kMaxPasses) {
        ++through.passes;
        const Vec3 direction{rays.dx[i], rays.dy[i], rays.dz[i]};
        refracted_.push(rayFrom(surface, -surface.geometricNormal, direction), through);
    }
    if (surface.coverage == 0) {
        surfaces_.traits[i] = 0;
        if (paths_.primary()) hit_[i] = 0;
        return false;
    }
    path.weight = path.weight * surface.coverage;
    return true;
}

/// Emission, and the constant light from everywhere; on the way, mirrors take their share of all light.
void WhittedIntegrator::addGlow() {
    const bool any = materials_->anyGlow();
    const ArraysOf3& glow = paths_.primary() ? radiance_ : surfaces_.added;
    if (any && !paths_.primary()) {
        for (float* const array : {glow.x, glow.y, glow.z}) std::fill_n(array, surfaces_.size(), 0.0F);
    }
    if (any) glowOf(*materials_, surfaces_, glow);
    if (materials_->anyMirror()) splitAtMirrors(*materials_, surfaces_, any ? &glow : nullptr);
    if (!any) return;
    const std::span<const std::uint32_t> notPlain = surfaces_.notPlain();
    for (std::size_t i = 0; i < notPlain.size(); ++i) glow.set(notPlain[i], glow_[i]);
    if (!paths_.primary()) accumulate();
}

void WhittedIntegrator::enterFog(const RayWave& rays) {
    fog_.enter(rays, hits_, surfaces_.traits, paths_.primary() ? nullptr : wave_.bounces.data());
    fog_.dimShares(surfaces_);
}

/// What the fog itself adds to the rays of the wave.
void WhittedIntegrator::addFog() {
    for (std::uint32_t number = 0; number < scene_->lights.size(); ++number) {
        const Light& light = scene_->lights[number];
        if (light.on == 0 || stopped()) continue;
        settings_->fog.shafts > 0 ? addShafts(light, number) : fog_.addLight(light);
    }
    const ArraysOf3& scattered = fog_.scattered();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Path path = paths_.path(i);
        radiance_.set(path.sample, radiance_.colourAt(path.sample) + path.weight * scattered.colourAt(i));
    }
    clock_.lap(Stage::Light);
}

/// `number`: of the light.
void WhittedIntegrator::addShafts(const Light& light, std::uint32_t number) {
    const std::size_t count = surfaces_.size();
    if (shifts_.size() < count + kWaveBlock) shifts_.resize(count + kWaveBlock);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t salt = mixBits(paths_.bounces(i) + 0x9E3779B9U * number) >> 8;
        shifts_[i] = randomShift(sampleId(paths_.sample(i)), Draw::Shaft, salt).u;
    }
    const int samples = settings_->fog.shafts;
    const std::size_t atOnce = FogShafts::raysAtOnce(samples);
    const bool tinted = tracesTinted();
    for (std::size_t first = 0; first < count && !stopped(); first += atOnce) {
        shafts_.draw(fog_, light, first, std::min(atOnce, count - first), samples, shifts_.data(), !tinted);
        if (!settings_->shadows) {
            shafts_.addAll(fog_);
        } else if (maps_ != nullptr) {
            const RayWave& rays = shafts_.rays();
            arriving_.resize(rays.size());
            for (std::size_t i = 0; i < arriving_.size(); ++i)
                arriving_[i] = maps_->of(number).arriving({rays.ox[i], rays.oy[i], rays.oz[i]}, {});
            shafts_.add(fog_, arriving_);
        } else if (tinted) {
            shafts_.add(fog_, shadows_.transmittance(shafts_.rays(), light, statistics_));
        } else {
            shafts_.add(fog_, shadows_.occluded(shafts_.rays(), statistics_));
        }
    }
}

void WhittedIntegrator::lightFromEverywhere() {
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (!occlusion_.takes(surfaces_, i)) continue;
        const Path path = paths_.path(i);
        const std::uint32_t bounce = path.depth | std::uint32_t{path.passes} << 12;
        occlusion_.add(surfaces_, i, sampleId(path.sample), bounce);
    }
    occlusion_.light(surfaces_, statistics_, stop_);
    lit_ = Lit::Everywhere;
    accumulate();
    clock_.lap(Stage::Occlusion);
}

void WhittedIntegrator::lightBy(const Light& light, std::uint32_t number) {
    if (hasSize(light) && settings_->areaLights.samples > 0) {
        lit_ = Lit::BySize;
        lightBySamples(light, number);
        return;
    }
    lit_ = Lit::ByPoint;
    addLight(light, *materials_, surfaces_, settings_->shadows ? &shadowRays_ : nullptr);
    addUnshadowed(light, number);
}

void WhittedIntegrator::lightBySamples(const Light& light, std::uint32_t number) {
    const int samples = settings_->areaLights.samples;
    lampDraw_.begin(
        surfaces_.size(), samples, settings_->antialiasing * settings_->antialiasing, number,
        [&](std::size_t i) { return sampleId(paths_.sample(i)); },
        [&](std::size_t i) { return paths_.bounces(i); });
    for (int k = 0; k < samples && !stopped(); ++k) {
        addLight(light, lampDraw_.part(k), *materials_, surfaces_,
                 settings_->shadows ? &shadowRays_ : nullptr);
        addUnshadowed(light, number);
    }
}

/// What the light adds to the samples from where nothing is between.
void WhittedIntegrator::addUnshadowed(const Light& light, std::uint32_t number) {
    // Where tinted shadows are traced, fog and glass take turns on the way.
    if (fog_.on() && !tracesTinted()) fog_.dimLight(light, surfaces_);
    clock_.lap(Stage::Light);
    if (settings_->shadows) {
        if (shadowRays_.rays.empty()) return;
        if (maps_ != nullptr) {
            lookShadowsUp(maps_->of(number));
        } else if (shadows_.tinted()) {
            tint(shadows_.transmittance(shadowRays_.rays, light, statistics_));
        } else {
            darken(shadows_.occluded(shadowRays_.rays, statistics_));
        }
        clock_.lap(Stage::Shadows);
    }
    accumulate();
    clock_.lap(Stage::Light);
}

void WhittedIntegrator::lookShadowsUp(const ShadowMap& map) {
    arriving_.resize(shadowRays_.rays.size());
    for (std::size_t i = 0; i < arriving_.size(); ++i) {
        const std::uint32_t point = shadowRays_.point[i];
        arriving_[i] = map.arriving(surfaces_.position.at(point), surfaces_.geometricNormal.at(point));
    }
    tint(arriving_);
}

void WhittedIntegrator::darken(const std::vector<std::uint8_t>& occluded) {
    const std::uint32_t* const point = shadowRays_.point.data();
    const ArraysOf3& added = surfaces_.added;
    for (std::size_t i = 0; i < occluded.size(); ++i) {
        if (occluded[i] != 0) added.set(point[i], Colour{});
    }
}

void WhittedIntegrator::tint(const std::vector<Colour>& arriving) {
    const ArraysOf3& added = surfaces_.added;
    for (std::size_t i = 0; i < arriving.size(); ++i) {
        const std::uint32_t point = shadowRays_.point[i];
        added.set(point, added.colourAt(point) * arriving[i]);
    }
}

/// Each sample's sum grows in the order of the rays.
void WhittedIntegrator::accumulate() {
    const ArraysOf3& added = surfaces_.added;
    if (collectFirstHits_ && lit_ != Lit::Not) tellFirstHits();
    if (paths_.primary()) {
        addToSums(surfaces_, radiance_);
        return;
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const std::size_t sample = wave_.sample[i];
        radiance_.set(sample, radiance_.colourAt(sample) + added.colourAt(i));
    }
}

/// What the wave's rays hit that are the first to hit anything of their samples, holes passed.
void WhittedIntegrator::takeFirstHits() {
    firstHits_.beginWave();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (surfaces_.traits[i] == 0) continue;
        const Path path = paths_.path(i);
        if (path.depth > 0 || !firstHits_.missing(path.sample)) continue;
        const Colour scattered = surfaces_.share.colourAt(i);
        const bool onward = (surfaces_.traits[i] & traits::kOnward) != 0;
        const Colour mirrored = onward ? surfaces_.onward.colourAt(i) : Colour{};
        Colour through;
        if ((surfaces_.traits[i] & traits::kGeneral) != 0) {
            const Colour rest = kWhite - scattered - mirrored;
            through = {std::max(rest.r, 0.0F), std::max(rest.g, 0.0F), std::max(rest.b, 0.0F)};
        }
        firstHits_.take(path.sample,
                        {.position = surfaces_.position.at(i),
                         .normal = surfaces_.shadingNormal.at(i),
                         .albedo = surfaces_.diffuse.colourAt(i) * kPi * scattered + mirrored + through,
                         .direct = {},
                         .soft = {}});
    }
}

void WhittedIntegrator::tellFirstHits() {
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (surfaces_.traits[i] == 0) continue;
        FirstHit* const hit = firstHits_.present(paths_.sample(i));
        if (hit == nullptr) continue;
        const Colour added = surfaces_.added.colourAt(i);
        if (lit_ != Lit::ByPoint) hit->soft += added;
        if (lit_ != Lit::Everywhere) {
            hit->direct += added;
        } else {
            hit->arriving += luminance(added);
            hit->whole += luminance(occlusion_.unoccluded(surfaces_, i));
        }
    }
}

void WhittedIntegrator::spawn() {
    if (materials_->anyOnward()) spawnMirrored(surfaces_, paths_.queue(), *settings_, mirrored_);
    for (const Transparent& point : transparent_) spawnTransmitted(point);
}

void WhittedIntegrator::spawnTransmitted(const Transparent& point) {
    const Surface& s = point.surface;
    const Material& m = *s.material;
    Path path = point.path;
    path.weight *= point.split.transmitted;
    if (isBlack(path.weight)) return;
    Vec3 direction = -s.toViewer;
    if (!s.closed) {
        path.weight *= m.transmission;
        if (++path.passes > kMaxPasses) return;
    } else {
        if (path.depth >= settings_->maxDepth) return;
        ++path.depth;
        const float eta = s.fromInside ? 1 / m.indexOfRefraction : m.indexOfRefraction;
        if (!refract(direction, s.shadingNormal, eta, direction)) return;
        if (dot(direction, s.geometricNormal) >= 0) return; // a smooth normal bent it back out
        if (!s.fromInside) path.weight *= tintOnEntering(m);
        path.extinction = s.fromInside ? Colour{} : extinctionOf(m);
        path.inside = !s.fromInside;
    }
    if (!matters(path.weight)) return;
    refracted_.push(rayFrom(s, -s.geometricNormal, direction), path);
}

bool WhittedIntegrator::matters(Colour weight) const {
    const float largest = maxComponent(weight);
    return largest > 0 && largest >= settings_->minContribution;
}

} // namespace rtcore
