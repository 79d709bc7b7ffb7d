// Commands for the key frames of flights.
#include "rtserver/commands/flight_choice.h"

#include "rtcore/motion/flight_edits.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace rtserver {

namespace {

using rtcore::Flight;
using rtcore::FlightKey;
using rtcore::FlightTiming;

/// The flight that the first argument names, with the index of the key frame that another one numbers.
std::pair<Flight, std::size_t> chosenKey(const Call& call, std::size_t argument) {
    Flight flight = flightNamed(call, call[0]);
    const auto number = static_cast<std::size_t>(integer(call[argument]));
    if (number > flight.keys.size())
        throw rtcore::Refusal(
            rtcore::say("the flight has {0} key frames, and no number {1}", flight.keys.size(), number));
    return {std::move(flight), number - 1};
}

/// Where the time has its place among the others: before the first that is later. At an even speed all are 0.
std::size_t insert(Flight& flight, FlightKey key) {
    const auto later =
        std::ranges::find_if(flight.keys, [&](const auto& each) { return each.time > key.time; });
    const std::ptrdiff_t index = later - flight.keys.begin();
    flight.keys.insert(later, key); // later is none any more
    return static_cast<std::size_t>(index);
}

Result addKey(const Call& call) {
    constexpr double kUsualPause = 3;
    const rtcore::Flights& all = call.document().flights();
    const auto found = rtcore::findFlight(all, call[0]);
    const bool made = found == all.end(), timed = call.size() > 1;
    Flight flight =
        made ? Flight{.name = call[0], .timing = timed ? FlightTiming::Times : FlightTiming::Even} : *found;
    if (flight.turns != 0)
        throw rtcore::Refusal(
            "a turntable has one key frame; make a flight by times of it, or another flight");
    if (timed && flight.timing == FlightTiming::Even)
        throw rtcore::Refusal("the flight has an even speed; 'flight timing NAME times' gives it times");
    FlightKey key{.camera = shownCamera(call)};
    if (timed)
        key.time = preciseNumber(call[1]);
    else if (flight.timing == FlightTiming::Times)
        key.time = flight.keys.back().time + kUsualPause;
    const std::size_t index = insert(flight, key);
    putFlight(call.document(), call[0], std::move(flight));
    return {.answer = std::to_string(index + 1)};
}

Result setKey(const Call& call) {
    auto [flight, i] = chosenKey(call, 1);
    flight.keys[i].camera = shownCamera(call);
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result moveKey(const Call& call) {
    auto [flight, i] = chosenKey(call, 1);
    const auto to = std::min(static_cast<std::size_t>(integer(call[2])), flight.keys.size()) - 1;
    std::vector<double> times;
    for (const FlightKey& key : flight.keys) times.push_back(key.time);
    const FlightKey moved = flight.keys[i];
    flight.keys.erase(flight.keys.begin() + static_cast<std::ptrdiff_t>(i));
    flight.keys.insert(flight.keys.begin() + static_cast<std::ptrdiff_t>(to), moved);
    for (std::size_t k = 0; k < times.size(); ++k) flight.keys[k].time = times[k];
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result setTime(const Call& call) {
    auto [flight, i] = chosenKey(call, 1);
    if (flight.timing == FlightTiming::Even)
        throw rtcore::Refusal("the flight has an even speed; 'flight timing NAME times' gives it times");
    flight.keys[i].time = preciseNumber(call[2]);
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result setKeyExposure(const Call& call) {
    auto [flight, i] = chosenKey(call, 1);
    flight.keys[i].exposure = call[2] == "automatic" ? std::nullopt : std::optional(number(call[2]));
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

/// The times of those behind the first one stay distances from it.
Result removeKey(const Call& call) {
    auto [flight, i] = chosenKey(call, 1);
    flight.keys.erase(flight.keys.begin() + static_cast<std::ptrdiff_t>(i));
    if (flight.keys.empty()) {
        rtcore::Flights all = call.document().flights();
        std::erase_if(all, [&](const Flight& each) { return each.name == call[0]; });
        call.document().setFlights(std::move(all));
        return {};
    }
    const double first = flight.keys[0].time;
    for (FlightKey& key : flight.keys) key.time -= first;
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

constexpr std::array kFlightKeyFunctions{
    CommandFunction{app::CommandId::FlightKeyAdd, addKey},
    CommandFunction{app::CommandId::FlightKeySet, setKey},
    CommandFunction{app::CommandId::FlightKeyMove, moveKey},
    CommandFunction{app::CommandId::FlightKeyTime, setTime},
    CommandFunction{app::CommandId::FlightKeyExposure, setKeyExposure},
    CommandFunction{app::CommandId::FlightKeyRemove, removeKey},
};

} // namespace

std::span<const CommandFunction> flightKeyFunctions() { return kFlightKeyFunctions; }

} // namespace rtserver
