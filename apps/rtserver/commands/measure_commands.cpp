// Commands that measure light.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/light_grid.h"
#include "rtserver/document/light_measuring.h"
#include "rtserver/document/measuring.h"

#include "common/cli/command_line.h"
#include "common/commands/pack_words.h"
#include "common/process/threads.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/camera_rays.h"

#include <array>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace rtserver {

namespace {

using rtcore::Vec3;
using rtcore::WhitePoint;

constexpr const char *kLux = "lx", *kCandela = "cd/m2";

/// Returns the answer.
using Measure = std::function<std::string(const MeasuredScene&, Measuring&)>;

Result measureApart(const Call& call, Measure measure) {
    Workspace& state = call.state;
    if (state.measuring)
        throw rtcore::FileError(
            rtcore::FailureKind::TryAgain, "",
            "light is being measured already; wait for it, or give it up by 'measure stop'");
    const auto measuring = std::make_shared<Measuring>();
    measuring->control.threads = threadsBeside(state.threads);
    state.measuring = measuring;
    return {.when = ReplyWhen::Apart,
            .work = [measure = std::move(measure), scene = measuredScene(call.document()), measuring,
                     &state]() -> Finish {
                std::exception_ptr failure;
                std::string answer;
                try {
                    app::useThreads(measuring->control.threads);
                    answer = measure(scene, *measuring);
                } catch (...) {
                    failure = std::current_exception();
                }
                return [answer, failure, &state] {
                    state.measuring.reset();
                    if (failure) std::rethrow_exception(failure);
                    return answer;
                };
            },
            .stop = {measuring, &measuring->control.cancel}};
}

void addLine(std::string& text, const std::string& line) {
    if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
}

/// With a line of its parts where there are some.
void addMeasured(const char* what, const rtcore::MeasuredLight& light, const char* unit,
                 const Photometer& photometer, std::string& text) {
    addLine(text, std::string(what) + ' ' + measuredText(light, unit));
    const std::string parts = photometer.partsText(light, unit);
    if (!parts.empty()) addLine(text, std::string(what) + ' ' + parts);
}

void addIlluminance(const WhitePoint& point, const rtcore::ProbeEffort& effort, Measuring& measuring,
                    Photometer& photometer, std::string& text) {
    const auto light = photometer.illuminance({&point, 1}, effort, measuring.control);
    addMeasured("illuminance", light.at(0), kLux, photometer, text);
}

Result measureSeen(const Call& call) {
    const rtcore::RenderSettings& settings = call.document().settings();
    const rtcore::CameraRays view(call.document().camera(), settings.width, settings.height);
    const rtcore::Ray ray = view.at(number(call[0]) * static_cast<float>(settings.width),
                                    number(call[1]) * static_cast<float>(settings.height));
    const auto side = sideSeen(*call.document().scene(), *call.document().tracer(), ray);
    const std::string at = side ? "at " + positionText(call, side->position) : "";
    rtcore::ProbeEffort effort;
    if (call.size() > 2) effort = {.relativeError = 0, .paths = static_cast<std::uint32_t>(integer(call[2]))};
    return measureApart(call, [ray, side, at, effort](const MeasuredScene& scene, Measuring& measuring) {
        Photometer photometer(scene);
        std::string text;
        if (side) addIlluminance(*side, effort, measuring, photometer, text);
        addMeasured("luminance", photometer.luminance(ray, effort, measuring.control), kCandela, photometer,
                    text);
        addLine(text, at);
        addLine(text, photometer.unitText());
        return text;
    });
}

/// Off a surface that the point was taken from.
WhitePoint pointAt(const Call& call) {
    constexpr float kLift = 1e-5F; // of the model's diagonal
    const Vec3 given = call.size() > 3 ? vectorAt(call, 3) : call.document().scene()->up;
    const Vec3 normal = normalize(given);
    if (!(length(normal) > 0)) throw app::UsageError(rtcore::say("the normal is not zero"));
    const float lift = kLift * call.document().world().loaded.tree.bounds.diagonal();
    return {positionAt(call, 0) + normal * lift, normal};
}

Result measureAt(const Call& call) {
    return measureApart(call, [point = pointAt(call)](const MeasuredScene& scene, Measuring& measuring) {
        Photometer photometer(scene);
        std::string text;
        addIlluminance(point, {}, measuring, photometer, text);
        addLine(text, photometer.unitText());
        return text;
    });
}

void refuseGuessedUnit(const rtcore::ModelUnits& units) {
    if (units.unitSaid != rtcore::Said::Guessed) return;
    throw rtcore::Refusal(
        "HEIGHT and SPACING are metres, but the unit of the model is a guess; say it first, as by 'units m'");
}

void writeTable(const std::filesystem::path& path, const std::string& table) {
    const std::array<std::span<const std::byte>, 1> pieces{std::as_bytes(std::span(table))};
    rtcore::writeFileAtomically(path, pieces);
}

Result measureGridFile(const Call& call) {
    refuseGuessedUnit(call.document().modelUnits());
    GridRequest request{.eye = call.document().camera().eye};
    if (call.size() > 1) request.height = static_cast<double>(number(call[1]));
    if (call.size() > 2) request.spacing = static_cast<double>(number(call[2]));
    return measureApart(call, [request, path = pathOf(call[0]), inputs = call.document().world().inputs](
                                  const MeasuredScene& scene, Measuring& measuring) {
        refuseInput(inputs, path, "");
        const std::vector<WhitePoint> points = gridPoints(scene, request);
        Photometer photometer(scene);
        const auto light = measureGrid(photometer, points, measuring);
        writeTable(path, gridTable(points, light, *scene.scene));
        std::string text = gridText(light);
        addLine(text, photometer.unitText());
        return text;
    });
}

Result measureProgress(const Call& call) {
    const std::shared_ptr<Measuring>& measuring = call.state.measuring;
    return {.answer =
                app::packProgressText(measuring ? std::optional(measuring->fraction.load()) : std::nullopt)};
}

Result stopMeasuring(const Call& call) {
    if (call.state.measuring) call.state.measuring->control.cancel = true;
    return {};
}

constexpr std::array kMeasureFunctions{
    CommandFunction{app::CommandId::MeasureLight, measureSeen},
    CommandFunction{app::CommandId::MeasureLightAt, measureAt},
    CommandFunction{app::CommandId::MeasureLightGrid, measureGridFile},
    CommandFunction{app::CommandId::MeasureProgress, measureProgress},
    CommandFunction{app::CommandId::MeasureStop, stopMeasuring},
};

} // namespace

std::span<const CommandFunction> measureFunctions() { return kMeasureFunctions; }

} // namespace rtserver
