/// A recorded way as a flight of few key frames.
#pragma once

#include "rtcore/scene/flight.h"

#include <optional>
#include <span>

namespace rtcore {

/// A view of a recording.
struct TimedView {
    Camera camera;
    double time = 0;                    ///< seconds
    std::optional<float> exposure = {}; ///< as in FlightKey
};

/// Key frames of a FlightTiming::Times flight, whose FlightCourse comes through each view within `distance`
/// scene units, and looks within `degrees` of where that does: views where it is farthest off become key
/// frames, until none is. The first is at 0 seconds. Views that are not kMinFlightSeconds later than the last
/// one are left out. Views are at least one and of one kind, `distance` and `degrees` above 0. Throws
/// BadValue where more than kMaxFlightKeys are needed.
std::vector<FlightKey> thinned(std::span<const TimedView> views, double distance, double degrees, Vec3 up);

} // namespace rtcore
