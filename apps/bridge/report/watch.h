/// The lines that --watch prints.
#pragma once

#include "bridge/room/room_figures.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace bridge {

/// Remembers what it was told last, since rates are differences.
class Watch {
  public:
    /// A line for each instance, ended by a newline each: server, pages, driver, frames and bits per second
    /// that were sent, how many pages have which rung, processor time. `ioCpu` as in metricsText(), `now` in
    /// seconds. Rates of the first call are 0.
    std::string lines(std::span<const RoomFigures> rooms, double ioCpu, double now);

  private:
    struct Counters {
        std::uint64_t frames = 0, bytes = 0;
        double cpu = 0;
    };
    std::map<std::string, Counters> last_;
    double lastTime_ = 0;
};

} // namespace bridge
