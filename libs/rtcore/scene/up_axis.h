/// The six axes that can be up, and units, by name.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <optional>
#include <string_view>

namespace rtcore {

inline constexpr std::array<std::string_view, 6> kAxisNames{"+x", "-x", "+y", "-y", "+z", "-z"};
inline constexpr std::array<Vec3, 6> kAxes{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// "" for what is none of the six.
std::string_view axisName(Vec3 up);
std::optional<Vec3> axisNamed(std::string_view name);

/// "mm", "cm", "m", "in", "ft": in metres.
std::optional<double> unitNamed(std::string_view name);

} // namespace rtcore
