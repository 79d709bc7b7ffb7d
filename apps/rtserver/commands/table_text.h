/// Fields of tables for other programs, as RFC 4180 has them.
#pragma once

#include "rtcore/scene/local_origin.h"

#include <string>
#include <string_view>

namespace rtserver {

/// A text of others as a field: in quotes where it needs them. One that a table program would take for a
/// formula has a ' before it.
std::string tableField(std::string_view text);

/// "0 0.5 -2": a point from the scene's zero in the coordinates of the model's file. What came of floats has
/// no more digits than these.
std::string pointText(const rtcore::Vec3d& point, const rtcore::LocalOrigin& origin);

} // namespace rtserver
