#include "rtcore/render/section_tracer.h"

#include "rtcore/kernels/section_clip.h"

#include <utility>

namespace rtcore {

SectionTracer::SectionTracer(std::shared_ptr<const RayTracer> surfaces, const SectionPlanes& sections,
                             std::shared_ptr<const RayTracer> uncut)
    : surfaces_(std::move(surfaces)),
      left_(surfaces_->within(SectionClip(sections, surfaces_->bounds()).halves())), uncut_(std::move(uncut)),
      all_(sections.light == SectionLight::Cut) {}

bool SectionTracer::meetsLeft(RayKind kind) const {
    return all_ || kind == RayKind::Primary || kind == RayKind::Mirror || kind == RayKind::Refracted;
}

void SectionTracer::intersect(RayKind kind, const RayWave& rays, HitWave& hits) const {
    meetsLeft(kind) ? intersectLeft(kind, rays, hits) : surfaces_->intersect(kind, rays, hits);
}

void SectionTracer::intersectSeen(const RayWave& rays, HitWave& hits) const {
    intersectLeft(RayKind::Scattered, rays, hits);
}

/// Of surfaces that are cut and those that are left whole.
void SectionTracer::intersectLeft(RayKind kind, const RayWave& rays, HitWave& hits) const {
    left_->intersect(kind, rays, hits);
    if (uncut_ == nullptr) return;
    thread_local HitWave whole;
    uncut_->intersect(kind, rays, whole);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!whole.isHit(i)) continue;
        const Hit hit = whole.hit(i), other = hits.hit(i);
        const bool nearer = hit.t < other.t || (hit.t == other.t && hit.triangle < other.triangle);
        if (!hits.isHit(i) || nearer) hits.put(i, whole, i);
    }
}

void SectionTracer::occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    if (!meetsLeft(kind)) return surfaces_->occluded(kind, rays, occluded);
    left_->occluded(kind, rays, occluded);
    if (uncut_ == nullptr) return;
    thread_local std::vector<std::uint8_t> whole;
    uncut_->occluded(kind, rays, whole);
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] |= whole[i];
}

void SectionTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                                  std::vector<Obstacle>& found) const {
    if (!all_) return surfaces_->findObstacles(rays, clear, found);
    left_->findObstacles(rays, clear, found);
    if (uncut_ == nullptr) return;
    thread_local std::vector<Obstacle> whole;
    uncut_->findObstacles(rays, clear, whole);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (found[i] == Obstacle::None || whole[i] == Obstacle::Opaque) found[i] = whole[i];
}

std::shared_ptr<const RayTracer> UncutSurfaces::of(const std::shared_ptr<const RayTracer>& surfaces,
                                                   const Scene& scene) {
    if (surfaces == surfaces_ && sameParts(scene.uncutParts, parts_)) return uncut_;
    forget();
    if (scene.uncutParts == nullptr) return nullptr;
    std::vector<std::uint8_t> others = partTriangles(scene.model, scene.uncutParts);
    for (std::uint8_t& triangle : others) triangle = triangle == 0 ? 1 : 0;
    uncut_ = surfaces->without(others);
    surfaces_ = surfaces;
    parts_ = scene.uncutParts;
    return uncut_;
}

std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                              UncutSurfaces& uncut) {
    if (SectionClip(scene.sections, surfaces->bounds()).empty()) {
        uncut.forget();
        return surfaces;
    }
    std::shared_ptr<const RayTracer> whole = uncut.of(surfaces, scene);
    return std::make_shared<const SectionTracer>(std::move(surfaces), scene.sections, std::move(whole));
}

} // namespace rtcore
