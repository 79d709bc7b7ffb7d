#include "rtcore/scene/up_axis.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

std::string_view axisName(Vec3 up) {
    const auto found = std::find(kAxes.begin(), kAxes.end(), up);
    return found == kAxes.end() ? "" : kAxisNames.at(static_cast<std::size_t>(found - kAxes.begin()));
}

std::optional<Vec3> axisNamed(std::string_view name) {
    const auto found = std::find(kAxisNames.begin(), kAxisNames.end(), name);
    if (found == kAxisNames.end()) return std::nullopt;
    return kAxes.at(static_cast<std::size_t>(found - kAxisNames.begin()));
}

std::optional<double> unitNamed(std::string_view name) {
    if (name == "mm") return 0.001;
    if (name == "cm") return 0.01;
    if (name == "m") return 1;
    if (name == "in") return 0.0254;
    if (name == "ft") return 0.3048;
    return std::nullopt;
}

} // namespace rtcore
