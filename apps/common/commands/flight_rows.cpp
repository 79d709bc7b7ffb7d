// Rows for flights: cameras along a path by key frames.
#include "common/commands/command_rows.h"

#include "rtcore/scene/flight.h"

namespace app {

using enum CommandEffect;

namespace {

const CommandArgument kSeconds = number("SECONDS", 0, rtcore::kMaxFlightSeconds);

std::vector<CommandSpec> flightMaking(const CommandArgument& name) {
    const CommandArgument seconds = number("SECONDS", 0.01, rtcore::kMaxFlightSeconds);
    return {
        {.id = CommandId::FlightThrough,
         .name = "flight through",
         .arguments = {name, seconds, manyOf(text("BOOKMARK", ArgumentType::Bookmark))},
         .effect = Keeps,
         .step = "flight",
         .help = "keep a flight through these bookmarks of the scene, or through all, at an even speed",
         .more =
             "One of that name is replaced. The eye goes along a smooth curve, and is eased at both ends; "
             "where two views differ in their direction alone, it stands while the camera turns"},
        {.id = CommandId::FlightTurntable,
         .name = "flight turntable",
         .arguments = {name, seconds, maybe(number("TURNS", -rtcore::kMaxTurns, rtcore::kMaxTurns))},
         .effect = Keeps,
         .step = "flight",
         .help = "keep a turntable: from the view once around what one orbits, or so many times",
         .more = "Around the upright axis through the pivot of `camera orbit`, counterclockwise as seen from "
                 "above; TURNS below 0 go clockwise. With whole TURNS the film can be shown over and over"},
        {.id = CommandId::FlightFrom,
         .name = "flight from",
         .arguments = {path({"lst", "txt"}), name, maybe(number("WITHIN", 0, 1000))},
         .step = "flight",
         .help = "keep a recorded list of cameras as a flight by times, with as few key frames as hold it "
                 "within WITHIN metres and 20 times as many degrees [0.05]",
         .more =
             "What the recording trembles less than that is smoothed. Its files need their `time`, or are "
             "30 per second"},
        {.id = CommandId::FlightCopy,
         .name = "flight copy",
         .arguments = {name, text("NEW")},
         .effect = Keeps,
         .step = "flight",
         .help = "keep a flight once more, under another name"},
        {.id = CommandId::FlightRename,
         .name = "flight rename",
         .arguments = {name, text("NEW")},
         .effect = Keeps,
         .step = "flight",
         .help = "give a flight another name"},
        {.id = CommandId::FlightRemove,
         .name = "flight remove",
         .arguments = {name},
         .effect = Keeps,
         .step = "flight",
         .help = "remove a flight from the scene"},
        {.id = CommandId::FlightSeconds,
         .name = "flight seconds",
         .arguments = {name, seconds},
         .effect = Keeps,
         .step = "flight",
         .help = "how long the whole takes; the times of key frames are stretched"},
        {.id = CommandId::FlightTrim,
         .name = "flight trim",
         .arguments = {name, kSeconds, kSeconds},
         .effect = Keeps,
         .step = "flight",
         .help = "leave of a flight what is between these two times, in seconds"},
        {.id = CommandId::FlightTiming,
         .name = "flight timing",
         .arguments = {name, choiceOf(rtcore::kFlightTimings)},
         .effect = Keeps,
         .step = "flight",
         .help = "one speed all the way, or through each key frame when that says",
         .more = "Key frames get the times at which the flight came through them"},
        {.id = CommandId::FlightClosed,
         .name = "flight closed",
         .arguments = {name, choice("on|off")},
         .effect = Keeps,
         .step = "flight",
         .help = "go on from the last key frame to the first; of a flight at an even speed"},
        {.id = CommandId::FlightTarget,
         .name = "flight target",
         .arguments = {name, maybe(number("X")), maybe(number("Y")), maybe(number("Z"))},
         .effect = Keeps,
         .step = "flight",
         .help = "look at this point all the way; without one: as the key frames do"},
    };
}

std::vector<CommandSpec> keyMaking(const CommandArgument& name) {
    const CommandArgument n = whole("N", 1, static_cast<double>(rtcore::kMaxFlightKeys));
    return {
        {.id = CommandId::FlightKeyAdd,
         .name = "flight key add",
         .arguments = {name, maybe(kSeconds)},
         .effect = Keeps,
         .step = "flight",
         .help = "keep the view as the last key frame of a flight, and print its number",
         .more =
             "A flight that is not there is made: with SECONDS, 0 for the first, one by times, else one at "
             "an even speed. By times, a key frame before the last one finds its place; without SECONDS it "
             "comes 3 seconds after the last"},
        {.id = CommandId::FlightKeySet,
         .name = "flight key set",
         .arguments = {name, n},
         .effect = Keeps,
         .step = "flight",
         .help = "put the view in the place of a key frame's"},
        {.id = CommandId::FlightKeyMove,
         .name = "flight key move",
         .arguments = {name, n, whole("TO", 1, static_cast<double>(rtcore::kMaxFlightKeys))},
         .effect = Keeps,
         .step = "flight",
         .help = "give a key frame another position among them; times stay where they were"},
        {.id = CommandId::FlightKeyTime,
         .name = "flight key time",
         .arguments = {name, n, kSeconds},
         .effect = Keeps,
         .step = "flight",
         .help = "when a flight by times comes through a key frame: between its neighbours' times"},
        {.id = CommandId::FlightKeyExposure,
         .name = "flight key exposure",
         .arguments = {name, n, orElse(between("C", 0, kMaxNumber), "automatic")},
         .effect = Keeps,
         .step = "flight",
         .help =
             "the constant of the exposure at a key frame, from which it changes to the next that has one"},
        {.id = CommandId::FlightKeyRemove,
         .name = "flight key remove",
         .arguments = {name, n},
         .effect = Keeps,
         .step = "flight",
         .help = "remove a key frame; the last one goes with its flight"},
    };
}

} // namespace

std::vector<CommandSpec> flightCommands() {
    const CommandArgument name = text("NAME", ArgumentType::Flight);
    std::vector<CommandSpec> all{
        {.id = CommandId::FlightList,
         .name = "flight list",
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the flights of the scene: seconds, key frames, name",
         .more = "A line each: `12 4 to the altar`; of a turntable `8 turntable the chair`"},
        {.id = CommandId::FlightGet,
         .name = "flight get",
         .arguments = {name},
         .effect = Tells,
         .help = "print a flight as a [[flight]] of a .scn file says it"}};
    for (CommandSpec& row : flightMaking(name)) all.push_back(std::move(row));
    for (CommandSpec& row : keyMaking(name)) all.push_back(std::move(row));
    const std::vector<CommandSpec> rest{
        {.id = CommandId::FlightGo,
         .name = "flight go",
         .arguments = {name, kSeconds},
         .step = "flight",
         .browser = BrowserUse::Move,
         .help = "look from where a flight is after so many seconds"},
        {.id = CommandId::FlightPlay,
         .name = "flight play",
         .arguments = {name, maybe(kSeconds)},
         .browser = BrowserUse::Move,
         .help = "show a flight in real time, from its beginning or from there; moving ends it"},
        {.id = CommandId::FlightExport,
         .name = "flight export",
         .arguments = {name, path({"lst"}), maybe(number("FPS", 0.1, 1000))},
         .effect = Waits,
         .help = "write a flight as a list of .cam files, in a folder beside it, for 'Renderer --list' [25]",
         .more = "`Renderer --flight` makes films without it"}};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

} // namespace app
