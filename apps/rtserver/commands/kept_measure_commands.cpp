// Commands for the measures that are kept with the scene.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/hidden_points.h"
#include "rtserver/commands/measure_table.h"
#include "rtserver/commands/measured_points.h"
#include "rtserver/commands/model_objects.h"

#include "ipc/layout/limits.h"

#include "common/cli/command_line.h"

#include "rtcore/measures/extents.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

using rtcore::KeptMeasure;
using rtcore::KeptMeasures;
using rtcore::MeasureKind;
using rtcore::Vec3d;

MeasureStyle measureStyleOf(const Call& call) {
    return {call.document().measures(), metresPerUnitOf(call), call.document().scene()->origin};
}

/// From the scene's zero.
Vec3d keptPointAt(const Call& call, std::size_t argument) {
    const rtcore::FilePoint& zero = call.document().scene()->origin.at;
    return filePointAt(call, argument) - Vec3d{zero[0], zero[1], zero[2]};
}

Result keepMeasure(const Call& call, KeptMeasure measure) {
    if (const auto problem = problemOf(measure)) throw app::UsageError(*problem);
    KeptMeasures all = call.document().measures();
    if (all.all.size() == rtcore::kMaxMeasures)
        throw rtcore::Refusal(
            rtcore::say("there are {0} measures already; remove one first", rtcore::kMaxMeasures));
    all.all.push_back(std::move(measure));
    call.document().setMeasures(std::move(all));
    const MeasureStyle style = measureStyleOf(call);
    return {.answer = measureLine(style, style.measures.all.size() - 1)};
}

Result keepDistance(const Call& call) {
    return keepMeasure(call, {.points = {keptPointAt(call, 0), keptPointAt(call, 3)}});
}

Result keepChain(const Call& call) {
    if (call.size() % 3 != 0) throw app::UsageError(rtcore::say("each point of a chain has three numbers"));
    KeptMeasure chain{.kind = MeasureKind::Chain, .points = {}};
    for (std::size_t i = 0; i < call.size(); i += 3) chain.points.push_back(keptPointAt(call, i));
    return keepMeasure(call, std::move(chain));
}

Result keepAngle(const Call& call) {
    return keepMeasure(call, {.kind = MeasureKind::Angle,
                              .points = {keptPointAt(call, 0), keptPointAt(call, 3), keptPointAt(call, 6)}});
}

Result keepHeight(const Call& call) {
    const rtcore::Vec3 up = call.document().scene()->up, point = positionAt(call, 0);
    const auto height = rtcore::clearanceFrom(*call.document().tracer(), point, -up);
    if (!height) throw rtcore::Refusal("there is no floor below the point");
    const Vec3d exactPoint = keptPointAt(call, 0);
    return keepMeasure(call, {.kind = MeasureKind::Height,
                              .points = {exactPoint, exactPoint - rtcore::exact(up) * *height}});
}

Result keepSeen(const Call& call) {
    return keepMeasure(
        call, {.points = {rtcore::exact(snapOf(call, 0).point), rtcore::exact(snapOf(call, 2).point)}});
}

Result keepFace(const Call& call) {
    const rtcore::Snap snap = snapOf(call, 0);
    const double area = rtcore::areaOfFace(*call.document().scene(), snap.triangle);
    if (!(area > 0)) throw rtcore::Refusal("nothing of the model is seen there");
    return keepMeasure(call, {.kind = MeasureKind::Area,
                              .points = {rtcore::exact(snap.point)},
                              .normal = snap.normal,
                              .amount = area});
}

/// The middle of a part.
Vec3d middleOf(const rtcore::Model& model, const rtcore::NamedPart& part) {
    rtcore::Box3 bounds;
    for (const std::uint32_t piece : part.pieces) {
        const rtcore::ModelPart& own = model.parts[piece];
        for (std::uint32_t t = own.firstTriangle; t < own.firstTriangle + own.triangleCount; ++t)
            for (const std::uint32_t v : model.mesh.triangles[t].v)
                bounds.extend(model.mesh.vertices[v].position());
    }
    return rtcore::exact(bounds.centre());
}

Result keepVolume(const Call& call) {
    const rtcore::Model& model = call.document().scene()->model;
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, call.arguments);
    const auto first = static_cast<std::size_t>(std::ranges::find(chosen, 1) - chosen.begin());
    if (std::ranges::count(chosen, 1) > 1)
        throw app::UsageError(rtcore::say("several parts are called so; give the number of one"));
    return keepMeasure(call, {.kind = MeasureKind::Volume,
                              .points = {middleOf(model, parts[first])},
                              .amount = volumeNamed(call, call.arguments),
                              .part = static_cast<int>(first) + 1});
}

Result listMeasures(const Call& call) {
    const MeasureStyle style = measureStyleOf(call);
    std::string text;
    const std::string guess = style.measures.all.empty() ? "" : guessLine(call);
    for (auto i = static_cast<std::size_t>(call.size() > 0 ? integer(call[0]) - 1 : 0);
         i < style.measures.all.size(); ++i) {
        const std::string line = measureLine(style, i) + '\n';
        if (text.size() + line.size() + guess.size() > ipc::kMaxAnswerText) break;
        text += line;
    }
    text += guess;
    if (!text.empty()) text.pop_back();
    return {.answer = text};
}

/// A line of numbers for each measure that has hidden points.
Result hiddenMeasures(const Call& call) {
    const std::vector<KeptMeasure>& all = call.document().measures().all;
    std::vector<Vec3d> points;
    for (const KeptMeasure& each : all) points.insert(points.end(), each.points.begin(), each.points.end());
    const std::vector<bool> hidden = hiddenFromCamera(call.document(), points);
    std::string text;
    for (std::size_t i = 0, first = 0; i < all.size(); first += all[i++].points.size()) {
        if (all[i].kind == MeasureKind::Volume) continue;
        std::string line;
        for (std::size_t k = 0; k < all[i].points.size(); ++k)
            if (hidden[first + k]) line += fmt::format(" {}", k + 1);
        if (line.empty()) continue;
        line = fmt::format("{}{}{}", text.empty() ? "" : "\n", i + 1, line);
        if (text.size() + line.size() > ipc::kMaxAnswerText) break;
        text += line;
    }
    return {.answer = text};
}

/// All measures, and that which the first argument numbers.
std::pair<KeptMeasures, std::size_t> chosenMeasure(const Call& call) {
    KeptMeasures all = call.document().measures();
    const auto number = static_cast<std::size_t>(integer(call[0]));
    if (number > all.all.size())
        throw rtcore::Refusal(rtcore::say("there is no measure {0}; 'measure list' lists them", number));
    return {std::move(all), number - 1};
}

Result nameMeasure(const Call& call) {
    auto [all, i] = chosenMeasure(call);
    all.all[i].name = call[1];
    if (const auto problem = problemOf(all.all[i])) throw rtcore::BadValue(*problem);
    call.document().setMeasures(std::move(all));
    return {};
}

Result removeMeasure(const Call& call) {
    if (call[0] == "all") {
        KeptMeasures none = call.document().measures();
        none.all.clear();
        call.document().setMeasures(std::move(none));
        return {};
    }
    auto [all, i] = chosenMeasure(call);
    all.all.erase(all.all.begin() + static_cast<std::ptrdiff_t>(i));
    call.document().setMeasures(std::move(all));
    return {};
}

Result chooseUnit(const Call& call) {
    KeptMeasures all = call.document().measures();
    all.unit = rtcore::lengthUnitNamed(call[0]).value();
    if (call.size() > 1) all.decimals = integer(call[1]);
    call.document().setMeasures(std::move(all));
    return {};
}

Result exportMeasures(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), table = measureTable(measureStyleOf(call)),
                     inputs = call.document().world().inputs]() -> Finish {
                refuseInput(inputs, path, "");
                const std::array<std::span<const std::byte>, 1> pieces{std::as_bytes(std::span(table))};
                rtcore::writeFileAtomically(path, pieces);
                return [path] { return path.string(); };
            }};
}

constexpr std::array kKeptMeasureFunctions{
    CommandFunction{app::CommandId::MeasureList, listMeasures},
    CommandFunction{app::CommandId::MeasureHidden, hiddenMeasures},
    CommandFunction{app::CommandId::MeasureKeepDistance, keepDistance},
    CommandFunction{app::CommandId::MeasureKeepChain, keepChain},
    CommandFunction{app::CommandId::MeasureKeepAngle, keepAngle},
    CommandFunction{app::CommandId::MeasureKeepHeight, keepHeight},
    CommandFunction{app::CommandId::MeasureKeepSeen, keepSeen},
    CommandFunction{app::CommandId::MeasureKeepFace, keepFace},
    CommandFunction{app::CommandId::MeasureKeepVolume, keepVolume},
    CommandFunction{app::CommandId::MeasureName, nameMeasure},
    CommandFunction{app::CommandId::MeasureRemove, removeMeasure},
    CommandFunction{app::CommandId::MeasureUnit, chooseUnit},
    CommandFunction{app::CommandId::MeasureExport, exportMeasures},
};

} // namespace

std::span<const CommandFunction> keptMeasureFunctions() { return kKeptMeasureFunctions; }

} // namespace rtserver
