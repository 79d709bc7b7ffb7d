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
    memory_.resize(9, points);
    std::size_t next = 0;
    for (ArraysOf3* const sums : {&sums_.arrived, &sums_.passing, &sums_.whole}) {
        *sums = {memory_.array(next), memory_.array(next + 1), memory_.array(next + 2)};
        next += 3;
    }
    for (std::size_t i = 0; i < next; ++i) std::fill_n(memory_.array(i), points, 0.0F);
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

/// The mean radiance that reaches a point. What all directions together bring with nothing in the way is
/// known; by how much the point's rays miss that, is taken from the mean in proportion to what passes - for
/// each ray as the others have found it, so that nothing is added on the mean. (Control variates) Two rays
/// of a pattern lie too far apart to tell of each other.
Colour SkyWave::arriving(std::size_t i, std::size_t directions, Vec3 normal) const {
    const auto count = static_cast<float>(directions);
    const Colour correction = sky_.light->correction(normal), arrived = sums_.arrived.colourAt(i);
    const Colour mean = correction * arrived / count;
    if (directions < 3 || sky_.fog != nullptr) return mean;
    const Colour passing = sums_.passing.colourAt(i), whole = sums_.whole.colourAt(i);
    const Colour known = passing * sky_.light->open(normal) * sky_.scale / count,
                 found = correction * (passing * whole - arrived) / (count * (count - 1));
    const Colour light = mean + known - found;
    return {std::max(light.r, 0.0F), std::max(light.g, 0.0F), std::max(light.b, 0.0F)};
}

void SkyWave::finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t point = points[i].index;
        const Colour light = arriving(i, directions, surfaces.shadingNormal.at(point));
        surfaces.added.set(point, scattered(surfaces, point) * light);
    }
}

} // namespace rtcore
