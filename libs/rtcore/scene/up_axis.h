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

/// The sides of a model with that axis up: what a viewer of the usual models with +Y up calls its front is
/// +Z, and others follow by turning the model. Unit vectors.
inline Vec3 rightOf(Vec3 up) { return up.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}; }
inline Vec3 frontOf(Vec3 up) { return cross(rightOf(up), up); }

/// "mm", "cm", "m", "in", "ft": in metres.
std::optional<double> unitNamed(std::string_view name);

} // namespace rtcore
