#include "rtcore/shading/surface/normal_map.h"

#include "rtcore/shading/surface/texture_lookup.h"

namespace rtcore {

namespace {

/// Directions in which the texture coordinates grow, not of unit length; zero when they span no area.
struct Tangents {
    Vec3 right, up;
};

Tangents tangentsOf(const Mesh& mesh, std::uint32_t triangle, std::uint32_t set) {
    const ShadingTriangle& shading = mesh.shading[triangle];
    const Vec2 t0 = mesh.texcoord(shading.v[0], set);
    const Vec2 t1 = mesh.texcoord(shading.v[1], set);
    const Vec2 t2 = mesh.texcoord(shading.v[2], set);
    const Vec2 d1{t1.x - t0.x, t1.y - t0.y};
    const Vec2 d2{t2.x - t0.x, t2.y - t0.y};
    const Vec3 p = mesh.position(triangle, 0);
    const Vec3 e1 = mesh.position(triangle, 1) - p;
    const Vec3 e2 = mesh.position(triangle, 2) - p;
    const float area = d1.x * d2.y - d1.y * d2.x;
    // The sign is all that matters of the area: lengths are normalised away.
    const float sign = area > 0 ? 1.0F : area < 0 ? -1.0F : 0.0F;
    return {(e1 * d2.y - e2 * d1.y) * sign, (e2 * d1.x - e1 * d2.x) * sign};
}

} // namespace

Vec3 mapNormal(const Scene& scene, const Texture& texture, std::uint32_t triangle, Vec2 uv, Vec3 normal,
               float scale) {
    if (scene.mesh().texcoords.empty()) return normal;
    const Tangents tangents = tangentsOf(scene.mesh(), triangle, texture.texcoordSet);
    const Vec3 right = normalize(tangents.right - normal * dot(tangents.right, normal));
    if (right == Vec3{}) return normal;
    Vec3 up = cross(normal, right);
    if (dot(up, tangents.up) < 0) up = -up; // mirrored texture
    const Vec3 stored = sampleTexture(scene.model, texture, uv).stored;
    const Vec3 bent = right * ((2 * stored.x - 1) * scale) + up * ((2 * stored.y - 1) * scale) +
                      normal * (2 * stored.z - 1);
    const Vec3 unit = normalize(bent);
    return dot(unit, normal) > 0 ? unit : normal;
}

} // namespace rtcore
