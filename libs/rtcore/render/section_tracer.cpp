#include "rtcore/render/section_tracer.h"

#include <utility>

namespace rtcore {

namespace {

const RayWave& clipped(const SectionClip& clip, const RayWave& rays) {
    thread_local RayWave copy;
    copy = rays;
    clip.clip(copy);
    return copy;
}

} // namespace

SectionTracer::SectionTracer(std::shared_ptr<const RayTracer> surfaces, const SectionPlanes& sections)
    : surfaces_(std::move(surfaces)), clip_(sections, surfaces_->bounds()),
      all_(sections.light == SectionLight::Cut) {}

bool SectionTracer::clips(RayKind kind) const {
    return all_ || kind == RayKind::Primary || kind == RayKind::Mirror || kind == RayKind::Refracted;
}

void SectionTracer::intersect(RayKind kind, const RayWave& rays, HitWave& hits) const {
    surfaces_->intersect(kind, clips(kind) ? clipped(clip_, rays) : rays, hits);
}

void SectionTracer::occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    surfaces_->occluded(kind, clips(kind) ? clipped(clip_, rays) : rays, occluded);
}

void SectionTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                                  std::vector<Obstacle>& found) const {
    surfaces_->findObstacles(all_ ? clipped(clip_, rays) : rays, clear, found);
}

std::shared_ptr<const RayTracer> withSections(std::shared_ptr<const RayTracer> surfaces, const Scene& scene) {
    if (SectionClip(scene.sections, surfaces->bounds()).empty()) return surfaces;
    return std::make_shared<const SectionTracer>(std::move(surfaces), scene.sections);
}

} // namespace rtcore
