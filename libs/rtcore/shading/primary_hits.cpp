#include "rtcore/shading/primary_hits.h"

#include "rtcore/math/constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    constexpr std::uint32_t kTexturedMirror = traits::kMirror | traits::kColoured;
    const std::uint32_t point = surfaces.traits[i];
    if ((point & traits::kGeneral) != 0 || (point & kTexturedMirror) == kTexturedMirror) {
        const Colour rest = kWhite - scattered - mirrored;
        through = {std::max(rest.r, 0.0F), std::max(rest.g, 0.0F), std::max(rest.b, 0.0F)};
    }
    Colour albedo = surfaces.diffuseBrdf.colourAt(i) * kPi;
    if ((point & traits::kMetallic) != 0) albedo += surfaces.gloss.colourAt(i);
    if ((point & traits::kCoated) != 0) albedo += kWhite * surfaces.coatAlbedo[i];
    return {albedo * scattered, mirrored, through};
}

bool shines(const MaterialRow& material) {
    return material.emission[0] > 0 || material.emission[1] > 0 || material.emission[2] > 0;
}

/// Half the divergence of the normals of the triangle's corners, seen from the side of `normal`.
float meanCurvature(const Mesh& mesh, std::uint32_t triangle, Vec3 normal) {
    const ShadingTriangle& corners = mesh.shading[triangle];
    const Vec3 first = mesh.position(triangle, 0), e1 = mesh.position(triangle, 1) - first,
               e2 = mesh.position(triangle, 2) - first;
    const Vec3 n0 = mesh.normals[corners.v[0]], d1 = mesh.normals[corners.v[1]] - n0,
               d2 = mesh.normals[corners.v[2]] - n0;
    const Vec3 across = cross(e1, e2);
    const float area = dot(across, across);
    const float divergence = (dot(d1, cross(e2, across)) + dot(d2, cross(across, e1))) / area;
    const float half = dot(n0, normal) < 0 ? -0.5F * divergence : 0.5F * divergence;
    return std::isfinite(half) ? half : 0;
}

/// How far behind a mirror of such curvature what is `distance` before it seems to be. (The mirror equation)
float imageDistance(float distance, float curvature) {
    constexpr float kMin = 0.25F; // of a concave one: images come near the viewer, and turn over
    const float inverse = 1 / distance + 2 * curvature;
    return inverse >= kMin / distance ? 1 / inverse : 0;
}

/// How often a path was mirrored, refracted or went straight through.
std::uint32_t bouncesOf(const Wave& wave, std::size_t i) {
    const std::uint32_t bounces = wave.paths.bounces(i);
    return (bounces & 0xFFFFU) + ((bounces & ~(kInsideBit | kLobeBit)) >> 16);
}

} // namespace

void PrimaryHits::start(std::size_t samples) {
    hits_.resize(samples);
    for (PrimaryHit& hit : hits_) hit.wave = 0; // nothing else is read of those that stay so
    wave_ = 0;
}

void PrimaryHits::take(const Wave& wave, const Mesh& mesh, const MaterialTable& materials) {
    ++wave_;
    const SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        PrimaryHit& hit = hits_[wave.paths.sample(i)];
        if (hit.any()) {
            takeSpecular(wave, i, hit);
            continue;
        }
        if (surfaces.traits[i] == 0) continue;
        const Albedo albedo = albedoOf(surfaces, i);
        hit = {.position = surfaces.position.at(i),
               .normal = surfaces.shadingNormal.at(i),
               .albedo = albedo.scattered + albedo.mirrored + albedo.through,
               .mirrored = std::clamp(luminance(albedo.mirrored + albedo.through), 0.0F, 1.0F),
               .matte = luminance(albedo.scattered),
               .direct = {},
               .soft = {},
               .wave = wave_,
               .surfaceLight = {},
               .tint = {},
               .bounces = bouncesOf(wave, i),
               .shines = shines(materials.rows()[surfaces.material[i]])};
        if (hit.mirrored > 0)
            hit.curvature = meanCurvature(mesh, wave.hits.triangle[i], surfaces.geometricNormal.at(i));
    }
}

void PrimaryHits::takeSpecular(const Wave& wave, std::size_t i, PrimaryHit& hit) const {
    const bool any = wave.surfaces.traits[i] != 0;
    const PathQueue& queue = *wave.paths.queue();
    if (bouncesOf(wave, i) == hit.bounces + 1) hit.tint += queue.path(i).weight;
    if (!any && wave.hits.isHit(i)) return; // a hole
    const float weight = luminance(any ? wave.surfaces.weight.colourAt(i) : queue.path(i).weight);
    if (!(weight > hit.specularWeight)) return;
    const float length = queue.length[i], t = any ? wave.hits.t[i] : std::numeric_limits<float>::infinity();
    const bool bentOnce = length < 0 && wave.kind == RayKind::Mirror && wave.paths.bounces(i) == 1;
    hit.specularDistance = length >= 0 ? length + t
                           : bentOnce  ? length - imageDistance(t, hit.curvature)
                                       : length;
    hit.specularWeight = weight;
}

void PrimaryHits::takeSurfaceLight(const Wave& wave, const SampleSums& sums) {
    forEachPresent(wave, [&](std::size_t i, PrimaryHit& hit) {
        hit.surfaceLight = sums.radiance().colourAt(wave.paths.sample(i));
    });
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
        const Colour added = wave.surfaces.contribution.colourAt(i);
        if (areaLight) hit.soft += added;
        hit.direct += added;
    });
}

void PrimaryHits::addSurroundings(const Wave& wave, const HemisphereWave& light) {
    forEachPresent(wave, [&](std::size_t i, PrimaryHit& hit) {
        const Colour added = wave.surfaces.contribution.colourAt(i);
        hit.soft += added;
        hit.arriving += luminance(added);
        hit.whole += luminance(light.unoccluded(wave.surfaces, i));
    });
}

} // namespace rtcore
