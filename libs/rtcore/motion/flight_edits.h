/// Edits of flights that need to know where their cameras are. Flights have no problemOf(); what is made of
/// them may have one.
#pragma once

#include "rtcore/scene/flight.h"

namespace rtcore {

/// The same with another timing. By times: key frames are at when the flight came through them, also the
/// first one again at the end of a closed flight; a turntable gets one every 30 degrees. Even: as long as
/// before. `up` as in WorldFrame.
Flight retimed(const Flight& flight, FlightTiming timing, Vec3 up);

/// So many seconds from beginning to end; times of key frames are stretched.
Flight lasting(const Flight& flight, double seconds);

/// What is between two times, from 0 to its seconds, `from` before `to`: the views at both become key frames,
/// those between stay. Of a closed flight or a turntable it is an open one.
Flight trimmed(const Flight& flight, double from, double to, Vec3 up);

/// Whole seconds of it: `seconds`, or the time of the last key frame.
double secondsOf(const Flight& flight);

} // namespace rtcore
