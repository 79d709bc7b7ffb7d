#include "rtserver/document/light_measuring.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtserver {

namespace {

void refuseIfCancelled(const rtcore::RenderControl& control) {
    if (control.cancel)
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "the measurement was stopped");
}

/// Decimals that show two digits of the number.
int decimalsOf(double number) {
    constexpr int kMax = 9, kOfZero = 2;
    if (!(number > 0)) return kOfZero;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(number))), 0, kMax);
}

} // namespace

MeasuredScene measuredScene(const Document& document) {
    return {document.scene(), document.tracer(), document.frameSettings()};
}

Photometer::Photometer(const MeasuredScene& measured)
    : measured_(measured), light_(lightByUnit(*measured.scene)) {
    std::vector<rtcore::ProbedLight> parts;
    for (const auto* part : {&light_.sky, &light_.rest})
        if (*part) parts.push_back({&(*part)->scene, (*part)->luminanceOfOne});
    probe_.begin(parts, *measured.tracer, measured.settings);
}

std::vector<rtcore::MeasuredLight> Photometer::illuminance(std::span<const rtcore::WhitePoint> points,
                                                           const rtcore::ProbeEffort& effort,
                                                           rtcore::RenderControl& control) {
    std::vector<rtcore::MeasuredLight> measured;
    probe_.irradiance(points, effort, control, measured);
    refuseIfCancelled(control);
    return measured;
}

rtcore::MeasuredLight Photometer::luminance(const rtcore::Ray& ray, const rtcore::ProbeEffort& effort,
                                            rtcore::RenderControl& control) {
    std::vector<rtcore::MeasuredLight> measured;
    probe_.radiance({&ray, 1}, effort, control, measured);
    refuseIfCancelled(control);
    return measured.at(0);
}

std::string Photometer::partsText(const rtcore::MeasuredLight& light, const char* unit) const {
    if (!light_.sky || !light_.rest || light.parts.size() != 2) return {};
    const int decimals = decimalsOf(light.error);
    return fmt::format("{:.{}f} {} of the sky, {:.{}f} {} of other light", light.parts[0], decimals, unit,
                       light.parts[1], decimals, unit);
}

std::string Photometer::unitText() const {
    const rtcore::UnitlessLight light = unitlessLight(*measured_.scene, measured_.settings);
    if (light.what.empty()) return {};
    std::string names;
    for (const rtcore::Sentence& each : light.what) names += (names.empty() ? "" : ", ") + each.english();
    return light.all ? "the light of this scene has no absolute unit: " + names
                     : "of the light of this scene this has no absolute unit: " + names;
}

std::string measuredText(const rtcore::MeasuredLight& light, const char* unit) {
    const int decimals = decimalsOf(light.error);
    return fmt::format("{:.{}f} {}, standard error {:.{}f}", light.luminance, decimals, unit, light.error,
                       decimals);
}

} // namespace rtserver
