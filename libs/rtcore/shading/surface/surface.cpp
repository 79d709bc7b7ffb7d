#include "rtcore/shading/surface/surface.h"

#include "rtcore/math/triangle-inl.h"
#include "rtcore/scene/media_crossing.h"
#include "rtcore/shading/surface/normal_map.h"
#include "rtcore/shading/surface/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

/// An attribute of the corners at the hit.
template <typename Value>
Value interpolate(std::span<const Value> values, const ShadingTriangle& triangle, const Hit& hit) {
    const Value& a = values[triangle.v[0]];
    const Value& b = values[triangle.v[1]];
    const Value& c = values[triangle.v[2]];
    return a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v;
}

/// As the texture of this number lies there.
Vec2 texcoordAt(const Scene& scene, std::uint32_t texture, const ShadingTriangle& triangle, const Hit& hit) {
    const Mesh& mesh = scene.mesh();
    if (mesh.texcoords.empty()) return {};
    const std::uint32_t set = scene.model.textures[texture].texcoordSet;
    const Vec2 a = mesh.texcoord(triangle.v[0], set);
    const Vec2 b = mesh.texcoord(triangle.v[1], set);
    const Vec2 c = mesh.texcoord(triangle.v[2], set);
    const float w = 1 - hit.u - hit.v;
    const Vec2 uv{a.x * w + b.x * hit.u + c.x * hit.v, a.y * w + b.y * hit.u + c.y * hit.v};
    return scene.material(triangle.material).flipTextures != 0 ? Vec2{uv.x, 1 - uv.y} : uv;
}

float textureAlpha(const Scene& scene, const Material& material, Vec2 uv) {
    const TextureSample s = sampleTexture(scene.model, scene.model.textures[material.alphaTexture], uv);
    return material.alphaFromAlpha != 0 ? s.alpha : s.stored.x;
}

float coverageOf(const Scene& scene, bool textures, const Hit& hit) {
    const ShadingTriangle& shading = scene.mesh().shading[hit.triangle];
    const Material& material = scene.material(shading.material);
    const bool textured = textures && material.alphaTexture != kNoTexture;
    const bool byVertex = material.vertexAlpha != 0 && !scene.mesh().alphas.empty();
    if (!textured && !byVertex) return 1;
    float alpha =
        textured ? textureAlpha(scene, material, texcoordAt(scene, material.alphaTexture, shading, hit)) : 1;
    if (byVertex) alpha *= interpolate(scene.mesh().alphas, shading, hit);
    if (material.alphaCutoff > 0) return alpha < material.alphaCutoff ? 0.0F : 1.0F;
    return alpha;
}

float opacityOf(const Scene& scene, const Material& material, Vec2 uv) {
    const Texture& texture = scene.model.textures[material.transmissionTexture];
    return 1 - (1 - material.opacity) * sampleTexture(scene.model, texture, uv).stored.x;
}

bool isCulled(const Scene& scene, const Material& material, const Hit& hit, bool fromInside) {
    return isFrontOnly(material) && fromInside && scene.isClosed(hit.triangle);
}

/// Colour of the vertices, where it multiplies the emission.
Colour emissionTint(const Scene& scene, const Material& material, const Hit& hit) {
    const Mesh& mesh = scene.mesh();
    if (material.tintsEmission == 0 || mesh.colours.empty()) return kWhite;
    return interpolate(mesh.colours, mesh.shading[hit.triangle], hit);
}

Colour textureColour(const Scene& scene, std::uint32_t texture, Vec2 uv) {
    return sampleColour(scene.model, scene.model.textures[texture], uv);
}

/// `turned` as for addMaterial().
Surface shapeOf(const Scene& scene, Vec3 direction, const Hit& hit, bool& turned) {
    const Mesh& mesh = scene.mesh();
    const ShadingTriangle& shading = mesh.shading[hit.triangle];

    Surface s;
    s.material = &scene.material(shading.material);
    // From the corners, not along the ray: the error then is that of the triangle's size, not of the ray's
    // length.
    const plain::Corners<float> positions{mesh.position(hit.triangle, 0), mesh.position(hit.triangle, 1),
                                          mesh.position(hit.triangle, 2)};
    const plain::Corners<float> normals{mesh.normals[shading.v[0]], mesh.normals[shading.v[1]],
                                        mesh.normals[shading.v[2]]};
    s.position = plain::interpolate(positions, hit.u, hit.v);
    s.toViewer = -direction;
    s.geometricNormal = normalize(plain::normalOf(positions));
    s.shadingNormal = normalize(plain::interpolate(normals, hit.u, hit.v));
    s.clearance = plain::surfaceClearance(positions, s.geometricNormal);
    s.fromInside = dot(s.geometricNormal, direction) > 0;
    const bool behind = plain::normalsBehind(normals, s.geometricNormal);
    if (s.fromInside) s.geometricNormal = -s.geometricNormal;
    const bool none = s.shadingNormal == Vec3{};
    if (none) s.shadingNormal = s.geometricNormal;
    turned = !none && behind != s.fromInside;
    if (turned) s.shadingNormal = -s.shadingNormal;
    setOwnMedium(scene, hit.triangle, s);
    return s;
}

} // namespace

void setOwnMedium(const Scene& scene, std::uint32_t triangle, Surface& s) {
    s.closed = scene.isClosed(triangle) && !isVeil(*s.material);
    s.index = s.material->indexOfRefraction;
    if (s.closed && s.fromInside) s.index = 1 / s.index;
    if (s.closed && !s.fromInside) s.behind = s.material;
}

bool setMedia(const Scene& scene, std::uint32_t triangle, MediaList media, Surface& s) {
    s.media = media;
    if (!boundsMedium(scene, triangle, *s.material)) return true;
    const MediaCrossing crossing = crossMedia(scene, triangle, s.fromInside, media);
    const auto indexOf = [](const Material* medium) {
        return medium != nullptr ? medium->indexOfRefraction : 1.0F;
    };
    s.media = crossing.list;
    if (crossing.before == nullptr && crossing.after == nullptr) return true;
    s.behind = crossing.after;
    s.index = indexOf(crossing.after) / indexOf(crossing.before);
    s.closed = true;
    return crossing.visible;
}

Surface surfaceAt(const Scene& scene, bool textures, Vec3 direction, const Hit& hit) {
    bool turned = false;
    Surface s = shapeOf(scene, direction, hit, turned);
    addMaterial(scene, textures, hit, turned, s);
    return s;
}

Surface shapeAt(const Scene& scene, Vec3 direction, const Hit& hit, float clearance) {
    bool turned = false;
    Surface s = shapeOf(scene, direction, hit, turned);
    s.clearance = std::max(s.clearance, clearance);
    return s;
}

void addMaterial(const Scene& scene, bool textures, const Hit& hit, bool turned, Surface& s) {
    const Material& material = *s.material;
    s.diffuse = diffuseAt(scene, textures, hit);
    s.emission = material.emission;
    if (material.tintsEmission != 0) s.emission *= emissionTint(scene, material, hit);
    s.opacity = material.opacity;
    if (hasHoles(material) || isFrontOnly(material))
        s.coverage = coverageAt(scene, textures, hit, s.fromInside);
    if (!textures) return;
    const bool bumps = material.normalTexture != kNoTexture, emits = material.emissionTexture != kNoTexture;
    const bool passes = material.transmissionTexture != kNoTexture;
    const bool tints = material.specularTexture != kNoTexture;
    if (!bumps && !emits && !passes && !tints) return;
    const auto uv = [&](std::uint32_t texture) {
        return texcoordAt(scene, texture, scene.mesh().shading[hit.triangle], hit);
    };
    if (bumps) {
        const Vec3 normal = turned ? -s.shadingNormal : s.shadingNormal;
        const Vec3 bent = mapNormal(scene, scene.model.textures[material.normalTexture], hit.triangle,
                                    uv(material.normalTexture), normal, material.normalScale);
        s.shadingNormal = turned ? -bent : bent;
    }
    if (emits) s.emission *= textureColour(scene, material.emissionTexture, uv(material.emissionTexture));
    if (passes) s.opacity = opacityOf(scene, material, uv(material.transmissionTexture));
    if (tints) s.specularTint = textureColour(scene, material.specularTexture, uv(material.specularTexture));
}

Colour diffuseAt(const Scene& scene, bool textures, const Hit& hit) {
    const ShadingTriangle& shading = scene.mesh().shading[hit.triangle];
    const std::uint32_t texture = scene.material(shading.material).diffuseTexture;
    const Colour diffuse = untexturedAt(scene, hit);
    if (!textures || texture == kNoTexture) return diffuse;
    return diffuse * textureColour(scene, texture, texcoordAt(scene, texture, shading, hit));
}

Colour untexturedAt(const Scene& scene, const Hit& hit) {
    const Mesh& mesh = scene.mesh();
    const ShadingTriangle& shading = mesh.shading[hit.triangle];
    const Colour diffuse = scene.material(shading.material).diffuse;
    return mesh.colours.empty() ? diffuse : diffuse * interpolate(mesh.colours, shading, hit);
}

RoughnessFactors roughnessAt(const Scene& scene, const Hit& hit) {
    const ShadingTriangle& shading = scene.mesh().shading[hit.triangle];
    const std::uint32_t texture = scene.material(shading.material).metallicRoughnessTexture;
    const Vec2 uv = texcoordAt(scene, texture, shading, hit);
    const Vec3 stored = sampleTexture(scene.model, scene.model.textures[texture], uv).stored;
    return {stored.y, stored.z};
}

Colour emissionAt(const Scene& scene, bool textures, const Hit& hit) {
    const ShadingTriangle& shading = scene.mesh().shading[hit.triangle];
    const Material& material = scene.material(shading.material);
    Colour emission = material.emission;
    if (material.tintsEmission != 0) emission *= emissionTint(scene, material, hit);
    if (hasHoles(material)) emission = emission * coverageOf(scene, textures, hit);
    if (!textures || material.emissionTexture == kNoTexture) return emission;
    return emission * textureColour(scene, material.emissionTexture,
                                    texcoordAt(scene, material.emissionTexture, shading, hit));
}

float coverageAt(const Scene& scene, bool textures, const Hit& hit, bool fromInside) {
    const Material& material = scene.material(scene.mesh().shading[hit.triangle].material);
    if (isCulled(scene, material, hit, fromInside)) return 0;
    return hasHoles(material) ? coverageOf(scene, textures, hit) : 1;
}

float opacityAt(const Scene& scene, bool textures, const Hit& hit) {
    const ShadingTriangle& shading = scene.mesh().shading[hit.triangle];
    const Material& material = scene.material(shading.material);
    if (!textures || material.transmissionTexture == kNoTexture) return material.opacity;
    return opacityOf(scene, material, texcoordAt(scene, material.transmissionTexture, shading, hit));
}

} // namespace rtcore
