#include "rtcore/shading/wave_lighting.h"

#include "rtcore/shading/fog/fog_light.h"

#include "rtcore/sampling/even_shift.h"

#include <algorithm>
#include <numeric>

namespace rtcore {

void WaveLighting::begin(const FrameContext& frame, const FogWave& fog) {
    fog_ = &fog;
    const FogMedium* const medium = fog.on() ? &fog.medium() : nullptr;
    on_.clear();
    for (std::size_t light = 0; light < frame.scene->lights.size(); ++light)
        if (frame.scene->lights[light].light.on != 0) on_.push_back(light);
    shadows_.begin(*frame.scene, *frame.tracer, *frame.settings, frame.materials->clear(), medium);
    RenderSettings surroundings = *frame.settings;
    if (frame.indirectTaps != nullptr) surroundings.ambientOcclusion.on = surroundings.skyLight.on = false;
    occlusion_.begin(*frame.scene, *frame.tracer, surroundings, *frame.materials);
    sky_.begin(*frame.scene, *frame.tracer, surroundings, *frame.materials, medium);
}

void WaveLighting::addFog(const FrameContext& frame, const Wave& wave, SampleSums& sums) {
    const std::vector<SceneLight>& lights = frame.scene->lights;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        if (lights[light].light.on == 0 || frame.stopped()) continue;
        if (frame.settings->fog.shafts > 0) {
            addShafts(frame, wave, light);
        } else {
            addFogLight(*fog_, lights[light].light);
        }
    }
    const ArraysOf3& scattered = fog_->rays().scattered;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const Path path = wave.paths.path(i);
        sums.add(path.sample, path.weight * scattered.colourAt(i));
    }
    frame.clock->lap(Stage::Light);
}

void WaveLighting::addShafts(const FrameContext& frame, const Wave& wave, std::size_t number) {
    const Light& light = frame.scene->lights[number].light;
    const std::size_t count = wave.size();
    if (shifts_.size() < count + kWaveBlock) shifts_.resize(count + kWaveBlock);
    const auto ofLight = 0x9E3779B9U * static_cast<std::uint32_t>(number);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t salt = mixBits(wave.paths.bounces(i) + ofLight) >> 8;
        shifts_[i] = randomShift(wave.sampleId(i), SampleDimension::Shaft, salt).u;
    }
    const int samples = frame.settings->fog.shafts;
    const std::size_t atOnce = FogShafts::raysAtOnce(samples);
    const bool tinted = tracesTinted(frame);
    for (std::size_t first = 0; first < count && !frame.stopped(); first += atOnce) {
        shafts_.sample(*fog_, light, {first, std::min(atOnce, count - first)}, samples, shifts_.data(),
                       !tinted);
        if (!frame.settings->shadows) {
            shafts_.addAll(*fog_);
        } else if (frame.shadowMaps != nullptr) {
            const RayWave& rays = shafts_.rays();
            arriving_.resize(rays.size());
            for (std::size_t i = 0; i < arriving_.size(); ++i) {
                const Vec3 position{rays.ox[i], rays.oy[i], rays.oz[i]};
                arriving_[i] = frame.shadowMaps->of(number).arriving(position, {});
            }
            shafts_.add(*fog_, arriving_);
        } else if (tinted) {
            shafts_.add(*fog_, shadows_.transmittance(shafts_.rays(), light, *frame.statistics));
        } else {
            shafts_.add(*fog_, shadows_.occluded(shafts_.rays(), *frame.statistics));
        }
    }
}

void WaveLighting::addLight(const FrameContext& frame, Wave& wave, const LightSums& to) {
    if (occlusion_.on()) addSurroundings(frame, occlusion_, wave, to);
    if (sky_.on()) addSurroundings(frame, sky_, wave, to);
    if (chooses(frame, to)) return addChosen(frame, wave, to);
    recall(frame, wave);
    const std::vector<SceneLight>& lights = frame.scene->lights;
    for (const std::size_t light : on_) {
        if (frame.stopped()) break;
        if (isAreaLight(lights[light].light) && frame.settings->areaLights.samples > 0) {
            addAreaLight(frame, wave, light, to);
        } else {
            addPointLight(frame, wave, light, to);
        }
    }
    if (remembers_) keep(frame, wave);
}

void WaveLighting::addSurroundings(const FrameContext& frame, HemisphereWave& light, Wave& wave,
                                   const LightSums& to) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        if (!light.takes(wave.surfaces, i)) continue;
        const Path path = wave.paths.path(i);
        const std::uint32_t bounce = path.depth | std::uint32_t{path.passes} << 12;
        light.add(wave.surfaces, i, wave.sampleId(i), bounce);
    }
    light.light(wave.surfaces, *frame.statistics, frame.stop);
    if (to.primaryHits != nullptr) to.primaryHits->addSurroundings(wave, light);
    to.sums.add(wave);
    frame.clock->lap(Stage::Occlusion);
}

/// An area light counts as a point in its middle here.
void WaveLighting::addPointLight(const FrameContext& frame, Wave& wave, std::size_t light,
                                 const LightSums& to) {
    const KnownVisibility known = knownOf(light);
    rtcore::addLight(frame.scene->lights[light].light, *frame.materials, wave.surfaces,
                     frame.settings->shadows ? &shadowRays_ : nullptr, remembers(light) ? &known : nullptr);
    addArriving(frame, wave, light, to);
}

void WaveLighting::addAreaLight(const FrameContext& frame, Wave& wave, std::size_t light,
                                const LightSums& to) {
    const RenderSettings& settings = *frame.settings;
    areaLightSampler_.begin(
        wave.size(), settings.areaLights.samples, settings.antialiasing * settings.antialiasing,
        static_cast<std::uint32_t>(light), [&](std::size_t i) { return wave.sampleId(i); },
        [&](std::size_t i) { return wave.paths.bounces(i); });
    const KnownVisibility known = knownOf(light);
    for (int k = 0; k < settings.areaLights.samples && !frame.stopped(); ++k) {
        rtcore::addLight(frame.scene->lights[light].light, areaLightSampler_.strata(k), *frame.materials,
                         wave.surfaces, settings.shadows ? &shadowRays_ : nullptr,
                         k > 0 && remembers(light) ? &known : nullptr);
        addArriving(frame, wave, light, to);
        if (k == 0 && remembers(light)) confirm(light);
    }
}

/// Known visibility of a light counts where the first ray to it confirms it.
void WaveLighting::confirm(std::size_t light) {
    const std::uint32_t bit = knownOf(light).bit;
    for (std::size_t i = 0; i < clear_.size(); ++i) {
        clear_[i] &= foundClear_[i] | ~bit;
        dark_[i] &= foundDark_[i] | ~bit;
    }
}

/// Adds what the light would add unshadowed, which surfaces.contribution holds, as far as it arrives.
void WaveLighting::addArriving(const FrameContext& frame, Wave& wave, std::size_t number,
                               const LightSums& to) {
    const Light& light = frame.scene->lights[number].light;
    // Tinted shadow rays attenuate by fog themselves, segment by segment between panes.
    if (fog_->on() && !tracesTinted(frame)) fog_->dimLight(light, wave.surfaces);
    frame.clock->lap(Stage::Light);
    if (frame.settings->shadows) {
        if (shadowRays_.rays.empty() && !remembers_) return;
        takeShadows(frame, wave.surfaces, number);
        frame.clock->lap(Stage::Shadows);
    }
    if (to.primaryHits != nullptr) {
        to.primaryHits->addLight(wave, isAreaLight(light) && frame.settings->areaLights.samples > 0);
    }
    to.sums.add(wave);
    frame.clock->lap(Stage::Light);
}

/// Takes from surfaces.contribution what does not arrive.
void WaveLighting::takeShadows(const FrameContext& frame, SurfaceWave& surfaces, std::size_t number) {
    const std::uint32_t* const point = shadowRays_.point.data();
    const RayWave& rays = shadowRays_.rays;
    const auto tint = [&](std::size_t ray, Colour arriving) {
        note(number, point[ray], arriving);
        surfaces.contribution.set(point[ray], surfaces.contribution.colourAt(point[ray]) * arriving);
    };
    if (frame.shadowMaps != nullptr) {
        const ShadowMap& map = frame.shadowMaps->of(number);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            tint(i, map.arriving(surfaces.position.at(point[i]), surfaces.geometricNormal.at(point[i])));
        }
    } else if (shadows_.tinted()) {
        const Light& light = frame.scene->lights[number].light;
        const std::vector<Colour>& arriving = shadows_.transmittance(rays, light, *frame.statistics);
        for (std::size_t i = 0; i < arriving.size(); ++i) tint(i, arriving[i]);
    } else {
        const std::vector<std::uint8_t>& occluded = shadows_.occluded(rays, *frame.statistics);
        for (std::size_t i = 0; i < occluded.size(); ++i) {
            note(number, point[i], occluded[i] != 0 ? Colour{} : kWhite);
            if (occluded[i] != 0) surfaces.contribution.set(point[i], Colour{});
        }
    }
}

// --- Some of many lights ---

/// Frames that remember light are those of a moving camera.
bool WaveLighting::chooses(const FrameContext& frame, const LightSums& to) const {
    return !frame.visibility.empty() && on_.size() > LightChoice::kAll && frame.settings->shadows &&
           to.primaryHits == nullptr;
}

void WaveLighting::addChosen(const FrameContext& frame, Wave& wave, const LightSums& to) {
    // What is kept of each light and point has a bound, whatever their numbers.
    constexpr std::size_t kMaxKept = std::size_t{1} << 22;
    const std::size_t atOnce = std::max<std::size_t>(kMaxKept / on_.size() / kWaveBlock, 1) * kWaveBlock;
    remembers_ = false;
    chosenMemory_.resize(3, wave.size());
    chosen_ = chosenMemory_.arraysOf3(0);
    for (float* const array : {chosen_.x, chosen_.y, chosen_.z}) std::fill_n(array, wave.size(), 0.0F);
    for (std::size_t first = 0; first < wave.size() && !frame.stopped(); first += atOnce) {
        points_.resize(std::min(atOnce, wave.size() - first));
        std::iota(points_.begin(), points_.end(), static_cast<std::uint32_t>(first));
        addChosen(frame, wave);
    }
    if (frame.stopped()) return;
    for (std::size_t i = 0; i < wave.size(); ++i) wave.surfaces.contribution.set(i, chosen_.colourAt(i));
    to.sums.add(wave);
    frame.clock->lap(Stage::Light);
}

/// At points_.
void WaveLighting::addChosen(const FrameContext& frame, Wave& wave) {
    const std::uint32_t first = points_.front();
    const bool whole = points_.size() == wave.size();
    if (!whole) part_.gather(wave.surfaces, points_, *frame.materials);
    SurfaceWave& surfaces = whole ? wave.surfaces : part_;
    choice_.begin(points_.size(), on_.size(), [&](std::size_t i) {
        const std::uint32_t salt = mixBits(wave.paths.bounces(first + i)) >> 8;
        return evenShift(wave.sampleId(first + i), SampleDimension::LightChoice, salt).v;
    });
    for (const std::size_t light : on_) {
        rtcore::addLight(frame.scene->lights[light].light, *frame.materials, surfaces, nullptr);
        choice_.weigh(surfaces.contribution);
    }
    choice_.end();
    frame.clock->lap(Stage::Light);
    for (const std::size_t light : on_) {
        if (frame.stopped()) return;
        const LightChoice::Taken taken = choice_.next();
        if (taken.points.empty()) continue;
        points_.resize(taken.points.size());
        std::ranges::transform(taken.points, points_.begin(), [&](std::uint32_t i) { return first + i; });
        addChosen(frame, wave, light, {points_, taken.weights});
    }
}

void WaveLighting::addChosen(const FrameContext& frame, const Wave& wave, std::size_t number,
                             LightChoice::Taken taken) {
    const Light& light = frame.scene->lights[number].light;
    const RenderSettings& settings = *frame.settings;
    some_.gather(wave.surfaces, taken.points, *frame.materials);
    if (!isAreaLight(light) || settings.areaLights.samples == 0) {
        rtcore::addLight(light, *frame.materials, some_, &shadowRays_);
        return addTaken(frame, number, taken);
    }
    areaLightSampler_.begin(
        taken.points.size(), settings.areaLights.samples, settings.antialiasing * settings.antialiasing,
        static_cast<std::uint32_t>(number), [&](std::size_t i) { return wave.sampleId(taken.points[i]); },
        [&](std::size_t i) { return wave.paths.bounces(taken.points[i]); });
    for (int k = 0; k < settings.areaLights.samples && !frame.stopped(); ++k) {
        rtcore::addLight(light, areaLightSampler_.strata(k), *frame.materials, some_, &shadowRays_);
        addTaken(frame, number, taken);
    }
}

void WaveLighting::addTaken(const FrameContext& frame, std::size_t number, LightChoice::Taken taken) {
    const Light& light = frame.scene->lights[number].light;
    if (fog_->on() && !tracesTinted(frame)) fog_->dimLight(light, some_);
    frame.clock->lap(Stage::Light);
    takeShadows(frame, some_, number);
    frame.clock->lap(Stage::Shadows);
    for (std::size_t i = 0; i < taken.points.size(); ++i) {
        const std::uint32_t point = taken.points[i];
        chosen_.set(point, chosen_.colourAt(point) + some_.contribution.colourAt(i) * taken.weights[i]);
    }
}

// --- What is remembered ---

void WaveLighting::recall(const FrameContext& frame, const Wave& wave) {
    remembers_ = !frame.visibility.empty() && wave.paths.primary() && frame.settings->shadows;
    if (!remembers_) return;
    for (auto* visibility : {&clear_, &dark_, &foundClear_, &foundDark_})
        visibility->assign(wave.size() + kWaveBlock, 0);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const LightVisibility known = frame.visibility[wave.paths.sample(i)];
        clear_[i] = known.clear;
        dark_[i] = known.dark;
    }
}

/// Notes the result of a shadow ray. Tinted light is traced anew each time.
void WaveLighting::note(std::size_t light, std::size_t point, Colour arriving) {
    if (!remembers(light)) return;
    if (arriving != kWhite) foundDark_[point] |= 1U << light;
    if (!isBlack(arriving)) foundClear_[point] |= 1U << light;
}

void WaveLighting::keep(const FrameContext& frame, const Wave& wave) const {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const std::uint32_t clear = clear_[i] | (foundClear_[i] & ~foundDark_[i]),
                            dark = dark_[i] | (foundDark_[i] & ~foundClear_[i]);
        frame.visibility[wave.paths.sample(i)] = {clear, dark};
    }
}

} // namespace rtcore
