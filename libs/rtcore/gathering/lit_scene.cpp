#include "rtcore/gathering/lit_scene.h"

#include "rtcore/math/octahedron-inl.h"
#include "rtcore/scene/environment.h"

#include <cstddef>
#include <utility>

namespace rtcore {

namespace {

/// The spread light of an environment from a direction.
Colour spreadRadiance(const EnvironmentLight& light, Vec3 direction) {
    const auto texel =
        static_cast<std::size_t>(HWY_NAMESPACE::octahedronTexel<float>(direction, light.side()));
    return {light.radiance(0)[texel], light.radiance(1)[texel], light.radiance(2)[texel]};
}

} // namespace

void LitScene::prepare(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings) {
    scene_ = &scene;
    tracer_ = &tracer;
    settings_ = settings;
    fog_ = fogMedium(scene, settings_);
    materials_.prepare(scene, settings_, Colour{});
    lights_.prepare(scene, settings_, tracer.bounds(), partTriangles(scene.model, scene.hiddenParts));
    darkened_ = nullptr;
}

void LitScene::prepareBeside(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                             const HiddenParts& other) {
    const auto emits = [&](std::uint32_t material) { return !isBlack(scene.material(material).emission); };
    std::uint32_t dark = 0;
    while (dark < scene.materials.size() && emits(dark)) ++dark;
    prepare(scene, tracer, settings);
    if (dark == scene.materials.size()) return; // nothing to make them of
    const std::vector<std::uint8_t> here = partTriangles(scene.model, scene.hiddenParts);
    std::vector<std::uint8_t> inBoth = partTriangles(scene.model, other);
    // Rays do not meet them, so that any material which emits nothing will do.
    const std::span<const ShadingTriangle> shading = scene.mesh().shading;
    auto darkened = std::make_shared<Darkened>();
    darkened->shading.assign(shading.begin(), shading.end());
    for (std::size_t i = 0; i < here.size(); ++i) {
        inBoth[i] = inBoth[i] != 0 && here[i] != 0 ? 1 : 0;
        if (here[i] != 0 && emits(shading[i].material)) darkened->shading[i].material = dark;
    }
    lights_.prepare(scene, settings_, tracer.bounds(), inBoth);
    darkened->scene = scene;
    darkened->scene.model.mesh.shading = darkened->shading;
    darkened_ = std::move(darkened);
}

Colour LitScene::fromSurroundings(Vec3 origin, Vec3 direction, Vec3 normal) const {
    const float left = fog_.on ? fogTransmittance(fog_, origin, direction, kEndless) : 1;
    const Environment* const environment = scene_->environment();
    if (environment == nullptr) return lights_.background().radiance(direction) * left;
    const EnvironmentLight& light = environment->light();
    return spreadRadiance(light, direction) * light.correction(normal) * (environment->intensity * left);
}

Colour LitScene::fromSurroundings(Vec3 origin, Vec3 direction) const {
    const float left = fog_.on ? fogTransmittance(fog_, origin, direction, kEndless) : 1;
    const Environment* const environment = scene_->environment();
    if (environment == nullptr) return lights_.background().radiance(direction) * left;
    return spreadRadiance(environment->light(), direction) * (environment->intensity * left);
}

} // namespace rtcore
