/// A small view in which everything occurs: mirrors, glass, a leaf with holes, textures, three kinds of
/// lights.
#pragma once

#include "rtcore/render/frame_renderer.h"
#include "support/small_scene.h"

#include <cstdint>
#include <span>

namespace test {

inline rtcore::Scene sampleScene() {
    SceneBuilder b;
    rtcore::Material floor = matte(0.8F);
    floor.diffuseTexture =
        b.texture(2, 2, {{255, 200, 90, 255}, {30, 60, 90, 255}, {60, 200, 90, 255}, {220, 220, 210, 255}});
    rtcore::Material leaf = matte(0.5F);
    leaf.alphaTexture = b.texture(2, 1, {{10, 0, 0, 255}, {240, 0, 0, 255}});
    rtcore::Material metal = mirror(0.6F);
    metal.fresnel = 1;
    metal.specular = {0.3F, 0.3F, 0.3F};
    metal.shininess = 40;
    rtcore::Material bottle = glass();
    bottle.transmission = {0.5F, 0.9F, 0.6F};
    bottle.attenuationDistance = 1;
    rtcore::Material pane = glass();
    pane.transmission = {0.9F, 0.5F, 0.5F};
    b.square({0.1F, -1, 0.2F}, {0, 1, 0}, 6, b.material(floor));
    b.sphere({-1.2F, 0, 0}, 1, 12, b.material(metal));
    b.sphere({1.1F, -0.2F, 0.6F}, 0.8F, 12, b.material(bottle));
    b.square({0, 0.4F, 2}, {0, 0, 1}, 0.7F, b.material(pane));
    b.square({0.2F, 1.4F, -1}, {0, 0, 1}, 1, b.material(leaf));
    b.box({-0.4F, -1, -1.6F}, {0.4F, 0.3F, -0.9F}, b.material(matte(0.7F)));
    b.scene.background = {0.2F, 0.3F, 0.5F};
    b.scene.ambient = {0.05F, 0.05F, 0.05F};
    rtcore::Light sun;
    sun.kind = rtcore::LightKind::Directional;
    sun.direction = rtcore::normalize({-1, -2, -0.5F});
    rtcore::Light spot = pointLight({-2, 3, 2}, 30);
    spot.kind = rtcore::LightKind::Spot;
    spot.direction = rtcore::normalize({1, -2, -1});
    spot.cosInner = 0.95F;
    spot.cosOuter = 0.8F;
    b.scene.lights = {sun, spot, pointLight({2, 2, 3}, 10)};
    return b.finish();
}

/// The same under area lights.
inline rtcore::Scene softlyLitScene() {
    rtcore::Scene scene = sampleScene();
    rtcore::Light& sphere = scene.lights[2].light;
    sphere.kind = rtcore::LightKind::Sphere;
    sphere.radius = 0.5F;
    rtcore::Light& panel = scene.lights[1].light;
    panel.kind = rtcore::LightKind::Rectangle;
    panel.right = rtcore::basisAround(panel.direction).tangent;
    panel.width = 1;
    panel.height = 0.5F;
    return scene;
}

inline rtcore::Scene foggyScene(rtcore::FogKind kind) {
    rtcore::Scene scene = sampleScene();
    scene.fog.kind = kind;
    scene.fog.density = 0.1F;
    scene.fog.scaleHeight = 0.8F;
    scene.fog.groundHeight = -1;
    scene.fog.surroundings = 0.5F;
    scene.fog.emission = {0.01F, 0, 0.02F};
    return scene;
}

inline rtcore::Camera sampleCamera() {
    rtcore::Camera camera;
    camera.eye = {0.3F, 0.8F, 6};
    camera.forward = {-0.02F, -0.1F, -1};
    camera.horizontalFov = 45;
    return camera;
}

inline rtcore::RenderSettings sampleSettings(int width, int height, int antialiasing = 1) {
    rtcore::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.antialiasing = antialiasing;
    return settings;
}

inline rtcore::Frame render(const TracedScene& s, const rtcore::RenderSettings& settings, int threads = 1) {
    rtcore::Frame frame;
    rtcore::RenderControl control{.threads = threads};
    rtcore::FrameRenderer renderer;
    renderer.collectAovs(settings.denoise.passes > 0);
    renderer.render({s.scene, s.tracer, sampleCamera(), settings}, control, frame);
    return frame;
}

/// FNV-1a.
inline std::uint64_t hashOf(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const std::byte b : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001B3U;
    return hash;
}

} // namespace test
