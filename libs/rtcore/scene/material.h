/// How a surface scatters, passes and emits light. The record is written to .bsp files as it stands here.
///
/// Light that arrives is divided in this order (docs/shading.md):
///   1. mirror:   weight M. `fresnel` set: Schlick's curve from `mirror` (at normal incidence) to 1 (at
///                grazing angles), all scaled by `mirrorScale`; not set: `mirror * mirrorScale` at any angle.
///                A transparent surface (opacity < 1) uses the exact Fresnel equations of
///                `indexOfRefraction` instead.
///   2. of the rest, (1 - opacity) passes through, tinted by `transmission`;
///   3. of the rest, `opacity` goes to the diffuse and the glossy lobe (physical Phong, notes in
///                scattering/phong-inl.h).
/// Where `roughness` is given, the metallic-roughness model of glTF 2 takes the place of 1 and 3
/// (scattering/metallic-inl.h): `diffuse` is its base colour, `specular` the reflectance at normal incidence
/// of what is no metal; `shininess` and all of `mirror` have no effect.
/// Over that lies a clear coat, as far as `coat` says (scattering/coat-inl.h).
#pragma once

#include "rtcore/math/colour.h"

#include <cstdint>
#include <type_traits>

namespace rtcore {

inline constexpr std::uint32_t kNoTexture = 0xFFFFFFFFU;
inline constexpr float kNoRoughness = -1;
inline constexpr float kMaxPriority = 100;

struct Material {
    Colour diffuse{0.8F, 0.8F, 0.8F}; ///< albedo k_d, multiplied with texture and vertex colour; 0..1
    float opacity = 1;                ///< 0 (clear) .. 1 (opaque)
    Colour specular;                  ///< albedo k_s of the Phong lobe; k_d + k_s <= 1 if that is there
    float shininess = 1;              ///< Phong exponent n, 0..100000
    Colour mirror;                    ///< reflectance at normal incidence, 0..1
    float mirrorScale = 1;            ///< 0..1; under 1 where roughness blurs mirrored rays away
    Colour transmission{1, 1, 1};     ///< tint of light that passes, 0..1
    float attenuationDistance = 0;  ///< closed meshes: distance in scene units over which light is tinted by
                                    ///< `transmission` (Beer); 0 = tint once, on entering
    Colour emission;                ///< radiance given off, >= 0
    float indexOfRefraction = 1.5F; ///< inside over outside, 1..5
    std::uint32_t fresnel = 0;      ///< 0 or 1, see above
    std::uint32_t diffuseTexture = kNoTexture;
    std::uint32_t alphaTexture =
        kNoTexture; ///< coverage: the red channel, or the alpha channel when `alphaFromAlpha`
    std::uint32_t alphaFromAlpha = 0;
    std::uint32_t normalTexture = kNoTexture;
    std::uint32_t emissionTexture = kNoTexture;
    float alphaCutoff = 0;          ///< > 0: alpha of a texture below it is a hole, above it is solid
    std::uint32_t nameOffset = 0;   ///< of the name in the model's string table
    float roughness = kNoRoughness; ///< 0..1, square root of GGX's alpha; kNoRoughness: `shininess` tells all
    float metallic = 0;             ///< 0 (dielectric) .. 1 (metal)
    std::uint32_t metallicRoughnessTexture = kNoTexture; ///< green times `roughness`, blue times `metallic`
    std::uint32_t emissionLights = 0;                    ///< 1: what it emits lights other surfaces
    std::uint32_t flipTextures = 0;                      ///< 1: its textures are turned upside down
    float normalScale = 1;                               ///< factor on how far the normal map leans
    std::uint32_t vertexAlpha = 0;                       ///< 1: Mesh::alphas multiply the coverage
    std::uint32_t tintsEmission = 0;                     ///< 1: colours of vertices multiply `emission`, too
    std::uint32_t transmissionTexture = kNoTexture;      ///< red: factor on 1 - opacity
    std::uint32_t specularTexture = kNoTexture;          ///< factor on `specular` and `mirror`; no roughness
    std::uint32_t frontOnly = 0; ///< 1: back faces of closed surfaces are holes where it isVeil()
    float coat = 0;              ///< 0..1: how much of it a coat of varnish covers; with `roughness` alone
    float coatRoughness = 0;     ///< 0..1, of that coat
    float priority = 0;          ///< whole, 0..kMaxPriority: which of solids that overlap is there

    friend bool operator==(const Material&, const Material&) = default;
};
static_assert(std::is_trivially_copyable_v<Material> && sizeof(Material) == 168);

/// It is one of the metallic-roughness model.
inline bool hasRoughness(const Material& m) { return m.roughness != kNoRoughness; }

/// Its coverage varies: an alpha texture or alphas of vertices cut holes.
inline bool hasHoles(const Material& m) { return m.alphaTexture != kNoTexture || m.vertexAlpha != 0; }

/// A part of the light may pass, through the surface or through holes.
inline bool isTransparent(const Material& m) { return m.opacity < 1 || hasHoles(m); }

/// Light passes neither bent nor tinted, whatever the surface bounds: it only covers.
inline bool isVeil(const Material& m) { return m.indexOfRefraction == 1 && m.transmission == kWhite; }

/// The back faces of closed surfaces are holes. Not those of glass, which light leaves through them.
inline bool isFrontOnly(const Material& m) { return m.frontOnly != 0 && isVeil(m); }

} // namespace rtcore
