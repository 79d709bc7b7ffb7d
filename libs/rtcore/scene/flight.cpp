#include "rtcore/scene/flight.h"

#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

bool isNearZero(Vec3d p) {
    constexpr double kFarthest = 1e12;
    return std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest && std::fabs(p.z) <= kFarthest;
}

bool isDuration(double seconds) { return seconds >= kMinFlightSeconds && seconds <= kMaxFlightSeconds; }

bool isSound(const FlightKey& key) {
    const Camera& c = key.camera;
    const bool angles = std::isfinite(c.horizontalFov) && std::isfinite(c.orthographicWidth);
    return angles && isFinite(c.eye) && isFinite(c.forward) && isFinite(c.up);
}

std::optional<FlightProblem> problemOfName(const std::string& name) {
    if (name.empty()) return FlightProblem{"name", say("name is empty; a flight is known by its name")};
    if (name.size() > kMaxFlightName || printable(name) != name)
        return FlightProblem{"name",
                             say("the name of a flight is UTF-8 of at most {0} bytes, without control "
                                 "characters",
                                 kMaxFlightName)};
    return std::nullopt;
}

std::optional<FlightProblem> problemOfKeys(const Flight& flight) {
    const std::vector<FlightKey>& keys = flight.keys;
    if (keys.empty()) return FlightProblem{"key", say("the flight has no key frame")};
    if (keys.size() > kMaxFlightKeys)
        return FlightProblem{"key", say("a flight has at most {0} key frames", kMaxFlightKeys)};
    if (std::ranges::any_of(keys,
                            [&](const FlightKey& key) { return key.camera.kind != keys[0].camera.kind; }))
        return FlightProblem{"key", say("perspective and orthographic views cannot be in one flight")};
    if (!std::ranges::all_of(keys, isSound))
        return FlightProblem{"key", say("a camera of the flight is not finite")};
    if (std::ranges::any_of(keys, [](const FlightKey& key) {
            return key.exposure && !(*key.exposure > 0 && std::isfinite(*key.exposure));
        }))
        return FlightProblem{"exposure", say("the exposure of a key frame is above 0 and finite")};
    return std::nullopt;
}

std::optional<FlightProblem> problemOfTimes(const Flight& flight) {
    if (flight.timing == FlightTiming::Even) {
        if (!isDuration(flight.seconds))
            return FlightProblem{"seconds",
                                 say("a flight takes between 0 and {0} seconds", kMaxFlightSeconds)};
        if (std::ranges::all_of(flight.keys, [](const FlightKey& key) { return key.time == 0; }))
            return std::nullopt;
        return FlightProblem{"key",
                             say("a key frame of a flight at an even speed has no time; leave it out, or "
                                 "set timing = \"times\"")};
    }
    if (flight.closed)
        return FlightProblem{"closed", say("a flight by times ends at its last key; leave closed out")};
    if (flight.keys.front().time != 0)
        return FlightProblem{"time", say("the time of the first key frame is 0")};
    for (std::size_t i = 1; i < flight.keys.size(); ++i) {
        const double time = flight.keys[i].time;
        if (!isDuration(time - flight.keys[i - 1].time) || !isDuration(time))
            return FlightProblem{"time",
                                 say("the times of key frames rise, up to {0} seconds at most; that of "
                                     "number {1} does not",
                                     kMaxFlightSeconds, i + 1)};
    }
    return std::nullopt;
}

std::optional<FlightProblem> problemOfTarget(const Flight& flight) {
    if (flight.target && !isNearZero(*flight.target))
        return FlightProblem{"target",
                             say("the target has a coordinate beyond 1e12; give one near the model")};
    if (flight.turns == 0) return std::nullopt;
    if (!(std::fabs(flight.turns) <= kMaxTurns))
        return FlightProblem{"turns", say("a turntable turns at most {0} times, either way", kMaxTurns)};
    if (!flight.target)
        return FlightProblem{"turns", say("a turntable needs the target that it turns about")};
    if (flight.keys.size() > 1 || flight.timing == FlightTiming::Times)
        return FlightProblem{"turns", say("a turntable has one key frame and an even speed")};
    return std::nullopt;
}

} // namespace

std::optional<FlightProblem> problemOf(const Flight& flight) {
    if (auto problem = problemOfName(flight.name)) return problem;
    if (auto problem = problemOfKeys(flight)) return problem;
    if (auto problem = problemOfTimes(flight)) return problem;
    return problemOfTarget(flight);
}

std::size_t keysOf(const Flights& flights) {
    std::size_t keys = 0;
    for (const Flight& flight : flights) keys += flight.keys.size();
    return keys;
}

Flights::const_iterator findFlight(const Flights& flights, std::string_view name) {
    return std::ranges::find(flights, name, &Flight::name);
}

} // namespace rtcore
