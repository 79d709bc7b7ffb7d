#include "renderer/plan_making.h"

#include "common/process/stop.h"

#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/render/visible_scene.h"

#include <atomic>

namespace renderer {

void makePlan(const app::PlanOrder& order, const rtcore::LoadedScene& loaded, int threads,
              app::Progress& progress) {
    app::refuseGuessedUnit(loaded.units, loaded.modelPath);
    rtcore::BuildOptions build;
    build.threads = threads;
    const rtcore::KdTree tree = rtcore::buildVisibleTree(loaded.tree, loaded.scene, build);
    const rtcore::KdRayTracer surfaces(tree, loaded.scene.model.mesh, rtcore::LeafRecords::Shared);
    std::atomic<bool> cancel{false};
    app::DrawnPlan plan;
    {
        const app::ProgressScope scope(progress, {.name = "drawing", .fraction = {}, .cancel = &cancel});
        plan = app::drawPlan(order, loaded.scene, surfaces, loaded.modelPath.filename().string(),
                             loaded.camera.eye, cancel);
        app::throwIfStopped();
    }
    for (const rtcore::Sentence& sentence : plan.told) progress.tell(sentence);
    rtcore::writeDrawing(order.file, plan.drawing, {order.scale, plan.title}, order.paper);
}

} // namespace renderer
