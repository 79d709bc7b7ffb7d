/// A number as text for files and messages: the fewest digits that a reader of the same type turns into the
/// same number, bit for bit, whatever the locale. Fixed or scientific, whichever is shorter: "70", "0.1",
/// "5e+05", "1e+30"; "inf" and "nan" where it is none.
#pragma once

#include <string>

namespace rtcore {

std::string shortestText(float value);
std::string shortestText(double value);

} // namespace rtcore
