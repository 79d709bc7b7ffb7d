#include "rtcore/render/ground_tracer.h"

#include <cstddef>
#include <utility>

namespace rtcore {

GroundTracer::GroundTracer(std::shared_ptr<const RayTracer> surfaces, std::shared_ptr<const SkyGround> ground,
                           GroundRole role)
    : surfaces_(std::move(surfaces)), ground_(std::move(ground)),
      first_(static_cast<std::uint32_t>(ground_->mesh.triangles.size()) -
             2 * ground_->cells * ground_->cells),
      role_(role) {}

bool GroundTracer::meets(RayKind kind) const {
    switch (role_) {
    case GroundRole::Mirrored:
        return kind == RayKind::Mirror;
    case GroundRole::Catcher:
        return kind == RayKind::Primary;
    case GroundRole::Seen:
        break;
    }
    return kind != RayKind::Shadow && kind != RayKind::Occlusion && kind != RayKind::Scattered;
}

void GroundTracer::intersect(RayKind kind, const RayWave& rays, HitWave& hits) const {
    if (role_ == GroundRole::Catcher && kind == RayKind::Primary) {
        missAll(rays.size(), hits);
    } else {
        surfaces_->intersect(kind, rays, hits);
    }
    if (!meets(kind)) return;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        const auto t = distanceToGround(*ground_, ray.origin, ray.direction);
        if (!t || !(*t >= ray.tMin && *t <= ray.tMax) || (hits.isHit(i) && hits.t[i] <= *t)) continue;
        const auto point = pointOnGround(*ground_, ray.origin + ray.direction * *t);
        if (!point) continue;
        hits.set(i, {*t, first_ + point->triangle, point->u, point->v});
        if (!hits.clearance.empty()) hits.clearance[i] = 0;
    }
}

void GroundTracer::occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    surfaces_->occluded(kind, rays, occluded);
}

void GroundTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                                 std::vector<Obstacle>& found) const {
    surfaces_->findObstacles(rays, clear, found);
}

void missAll(std::size_t count, HitWave& hits) {
    hits.resize(count);
    for (std::size_t i = 0; i < count; ++i) hits.set(i, {0, kNoTriangle, 0, 0});
}

std::shared_ptr<const RayTracer> withGround(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                            GroundRole role) {
    if (!scene.showsGround()) return surfaces;
    return std::make_shared<const GroundTracer>(std::move(surfaces), scene.ground, role);
}

} // namespace rtcore
