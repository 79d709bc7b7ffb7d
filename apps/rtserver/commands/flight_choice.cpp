#include "rtserver/commands/flight_choice.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <utility>

namespace rtserver {

const rtcore::Flight& flightNamed(const Call& call, const std::string& name) {
    const rtcore::Flights& all = call.document().flights();
    const auto found = rtcore::findFlight(all, name);
    if (found != all.end()) return *found;
    throw rtcore::Refusal(
        rtcore::say("the scene has no flight {0}; 'flight list' lists them", rtcore::inQuotes(name)));
}

void putFlight(Document& document, const std::string& formerName, rtcore::Flight flight) {
    if (const auto problem = problemOf(flight)) throw rtcore::BadValue(problem->why);
    rtcore::Flights all = document.flights();
    const auto former = std::ranges::find(all, formerName, &rtcore::Flight::name);
    const auto other = std::ranges::find(all, flight.name, &rtcore::Flight::name);
    if (other != all.end() && other != former)
        throw rtcore::BadValue(rtcore::say("another flight is called {0}", rtcore::inQuotes(flight.name)));
    if (former != all.end()) {
        *former = std::move(flight);
    } else if (all.size() < rtcore::kMaxFlights) {
        all.push_back(std::move(flight));
    } else {
        throw rtcore::Refusal(
            rtcore::say("there are {0} flights already; remove one first", rtcore::kMaxFlights));
    }
    if (keysOf(all) > rtcore::kMaxKeysOfFlights)
        throw rtcore::Refusal(
            rtcore::say("the flights would have more than {0} key frames together; remove some",
                        rtcore::kMaxKeysOfFlights));
    document.setFlights(std::move(all));
}

rtcore::Camera shownCamera(const Call& call) {
    rtcore::Camera camera = call.document().camera();
    camera.nameOffset = 0;
    return camera;
}

} // namespace rtserver
