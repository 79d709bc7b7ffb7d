#include "common/cli/import_options.h"

#include "rtcore/scene/up_axis.h"

#include <charconv>
#include <cstdint>
#include <system_error>

namespace app {

namespace {
constexpr double kMinUnit = 1e-9, kLargestUnit = 1e9; ///< as of a .scn

rtcore::PoseChoice poseIn(const std::string& text) {
    if (const auto pose = rtcore::readPose(text)) return *pose;
    throw UsageError(
        rtcore::say("a pose is rest, first or the name or number of an animation, @ and seconds, not {0}",
                    "'" + text + "'"));
}
} // namespace

std::optional<double> readUnits(const std::string& text) {
    if (text == "auto") return std::nullopt;
    if (const auto unit = rtcore::unitNamed(text)) return unit;
    double metres = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), metres);
    const bool number = error == std::errc() && end == text.data() + text.size();
    if (number && metres >= kMinUnit && metres <= kLargestUnit) return metres;
    throw UsageError(
        rtcore::say("a unit is auto, mm, cm, m, in, ft or a number of metres, not {0}", "'" + text + "'"));
}

rtcore::ImportOptions readImportOptions(const Arguments& arguments) {
    rtcore::ImportOptions options;
    if (const auto angle = arguments.number("crease-angle")) options.creaseAngle = static_cast<float>(*angle);
    if (const auto off = arguments.number("deflection")) options.deflection = static_cast<float>(*off);
    if (const auto up = arguments.text("up")) options.up = rtcore::axisNamed(*up);
    if (const auto units = arguments.text("units")) options.metresPerUnit = readUnits(*units);
    if (arguments.has("flip-textures")) options.flipTextures = true;
    if (const auto pose = arguments.text("pose")) options.pose = poseIn(*pose);
    if (const auto limit = arguments.integer("memory-limit")) {
        options.memoryLimit = static_cast<std::uint64_t>(*limit) * 1'000'000;
    }
    if (const auto limit = arguments.number("time-limit")) options.timeLimit = *limit;
    return options;
}

} // namespace app
