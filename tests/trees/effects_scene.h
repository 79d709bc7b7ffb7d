/// Puts all that effects show into a scene: mirrors, glass, lights of each kind, fog and an environment, in
/// proportion to its size.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/scene/photometry.h"
#include "rtcore/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace test {

/// Each block of triangles shows its material as it is, or mirrors, or lets light through.
inline void varyMaterials(rtcore::Scene& scene) {
    constexpr std::uint32_t kBlock = 32, kVariants = 3;
    const std::vector<rtcore::Material> plain = std::move(scene.materials);
    scene.materials.clear();
    for (const rtcore::Material& material : plain) {
        rtcore::Material mirror = material;
        mirror.mirror = {0.3F, 0.3F, 0.3F};
        mirror.mirrorScale = 1;
        mirror.fresnel = 1;
        rtcore::Material glass = material;
        glass.opacity = 0.1F;
        glass.transmission = {0.9F, 0.8F, 0.7F};
        for (const rtcore::Material& variant : {material, mirror, glass}) scene.materials.push_back(variant);
    }
    struct Shading {
        std::shared_ptr<const void> model;
        std::vector<rtcore::ShadingTriangle> triangles;
    };
    const auto shading = std::make_shared<Shading>();
    shading->model = scene.model.storage;
    for (rtcore::ShadingTriangle triangle : scene.mesh().shading) {
        const auto block = static_cast<std::uint32_t>(shading->triangles.size()) / kBlock;
        constexpr std::uint32_t kVariantOf[8] = {0, 1, 0, 1, 0, 2, 0, 1};
        triangle.material = triangle.material * kVariants + kVariantOf[block * 0x9E3779B1U >> 29U];
        shading->triangles.push_back(triangle);
    }
    scene.model.mesh.shading = shading->triangles;
    scene.model.storage = shading;
    scene.closed = rtcore::findClosedSurfaces(scene.mesh(), scene.materials);
    scene.solids = rtcore::findGlassSolids(scene.mesh(), scene.materials, scene.closed);
}

/// In place of the scene's own.
inline void addLights(rtcore::Scene& scene, const rtcore::Box3& bounds) {
    using rtcore::Vec3;
    const Vec3 size = bounds.size();
    const auto at = [&](float x, float y, float z) {
        return bounds.lo + Vec3{x * size.x, y * size.y, z * size.z};
    };
    const float diagonal = bounds.diagonal();
    const float bright = 0.15F * diagonal * diagonal;
    rtcore::Light ball;
    ball.kind = rtcore::LightKind::Sphere;
    ball.position = at(0.3F, 0.8F, 0.55F);
    ball.radius = 0.02F * diagonal;
    ball.intensity = rtcore::Colour{1, 0.9F, 0.7F} * bright;
    rtcore::Light panel;
    panel.kind = rtcore::LightKind::Rectangle;
    panel.position = at(0.7F, 0.9F, 0.4F);
    panel.direction = rtcore::normalize({-0.2F, -1, 0.1F});
    panel.right = rtcore::basisAround(panel.direction).tangent;
    panel.width = 0.1F * diagonal;
    panel.height = 0.05F * diagonal;
    panel.intensity = rtcore::Colour{0.7F, 0.8F, 1} * bright;
    rtcore::Light bulb;
    bulb.position = at(0.5F, 0.4F, 0.8F);
    bulb.intensity = rtcore::Colour{0.5F, 0.4F, 0.3F} * bright;
    rtcore::Light spot;
    spot.kind = rtcore::LightKind::Spot;
    spot.position = at(0.1F, 0.9F, 0.2F);
    spot.direction = rtcore::normalize(at(0.6F, 0.1F, 0.6F) - spot.position);
    spot.cosInner = 0.95F;
    spot.cosOuter = 0.7F;
    spot.intensity = rtcore::Colour{1, 1, 1} * bright;
    rtcore::Light sun;
    sun.kind = rtcore::LightKind::Directional;
    sun.direction = rtcore::normalize({-0.4F, -1, -0.3F});
    sun.intensity = {2, 1.8F, 1.5F};
    sun.discSine = 0.01F;
    rtcore::Light luminaire = spot;
    luminaire.kind = rtcore::LightKind::Ies;
    luminaire.right = rtcore::basisAround(luminaire.direction).tangent;
    luminaire.photometry = rtcore::keepPhotometry(
        {{0, 20, 40, 90}, {0, 90, 270, 360}, {9, 5, 8, 0, 9, 6, 2, 1, 9, 5, 4, 0, 9, 5, 8, 0}});
    static_assert(rtcore::kLightKinds == 6, "one light of each kind");
    scene.lights = {ball, panel, bulb, spot, sun, luminaire};
}

/// A sky that is brighter above than below, and differs to all sides.
inline rtcore::Environment sampleSky() {
    rtcore::HdrImage sky(16, 8);
    for (int y = 0; y < sky.height; ++y) {
        for (int x = 0; x < sky.width; ++x) {
            const auto across = static_cast<float>(x) / 16, down = static_cast<float>(y) / 8;
            sky.at(x, y) = {1 - down, 0.3F + 0.5F * across, 0.8F - 0.4F * across * down};
        }
    }
    return rtcore::Environment::fromEquirectangular(sky, "sky");
}

inline void addEveryEffect(rtcore::Scene& scene) {
    const rtcore::Box3 bounds = scene.mesh().bounds();
    const float diagonal = bounds.diagonal();
    varyMaterials(scene);
    addLights(scene, bounds);
    scene.ambient = {0.1F, 0.1F, 0.12F};
    scene.environments = {std::make_shared<rtcore::Environment>(sampleSky())};
    scene.activeEnvironment = 0;
    scene.metresPerUnit = 20 / diagonal; // so that the lens blurs all scenes alike
    scene.fog.kind = rtcore::FogKind::Exponential;
    scene.fog.density = 0.2F / diagonal;
    scene.fog.scaleHeight = 0.3F * diagonal;
    scene.fog.groundHeight = dot(bounds.lo, scene.up);
}

} // namespace test
