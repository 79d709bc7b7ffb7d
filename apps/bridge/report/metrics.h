/// What /metrics tells, in the text format of Prometheus.
#pragma once

#include "bridge/control/room.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace bridge {

std::string metricsText(std::span<const Room* const> rooms,
                        const std::map<std::string, std::uint64_t>& refused);

} // namespace bridge
