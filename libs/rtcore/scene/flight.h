/// Flights: cameras along a path by key frames, kept with a scene. motion/flight_course.h says what lies
/// between the keys.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/camera.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Even: at one speed all the way, eased at both ends. Times: through each key when it says.
enum class FlightTiming : std::uint8_t { Even, Times };
inline constexpr std::array<std::string_view, 2> kFlightTimings{"even", "times"};
inline std::string_view nameOf(FlightTiming timing) {
    return kFlightTimings.at(static_cast<std::size_t>(timing));
}

inline constexpr std::size_t kMaxFlights = 100, kMaxFlightKeys = 1000;
inline constexpr std::size_t kMaxFlightName = 200;       ///< bytes
inline constexpr std::size_t kMaxKeysOfFlights = 20'000; ///< of all of a scene together
inline constexpr double kMinFlightSeconds = 0.001;       ///< of the whole, and between two key frames
inline constexpr int kMaxFlightSeconds = 24 * 3600;      ///< a day
inline constexpr int kMaxTurns = 1000;                   ///< of a turntable, either way

/// One key frame.
struct FlightKey {
    Camera camera;                      ///< nameOffset is 0
    double time = 0;                    ///< seconds from the beginning; FlightTiming::Times only
    std::optional<float> exposure = {}; ///< the fixed constant c (.cam); absent: that of its neighbours
    friend bool operator==(const FlightKey&, const FlightKey&) = default;
};

struct Flight {
    std::string name; ///< not ""; no other flight of the scene has it
    FlightTiming timing = FlightTiming::Even;
    double seconds = 10;              ///< of the whole; FlightTiming::Even only
    bool closed = false;              ///< goes on from the last key to the first; FlightTiming::Even only
    std::optional<Vec3d> target = {}; ///< looked at all the way; scene units, below 1e12 in size
    /// Unless 0, a turntable: its one key goes so many times around the upright axis through the target, to
    /// the right of its eye, and looks at that axis as it does in the beginning. It is Even.
    double turns = 0;
    std::vector<FlightKey> keys = {}; ///< kMaxFlightKeys at most
    friend bool operator==(const Flight&, const Flight&) = default;
};
using Flights = std::vector<Flight>; ///< kMaxFlights at most

/// A key of [[flight]], and why its value cannot be kept.
struct FlightProblem {
    std::string_view key;
    Sentence why;
};
/// An empty or long name, or one with control characters; no key, too many, cameras that are not finite,
/// exposures that are not above 0, times that do not rise from 0 on, or are those of an even flight,
/// seconds or turns that are out of range, perspective and orthographic keys together; a closed flight by
/// times; a turntable without a target, with several keys or by times; a target beyond 1e12.
std::optional<FlightProblem> problemOf(const Flight& flight);

/// Key frames of all of them.
std::size_t keysOf(const Flights& flights);

/// The end where none has that name.
Flights::const_iterator findFlight(const Flights& flights, std::string_view name);

} // namespace rtcore
