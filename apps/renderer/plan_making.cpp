#include "renderer/plan_making.h"

#include "common/process/stop.h"

#include "rtcore/io/drawings/drawing_file.h"

#include <atomic>
#include <cmath>
#include <vector>

namespace renderer {

namespace {

constexpr double kInch = 0.0254;

app::DrawnPlan draw(const app::PlanOrder& order, const PictureMaker& maker, app::Progress& progress) {
    const rtcore::LoadedScene& loaded = maker.loaded();
    std::atomic<bool> cancel{false};
    const app::ProgressScope scope(progress, {.name = "drawing", .fraction = {}, .cancel = &cancel});
    app::DrawnPlan plan = app::drawPlan(order, loaded.scene, maker.surfaces(),
                                        loaded.modelPath.filename().string(), loaded.camera.eye, cancel);
    app::throwIfStopped();
    return plan;
}

/// Lines of an elevation, too, know no section. Where the scene does not say how light meets one, it falls
/// in from above: rooms below a roof would be dark beside what is outside.
rtcore::SectionPlanes sectionsOf(const app::PlanOrder& order, const app::DrawnPlan& plan,
                                 const rtcore::Scene& scene) {
    rtcore::SectionPlanes sections = scene.sections;
    if (sections.empty()) sections.light = rtcore::SectionLight::Cut;
    if (order.choice.side != rtcore::PlanSide::Section) sections.planes.clear();
    if (order.choice.side == rtcore::PlanSide::Above) sections.planes = {plan.plane};
    return sections;
}

/// Whole pixels from the upper left corner of the drawing on.
const rtcore::LdrImage& lightOf(const app::PlanOrder& order, const app::DrawnPlan& plan,
                                PictureMaker& maker) {
    const rtcore::Drawing& drawing = plan.drawing;
    const double pixel = kInch / order.dpi * order.scale; // metres
    const double wide = std::ceil((drawing.high[0] - drawing.low[0]) / pixel);
    const double high = std::ceil((drawing.high[1] - drawing.low[1]) / pixel);
    rtcore::refuseLargeImage(wide, high);
    const rtcore::FlatPoint low{drawing.low[0], drawing.high[1] - std::max(high, 1.0) * pixel};
    const rtcore::FlatPoint far{drawing.low[0] + std::max(wide, 1.0) * pixel, drawing.high[1]};
    const rtcore::Scene& scene = maker.loaded().scene;
    const rtcore::Camera camera = rtcore::planCamera(scene, maker.surfaces().bounds(), plan.plane, low, far);
    return maker.picture(camera, static_cast<int>(std::max(wide, 1.0)), static_cast<int>(std::max(high, 1.0)),
                         sectionsOf(order, plan, scene));
}

} // namespace

void makePlan(const app::PlanOrder& order, PictureMaker& maker, const app::InputFiles& inputs,
              app::Progress& progress) {
    const rtcore::LoadedScene& loaded = maker.loaded();
    app::refuseGuessedUnit(loaded.units, loaded.modelPath);
    const app::DrawnPlan plan = draw(order, maker, progress);
    for (const rtcore::Sentence& sentence : plan.told) progress.tell(sentence);
    rtcore::DrawingOrder written = app::drawingOrderOf(order, plan);
    const std::vector<std::filesystem::path> files = rtcore::drawingFiles(order.file, written);
    for (const std::filesystem::path& file : files) inputs.refuse(file);
    written.lines = order.image != app::PlanImage::Light;
    if (order.image != app::PlanImage::Lines) written.light = &lightOf(order, plan, maker);
    rtcore::writeDrawing(order.file, written);
    if (const auto told = app::sheetsTold(files)) progress.tell(*told);
}

} // namespace renderer
