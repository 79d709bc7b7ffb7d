/// The part of /status about one instance.
#pragma once

#include "bridge/room/room_figures.h"

#include <nlohmann/json_fwd.hpp>

namespace bridge {

nlohmann::json statusOf(const RoomFigures& room);

} // namespace bridge
