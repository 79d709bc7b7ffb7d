#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"

#include "rtcore/settings/plain_text.h"

namespace rtcore {

namespace {

constexpr Limits kTime{.minimum = 0, .maximum = kMaxFlightSeconds};
constexpr Limits kTurns{.minimum = -kMaxTurns, .maximum = kMaxTurns};

FlightKey readFlightKey(StrictTable& table, Vec3 up) {
    FlightKey key;
    key.time = table.preciseNumber("time", kTime).value_or(0);
    key.exposure = table.number("exposure", kPositive);
    key.camera = readCamera(table, up, true);
    return key;
}

Flight readFlight(StrictTable& table, Vec3 up) {
    Flight flight;
    const auto name = table.text("name");
    const auto timing = table.choice("timing", kFlightTimings);
    flight.timing = static_cast<FlightTiming>(timing.value_or(0));
    flight.seconds = table.preciseNumber("seconds", kTime).value_or(flight.seconds);
    flight.closed = table.boolean("closed").value_or(false);
    if (const auto target = table.precisePosition("target"))
        flight.target = Vec3d{(*target)[0], (*target)[1], (*target)[2]};
    flight.turns = table.preciseNumber("turns", kTurns).value_or(0);
    for (StrictTable& key : table.tables("key")) flight.keys.push_back(readFlightKey(key, up));
    table.finish();
    flight.name = table.require("name", name);
    if (const auto problem = problemOf(flight)) table.fail(problem->key, problem->why);
    return flight;
}

void writeFlightKey(TomlWriter& writer, const FlightKey& key, FlightTiming timing, const LocalOrigin& zero) {
    writer.section("[[flight.key]]");
    if (timing == FlightTiming::Times) writer.add("time", key.time);
    writer.add("exposure", key.exposure);
    writeCamera(writer, key.camera, zero);
}

} // namespace

Flights readFlights(StrictTable& root, Vec3 up) {
    Flights flights;
    for (StrictTable& table : root.tables("flight")) {
        root.needVersion(2, "flight");
        if (flights.size() == kMaxFlights)
            table.fail("name", say("there are more than {0} flights; leave some out", kMaxFlights));
        Flight flight = readFlight(table, up);
        if (findFlight(flights, flight.name) != flights.end())
            table.fail("name", say("another flight is called {0}, too", inQuotes(flight.name)));
        flights.push_back(std::move(flight));
        if (keysOf(flights) > kMaxKeysOfFlights)
            table.fail("name", say("the flights have more than {0} key frames together; leave some out",
                                   kMaxKeysOfFlights));
    }
    return flights;
}

void writeFlight(TomlWriter& writer, const Flight& flight, const LocalOrigin& zero) {
    writer.section("[[flight]]");
    writer.add("name", flight.name);
    writer.add("timing", nameOf(flight.timing));
    if (flight.timing == FlightTiming::Even) writer.add("seconds", flight.seconds);
    if (flight.closed) writer.add("closed", true);
    if (const auto& target = flight.target)
        writer.add("target",
                   FilePoint{target->x + zero.at[0], target->y + zero.at[1], target->z + zero.at[2]});
    if (flight.turns != 0) writer.add("turns", flight.turns);
    for (const FlightKey& key : flight.keys) writeFlightKey(writer, key, flight.timing, zero);
}

std::string formatFlight(const Flight& flight, const LocalOrigin& zero) {
    TomlWriter writer;
    writeFlight(writer, flight, zero);
    return writer.text();
}

} // namespace rtcore
