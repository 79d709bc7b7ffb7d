// Commands for flights: cameras along a path by key frames.
#include "rtserver/commands/flight_choice.h"

#include "ipc/layout/limits.h"

#include "common/cli/command_line.h"
#include "common/flights/flight_recording.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/motion/flight_edits.h"
#include "rtcore/motion/flight_thinning.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

using rtcore::Flight;
using rtcore::Flights;
using rtcore::FlightTiming;

rtcore::Vec3 upOf(const Call& call) { return call.document().scene()->up; }

rtcore::FlightCourse courseOf(const Call& call, const Flight& flight) { return {flight, upOf(call)}; }

// --- Tell ---

std::string lineOf(const Flight& flight) {
    const std::string keys = flight.turns != 0 ? "turntable" : std::to_string(flight.keys.size());
    return fmt::format("{} {} {}\n", secondsOf(flight), keys, flight.name);
}

Result listFlights(const Call& call) {
    std::string text;
    for (const Flight& flight : call.document().flights()) {
        const std::string line = lineOf(flight);
        if (text.size() + line.size() > ipc::kMaxAnswerText) break;
        text += line;
    }
    if (!text.empty()) text.pop_back();
    return {.answer = text};
}

Result tellFlight(const Call& call) {
    std::string text = rtcore::formatFlight(flightNamed(call, call[0]), call.document().scene()->origin);
    if (text.size() > ipc::kMaxAnswerText)
        throw rtcore::Refusal(rtcore::say("the flight is too long for an answer; 'export scene' writes it"));
    return {.answer = std::move(text)};
}

// --- Make ---

Result makeThrough(const Call& call) {
    Flight flight{.name = call[0], .seconds = preciseNumber(call[1])};
    const rtcore::SceneBookmarks& all = call.document().bookmarks();
    for (std::size_t i = 2; i < call.size(); ++i) {
        const auto found = rtcore::findBookmark(all, call[i]);
        if (found == all.end())
            throw rtcore::BadValue(rtcore::say("the scene has no bookmark {0}", rtcore::inQuotes(call[i])));
        flight.keys.push_back({.camera = found->camera});
    }
    if (call.size() == 2) {
        for (const rtcore::SceneBookmark& bookmark : all) flight.keys.push_back({.camera = bookmark.camera});
        if (all.empty())
            throw rtcore::Refusal("the scene has no bookmarks; 'bookmark add' keeps the view as one");
    }
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result makeTurntable(const Call& call) {
    const double turns = call.size() > 2 ? preciseNumber(call[2]) : 1;
    if (turns == 0) throw rtcore::BadValue("a turntable turns; give a number other than 0");
    Flight flight{.name = call[0], .seconds = preciseNumber(call[1])};
    flight.target = rtcore::exact(call.walk().pivot());
    flight.turns = turns;
    flight.keys.push_back({.camera = shownCamera(call)});
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

/// Those without a time, or with one that does not rise, are a 30th of a second behind the one before, and
/// what follows goes on from there.
std::vector<rtcore::TimedView> viewsOf(const std::filesystem::path& list, const rtcore::LocalOrigin& zero) {
    constexpr double kInterval = 1.0 / 30;
    std::vector<rtcore::TimedView> views;
    double later = 0;
    for (const std::filesystem::path& path : rtcore::readCameraList(list)) {
        const rtcore::CameraFile file = rtcore::readCameraFile(path, zero);
        const double next = views.empty() ? 0 : views.back().time + kInterval;
        double time = file.time ? *file.time + later : next;
        if (!views.empty() && !(time > views.back().time)) {
            later += next - time;
            time = next;
        }
        views.push_back({file.camera, time, file.exposure});
    }
    if (!views.empty()) return views;
    throw rtcore::FileError(rtcore::FailureKind::BadData, list.string(), "the list names no camera");
}

Result makeOfList(const Call& call) {
    constexpr double kUsual = 0.05, kDegreesPerMetre = 20;
    const double within = call.size() > 2 ? preciseNumber(call[2]) : kUsual;
    if (!(within > 0)) throw rtcore::BadValue("WITHIN is above 0");
    const rtcore::Scene& scene = *call.document().scene();
    return {.when = ReplyWhen::Beside,
            .work = [&document = call.document(), world = call.document().history().firstState(),
                     list = pathOf(call[0]), name = call[1], zero = scene.origin, up = scene.up, within,
                     distance = within / double{scene.metresPerUnit}]() -> Finish {
                const auto views = viewsOf(list, zero);
                Flight flight{.name = name, .timing = FlightTiming::Times};
                flight.keys = rtcore::thinned(views, distance, within * kDegreesPerMetre, up);
                return [&document, world, flight = std::move(flight)] {
                    if (document.history().firstState() != world)
                        throw rtcore::Refusal("another scene is shown by now");
                    putFlight(document, flight.name, flight);
                    return std::to_string(flight.keys.size());
                };
            }};
}

Result copyFlight(const Call& call) {
    Flight flight = flightNamed(call, call[0]);
    flight.name = call[1];
    putFlight(call.document(), "", std::move(flight));
    return {};
}

Result renameFlight(const Call& call) {
    Flight flight = flightNamed(call, call[0]);
    flight.name = call[1];
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result removeFlight(const Call& call) {
    const std::string name = flightNamed(call, call[0]).name;
    Flights all = call.document().flights();
    std::erase_if(all, [&](const Flight& each) { return each.name == name; });
    call.document().setFlights(std::move(all));
    return {};
}

// --- Change ---

Result setSeconds(const Call& call) {
    putFlight(call.document(), call[0], lasting(flightNamed(call, call[0]), preciseNumber(call[1])));
    return {};
}

Result trim(const Call& call) {
    const Flight& flight = flightNamed(call, call[0]);
    const double from = preciseNumber(call[1]), to = std::min(preciseNumber(call[2]), secondsOf(flight));
    if (!(from < to))
        throw rtcore::BadValue(
            rtcore::say("the flight ends after {0} seconds; give two times before that, the "
                        "earlier one first",
                        fmt::format("{}", secondsOf(flight))));
    putFlight(call.document(), call[0], trimmed(flight, from, to, upOf(call)));
    return {};
}

Result setTiming(const Call& call) {
    const auto timing = call[1] == nameOf(FlightTiming::Even) ? FlightTiming::Even : FlightTiming::Times;
    putFlight(call.document(), call[0], retimed(flightNamed(call, call[0]), timing, upOf(call)));
    return {};
}

Result setClosed(const Call& call) {
    Flight flight = flightNamed(call, call[0]);
    flight.closed = flag(call[1]);
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

Result setTarget(const Call& call) {
    if (call.size() == 2 || call.size() == 3)
        throw app::UsageError("flight target takes three coordinates behind the name, or none");
    Flight flight = flightNamed(call, call[0]);
    flight.target.reset();
    if (call.size() > 1) flight.target = rtcore::exact(positionAt(call, 1));
    putFlight(call.document(), call[0], std::move(flight));
    return {};
}

// --- Show and write ---

Result goToTime(const Call& call) {
    call.document().setCamera(courseOf(call, flightNamed(call, call[0])).at(preciseNumber(call[1])).camera);
    return {};
}

Result playFlight(const Call& call) {
    const double from = call.size() > 1 ? preciseNumber(call[1]) : 0;
    call.walk().play(std::make_unique<Playback>(courseOf(call, flightNamed(call, call[0])), from));
    return {};
}

Result exportFlight(const Call& call) {
    constexpr double kUsualRate = 25;
    const double rate = call.size() > 2 ? preciseNumber(call[2]) : kUsualRate;
    app::FilmOfFlight film{courseOf(call, flightNamed(call, call[0])), rate};
    film.common.origin = call.document().scene()->origin;
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    return {.when = ReplyWhen::Apart,
            .work = [list = pathOf(call[1]), film, stop]() -> Finish {
                app::recordFlight(list, film, stop.get());
                return [frames = app::filmFrames(film.course, film.perSecond)] {
                    return fmt::format("{} frames", frames);
                };
            },
            .stop = stop};
}

constexpr std::array kFlightFunctions{
    CommandFunction{app::CommandId::FlightList, listFlights},
    CommandFunction{app::CommandId::FlightGet, tellFlight},
    CommandFunction{app::CommandId::FlightThrough, makeThrough},
    CommandFunction{app::CommandId::FlightTurntable, makeTurntable},
    CommandFunction{app::CommandId::FlightFrom, makeOfList},
    CommandFunction{app::CommandId::FlightCopy, copyFlight},
    CommandFunction{app::CommandId::FlightRename, renameFlight},
    CommandFunction{app::CommandId::FlightRemove, removeFlight},
    CommandFunction{app::CommandId::FlightSeconds, setSeconds},
    CommandFunction{app::CommandId::FlightTrim, trim},
    CommandFunction{app::CommandId::FlightTiming, setTiming},
    CommandFunction{app::CommandId::FlightClosed, setClosed},
    CommandFunction{app::CommandId::FlightTarget, setTarget},
    CommandFunction{app::CommandId::FlightGo, goToTime},
    CommandFunction{app::CommandId::FlightPlay, playFlight},
    CommandFunction{app::CommandId::FlightExport, exportFlight},
};

} // namespace

std::span<const CommandFunction> flightFunctions() { return kFlightFunctions; }

} // namespace rtserver
