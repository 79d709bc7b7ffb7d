#include "rtcore/render/section_tracer.h"

#include "rtcore/kernels/section_clip.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rtcore {

namespace {

bool isSame(const HalfSpace& a, const HalfSpace& b) { return a.normal == b.normal && a.offset == b.offset; }

} // namespace

SectionTracer::SectionTracer(std::shared_ptr<const RayTracer> surfaces, std::shared_ptr<const RayTracer> left,
                             std::shared_ptr<const RayTracer> uncut, SectionLight light)
    : surfaces_(std::move(surfaces)), left_(std::move(left)), uncut_(std::move(uncut)),
      all_(light == SectionLight::Cut) {
    if (surfaces_ == nullptr || left_ == nullptr)
        throw std::invalid_argument("sections need a tracer of what they leave of surfaces");
}

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

bool sameHalves(std::span<const HalfSpace> a, std::span<const HalfSpace> b) {
    return std::ranges::equal(a, b, isSame);
}

std::shared_ptr<const RayTracer> SectionSurfaces::left(const std::shared_ptr<const RayTracer>& surfaces,
                                                       std::span<const HalfSpace> halves) {
    if (surfaces != cut_ || !sameHalves(halves, halves_)) useLeft(surfaces, halves, surfaces->within(halves));
    return left_;
}

void SectionSurfaces::useLeft(std::shared_ptr<const RayTracer> surfaces, std::span<const HalfSpace> halves,
                              std::shared_ptr<const RayTracer> left) {
    cut_ = std::move(surfaces);
    halves_.assign(halves.begin(), halves.end());
    left_ = std::move(left);
}

std::shared_ptr<const RayTracer> SectionSurfaces::uncut(const std::shared_ptr<const RayTracer>& surfaces,
                                                        const Scene& scene) {
    if (surfaces == surfaces_ && sameParts(scene.uncutParts, parts_)) return uncut_;
    surfaces_ = uncut_ = nullptr;
    parts_ = nullptr;
    if (scene.uncutParts == nullptr) return nullptr;
    std::vector<std::uint8_t> others = partTriangles(scene.model, scene.uncutParts);
    for (std::uint8_t& triangle : others) triangle = triangle == 0 ? 1 : 0;
    uncut_ = surfaces->without(others);
    surfaces_ = surfaces;
    parts_ = scene.uncutParts;
    return uncut_;
}

std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                              SectionSurfaces& known) {
    const SectionClip clip(scene.sections, surfaces->bounds());
    if (clip.empty()) {
        known.forget();
        return surfaces;
    }
    auto left = known.left(surfaces, clip.halves());
    auto uncut = known.uncut(surfaces, scene);
    return std::make_shared<const SectionTracer>(std::move(surfaces), std::move(left), std::move(uncut),
                                                 scene.sections.light);
}

} // namespace rtcore
