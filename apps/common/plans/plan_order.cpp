#include "common/plans/plan_order.h"

#include "rtcore/sections/closed_pieces.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace app {

namespace {

constexpr double kStepOnPaper = 0.0002; // metres

std::string metres(double length) { return fmt::format("{:.2f} m", length); }

std::string titleOf(const PlanOrder& order, const rtcore::ChosenPlan& chosen, const std::string& model) {
    std::string title = rtcore::printable(model) + "   ";
    if (chosen.storey > 0 && chosen.storeys > 1) title += fmt::format("storey {}   ", chosen.storey);
    if (chosen.floor)
        return title + fmt::format("floor {:+.2f} m, cut {:+.2f} m   ", *chosen.floor,
                                   *chosen.floor + order.choice.height);
    return title + fmt::format("{}   ", rtcore::kPlanSides.at(static_cast<std::size_t>(order.choice.side)));
}

/// Something is above it: who is in a house is on one of its storeys, who flies above it on none.
bool isCovered(const rtcore::RayTracer& surfaces, rtcore::Vec3 eye, rtcore::Vec3 up) {
    rtcore::RayWave ray;
    ray.push({eye, 0, up, std::numeric_limits<float>::max()});
    std::vector<std::uint8_t> covered;
    surfaces.occluded(rtcore::RayKind::Occlusion, ray, covered);
    return covered[0] != 0;
}

std::vector<rtcore::Sentence> findings(const PlanOrder& order, const rtcore::ChosenPlan& chosen,
                                       const rtcore::Drawing& drawing) {
    std::vector<rtcore::Sentence> told;
    if (chosen.storey > 0)
        told.push_back(rtcore::say("storey {0} of {1}: its floor is at {2}, the cut at {3}", chosen.storey,
                                   chosen.storeys, metres(*chosen.floor),
                                   metres(*chosen.floor + order.choice.height)));
    double area = 0;
    for (const rtcore::RoomArea& room : drawing.rooms) area += room.area;
    if (!drawing.rooms.empty())
        told.push_back(
            rtcore::say("rooms: {0}, {1} m2 together", drawing.rooms.size(), fmt::format("{:.2f}", area)));
    if (!drawing.loops.empty() || !drawing.chains.empty())
        told.emplace_back(rtcore::form("some parts that are cut are open: they have lines and no area"));
    return told;
}

} // namespace

void refuseGuessedUnit(const rtcore::ModelUnits& units, const std::filesystem::path& model) {
    if (units.unitSaid == rtcore::Said::Guessed)
        throw rtcore::Refusal(
            rtcore::say("the unit of {0} is not known, so a drawing would have no scale; say it: "
                        "--units or the command 'units' with m, cm, mm, in or ft (a guess is {1} m)",
                        model.filename().string(), fmt::format("{:g}", units.metresPerUnit)));
}

DrawnPlan drawPlan(const PlanOrder& order, const rtcore::Scene& scene, const rtcore::RayTracer& surfaces,
                   const std::string& model, rtcore::Vec3 eye, const std::atomic<bool>& cancel) {
    const rtcore::ChosenPlan chosen =
        rtcore::choosePlan(order.choice, scene, surfaces.bounds(),
                           isCovered(surfaces, eye, scene.up) ? std::optional(eye) : std::nullopt);
    rtcore::ClosedPieces pieces(scene.model);
    rtcore::PlanOptions options = order.options;
    options.step = kStepOnPaper * order.scale;
    DrawnPlan plan{.drawing = rtcore::drawingOf(scene, surfaces, pieces, chosen.plane, options, cancel),
                   .plane = chosen.plane,
                   .title = titleOf(order, chosen, model),
                   .told = {}};
    if (plan.drawing.empty() && !cancel.load())
        throw rtcore::Refusal(
            rtcore::form("nothing is cut there, and nothing is beyond: there is nothing to draw"));
    plan.told = findings(order, chosen, plan.drawing);
    return plan;
}

rtcore::DrawingOrder drawingOrderOf(const PlanOrder& order, const DrawnPlan& plan) {
    return {.drawing = plan.drawing,
            .options = {.scale = order.scale, .title = plan.title, .dpi = order.dpi},
            .paper = order.paper};
}

std::optional<rtcore::Sentence> sheetsTold(const std::vector<std::filesystem::path>& files) {
    if (files.size() < 2) return std::nullopt;
    return rtcore::say("{0} sheets: {1} to {2}", files.size(), files.front().filename().string(),
                       files.back().filename().string());
}

} // namespace app
