// Commands that measure lengths, angles, areas and volumes.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/model_objects.h"

#include "rtcore/measures/extents.h"
#include "rtcore/measures/snap.h"
#include "rtcore/plans/file_metres.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_plane.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace rtserver {

namespace {

constexpr float kReach = 8; // pixels

const rtcore::Scene& sceneOf(const Call& call) { return *call.document().scene(); }

double metres(const Call& call) { return rtcore::exactMetresPerUnit(sceneOf(call)); }

std::string line(const char* what, double value, const char* unit) {
    return fmt::format("{} {:.6g} {}\n", what, value, unit);
}

/// Without the last line's end, and with a word on a unit that is guessed.
Result told(const Call& call, std::string text) {
    if (call.document().modelUnits().unitSaid == rtcore::Said::Guessed)
        text += "the unit is a guess; 'units' says it\n";
    text.pop_back();
    return {.answer = text};
}

rtcore::Snap snapOf(const Call& call, std::size_t argument) {
    const rtcore::RenderSettings& settings = call.document().settings();
    const rtcore::CameraRays view(call.document().camera(), settings.width, settings.height);
    const auto snap =
        rtcore::snapAt(sceneOf(call), *call.document().tracer(), view,
                       number(call[argument]) * static_cast<float>(settings.width),
                       number(call[argument + 1]) * static_cast<float>(settings.height), kReach);
    if (!snap) throw rtcore::Refusal("there is nothing to measure");
    return *snap;
}

std::string pointLine(const Call& call, const rtcore::Snap& snap) {
    return fmt::format("{} {}\n", rtcore::kSnapKinds.at(static_cast<std::size_t>(snap.kind)),
                       positionText(call, snap.point));
}

/// In doubles, in which the file's coordinates are whole.
rtcore::Vec3d pointAt(const Call& call, std::size_t argument) {
    return {preciseNumber(call[argument]), preciseNumber(call[argument + 1]),
            preciseNumber(call[argument + 2])};
}

std::string distanceLines(const Call& call, rtcore::Vec3d from, rtcore::Vec3d to) {
    const double unit = metres(call);
    const rtcore::Vec3d way = (to - from) * unit, up = rtcore::exact(sceneOf(call).up);
    const double height = dot(way, up);
    return line("distance", length(way), "m") + line("level", length(way - up * height), "m") +
           line("height", height, "m");
}

Result measurePoint(const Call& call) {
    std::string text = pointLine(call, snapOf(call, 0));
    text.pop_back();
    return {.answer = text};
}

Result measureSeenPoints(const Call& call) {
    const rtcore::Snap from = snapOf(call, 0), to = snapOf(call, 2);
    return told(call, pointLine(call, from) + pointLine(call, to) +
                          distanceLines(call, rtcore::exact(from.point), rtcore::exact(to.point)));
}

Result measureDistance(const Call& call) {
    return told(call, distanceLines(call, pointAt(call, 0), pointAt(call, 3)));
}

Result measureAngle(const Call& call) {
    const rtcore::Vec3d apex = pointAt(call, 3), a = pointAt(call, 0) - apex, b = pointAt(call, 6) - apex;
    if (!(length(a) > 0 && length(b) > 0))
        throw rtcore::Refusal("an angle needs two points beside the one that it is at");
    const double angle = std::atan2(length(cross(a, b)), dot(a, b));
    return {.answer = fmt::format("angle {:.6g} degrees", angle * 180 / std::numbers::pi)};
}

Result measureFace(const Call& call) {
    const rtcore::Snap snap = snapOf(call, 0);
    const rtcore::Scene& scene = sceneOf(call);
    const double unit = metres(call);
    std::string text = line("area", rtcore::areaOfFace(scene, snap.triangle) * unit * unit, "m2");
    const rtcore::RayTracer& shown = *call.document().tracer();
    if (const auto clearance = rtcore::clearanceFrom(shown, snap.point, snap.normal))
        text += line("clearance", *clearance * unit, "m");
    if (const auto above = rtcore::clearanceFrom(shown, snap.point, -scene.up))
        text += line("above", *above * unit, "m");
    return told(call, text);
}

Result measureVolume(const Call& call) {
    const rtcore::Scene& scene = sceneOf(call);
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, call.arguments);
    rtcore::ClosedPieces pieces(scene.model);
    double volume = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen[i] == 0) continue;
        const auto own = rtcore::volumeOf(scene.model, parts[i].pieces, pieces);
        if (!own)
            throw rtcore::Refusal(
                rtcore::say("{0} is open: it has no volume", rtcore::inQuotes(parts[i].name)));
        volume += *own;
    }
    return told(call, line("volume", volume * std::pow(metres(call), 3), "m3"));
}

constexpr std::array kDimensionFunctions{
    CommandFunction{app::CommandId::MeasurePoint, measurePoint},
    CommandFunction{app::CommandId::MeasureSeen, measureSeenPoints},
    CommandFunction{app::CommandId::MeasureDistance, measureDistance},
    CommandFunction{app::CommandId::MeasureAngle, measureAngle},
    CommandFunction{app::CommandId::MeasureFace, measureFace},
    CommandFunction{app::CommandId::MeasureVolume, measureVolume},
};

} // namespace

std::span<const CommandFunction> dimensionFunctions() { return kDimensionFunctions; }

} // namespace rtserver
