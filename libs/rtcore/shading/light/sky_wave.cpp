#include "rtcore/shading/light/sky_wave.h"

#include <algorithm>
#include <limits>

namespace rtcore {

void SkyWave::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                    const MaterialTable& materials, const FogMedium* fog) {
    if (!settings.skyLight.on) return HemisphereWave::begin();
    static const EnvironmentLight even;
    const Environment* const environment = scene.environment();
    sky_.light = environment != nullptr ? &environment->light() : &even;
    sky_.scale = environment != nullptr ? kWhite * environment->intensity : scene.background;
    sky_.fog = fog;
    obstacles_.begin(scene, tracer, settings, materials.clear(), nullptr, RayKind::Occlusion);
    HemisphereWave::begin(materials, {settings.ambientOcclusion.pattern, settings.skyLight.samples,
                                      std::numeric_limits<float>::max()});
}

void SkyWave::start(std::size_t points) {
    points_ = points;
    memory_.resize(3, points);
    sums_ = {memory_.array(0), memory_.array(1), memory_.array(2)};
    for (float* const array : {sums_.x, sums_.y, sums_.z}) std::fill_n(array, points, 0.0F);
}

void SkyWave::gather(std::size_t directions, RayStatistics& statistics) {
    const auto addAll = [&](const auto* found) {
        for (std::size_t i = 0; i < directions; ++i)
            addSky(sky_, {rays(), i * points_, points_}, found + i * points_, sums_);
    };
    if (obstacles_.tinted()) {
        addAll(obstacles_.transmittance(rays(), statistics).data());
    } else {
        addAll(obstacles_.occluded(rays(), statistics).data());
    }
}

void SkyWave::finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) {
    const float part = 1 / static_cast<float>(directions);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t point = points[i].index;
        const Colour correction = sky_.light->correction(surfaces.shadingNormal.at(point));
        surfaces.added.set(point, scattered(surfaces, point) * correction * sums_.colourAt(i) * part);
    }
}

} // namespace rtcore
