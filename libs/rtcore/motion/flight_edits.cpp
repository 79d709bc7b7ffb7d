#include "rtcore/motion/flight_edits.h"

#include "rtcore/motion/flight_course.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

FlightKey keyAt(const FlightCourse& course, double time) {
    const FlightView view = course.at(time);
    return {.camera = view.camera, .time = time, .exposure = view.exposure};
}

/// A turntable's every 30 degrees, others' own with those that a closed flight passes again.
std::vector<FlightKey> timedKeys(const Flight& flight, Vec3 up) {
    const FlightCourse course(flight, up);
    std::vector<FlightKey> keys;
    if (flight.turns != 0) {
        constexpr double kInATurn = 12;
        const double steps = std::ceil(std::fabs(flight.turns) * kInATurn);
        for (double i = 0; i <= steps; ++i) keys.push_back(keyAt(course, course.seconds() * i / steps));
        return keys;
    }
    for (std::size_t i = 0; i < flight.keys.size(); ++i) {
        keys.push_back(flight.keys[i]);
        keys.back().time = course.timeOf(i);
    }
    if (flight.closed && keys.size() > 1) {
        keys.push_back(keys.front());
        keys.back().time = course.seconds();
    }
    // Views that are the same are passed at once.
    const auto passed = std::unique(keys.begin(), keys.end(), [](const FlightKey& a, const FlightKey& b) {
        return b.time < a.time + kMinFlightSeconds;
    });
    keys.erase(passed, keys.end());
    return keys;
}

Flight opened(const Flight& flight) {
    Flight result = flight;
    result.closed = false;
    if (flight.turns != 0) result.target.reset(); // it was the axis, not what is looked at
    result.turns = 0;
    return result;
}

} // namespace

double secondsOf(const Flight& flight) {
    return flight.timing == FlightTiming::Even ? flight.seconds : flight.keys.back().time;
}

Flight retimed(const Flight& flight, FlightTiming timing, Vec3 up) {
    if (flight.timing == timing) return flight;
    Flight result = flight;
    if (timing == FlightTiming::Times) {
        result = opened(flight);
        result.keys = timedKeys(flight, up);
        result.seconds = Flight().seconds; // it is that of the last key frame
    } else {
        result.seconds = secondsOf(flight) > 0 ? secondsOf(flight) : Flight().seconds;
        for (FlightKey& key : result.keys) key.time = 0;
    }
    result.timing = timing;
    return result;
}

Flight lasting(const Flight& flight, double seconds) {
    Flight result = flight;
    if (flight.timing == FlightTiming::Even) {
        result.seconds = seconds;
        return result;
    }
    const double whole = secondsOf(flight);
    if (!(whole > 0)) return result;
    for (FlightKey& key : result.keys) key.time *= seconds / whole;
    result.keys.back().time = seconds;
    return result;
}

Flight trimmed(const Flight& flight, double from, double to, Vec3 up) {
    const FlightCourse course(flight, up);
    Flight result = opened(flight);
    result.keys = {keyAt(course, from)};
    for (FlightKey& key : timedKeys(flight, up)) {
        if (key.time >= from + kMinFlightSeconds && key.time <= to - kMinFlightSeconds)
            result.keys.push_back(key);
    }
    result.keys.push_back(keyAt(course, to));
    for (FlightKey& key : result.keys) key.time = flight.timing == FlightTiming::Times ? key.time - from : 0;
    if (flight.timing == FlightTiming::Even) result.seconds = to - from;
    return result;
}

} // namespace rtcore
