#include "common/commands/state_report.h"

#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/settings_section.h"
#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/utf8.h"

#include <algorithm>
#include <stdexcept>

namespace app {

namespace {

const std::string kName = "the server's state"; // in errors
constexpr int kMax = 1'000'000'000;
constexpr rtcore::Limits kTurn{.minimum = -360, .maximum = 360};
constexpr rtcore::Limits kUnit{.minimum = 1e-12, .maximum = 1e12};

/// How much of each list is written.
struct Extent {
    std::size_t max; ///< of the switches
    bool names;
    bool lights; ///< all of each light
    std::size_t measures, notes;
    std::size_t noteBytes; ///< of a text
};

constexpr const char* kPathsFrom = "/"; ///< where those of luminaires begin
constexpr int kVersion = 2;             ///< which [[light]] with an id needs

void write(rtcore::TomlWriter& writer, const std::string& key, const std::vector<NamedSwitch>& switches,
           const Extent& extent) {
    std::vector<bool> on;
    std::vector<std::string> named;
    for (std::size_t i = 0; i < std::min(switches.size(), extent.max); ++i) {
        on.push_back(switches[i].on);
        named.push_back(rtcore::printable(switches[i].name));
    }
    writer.section("[" + key + "]");
    writer.add("on", on);
    if (extent.names) writer.add("names", named);
}

std::vector<NamedSwitch> switchesOf(const std::vector<ReportedLight>& lights) {
    std::vector<NamedSwitch> switches;
    for (const ReportedLight& light : lights) switches.push_back({light.on, light.name});
    return switches;
}

void writeLights(rtcore::TomlWriter& writer, const StateReport& state, const Extent& extent) {
    const std::vector<ReportedLight>& lights = state.lights;
    write(writer, "lights", switchesOf(lights), extent);
    std::vector<int> ids;
    for (std::size_t i = 0; i < std::min(lights.size(), extent.max); ++i) ids.push_back(lights[i].id);
    writer.add("ids", ids);
    if (state.sun > 0) writer.add("sun", state.sun);
    if (!extent.lights) return;
    for (const ReportedLight& light : lights) {
        if (!light.description) continue;
        rtcore::LightDescription description = *light.description;
        description.name = rtcore::printable(description.name);
        description.file = rtcore::printable(description.file.string());
        rtcore::writeLight(writer, description, kPathsFrom);
        if (light.power) writer.add("power", *light.power);
    }
}

std::vector<std::string> printableOf(const std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) all.push_back(rtcore::printable(name));
    return all;
}

/// Beyond so many points no answer has room for them.
constexpr std::size_t kMaxPoints = 1500;

std::size_t firstMeasures(const rtcore::KeptMeasures& measures) {
    std::size_t points = 0, count = 0;
    for (; count < measures.all.size(); ++count) {
        points += measures.all[count].points.size();
        if (points > kMaxPoints) break;
    }
    return count;
}

/// As long as a name may be, with what is no text spelt out.
std::string shownName(const std::string& name) {
    return std::string(rtcore::utf8Beginning(rtcore::printable(name), rtcore::kMaxMeasureName));
}

void writeMeasures(rtcore::TomlWriter& writer, const rtcore::KeptMeasures& measures, std::size_t max) {
    for (std::size_t i = 0; i < std::min(measures.all.size(), max); ++i) {
        rtcore::KeptMeasure measure = measures.all[i];
        measure.name = shownName(measure.name);
        rtcore::writeMeasure(writer, measure);
    }
}

std::size_t firstNotes(const rtcore::SceneNotes& notes, std::size_t max) {
    std::size_t bytes = 0, count = 0;
    for (; count < notes.size(); ++count) {
        bytes += std::min(notes[count].text.size(), kShortNote);
        if (bytes > max) break;
    }
    return count;
}

void writeNotes(rtcore::TomlWriter& writer, const rtcore::SceneNotes& notes, const Extent& extent) {
    for (std::size_t i = 0; i < std::min(notes.size(), extent.notes); ++i) {
        rtcore::SceneNote note = notes[i];
        note.text = rtcore::shortened(note.text, extent.noteBytes);
        note.view.reset(); // `note go` knows it
        rtcore::writeNote(writer, note);
    }
}

void writeFlights(rtcore::TomlWriter& writer, const std::vector<ReportedFlight>& flights) {
    for (const ReportedFlight& each : flights) {
        writer.section("[[flights]]");
        writer.add("name", rtcore::printable(each.name));
        writer.add("seconds", each.seconds);
        writer.add("timing", rtcore::nameOf(each.timing));
        if (each.closed) writer.add("closed", true);
        if (each.turntable) writer.add("turntable", true);
        writer.add("keyCount", each.keyCount);
        writer.add("keyTimes", each.keyTimes);
    }
}

std::string format(const StateReport& state, const Extent& extent) {
    rtcore::TomlWriter writer;
    writer.add("version", kVersion);
    writer.add("scene", rtcore::printable(state.scene));
    writer.add("undo", rtcore::printable(state.undo));
    writer.add("redo", rtcore::printable(state.redo));
    writer.add("undoEdit", std::vector<int>{state.undoEdit.number, state.undoEdit.person});
    writer.add("redoEdit", std::vector<int>{state.redoEdit.number, state.redoEdit.person});
    writer.add("edits", state.edits);
    writer.add("modified", state.modified);
    writer.add("indoors", state.indoors);
    if (extent.names) {
        writer.add("bookmarks", printableOf(state.bookmarks));
        writer.add("bookmarkViews", printableOf(state.bookmarkViews));
        writer.add("variants", printableOf(state.variants));
        if (!state.variant.empty()) writer.add("variant", rtcore::printable(state.variant));
    }
    writer.add("up", rtcore::axisName(state.up));
    writer.add("metresPerUnit", state.metresPerUnit);
    writer.add("origin", state.origin);
    if (!state.bounds.empty()) {
        writer.add("boundsMin", state.bounds.lo);
        writer.add("boundsMax", state.bounds.hi);
    }
    rtcore::writeSectionStyle(writer, state.sections);
    rtcore::writeMeasureStyle(writer, state.measures);
    if (state.measureCount > 0) writer.add("measureCount", state.measureCount);
    if (state.noteCount > 0) writer.add("noteCount", state.noteCount);
    if (state.notesShortened || extent.noteBytes < rtcore::kMaxNoteBytes) writer.add("notesShortened", true);
    writeLights(writer, state, extent);
    write(writer, "environments", state.environments, extent);
    if (state.map) {
        writer.section("[map]");
        writer.add("rotation", state.map->rotation);
        writer.add("strength", state.map->strength);
    }
    if (state.sky) rtcore::writeSky(writer, *state.sky);
    for (const rtcore::SectionPlane& plane : state.sections.planes) rtcore::writeSectionPlane(writer, plane);
    writeMeasures(writer, state.measures, extent.measures);
    writeNotes(writer, state.notes, extent);
    if (extent.names) writeFlights(writer, state.flights);
    writer.section("[camera]");
    rtcore::writeCamera(writer, state.camera);
    rtcore::writeSettingsSection(writer, "settings", state.settings);
    return writer.text();
}

std::vector<NamedSwitch> read(rtcore::StrictTable& root, std::string_view key) {
    rtcore::StrictTable table = root.require(key, root.table(key));
    const std::vector<bool> on = table.require("on", table.booleans("on"));
    const std::vector<std::string> names = table.texts("names").value_or(std::vector<std::string>());
    table.finish();
    std::vector<NamedSwitch> switches;
    for (std::size_t i = 0; i < on.size(); ++i)
        switches.push_back({on[i], i < names.size() ? names[i] : std::string()});
    return switches;
}

std::optional<ReportedMap> readMap(rtcore::StrictTable& root) {
    auto table = root.table("map");
    if (!table) return {};
    ReportedMap map;
    map.rotation = table->require("rotation", table->number("rotation", kTurn));
    map.strength = table->require("strength", table->number("strength", rtcore::kNotNegative));
    table->finish();
    return map;
}

void readLights(rtcore::StrictTable& root, StateReport& state) {
    rtcore::StrictTable table = root.require("lights", root.table("lights"));
    const std::vector<bool> on = table.require("on", table.booleans("on"));
    const std::vector<std::string> names = table.texts("names").value_or(std::vector<std::string>());
    const std::vector<int> ids = table.require("ids", table.integers("ids", 1, rtcore::kMaxLightId));
    state.sun = table.integer("sun", 1, rtcore::kMaxLightId).value_or(0);
    table.finish();
    if (ids.size() != on.size()) table.fail("ids", "there are not as many ids as lights");
    std::vector<ReportedLight>& lights = state.lights;
    for (std::size_t i = 0; i < on.size(); ++i)
        lights.push_back({ids[i], on[i], i < names.size() ? names[i] : std::string()});
    for (rtcore::StrictTable& each : root.tables("light")) {
        const auto power = each.number("power", rtcore::kNotNegative);
        const rtcore::LightDescription description = rtcore::readLight(each, kPathsFrom);
        const auto light = std::ranges::find(lights, description.id, &ReportedLight::id);
        if (light == lights.end()) continue;
        light->description = description;
        light->power = power;
    }
}

rtcore::Box3 readBounds(rtcore::StrictTable& root) {
    const auto lo = root.vector("boundsMin"), hi = root.vector("boundsMax");
    return lo && hi ? rtcore::Box3{*lo, *hi} : rtcore::Box3();
}

ReportedFlight readFlight(rtcore::StrictTable& table) {
    constexpr rtcore::Limits kSeconds{.minimum = 0, .maximum = rtcore::kMaxFlightSeconds};
    constexpr int kMaxTime = 1000 * rtcore::kMaxFlightSeconds;
    ReportedFlight flight{.name = table.require("name", table.text("name"))};
    flight.seconds = table.require("seconds", table.preciseNumber("seconds", kSeconds));
    flight.timing = static_cast<rtcore::FlightTiming>(
        table.require("timing", table.choice("timing", rtcore::kFlightTimings)));
    flight.closed = table.boolean("closed").value_or(false);
    flight.turntable = table.boolean("turntable").value_or(false);
    flight.keyCount = table.require("keyCount", table.integer("keyCount", 0, kMax));
    flight.keyTimes = table.require("keyTimes", table.integers("keyTimes", 0, kMaxTime));
    table.finish();
    return flight;
}

ReportedEdit readEdit(rtcore::StrictTable& root, std::string_view key) {
    const std::vector<int> pair = root.require(key, root.integers(key, 0, kMax));
    if (pair.size() != 2) root.fail(key, "it takes an edit's number and its person");
    return {pair[0], pair[1]};
}

} // namespace

std::string formatStateReport(const StateReport& state, std::size_t max) {
    const std::size_t measures = firstMeasures(state.measures), notes = firstNotes(state.notes, max);
    const bool longTexts = std::ranges::any_of(
        state.notes, [](const rtcore::SceneNote& note) { return note.text.size() > kShortNote; });
    Extent extent{.max = std::max(state.lights.size(), state.environments.size()),
                  .names = true,
                  .lights = true,
                  .measures = measures,
                  .notes = notes,
                  .noteBytes = rtcore::kMaxNoteBytes};
    for (;;) {
        std::string text = format(state, extent);
        if (text.ends_with('\n')) text.pop_back();
        if (text.size() <= max) return text;
        if (longTexts && extent.noteBytes > kShortNote) {
            extent.noteBytes = kShortNote;
            continue;
        }
        // Strangers may write notes.
        if (std::size_t& fewer = extent.notes > 0 ? extent.notes : extent.measures; fewer > 0) {
            fewer /= 2;
            continue;
        }
        extent.measures = measures;
        extent.notes = notes;
        if (extent.max == 0) throw rtcore::Refusal("the state takes more bytes than an answer has");
        if (!extent.lights && !extent.names) extent.max /= 2;
        if (!extent.lights) extent.names = false;
        extent.lights = false;
    }
}

StateReport parseStateReport(std::string_view text) {
    const rtcore::TextValue content = rtcore::parseToml(text, kName);
    rtcore::StrictTable root(content, kName);
    root.checkVersion(kVersion);
    StateReport state;
    state.origin = root.readOrigin({});
    state.scene = root.require("scene", root.text("scene"));
    state.undo = root.require("undo", root.text("undo"));
    state.redo = root.require("redo", root.text("redo"));
    state.undoEdit = readEdit(root, "undoEdit");
    state.redoEdit = readEdit(root, "redoEdit");
    state.edits = root.require("edits", root.integer("edits", 0, kMax));
    state.modified = root.require("modified", root.boolean("modified"));
    state.indoors = root.require("indoors", root.boolean("indoors"));
    state.bookmarks = root.texts("bookmarks").value_or(std::vector<std::string>());
    state.bookmarkViews = root.texts("bookmarkViews").value_or(std::vector<std::string>());
    state.variants = root.texts("variants").value_or(std::vector<std::string>());
    state.variant = root.text("variant").value_or("");
    for (rtcore::StrictTable& each : root.tables("flights")) state.flights.push_back(readFlight(each));
    state.up = rtcore::kAxes.at(root.require("up", root.choice("up", rtcore::kAxisNames)));
    state.metresPerUnit = root.require("metresPerUnit", root.number("metresPerUnit", kUnit));
    readLights(root, state);
    state.environments = read(root, "environments");
    state.map = readMap(root);
    if (auto sky = root.table("sky")) state.sky = rtcore::readSky(*sky);
    state.bounds = readBounds(root);
    state.sections = rtcore::readSectionPlanes(root);
    state.measures = rtcore::readMeasures(root);
    state.notes = rtcore::readNotes(root, state.up);
    state.noteCount = root.integer("noteCount", 0, kMax).value_or(0);
    state.notesShortened = root.boolean("notesShortened").value_or(false);
    state.measureCount = root.integer("measureCount", 0, kMax).value_or(0);
    rtcore::StrictTable camera = root.require("camera", root.table("camera"));
    state.camera = rtcore::readCamera(camera, rtcore::Vec3{0, 1, 0}, false);
    state.settings = rtcore::readSettingsSection(root, "settings");
    root.finish();
    return state;
}

} // namespace app
