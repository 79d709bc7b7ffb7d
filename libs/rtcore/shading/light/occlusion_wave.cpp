#include "rtcore/shading/light/occlusion_wave.h"

#include "rtcore/shading/light/arriving_light.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// A ray that passed so many holes and panes goes on to infinity.
constexpr int kMaxLayers = 4;

} // namespace

void OcclusionWave::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                          const MaterialTable& materials) {
    const AmbientOcclusionSettings& occlusion = settings.ambientOcclusion;
    if (!occlusion.on || settings.skyLight.on) return HemisphereWave::begin();
    scene_ = &scene;
    tracer_ = &tracer;
    textures_ = settings.textures;
    refractions_ = settings.refractions;
    light_ = occludedLight(scene, tracer.bounds(), occlusion);
    HemisphereWave::begin(materials, {occlusion.pattern, occlusion.samples, light_.distance});
}

void OcclusionWave::start(std::size_t points) { visible_.assign(points, 0); }

void OcclusionWave::gather(std::size_t directions, RayStatistics& statistics) {
    statistics.count(RayKind::Occlusion, rays().size());
    tracer_->intersect(RayKind::Occlusion, rays(), hits_);
    if (materials().tintedShadows()) return sumSeeThrough(statistics);
    const std::size_t points = visible_.size();
    for (std::size_t i = 0; i < directions; ++i)
        addVisible(visible_.data(), points, hits_, i * points, light_.distance);
}

void OcclusionWave::finish(std::span<const Point> points, std::size_t directions, SurfaceWave& surfaces) {
    const Colour light = light_.radiance / static_cast<float>(directions);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t point = points[i].index;
        surfaces.contribution.set(point, scattered(surfaces, point) * light * visible_[i]);
    }
}

/// Holes and glass let rays pass, in part: what passes goes on to what is behind, layer by layer.
void OcclusionWave::sumSeeThrough(RayStatistics& statistics) {
    current_.start(rays().size(), visible_.size());
    for (int layer = 0; layer < kMaxLayers; ++layer) {
        next_.clear();
        for (std::size_t i = 0; i < current_.size(); ++i) sumHit(layer == 0 ? rays() : current_.rays, i);
        if (next_.empty()) return;
        std::swap(current_, next_);
        if (layer + 1 == kMaxLayers) break;
        statistics.count(RayKind::Occlusion, current_.size());
        tracer_->intersect(RayKind::Occlusion, current_.rays, hits_);
    }
    for (std::size_t i = 0; i < current_.size(); ++i) {
        visible_[current_.point[i]] += current_.weight[i];
    }
}

void OcclusionWave::sumHit(const RayWave& rays, std::size_t i) {
    float& visible = visible_[current_.point[i]];
    const float weight = current_.weight[i];
    if (!hits_.isHit(i)) {
        visible += weight;
        return;
    }
    const Ray ray = rays.ray(i);
    const Hit hit = hits_.hit(i);
    const float travelled = current_.travelled[i] + hit.t;
    const bool fromInside = dot(scene_->mesh().geometricNormal(hit.triangle), ray.direction) > 0;
    float solid = coverageAt(*scene_, textures_, hit, fromInside);
    if (refractions_) solid *= opacityAt(*scene_, textures_, hit);
    visible += weight * solid * std::min(travelled / light_.distance, 1.0F);
    if (solid >= 1) return;
    const float passing = weight * (1 - solid);
    const Surface surface = shapeAt(*scene_, ray.direction, hit, hits_.clearanceOf(i));
    const Ray rest{surface.position - surface.geometricNormal * surface.clearance, 0, ray.direction,
                   light_.distance - travelled};
    if (rest.tMax > 0) {
        next_.push(rest, current_.point[i], passing, travelled);
    } else {
        visible += passing;
    }
}

void OcclusionWave::SeeingRays::start(std::size_t count, std::size_t points) {
    rays.clear();
    point.resize(count);
    for (std::size_t i = 0; i < count; ++i) point[i] = static_cast<std::uint32_t>(i % points);
    weight.assign(count, 1);
    travelled.assign(count, 0);
}

void OcclusionWave::SeeingRays::clear() {
    rays.clear();
    point.clear();
    weight.clear();
    travelled.clear();
}

void OcclusionWave::SeeingRays::push(const Ray& ray, std::uint32_t ofPoint, float itsWeight, float soFar) {
    rays.push(ray);
    point.push_back(ofPoint);
    weight.push_back(itsWeight);
    travelled.push_back(soFar);
}

} // namespace rtcore
