/// Numbers that many formulas need.
#pragma once

#include <numbers>

namespace rtcore {

inline constexpr float kPi = std::numbers::pi_v<float>;

} // namespace rtcore
