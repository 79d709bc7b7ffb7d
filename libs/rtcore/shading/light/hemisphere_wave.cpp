#include "rtcore/shading/light/hemisphere_wave.h"

#include "rtcore/sampling/even_shift.h"
#include "rtcore/shading/surface/scattered_light.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Rays traced at once: a stream's worth. How many of them belong to one point depends on the settings
/// alone, so that its sum has the same order in every wave.
constexpr std::size_t kRays = 16384;
constexpr std::size_t kMaxAtOnce = 256;

/// Points whose weight in their sample is above this get all rays, half of them more than
/// half of it, and so on.
constexpr float kFullWeight = 0.5F;

} // namespace

void HemisphereWave::begin(const MaterialTable& materials, const Rays& rays) {
    for (auto& points : points_) points.clear();
    on_ = true;
    materials_ = &materials;
    kind_ = rays.pattern;
    reach_ = rays.reach;
    int count = rays.count;
    for (auto& pattern : patterns_) {
        setSpiral(count, pattern);
        count = (count + 1) / 2;
    }
}

Colour HemisphereWave::scattered(const SurfaceWave& surfaces, std::size_t point) const {
    return scatteredOf(*materials_, surfaces, point);
}

bool HemisphereWave::takes(const SurfaceWave& surfaces, std::size_t point) const {
    return surfaces.traits[point] != 0 && maxComponent(scattered(surfaces, point)) > 0;
}

void HemisphereWave::add(const SurfaceWave& surfaces, std::size_t point, SampleId sample,
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

void HemisphereWave::light(SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop) {
    for (float* const array : {surfaces.contribution.x, surfaces.contribution.y, surfaces.contribution.z}) {
        std::fill_n(array, surfaces.size(), 0.0F);
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
        trace(points_[i], patterns_[i], surfaces, statistics, stop);
        points_[i].clear();
    }
}

void HemisphereWave::trace(const std::vector<Point>& points, const std::vector<HemispherePoint>& pattern,
                           SurfaceWave& surfaces, RayStatistics& statistics, const std::atomic<bool>* stop) {
    if (points.empty()) return;
    const std::size_t atOnce = std::min(pattern.size(), kMaxAtOnce);
    const std::size_t max = kRays / atOnce;
    const std::size_t groups = (points.size() + max - 1) / max;
    const std::size_t size = (points.size() + groups - 1) / groups;
    for (std::size_t begin = 0; begin < points.size(); begin += size) {
        const std::span group(&points[begin], std::min(size, points.size() - begin));
        place(group, kind_ == OcclusionPattern::Random ? 0 : 1 / static_cast<float>(pattern.size()),
              surfaces);
        start(group.size());
        for (std::size_t k = 0; k < pattern.size(); k += atOnce) {
            if (stop != nullptr && stop->load(std::memory_order_relaxed)) return;
            const std::size_t count = std::min(atOnce, pattern.size() - k);
            aim(group, {&pattern[k], count}, k);
            gather(count, statistics);
        }
        finish(group, pattern.size(), surfaces);
    }
}

void HemisphereWave::place(std::span<const Point> points, float ring, const SurfaceWave& surfaces) {
    memory_.resize(16, points.size());
    std::size_t next = 0;
    for (ArraysOf3* const arrays :
         {&frames_.origin, &frames_.tangent, &frames_.bitangent, &frames_.normal, &frames_.side}) {
        *arrays = memory_.arraysOf3(next);
        next += 3;
    }
    frames_.shift = memory_.array(next);
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
    }
}

/// All rays of the first direction, then all of the next.
void HemisphereWave::aim(std::span<const Point> points, std::span<const HemispherePoint> pattern,
                         std::size_t first) {
    const std::size_t count = points.size() * pattern.size();
    rays_.resize(count + kWaveBlock);
    std::fill_n(rays_.tMin.begin(), count, 0.0F);
    std::fill_n(rays_.tMax.begin(), count, reach_);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (kind_ == OcclusionPattern::Random) {
            samplePoints(points, static_cast<std::uint32_t>(first + i));
            aimEach(frames_, samples_.data(), rays_, i * points.size());
        } else {
            aimAlike(frames_, pattern[i], rays_, i * points.size());
        }
    }
    rays_.resize(count);
}

/// A direction for each point that has nothing to do with its others.
void HemisphereWave::samplePoints(std::span<const Point> points, std::uint32_t ray) {
    samples_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t bits = mixBits(points[i].name + 0x9E3779B9U * ray);
        samples_[i] = hemispherePoint({unitFloat(bits), unitFloat(mixBits(bits + 0x85EBCA6BU))});
    }
}

} // namespace rtcore
