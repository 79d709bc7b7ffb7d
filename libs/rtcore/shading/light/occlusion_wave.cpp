#include "rtcore/shading/light/occlusion_wave.h"

#include "rtcore/math/constants.h"
#include "rtcore/sampling/even_shift.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Rays traced at once: a stream's worth. How many of them belong to one point depends on the settings
/// alone, so that its sum has the same order in every wave.
constexpr std::size_t kRays = 16384;
constexpr std::size_t kMostAtOnce = 256;
/// A ray that passed so many holes and panes goes on to infinity.
constexpr int kMaxLayers = 4;

/// Points whose weight in their sample is above this get all rays, half of them more than
/// half of it, and so on.
constexpr float kFullWeight = 0.5F;

} // namespace

void OcclusionWave::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                          const MaterialTable& materials) {
    const AmbientOcclusionSettings& occlusion = settings.ambientOcclusion;
    for (auto& points : points_) points.clear();
    on_ = occlusion.on;
    if (!on_) return;
    scene_ = &scene;
    tracer_ = &tracer;
    materials_ = &materials;
    textures_ = settings.textures;
    refractions_ = settings.refractions;
    kind_ = occlusion.pattern;
    light_ = occludedLight(scene, tracer.bounds(), occlusion);
    int rays = occlusion.samples;
    for (auto& pattern : patterns_) {
        setSpiral(rays, pattern);
        rays = (rays + 1) / 2;
    }
}

/// The fraction of the ambient light at the point that reaches its sample.
Colour OcclusionWave::scattered(const SurfaceWave& surfaces, std::size_t point) const {
    const MaterialRow& row = materials_->rows()[surfaces.material[point]];
    const Colour specular{row.specular[0], row.specular[1], row.specular[2]};
    return surfaces.weight.colourAt(point) * (surfaces.diffuse.colourAt(point) * kPi + specular);
}

bool OcclusionWave::takes(const SurfaceWave& surfaces, std::size_t point) const {
    return surfaces.traits[point] != 0 && maxComponent(scattered(surfaces, point)) > 0;
}

void OcclusionWave::add(const SurfaceWave& surfaces, std::size_t point, SampleId sample,
                        std::uint32_t bounce) {
    const float weight = maxComponent(surfaces.weight.colourAt(point));
    const std::size_t fewer = weight > kFullWeight ? 0 : weight > kFullWeight / 2 ? 1 : 2;
    Point named{static_cast<std::uint32_t>(point), {0.5F, 0}, 0}; // Regular: the middle of each ring
    if (kind_ == OcclusionPattern::Rotated)
        named.shift = evenShift(sample, SampleDimension::Occlusion, bounce);
    if (kind_ == OcclusionPattern::Random)
        named.name = randomBits(sample, SampleDimension::Occlusion, bounce);
    points_[fewer].push_back(named);
}

void OcclusionWave::light(SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop) {
    for (float* const array : {surfaces.added.x, surfaces.added.y, surfaces.added.z}) {
        std::fill_n(array, surfaces.size(), 0.0F);
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
        trace(points_[i], patterns_[i], surfaces, statistics, stop);
        points_[i].clear();
    }
}

void OcclusionWave::trace(const std::vector<Point>& points, const std::vector<HemispherePoint>& pattern,
                          SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop) {
    if (points.empty()) return;
    const std::size_t atOnce = std::min(pattern.size(), kMostAtOnce);
    const std::size_t most = kRays / atOnce;
    const std::size_t groups = (points.size() + most - 1) / most;
    const std::size_t size = (points.size() + groups - 1) / groups;
    for (std::size_t begin = 0; begin < points.size(); begin += size) {
        const std::span group(&points[begin], std::min(size, points.size() - begin));
        place(group, kind_ == OcclusionPattern::Random ? 0 : 1 / static_cast<float>(pattern.size()),
              surfaces);
        for (std::size_t k = 0; k < pattern.size(); k += atOnce) {
            if (stop != nullptr && stop->load(std::memory_order_relaxed)) return;
            const std::size_t count = std::min(atOnce, pattern.size() - k);
            aim(group, {&pattern[k], count}, k);
            statistics.count(RayKind::Occlusion, rays_.size());
            tracer_->intersect(RayKind::Occlusion, rays_, hits_);
            if (materials_->tintedShadows()) {
                sumSeeThrough(statistics);
            } else {
                for (std::size_t i = 0; i < count; ++i) {
                    addVisible(frames_, hits_, i * group.size(), light_.distance);
                }
            }
        }
        const Colour light = light_.radiance / static_cast<float>(pattern.size());
        for (std::size_t i = 0; i < group.size(); ++i) {
            const std::size_t point = group[i].index;
            surfaces.added.set(point, scattered(surfaces, point) * light * frames_.visible[i]);
        }
    }
}

void OcclusionWave::place(std::span<const Point> points, float ring, const SurfaceWave& surfaces) {
    memory_.resize(17, points.size());
    std::size_t next = 0;
    for (ArraysOf3* const arrays :
         {&frames_.origin, &frames_.tangent, &frames_.bitangent, &frames_.normal, &frames_.side}) {
        *arrays = {memory_.array(next), memory_.array(next + 1), memory_.array(next + 2)};
        next += 3;
    }
    frames_.shift = memory_.array(next);
    frames_.visible = memory_.array(next + 1);
    frames_.count = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t point = points[i].index;
        const Vec3 side = surfaces.geometricNormal.at(point);
        const Vec3 normal = surfaces.shadingNormal.at(point);
        const auto [tangent, bitangent] = basisAround(normal);
        const HemispherePoint turn = hemispherePoint(points[i].shift);
        frames_.origin.set(i, surfaces.position.at(point) + side * surfaces.clearance[point]);
        frames_.tangent.set(i, tangent * turn.cosine + bitangent * turn.sine);
        frames_.bitangent.set(i, bitangent * turn.cosine - tangent * turn.sine);
        frames_.normal.set(i, normal);
        frames_.side.set(i, side);
        frames_.shift[i] = turn.u * ring;
        frames_.visible[i] = 0;
    }
}

/// All rays of the first direction, then all of the next.
void OcclusionWave::aim(std::span<const Point> points, std::span<const HemispherePoint> pattern,
                        std::size_t first) {
    const std::size_t count = points.size() * pattern.size();
    rays_.resize(count + kWaveBlock);
    std::fill_n(rays_.tMin.begin(), count, 0.0F);
    std::fill_n(rays_.tMax.begin(), count, light_.distance);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (kind_ == OcclusionPattern::Random) {
            draw(points, static_cast<std::uint32_t>(first + i));
            aimEach(frames_, drawn_.data(), rays_, i * points.size());
        } else {
            aimAlike(frames_, pattern[i], rays_, i * points.size());
        }
    }
    rays_.resize(count);
}

/// A direction for each point that has nothing to do with its others.
void OcclusionWave::draw(std::span<const Point> points, std::uint32_t ray) {
    drawn_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t bits = mixBits(points[i].name + 0x9E3779B9U * ray);
        drawn_[i] = hemispherePoint({unitFloat(bits), unitFloat(mixBits(bits + 0x85EBCA6BU))});
    }
}

/// Holes and glass let rays pass, in part: what passes goes on to what is behind, layer by layer.
void OcclusionWave::sumSeeThrough(RayStatistics& statistics) {
    const std::size_t points = frames_.count;
    current_.start(rays_.size(), points);
    for (int layer = 0; layer < kMaxLayers; ++layer) {
        next_.clear();
        for (std::size_t i = 0; i < current_.size(); ++i) sumHit(layer == 0 ? rays_ : current_.rays, i);
        if (next_.empty()) return;
        std::swap(current_, next_);
        if (layer + 1 == kMaxLayers) break;
        statistics.count(RayKind::Occlusion, current_.size());
        tracer_->intersect(RayKind::Occlusion, current_.rays, hits_);
    }
    for (std::size_t i = 0; i < current_.size(); ++i) {
        frames_.visible[current_.point[i]] += current_.weight[i];
    }
}

void OcclusionWave::sumHit(const RayWave& rays, std::size_t i) {
    float& visible = frames_.visible[current_.point[i]];
    const float weight = current_.weight[i];
    if (!hits_.isHit(i)) {
        visible += weight;
        return;
    }
    const Ray ray = rays.ray(i);
    const Hit hit = hits_.hit(i);
    const float travelled = current_.travelled[i] + hit.t;
    const Material& material = scene_->materials[scene_->mesh().shading[hit.triangle].material];
    float solid = coverageAt(*scene_, textures_, hit);
    if (refractions_) solid *= material.opacity;
    visible += weight * solid * std::min(travelled / light_.distance, 1.0F);
    if (solid >= 1) return;
    const float passing = weight * (1 - solid);
    const Surface surface = shapeAt(*scene_, ray.direction, hit);
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
