/// Drawings to scale, as Renderer and RTServer make them.
#pragma once

#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/plans/plan.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene.h"
#include "rtcore/survey/model_units.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// How an image is filled: lines of the drawing, the light of what it shows, or lines over light.
enum class PlanImage : std::uint8_t { Lines, Light, Both };
inline constexpr std::array<std::string_view, 3> kPlanImages{"lines", "light", "both"};

struct PlanOrder {
    std::filesystem::path file; ///< of an extension that rtcore::drawingFormatOf() knows
    rtcore::PlanChoice choice = {};
    rtcore::PlanOptions options = {};
    double scale = 100; ///< 1 to that
    std::optional<rtcore::PaperSize> paper = {};
    double dpi = 300; ///< of an image, as what follows
    PlanImage image = PlanImage::Lines;
};

struct DrawnPlan {
    rtcore::Drawing drawing;
    rtcore::SectionPlane plane;
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

/// To be written: of what `plan` has. Both must outlive it.
rtcore::DrawingOrder drawingOrderOf(const PlanOrder& order, const DrawnPlan& plan);

/// Of several files, which they are; else nothing.
std::optional<rtcore::Sentence> sheetsTold(const std::vector<std::filesystem::path>& files);

} // namespace app
