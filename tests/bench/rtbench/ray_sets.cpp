#include "bench/rtbench/ray_sets.h"

#include "rtcore/render/camera_rays.h"
#include "support/random_numbers.h"

#include <algorithm>

namespace rtbench {

using rtcore::Hit;
using rtcore::Ray;
using rtcore::Vec3;

namespace {

constexpr int kOcclusionRays = 9;
constexpr float kOcclusionReach = 0.15F; // of the diagonal
constexpr int kBlock = 32;               // pixels of a side, as the renderer's tiles

// Every second bit of `code`: one coordinate of a place on the Z-order curve (Morton 1966).
int everySecondBit(int code) {
    int value = 0;
    for (int bit = 0; bit < 5; ++bit) value |= (code >> (2 * bit) & 1) << bit;
    return value;
}

// Block after block; inside, on the Z-order curve, so that any 16 rays are 4 x 4 pixels and any 64 are 8 x 8.
std::vector<Ray> primaryRays(const BenchView& view, int size) {
    const rtcore::CameraRays camera(view.camera(1), size, size);
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int top = 0; top < size; top += kBlock) {
        for (int left = 0; left < size; left += kBlock) {
            for (int place = 0; place < kBlock * kBlock; ++place) {
                const int x = left + everySecondBit(place);
                const int y = top + everySecondBit(place >> 1);
                if (x >= size || y >= size) continue;
                rays.push_back(camera.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
            }
        }
    }
    return rays;
}

std::vector<rtcore::RayWave> wavesOf(const std::vector<Ray>& rays) {
    std::vector<rtcore::RayWave> waves((rays.size() + kWaveRays - 1) / kWaveRays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rtcore::RayWave& wave = waves[i / kWaveRays];
        if (wave.empty()) wave.reserve(std::min(kWaveRays, rays.size() - i));
        wave.push(rays[i]);
    }
    return waves;
}

std::vector<Hit> trace(const rtcore::RayTracer& tracer, const std::vector<Ray>& rays) {
    std::vector<Hit> hits;
    hits.reserve(rays.size());
    rtcore::HitWave answers;
    for (const rtcore::RayWave& wave : wavesOf(rays)) {
        tracer.intersect(rtcore::RayKind::Primary, wave, answers);
        for (std::size_t i = 0; i < wave.size(); ++i) hits.push_back(answers.hit(i));
    }
    return hits;
}

} // namespace

RaySource::RaySource(const rtcore::Mesh& mesh, const rtcore::RayTracer& tracer, const BenchView& view,
                     int size)
    : mesh_(mesh), tracer_(tracer), view_(view), size_(size), diagonal_(mesh.bounds().diagonal()),
      primary_(primaryRays(view, size)), hits_(trace(tracer, primary_)),
      points_(test::surfacePoints(mesh, primary_, hits_)) {}

RaySet RaySource::make(const RayTest& test) const {
    std::vector<Ray> rays;
    switch (test.kind) {
    case rtcore::RayKind::Primary:
        rays = primary_;
        break;
    case rtcore::RayKind::Shadow:
        rays = test::shadowRays(points_, view_.light);
        break;
    case rtcore::RayKind::Occlusion:
        rays = occlusionRays();
        break;
    case rtcore::RayKind::Mirror:
        rays = mirrorRays();
        break;
    default:
        rays = test::diffuseRays(points_, 1);
        break;
    }
    return {&test, wavesOf(rays), rays.size()};
}

std::vector<Ray> RaySource::occlusionRays() const {
    const std::vector<Ray> coarse = primaryRays(view_, std::max(1, size_ / 2));
    const float reach = kOcclusionReach * diagonal_;
    test::Random random(2);
    std::vector<Ray> rays;
    for (const test::SurfacePoint& p : test::surfacePoints(mesh_, coarse, trace(tracer_, coarse))) {
        for (int i = 0; i < kOcclusionRays; ++i) {
            const Vec3 direction = normalize(p.normal + random.unitVector() * 0.999F);
            rays.push_back({p.position, 0, direction, reach});
        }
    }
    return rays;
}

std::vector<Ray> RaySource::mirrorRays() const {
    std::vector<Ray> rays;
    std::size_t point = 0;
    for (std::size_t i = 0; i < primary_.size(); ++i) {
        if (hits_[i].triangle == rtcore::kNoTriangle) continue;
        const test::SurfacePoint& p = points_[point++];
        const Vec3 in = primary_[i].direction;
        rays.push_back({p.position, 0, in - p.normal * (2 * dot(in, p.normal)), test::kUnlimited});
    }
    return rays;
}

} // namespace rtbench
