/// Lines that lie on each other become one.
#pragma once

#include "rtcore/sections/section_caps.h"

#include <vector>

namespace rtcore {

/// What all lines together cover: those on one straight line, within `tolerance`, that overlap or touch are
/// one. Their ends stay as they were. In an order of their own.
std::vector<FlatLine> unionOfLines(const std::vector<FlatLine>& lines, double tolerance);

} // namespace rtcore
