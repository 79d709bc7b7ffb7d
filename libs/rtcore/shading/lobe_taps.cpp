#include "rtcore/shading/lobe_taps.h"

#include "rtcore/math/constants.h"
#include "rtcore/sampling/even_shift.h"
#include "rtcore/scattering/ggx-inl.h"
#include "rtcore/scattering/phong-inl.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

bool isMetallic(const SurfaceWave& surfaces, std::size_t point) {
    return (surfaces.traits[point] & traits::kMetallic) != 0;
}

/// The alpha of a GGX lobe about as wide as cos^n.
float alphaOfPhong(float shininess) { return std::sqrt(2 / (shininess + 2)); }

/// 1 for narrow lobes, and 0 from the widest on.
float fractionOf(float alpha) {
    constexpr float kWidest = kMaxLobeRoughness * kMaxLobeRoughness, kFade = 0.05F;
    return std::clamp((kWidest - alpha) / kFade, 0.0F, 1.0F);
}

Colour phongAlbedo(const MaterialRow& row, const SurfaceWave& surfaces, std::size_t point) {
    constexpr float kTwoPi = 2 * kPi;
    const Colour specular{row.specular[0], row.specular[1], row.specular[2]};
    const float part = row.lobeScale * kTwoPi / (row.shininess + 2); // the rest is the rough lobe
    return surfaces.tint.x != nullptr ? specular * surfaces.tint.colourAt(point) * part : specular * part;
}

Vec3 sampled(const MaterialTable& materials, const SurfaceWave& surfaces, std::size_t point, float u,
             float v) {
    const Vec3 normal = surfaces.shadingNormal.at(point), toViewer = surfaces.toViewer.at(point);
    if (isMetallic(surfaces, point))
        return plain::sampleGgx<float>(normal, plain::liftedViewer<float>(toViewer, normal),
                                       surfaces.alpha[point], {u, v});
    const Vec3 mirrored = normal * (2 * dot(normal, toViewer)) - toViewer;
    return plain::samplePhong<float>(mirrored, materials.rows()[surfaces.material[point]].shininess, {u, v});
}

/// What a lobe of Phong's model sends that way of an even light, over its albedo: less at grazing angles.
float phongFactor(float shininess, float cosine) {
    return (shininess + 2) / (shininess + 1) * std::max(cosine, 0.0F);
}

} // namespace

NarrowLobe narrowLobeOf(const MaterialTable& materials, const SurfaceWave& surfaces, std::size_t point,
                        float minAlbedo) {
    const std::uint32_t traits = surfaces.traits[point];
    if ((traits & (traits::kMetallic | traits::kGlossy)) == 0) return {};
    const MaterialRow& row = materials.rows()[surfaces.material[point]];
    const bool metallic = isMetallic(surfaces, point);
    const float alpha = metallic ? surfaces.alpha[point] : alphaOfPhong(row.shininess);
    const float fraction = fractionOf(alpha);
    if (!(fraction > 0)) return {};
    const Colour albedo = metallic ? surfaces.gloss.colourAt(point) - surfaces.further.colourAt(point)
                                   : phongAlbedo(row, surfaces, point);
    const NarrowLobe lobe{surfaces.weight.colourAt(point) * albedo * fraction, alpha};
    return maxComponent(lobe.albedo) > minAlbedo ? lobe : NarrowLobe{};
}

void addLobeTaps(const MaterialTable& materials, const Wave& wave, std::size_t point, const NarrowLobe& lobe,
                 std::uint32_t rays, std::vector<LobeTap>& taps) {
    const SurfaceWave& surfaces = wave.surfaces;
    const Vec3 face = surfaces.geometricNormal.at(point);
    const Vec3 origin = surfaces.position.at(point) + face * surfaces.clearance[point];
    const float shininess = materials.rows()[surfaces.material[point]].shininess;
    const std::uint32_t salt = mixBits(wave.paths.bounces(point)) >> 8;
    SampleId id = wave.sampleId(point);
    id.sub *= rays;
    for (std::uint32_t k = 0; k < rays; ++k, ++id.sub) {
        const SquarePoint at = evenShift(id, SampleDimension::Direction, salt);
        Vec3 direction = sampled(materials, surfaces, point, at.u, at.v);
        float factor = 1 / static_cast<float>(rays);
        if (!isMetallic(surfaces, point))
            factor *= phongFactor(shininess, dot(direction, surfaces.shadingNormal.at(point)));
        const float above = dot(direction, face);
        if (above < 0) direction = direction - face * (2 * above);
        if (factor > 0)
            taps.push_back({origin, direction, lobe.albedo * factor, lobe.width, wave.paths.sample(point),
                            randomBits(id, SampleDimension::Lobe, salt)});
    }
}

} // namespace rtcore
