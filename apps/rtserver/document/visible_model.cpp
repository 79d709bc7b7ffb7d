#include "rtserver/document/visible_model.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/render/shown_tracer.h"
#include "rtcore/render/visible_scene.h"

#include <utility>

namespace rtserver {

void VisibleModel::prune(const World& world, const rtcore::Scene& scene) {
    tree_ = rtcore::visibleTree(world.loaded.tree, scene);
    pruned_ = scene.hiddenParts != nullptr;
    surfaces_ = pruned_ ? std::make_shared<const rtcore::KdRayTracer>(tree_, *world.tracer) : world.tracer;
    built_ = false;
    take(scene);
}

void VisibleModel::replace(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                           const rtcore::Scene& scene) {
    tree_ = std::move(tree);
    pruned_ = false;
    surfaces_ = std::move(tracer);
    built_ = false;
    take(scene);
}

void VisibleModel::take(const rtcore::Scene& scene) {
    const rtcore::SectionClip clip(scene.sections, surfaces_->bounds());
    if (!rtcore::sameHalves(clip.halves(), halves_)) {
        halves_.assign(clip.halves().begin(), clip.halves().end());
        built_ = false;
    }
    tracer_ = rtcore::shownTracer(surfaces_, scene, sections_);
}

void VisibleModel::useWithin(const rtcore::KdRayTracer& built, std::span<const rtcore::HalfSpace> halves,
                             const rtcore::Scene& scene) {
    if (halves_.empty() || !rtcore::sameHalves(halves, halves_)) return;
    sections_.useLeft(surfaces_, halves_, built.within(halves_));
    built_ = true;
    take(scene);
}

} // namespace rtserver
