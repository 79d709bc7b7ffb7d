#include "rtcore/gathering/lit_scene.h"

#include "rtcore/math/octahedron-inl.h"
#include "rtcore/scene/environment.h"
#include "rtcore/scene/part_list.h"

#include <cstddef>

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
    lights_.prepare(scene, settings_, tracer.bounds(), hiddenTriangles(scene.model, scene.hiddenParts));
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
