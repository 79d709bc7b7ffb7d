#include "rtcore/shading/primary_hits.h"

#include "rtcore/math/constants.h"

#include <algorithm>

namespace rtcore {

namespace {

/// The fractions of the light at a point that are scattered, mirrored and let through.
struct Albedo {
    Colour scattered, mirrored, through;
};
Albedo albedoOf(const SurfaceWave& surfaces, std::size_t i) {
    const Colour scattered = surfaces.weight.colourAt(i);
    const bool specular = (surfaces.traits[i] & traits::kSpecular) != 0;
    const Colour mirrored = specular ? surfaces.specular.colourAt(i) : Colour{};
    Colour through;
    if ((surfaces.traits[i] & traits::kGeneral) != 0) {
        const Colour rest = kWhite - scattered - mirrored;
        through = {std::max(rest.r, 0.0F), std::max(rest.g, 0.0F), std::max(rest.b, 0.0F)};
    }
    return {surfaces.diffuse.colourAt(i) * kPi * scattered, mirrored, through};
}

} // namespace

void PrimaryHits::start(std::size_t samples) {
    hits_.assign(samples, {});
    wave_ = 0;
}

void PrimaryHits::take(const Wave& wave) {
    ++wave_;
    const SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        const Path path = wave.paths.path(i);
        PrimaryHit& hit = hits_[path.sample];
        if (path.depth > 0 || hit.any()) continue;
        const Albedo albedo = albedoOf(surfaces, i);
        hit = {.position = surfaces.position.at(i),
               .normal = surfaces.shadingNormal.at(i),
               .albedo = albedo.scattered + albedo.mirrored + albedo.through,
               .mirrored = std::clamp(luminance(albedo.mirrored + albedo.through), 0.0F, 1.0F),
               .direct = {},
               .soft = {},
               .wave = wave_};
    }
}

/// Calls `use` with each point that is the first hit of its sample, and with that hit.
template <typename Use>
void PrimaryHits::forEachPresent(const Wave& wave, Use&& use) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        if (wave.surfaces.traits[i] == 0) continue;
        PrimaryHit& hit = hits_[wave.paths.sample(i)];
        if (hit.wave == wave_) use(i, hit);
    }
}

void PrimaryHits::addLight(const Wave& wave, bool areaLight) {
    forEachPresent(wave, [&](std::size_t i, PrimaryHit& hit) {
        const Colour added = wave.surfaces.added.colourAt(i);
        if (areaLight) hit.soft += added;
        hit.direct += added;
    });
}

void PrimaryHits::addAmbient(const Wave& wave, const OcclusionWave& occlusion) {
    forEachPresent(wave, [&](std::size_t i, PrimaryHit& hit) {
        const Colour added = wave.surfaces.added.colourAt(i);
        hit.soft += added;
        hit.arriving += luminance(added);
        hit.whole += luminance(occlusion.unoccluded(wave.surfaces, i));
    });
}

} // namespace rtcore
