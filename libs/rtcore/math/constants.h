/// Numbers that many formulas need.
#pragma once

namespace rtcore {

inline constexpr float kPi = 3.14159265358979F;

} // namespace rtcore
