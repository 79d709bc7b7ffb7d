// Commands for storeys, and for drawings to scale.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/storey_outlines.h"

#include "common/plans/plan_order.h"
#include "common/process/threads.h"

#include "ipc/layout/limits.h"

#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/plans/file_metres.h"
#include "rtcore/plans/storeys.h"
#include "rtcore/survey/standing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace rtserver {

namespace {

template <typename Names>
std::size_t indexOf(const Names& names, std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

app::PlanOrder orderOf(const Call& call) {
    app::PlanOrder order{.file = pathOf(call[0])};
    if (!rtcore::drawingFormatOf(order.file))
        throw app::UsageError("a plan is a .svg, .pdf, .dxf, .png or .tif file");
    if (call.size() > 1)
        order.choice.side = static_cast<rtcore::PlanSide>(indexOf(rtcore::kPlanSides, call[1]));
    if (call.size() > 2) order.scale = preciseNumber(call[2]);
    if (call.size() > 3 && call[3] != "sheet")
        order.paper = *std::ranges::find(rtcore::kPaperSizes, call[3], &rtcore::PaperSize::name);
    if (call.size() > 4 && integer(call[4]) > 0) order.choice.storey = integer(call[4]);
    if (call.size() > 5) order.choice.height = preciseNumber(call[5]);
    if (call.size() > 6) order.dpi = preciseNumber(call[6]);
    return order;
}

std::string lines(const std::vector<rtcore::Sentence>& sentences) {
    std::string text;
    for (const rtcore::Sentence& sentence : sentences)
        text += (text.empty() ? "" : "\n") + sentence.english();
    return text;
}

Result plan(const Call& call) {
    const Document& document = call.document();
    const app::PlanOrder order = orderOf(call);
    const std::filesystem::path model = document.world().loaded.modelPath;
    app::refuseGuessedUnit(document.modelUnits(), model);
    refuseInput(document.world().inputs, order.file, "");
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    return {.when = ReplyWhen::Apart,
            .work = [order, model, inputs = document.world().inputs, scene = document.scene(),
                     surfaces = document.visible().surfaces(), eye = document.camera().eye,
                     threads = threadsBeside(call.state.threads), stop]() -> Finish {
                app::useThreads(threads);
                const app::DrawnPlan plan =
                    app::drawPlan(order, *scene, *surfaces, model.filename().string(), eye, *stop);
                if (stop->load()) throw rtcore::Refusal("the plan was given up");
                const rtcore::DrawingOrder written = app::drawingOrderOf(order, plan);
                const auto files = rtcore::drawingFiles(order.file, written);
                for (const std::filesystem::path& file : files) refuseInput(inputs, file, "");
                rtcore::writeDrawing(order.file, written);
                std::vector<rtcore::Sentence> told = plan.told;
                if (const auto sheets = app::sheetsTold(files)) told.push_back(*sheets);
                return [told = lines(told)] { return told; };
            },
            .stop = stop};
}

/// The same name, the same text.
std::string nameOf(const StoreyOutlines::Order& order) {
    if (order.storey)
        return fmt::format("outline {} {}", static_cast<const void*>(order.scene.get()), *order.storey);
    const rtcore::Vec3 eye = order.eye;
    return fmt::format("outline {} at {} {} {}", static_cast<const void*>(order.scene.get()), eye.x, eye.y,
                       eye.z);
}

// By one thread, for what is small: live frames keep the others. Of many who ask for a storey at once, such
// as pages that have just been opened, one takes a thread.
Result outline(const Call& call) {
    const Document& document = call.document();
    if (!call.state.outlines) call.state.outlines = std::make_shared<StoreyOutlines>();
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    const StoreyOutlines::Order order{.scene = document.scene(),
                                      .bounds = document.world().loaded.tree.bounds,
                                      .storey =
                                          call.size() > 0 ? std::optional(integer(call[0])) : std::nullopt,
                                      .eye = document.camera().eye,
                                      .maxBytes = ipc::kMaxAnswerText};
    return {.when = ReplyWhen::Apart,
            .work = [order, outlines = call.state.outlines, stop]() -> Finish {
                app::useThreads(1);
                return [told = outlines->text(order, *stop)] { return told; };
            },
            .stop = stop,
            .shared = nameOf(order)};
}

Result storeys(const Call& call) {
    const rtcore::Scene& scene = *call.document().scene();
    const double unit = rtcore::exactMetresPerUnit(scene);
    std::string text;
    std::size_t number = 0;
    for (const rtcore::Storey& storey : rtcore::storeysOf(scene))
        text += fmt::format("{}{} {:.3f} {:.2f}", text.empty() ? "" : "\n", ++number,
                            rtcore::heightInFile(scene, storey.height), storey.area * unit * unit);
    return {.answer = text};
}

Result storeyGo(const Call& call) {
    const rtcore::Scene& scene = *call.document().scene();
    const std::vector<rtcore::Storey> all = rtcore::storeysOf(scene);
    const auto number = static_cast<std::size_t>(integer(call[0]));
    if (number > all.size())
        throw rtcore::Refusal(rtcore::say("there is no storey {0}; {1} were found, of which 1 is the lowest",
                                          number, all.size()));
    rtcore::Camera camera = call.document().camera();
    const double height = all[number - 1].height + rtcore::kEyeHeight / scene.metresPerUnit;
    camera.eye = camera.eye + (static_cast<float>(height) - dot(camera.eye, scene.up)) * scene.up;
    call.document().setCamera(camera);
    return {};
}

constexpr std::array kPlanFunctions{
    CommandFunction{app::CommandId::Plan, plan},
    CommandFunction{app::CommandId::PlanOutline, outline},
    CommandFunction{app::CommandId::Storeys, storeys},
    CommandFunction{app::CommandId::StoreyGo, storeyGo},
};

} // namespace

std::span<const CommandFunction> planFunctions() { return kPlanFunctions; }

} // namespace rtserver
