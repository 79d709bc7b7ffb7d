#include "rtserver/document/visible_model.h"

#include "rtcore/render/shown_tracer.h"
#include "rtcore/render/visible_scene.h"

#include <utility>

namespace rtserver {

void VisibleModel::prune(const World& world, const rtcore::Scene& scene) {
    tree_ = rtcore::visibleTree(world.loaded.tree, scene);
    pruned_ = scene.hiddenParts != nullptr;
    surfaces_ = pruned_ ? std::make_shared<const rtcore::KdRayTracer>(tree_, *world.tracer) : world.tracer;
    take(scene);
}

void VisibleModel::replace(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                           const rtcore::Scene& scene) {
    tree_ = std::move(tree);
    pruned_ = false;
    surfaces_ = std::move(tracer);
    take(scene);
}

void VisibleModel::take(const rtcore::Scene& scene) {
    tracer_ = rtcore::shownTracer(surfaces_, scene, uncut_);
}

} // namespace rtserver
