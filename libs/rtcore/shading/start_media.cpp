#include "rtcore/shading/start_media.h"

#include "rtcore/scene/media_crossing.h"
#include "rtcore/shading/path_medium.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace rtcore {

namespace {

constexpr int kMaxMet = 1000; ///< surfaces; it bounds the work of a hostile model

} // namespace

MediaList StartMedia::around(const RayTracer& tracer, Vec3 point) {
    const auto holds = [&](const Box3& box) { return box.contains(point); };
    if (std::none_of(near_.begin(), near_.end(), holds)) return {};
    constexpr Vec3 kOblique{0.36F, 0.48F, 0.8F};
    MediaAtStart start;
    Ray ray{point, 0, kOblique, std::numeric_limits<float>::max()};
    for (int met = 0; met < kMaxMet; ++met) {
        ray_.clear();
        ray_.push(ray);
        tracer.intersect(RayKind::Refracted, ray_, hit_);
        if (!hit_.isHit(0)) break;
        const Hit hit = hit_.hit(0);
        const Surface s = shapeAt(*scene_, ray.direction, hit, hit_.clearanceOf(0));
        if (boundsSolid(*scene_, hit.triangle, *s.material))
            start.meet(*scene_, {hit.triangle, s.fromInside});
        ray.origin = s.position - s.geometricNormal * s.clearance;
    }
    return start.media();
}

void StartMedia::find(const Scene& scene, const RayTracer& tracer, const RayWave& rays, std::uint32_t first) {
    any_ = false;
    if (scene.solids == nullptr || rays.empty()) return;
    scene_ = &scene;
    first_ = first;
    Box3 origins;
    for (std::size_t i = 0; i < rays.size(); ++i) origins.extend(rays.ray(i).origin);
    near_.clear();
    std::copy_if(scene.solids->boxes.begin(), scene.solids->boxes.end(), std::back_inserter(near_),
                 [&](const Box3& box) { return box.meets(origins); });
    if (near_.empty()) return;
    media_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3 origin = rays.ray(i).origin;
        const bool again = i > 0 && origin == rays.ray(i - 1).origin;
        media_[i] = again ? media_[i - 1] : around(tracer, origin);
        any_ = any_ || !media_[i].empty();
    }
}

Path StartMedia::pathOf(std::size_t ray) const {
    Path path;
    path.sample = first_ + static_cast<std::uint32_t>(ray);
    enterMedium(mediumOf(*scene_, media_[ray]), media_[ray], path);
    if (!scene_->solids->overlap) path.media = {};
    return path;
}

void absorbFromStart(Wave& wave) {
    if (wave.paths.past() == nullptr) return;
    SurfaceWave& surfaces = wave.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces.traits[i] == 0) continue;
        surfaces.weight.set(i, absorption(wave.paths.path(i).extinction, wave.hits.t[i]));
    }
}

} // namespace rtcore
