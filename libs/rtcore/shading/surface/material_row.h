/// Material values for shading: each column, and how it follows from the material.
#pragma once

#include "rtcore/scattering/phong.h"
#include "rtcore/scene/metallic_roughness.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace rtcore {

/// Needs of a point beyond the diffuse lobe of its material's own colour.
namespace traits {
inline constexpr std::uint32_t kPoint = 1;     ///< there is a surface to be lit
inline constexpr std::uint32_t kGlossy = 2;    ///< it has a Phong lobe
inline constexpr std::uint32_t kMirror = 4;    ///< opaque, reflects, and is not kGeneral
inline constexpr std::uint32_t kFresnel = 8;   ///< a mirror that reflects more at grazing angles
inline constexpr std::uint32_t kColoured = 16; ///< the albedo varies: texture, colours of vertices
inline constexpr std::uint32_t kGeneral = 32; ///< transparent, perforated, bump mapped, emitting by a texture
inline constexpr std::uint32_t kSpecular = 64;   ///< of points, not of materials: a mirrored ray follows
inline constexpr std::uint32_t kRough = 128;     ///< it has a rough lobe (phong.h)
inline constexpr std::uint32_t kMetallic = 1024; ///< of the metallic-roughness model: has none of the lobes
                                                 ///< and mirrors above
inline constexpr std::uint32_t kSharp = 2048; ///< of these: no glass, and somewhere so smooth that it mirrors
inline constexpr std::uint32_t kVaried = 4096; ///< of these: a texture has roughness and metal
inline constexpr std::uint32_t kCoated = 8192; ///< of these: a clear coat lies over the lobes
/// Traits of points that vector code alone cannot shade: seen from behind; shading normal turned (surface.h).
inline constexpr std::uint32_t kFromInside = 256, kTurned = 512;
/// Vector code alone cannot shade such a point.
inline constexpr std::uint32_t kNotPlain = kColoured | kGeneral;
} // namespace traits

/// A power of two of floats, so that indices are multiplied by shifts.
struct alignas(64) MaterialRow {
    float diffuseBrdf[3] = {}; ///< f_r of the diffuse lobe, albedo / pi; kMetallic: base colour / pi
    std::uint32_t traits = 0;
    float specular[3] = {}; ///< kMetallic: reflectance of what is no metal, straight on
    float shininess = 0;    ///< of the Phong lobe, at least kMinShininess
    float lobeScale = 0;    ///< of the Phong lobe, (n + 2) / 2 pi times its fraction
    float roughScale = 0;   ///< of the rough lobe, its fraction over 2 pi
    float mirrorScale = 0;
    float mirror[3] = {};
    float emission[3] = {};
    float ambient[3] = {}; ///< radiance of reflected ambient light; 0 of kMetallic, where it varies
    float emitted[3] = {}; ///< emission + ambient
    float roughness = 0, metallic = 0; ///< of kMetallic
    float coat = 0, coatRoughness = 0; ///< of kCoated
    float unused[5] = {};
};
inline constexpr int kRowShift = 5; ///< a row has 2^kRowShift floats
static_assert(sizeof(MaterialRow) == sizeof(float) << kRowShift);

/// Those of a material.
inline std::uint32_t traitsOf(const Material& m, const Mesh& mesh, const RenderSettings& settings) {
    const bool colours = !mesh.colours.empty();
    const auto used = [&](std::uint32_t texture) { return settings.textures && texture != kNoTexture; };
    std::uint32_t result = traits::kPoint;
    if (hasRoughness(m)) {
        result |= traits::kMetallic;
        if (used(m.metallicRoughnessTexture)) result |= traits::kVaried;
        // The covering part of a veil mirrors as if it were opaque.
        const bool covers = !settings.refractions || m.opacity >= 1 || isVeil(m);
        const bool coated = m.coat > 0;
        if (coated) result |= traits::kCoated;
        const bool smooth = m.roughness < kMirrorsBelow || used(m.metallicRoughnessTexture) ||
                            (coated && m.coatRoughness < kMirrorsBelow);
        if (settings.reflections && covers && smooth) result |= traits::kSharp;
    } else if (!isBlack(m.specular)) {
        if (m.shininess > 0) result |= traits::kGlossy;
        if (m.shininess < kMinShininess) result |= traits::kRough;
    }
    if (colours || used(m.diffuseTexture)) result |= traits::kColoured;
    const bool varies = used(m.alphaTexture) || used(m.normalTexture) || used(m.emissionTexture) ||
                        used(m.specularTexture) || (m.vertexAlpha != 0 && !mesh.alphas.empty()) ||
                        (m.tintsEmission != 0 && colours);
    if ((settings.refractions && !(m.opacity >= 1)) || varies) {
        result |= traits::kGeneral;
    }
    if (!hasRoughness(m) && settings.reflections && !isBlack(m.mirror * m.mirrorScale)) {
        if ((result & traits::kGeneral) != 0) return result;
        result |= traits::kMirror;
        if (m.fresnel != 0) result |= traits::kFresnel;
    }
    return result;
}

/// `ambientLight`: that of MaterialTable.
inline MaterialRow rowOf(const Material& m, const Mesh& mesh, const RenderSettings& settings,
                         Colour ambientLight) {
    constexpr float pi = std::numbers::pi_v<float>;
    MaterialRow row;
    const auto put = [](Colour c, float(&to)[3]) {
        to[0] = c.r;
        to[1] = c.g;
        to[2] = c.b;
    };
    row.traits = traitsOf(m, mesh, settings);
    const Colour ambient = hasRoughness(m) ? Colour{} : ambientLight * (m.diffuse + m.specular);
    put(m.diffuse / pi, row.diffuseBrdf);
    put(m.emission, row.emission);
    put(ambient, row.ambient);
    put(m.emission + ambient, row.emitted);
    put(m.mirror, row.mirror);
    row.mirrorScale = m.mirrorScale;
    put(m.specular, row.specular);
    const float phong = std::min(m.shininess / kMinShininess, 1.0F);
    row.shininess = std::max(m.shininess, kMinShininess);
    row.lobeScale = phong * (row.shininess + 2) / (2 * pi);
    row.roughScale = (1 - phong) / (2 * pi);
    row.roughness = m.roughness;
    row.metallic = m.metallic;
    row.coat = m.coat;
    row.coatRoughness = m.coatRoughness;
    return row;
}

} // namespace rtcore
