/// Drawings to scale, as Renderer and RTServer make them.
#pragma once

#include "rtcore/io/drawings/sheet.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/plans/plan.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene.h"
#include "rtcore/survey/model_units.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct PlanOrder {
    std::filesystem::path file; ///< .svg, .pdf or .dxf
    rtcore::PlanChoice choice = {};
    rtcore::PlanOptions options = {};
    double scale = 100; ///< 1 to that
    std::optional<rtcore::PaperSize> paper = {};
};

struct DrawnPlan {
    rtcore::Drawing drawing;
    std::string title;
    std::vector<rtcore::Sentence> told; ///< what was found
};

/// Throws rtcore::Refusal, which names the remedy, where the unit of the model is but a guess: a drawing
/// would have no scale.
void refuseGuessedUnit(const rtcore::ModelUnits& units, const std::filesystem::path& model);

/// `surfaces`: of the scene's model without its hidden parts. Any thread. Throws rtcore::Refusal where the
/// order cannot be met, also where there is nothing to be drawn. Of no use once `cancel` is set.
DrawnPlan drawPlan(const PlanOrder& order, const rtcore::Scene& scene, const rtcore::RayTracer& surfaces,
                   const std::string& model, rtcore::Vec3 eye, const std::atomic<bool>& cancel);

} // namespace app
