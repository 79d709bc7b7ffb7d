/// Renderer --plan: a drawing to scale, and what lies behind its lines.
#pragma once

#include "common/cli/input_files.h"
#include "common/plans/plan_order.h"
#include "common/progress/progress.h"
#include "renderer/picture_maker.h"

namespace renderer {

/// Draws it, renders its light where that is ordered, tells what was found and writes it. Throws
/// rtcore::FileError Stopped and CannotWrite, app::UsageError for a file that is one of `inputs`, and what
/// app::drawPlan(), rtcore::drawingFiles() and the maker throw.
void makePlan(const app::PlanOrder& order, PictureMaker& maker, const app::InputFiles& inputs,
              app::Progress& progress);

} // namespace renderer
