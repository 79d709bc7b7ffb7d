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
    tracer_ = &tracer;
    around_ = settings.ambientOcclusion.on
                  ? std::optional(occludedLight(scene, tracer.bounds(), settings.ambientOcclusion))
                  : std::nullopt;
    HemisphereWave::begin(materials, {settings.ambientOcclusion.pattern, settings.skyLight.samples,
                                      std::numeric_limits<float>::max()});
}

void SkyWave::start(std::size_t points) {
    points_ = points;
    memory_.resize(9, points);
    std::size_t next = 0;
    for (ArraysOf3* const sums : {&sums_.arrived, &sums_.passing, &sums_.whole}) {
        *sums = memory_.arraysOf3(next);
        next += 3;
    }
    for (std::size_t i = 0; i < next; ++i) std::fill_n(memory_.array(i), points, 0.0F);
    if (around_) near_.assign(points, 0);
}

void SkyWave::gather(std::size_t directions, RayStatistics& statistics) {
    const auto addAll = [&](const auto* found) {
        for (std::size_t i = 0; i < directions; ++i)
            addSky(sky_, {rays(), i * points_, points_}, found + i * points_, sums_);
    };
    if (around_) {
        statistics.count(RayKind::Occlusion, rays().size());
        tracer_->intersect(RayKind::Occlusion, rays(), hits_);
    }
    if (obstacles_.tinted()) {
        const Colour* const passing = obstacles_.transmittance(rays(), statistics).data();
        addAll(passing);
        if (around_) addAround([&](std::size_t ray) { return 1 - maxComponent(passing[ray]); });
    } else if (around_) {
        ended_.resize(rays().size());
        for (std::size_t ray = 0; ray < ended_.size(); ++ray) ended_[ray] = hits_.isHit(ray) ? 1 : 0;
        addAll(ended_.data());
        addAround([](std::size_t) { return 1.0F; });
    } else {
        addAll(obstacles_.occluded(rays(), statistics).data());
    }
}

/// `ending`: how much of a ray that hits something does not go on.
template <typename Ending>
void SkyWave::addAround(Ending ending) {
    for (std::size_t ray = 0, i = 0; ray < rays().size(); ++ray, i = i + 1 == points_ ? 0 : i + 1)
        if (hits_.isHit(ray)) near_[i] += ending(ray) * std::min(hits_.hit(ray).t / around_->distance, 1.0F);
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
        Colour light = arriving(i, directions, surfaces.shadingNormal.at(point));
        if (around_) light += around_->radiance * (near_[i] / static_cast<float>(directions));
        surfaces.contribution.set(point, scattered(surfaces, point) * light);
    }
}

} // namespace rtcore
