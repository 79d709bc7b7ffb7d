/// Renderer --plan: a drawing to scale.
#pragma once

#include "common/plans/plan_order.h"
#include "common/progress/progress.h"

#include "rtcore/io/scene_loader.h"

namespace renderer {

/// Draws it, tells what was found and writes it. Throws rtcore::FileError Stopped and CannotWrite, and what
/// app::drawPlan() throws.
void makePlan(const app::PlanOrder& order, const rtcore::LoadedScene& loaded, int threads,
              app::Progress& progress);

} // namespace renderer
