/// The answer to /metrics, in the text format of Prometheus, version 0.0.4.
#pragma once

#include "bridge/room/room_figures.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace bridge {

/// `refused`: connections, by reason. `ioCpu`: processor seconds of the thread of the sockets.
std::string metricsText(std::span<const RoomFigures> rooms,
                        const std::map<std::string, std::uint64_t>& refused, double ioCpu);

} // namespace bridge
