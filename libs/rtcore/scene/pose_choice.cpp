#include "rtcore/scene/pose_choice.h"

#include "rtcore/settings/number_text.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace rtcore {

std::optional<PoseChoice> readPose(std::string_view text) {
    if (text == "rest") return PoseChoice{};
    if (text == "first") return PoseChoice{PoseChoice::Kind::First, {}, 0};
    const std::size_t at = text.rfind('@');
    if (at == std::string_view::npos || at == 0) return std::nullopt;
    PoseChoice pose{PoseChoice::Kind::Moment, std::string(text.substr(0, at)), 0};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + at + 1, last, pose.seconds);
    if (error != std::errc() || end != last || !std::isfinite(pose.seconds)) return std::nullopt;
    return pose;
}

std::string poseText(const PoseChoice& pose) {
    if (pose.kind == PoseChoice::Kind::Rest) return "rest";
    if (pose.kind == PoseChoice::Kind::First) return "first";
    return pose.animation + "@" + shortestText(pose.seconds);
}

} // namespace rtcore
