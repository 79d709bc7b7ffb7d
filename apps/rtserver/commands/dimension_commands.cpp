// Commands that measure lengths, angles, areas and volumes.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/measured_points.h"

#include "rtcore/measures/extents.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_plane.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace rtserver {

namespace {

const rtcore::Scene& sceneOf(const Call& call) { return *call.document().scene(); }

std::string line(const char* what, double value, const char* unit) {
    return fmt::format("{} {:.6g} {}\n", what, value, unit);
}

/// Without the last line's end, and with a word on a unit that is guessed.
Result told(const Call& call, std::string text) {
    text += guessLine(call);
    text.pop_back();
    return {.answer = text};
}

std::string pointLine(const Call& call, const rtcore::Snap& snap) {
    return fmt::format("{} {}\n", rtcore::kSnapKinds.at(static_cast<std::size_t>(snap.kind)),
                       positionText(call, snap.point));
}

std::string distanceLines(const Call& call, rtcore::Vec3d from, rtcore::Vec3d to) {
    const double unit = metresPerUnitOf(call);
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
    return told(call, distanceLines(call, filePointAt(call, 0), filePointAt(call, 3)));
}

Result measureAngle(const Call& call) {
    const rtcore::Vec3d apex = filePointAt(call, 3), a = filePointAt(call, 0) - apex,
                        b = filePointAt(call, 6) - apex;
    if (!(length(a) > 0 && length(b) > 0))
        throw rtcore::Refusal("an angle needs two points beside the one that it is at");
    const double angle = std::atan2(length(cross(a, b)), dot(a, b));
    return {.answer = fmt::format("angle {:.6g} degrees", angle * 180 / std::numbers::pi)};
}

Result measureFace(const Call& call) {
    const rtcore::Snap snap = snapOf(call, 0);
    const rtcore::Scene& scene = sceneOf(call);
    const double unit = metresPerUnitOf(call);
    std::string text = line("area", rtcore::areaOfFace(scene, snap.triangle) * unit * unit, "m2");
    const rtcore::RayTracer& shown = *call.document().tracer();
    if (const auto clearance = rtcore::clearanceFrom(shown, snap.point, snap.normal))
        text += line("clearance", *clearance * unit, "m");
    if (const auto above = rtcore::clearanceFrom(shown, snap.point, -scene.up))
        text += line("above", *above * unit, "m");
    return told(call, text);
}

Result measureVolume(const Call& call) {
    const double volume = volumeNamed(call, call.arguments);
    return told(call, line("volume", volume * std::pow(metresPerUnitOf(call), 3), "m3"));
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
