#include "bridge/control/scene_facts.h"

#include "bridge/control/page_sentence.h"
#include "bridge/control/setting_value.h"

#include "common/cli/command_line.h"
#include "common/commands/step_label.h"

#include "rtcore/io/text/cosine.h"
#include "rtcore/scene/light_power.h"

#include <array>
#include <filesystem>

namespace bridge {

namespace {

using nlohmann::json;
using rtcore::Vec3;

json vectorJson(Vec3 v) { return {v.x, v.y, v.z}; }
json vectorJson(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

json positionJson(Vec3 p, const rtcore::LocalOrigin& origin) {
    return origin.isZero() ? vectorJson(p) : json(origin.inFile(p));
}

json cameraJson(const rtcore::Camera& camera, const rtcore::LocalOrigin& origin) {
    const bool orthographic = camera.kind == rtcore::CameraKind::Orthographic;
    return {{"eye", positionJson(camera.eye, origin)},
            {"forward", vectorJson(camera.forward)},
            {"up", vectorJson(camera.up)},
            {"fov", orthographic ? 0 : camera.horizontalFov},
            {"orthographic", orthographic ? camera.orthographicWidth : 0}};
}

void describe(json& row, const app::ReportedLight& reported, const app::StateReport& state) {
    const float metresPerUnit = state.metresPerUnit;
    const rtcore::LightDescription& description = *reported.description;
    const rtcore::Light& light = description.light;
    const float max = rtcore::maxComponent(light.intensity);
    const rtcore::Colour colour = max > 0 ? light.intensity / max : rtcore::Colour{1, 1, 1};
    row["kind"] = rtcore::traitsOf(light).name;
    row["position"] = positionJson(light.position, state.origin);
    row["direction"] = vectorJson(light.direction);
    row["colour"] = {colour.r, colour.g, colour.b};
    row["temperature"] = description.temperature;
    const float power = reported.power.value_or(rtcore::powerOf(rtcore::tintedLight(description)));
    row["power"] = power;
    row["lumens"] =
        rtcore::kLumensPerWatt * rtcore::radiantWatts(light, double{power}, double{metresPerUnit});
    row["radius"] = light.radius;
    row["width"] = light.width;
    row["height"] = light.height;
    row["angle"] = rtcore::degreesOfHalfSine(light.discSine);
    row["mirrored"] = light.mirrored != 0;
    row["file"] = description.file.filename().string();
    const bool spot = light.kind == rtcore::LightKind::Spot;
    row["inner"] = spot ? rtcore::degreesOfCosine(light.cosInner) : 0;
    row["outer"] = spot ? rtcore::degreesOfCosine(light.cosOuter) : 0;
}

json lightsJson(const app::StateReport& state) {
    json rows = json::array();
    for (const app::ReportedLight& light : state.lights) {
        json row{{"id", light.id}, {"on", light.on}, {"name", light.name}};
        if (light.description) describe(row, light, state);
        rows.push_back(std::move(row));
    }
    return rows;
}

json valueJson(const rtcore::MeasureValue& value) {
    return {{"value", value.value}, {"power", value.power}, {"decimals", value.decimals}};
}

/// Whether a section takes the point away.
bool isCutAway(rtcore::Vec3d point, const app::StateReport& state) {
    constexpr double kOfDiagonal = 1e-4;
    const double slack = state.bounds.empty() ? 0 : kOfDiagonal * double{state.bounds.diagonal()};
    const auto doubles = [](Vec3 v) { return rtcore::Vec3d{v.x, v.y, v.z}; };
    return std::ranges::any_of(state.sections.planes, [&](const rtcore::SectionPlane& plane) {
        return dot(normalize(doubles(plane.normal)), point - doubles(plane.point)) > slack;
    });
}

json doublesJson(const rtcore::Vec3d& p, const rtcore::LocalOrigin& origin) {
    return {p.x + origin.at[0], p.y + origin.at[1], p.z + origin.at[2]};
}

json measureJson(const rtcore::KeptMeasure& measure, const app::StateReport& state) {
    const double metres{state.metresPerUnit};
    json points = json::array(), legs = json::array();
    for (const rtcore::Vec3d p : measure.points) points.push_back(doublesJson(p, state.origin));
    for (const rtcore::MeasureValue& leg : legsOf(measure, state.measures, metres))
        legs.push_back(valueJson(leg));
    json row = valueJson(valueOf(measure, state.measures, metres));
    row["kind"] = nameOf(measure.kind);
    row["name"] = measure.name;
    row["points"] = std::move(points);
    row["legs"] = std::move(legs);
    row["cut"] = isCutAway(labelPoint(measure), state);
    return row;
}

json measuresJson(const app::StateReport& state) {
    json rows = json::array();
    for (const rtcore::KeptMeasure& measure : state.measures.all) rows.push_back(measureJson(measure, state));
    return {{"unit", nameOf(state.measures.unit)}, {"count", state.measureCount}, {"all", std::move(rows)}};
}

json notesJson(const app::StateReport& state) {
    json rows = json::array();
    for (const rtcore::SceneNote& note : state.notes)
        rows.push_back({{"point", doublesJson(note.point, state.origin)},
                        {"text", note.text},
                        {"author", note.author},
                        {"written", note.written},
                        {"cut", isCutAway(note.point, state)}});
    return {{"count", state.noteCount}, {"shortened", state.notesShortened}, {"all", std::move(rows)}};
}

json environmentsJson(const std::vector<app::NamedSwitch>& environments) {
    json rows = json::array();
    for (const app::NamedSwitch& each : environments)
        rows.push_back({{"number", rows.size() + 1}, {"on", each.on}, {"name", each.name}});
    return rows;
}

json skyJson(const app::StateReport& state) {
    if (!state.sky) return nullptr;
    const rtcore::Sky& sky = *state.sky;
    json row{{"on", !state.environments.empty() && state.environments.back().on},
             {"date", nullptr},
             {"direction", vectorJson(sky.direction)},
             {"north", sky.north},
             {"turbidity", sky.turbidity},
             {"strength", sky.strength},
             {"ground", sky.ground},
             {"haze", sky.haze},
             {"studio", sky.studio}};
    if (!sky.date) return row;
    constexpr double kHour = 3600;
    row["date"] = {{"year", sky.date->year}, {"month", sky.date->month}, {"day", sky.date->day}};
    row["hour"] = sky.date->second / kHour;
    row["zone"] = sky.date->timeZone;
    row["latitude"] = sky.date->latitude;
    row["longitude"] = sky.date->longitude;
    return row;
}

json sectionsJson(const app::StateReport& state) {
    const rtcore::SectionPlanes& sections = state.sections;
    json planes = json::array();
    for (const rtcore::SectionPlane& plane : sections.planes)
        planes.push_back(
            {{"point", positionJson(plane.point, state.origin)}, {"normal", vectorJson(plane.normal)}});
    const rtcore::Box3 bounds = state.bounds.empty() ? rtcore::Box3{{}, {}} : state.bounds;
    const rtcore::Colour colour = sections.caps.colour;
    return {{"planes", planes},
            {"max", rtcore::kMaxSectionPlanes},
            {"bounds",
             {{"lo", positionJson(bounds.lo, state.origin)}, {"hi", positionJson(bounds.hi, state.origin)}}},
            {"light", nameOf(sections.light)},
            {"caps", nameOf(sections.caps.colours)},
            {"colour", {colour.r, colour.g, colour.b}},
            {"hatching", sections.caps.hatched}};
}

json valuesJson(const std::vector<rtcore::SettingAssignment>& settings) {
    json values = json::object();
    for (const rtcore::SettingAssignment& each : settings) values[each.name] = settingJson(each.value);
    return values;
}

/// By words of the table of commands; a step of a newer server by its line.
json stepJson(const std::string& step) {
    if (step.empty()) return nullptr;
    const app::StepLabel label = app::stepLabel(step);
    if (label.isSetting) return {{"setting", label.of}};
    if (label.text.empty()) return {{"label", withoutFolders(step)}, {"of", ""}};
    return {{"label", label.text}, {"of", label.of}};
}

/// The keys of `now` that are not the same in `before`.
json difference(const json& now, const json& before) {
    json changed = json::object();
    for (const auto& [key, value] : now.items()) {
        const auto old = before.find(key);
        if (old != before.end() && *old == value) continue;
        changed[key] = key == "values" && old != before.end() ? difference(value, *old) : value;
    }
    return changed;
}

constexpr std::array<const char*, 3> kModes{"fly", "walk", "floor"};

} // namespace

json lightKindsJson() {
    json kinds = json::array();
    for (const rtcore::LightTraits& kind : rtcore::kLightTraits)
        kinds.push_back({{"name", kind.name},
                         {"label", rtcore::settingLabel(kind.name)},
                         {"position", kind.position},
                         {"direction", kind.direction},
                         {"cone", kind.beam == rtcore::Beam::Cone},
                         {"radius", kind.position && !kind.sides},
                         {"sides", kind.sides},
                         {"disc", kind.disc},
                         {"turns", kind.turns()},
                         {"area", kind.radius || kind.sides}});
    return kinds;
}

std::vector<std::string> flightNamesOf(const std::vector<app::ReportedFlight>& flights) {
    std::vector<std::string> names;
    for (const app::ReportedFlight& each : flights) names.push_back(each.name);
    return names;
}

json sceneJson(const app::StateReport& state) {
    json scene{{"scene", std::filesystem::path(state.scene).filename().string()},
               {"up", vectorJson(state.up)},
               {"metresPerUnit", state.metresPerUnit},
               {"values", valuesJson(state.settings)},
               {"camera", cameraJson(state.camera, state.origin)},
               {"lights", lightsJson(state)},
               {"environments", environmentsJson(state.environments)},
               {"map", nullptr},
               {"sky", skyJson(state)},
               {"sections", sectionsJson(state)},
               {"bookmarks", state.bookmarks},
               {"flights", flightNamesOf(state.flights)},
               {"variants", state.variants},
               {"variant", state.variant},
               {"measures", measuresJson(state)},
               {"notes", notesJson(state)},
               {"undo", stepJson(state.undo)},
               {"redo", stepJson(state.redo)},
               {"edits", state.edits},
               {"modified", state.modified},
               {"indoors", state.indoors}};
    if (state.map) scene["map"] = {{"rotation", state.map->rotation}, {"strength", state.map->strength}};
    return scene;
}

bool SceneFacts::read(std::string_view report) {
    try {
        const app::StateReport state = app::parseStateReport(report);
        json now = sceneJson(state);
        changes_ = difference(now, all_);
        all_ = std::move(now);
        bookmarks_ = state.bookmarks;
        flights_ = flightNamesOf(state.flights);
        variants_ = state.variants;
        notes_ = static_cast<std::size_t>(state.noteCount);
        lights_ = state.lights.size();
        hasSky_ = state.sky.has_value();
        settings_ = state.settings;
        undo_ = state.undoEdit;
        redo_ = state.redoEdit;
        known_ = true;
        return true;
    } catch (const std::exception&) { // of a server that is no RTServer
        changes_ = json::object();
        return false;
    }
}

void SceneFacts::clear() { *this = SceneFacts(); }

std::string SceneFacts::settingText(const std::string& name) const {
    for (const rtcore::SettingAssignment& each : settings_)
        if (each.name == name) return rtcore::settingText(each.value);
    return {};
}

json statusJson(const ipc::Status& status) {
    rtcore::LocalOrigin origin;
    std::ranges::copy(status.origin, origin.at.begin());
    const json eye = positionJson({status.eye[0], status.eye[1], status.eye[2]}, origin);
    const std::size_t mode = std::min<std::size_t>(status.mode, kModes.size() - 1);
    constexpr double kMilliseconds = 1000;
    return {{"event", "status"},
            {"fps", status.framesPerSecond},
            {"frameMs", status.frameSeconds * kMilliseconds},
            {"wholeMs", status.wholeSeconds * kMilliseconds},
            {"rays", status.raysPerSecond},
            {"triangles", status.polygons},
            {"width", status.width},
            {"height", status.height},
            {"eye", eye},
            {"forward", vectorJson(status.forward)},
            {"up", vectorJson(status.up)},
            {"fov", status.fieldOfView},
            {"orthographic", status.parallelWidth},
            {"exposure", status.exposure},
            {"mode", kModes[mode]},
            {"idle", status.idle != 0},
            {"paused", status.paused != 0},
            {"recording", status.recording != 0},
            {"progress", status.progress},
            {"kept", status.kept},
            {"indirectError", status.lightError}};
}

std::string withoutFolders(std::string_view text) {
    constexpr std::string_view kLuminanceUnit = "cd/m2";
    std::string kept;
    std::size_t word = 0; // where the present one begins in `kept`
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '/' && word == kept.size()) { // a whole path, whose folders may have blanks
            const std::string_view rest = text.substr(i, text.find_first_of(":\"'\n", i) - i);
            i += rest.rfind('/');
            continue;
        }
        if (text.substr(i).starts_with(kLuminanceUnit) && word == kept.size()) { // no folder
            kept += kLuminanceUnit;
            i += kLuminanceUnit.size() - 1;
            continue;
        }
        const bool ends = c == ' ' || c == '"' || c == '\'' || c == '\n' || c == '(' || c == '=';
        if (c == '/') {
            kept.resize(word);
        } else {
            kept += c;
            if (ends) word = kept.size();
        }
    }
    return kept;
}

std::vector<json> messageEvents(std::string_view lines, std::string_view details) {
    const auto takeLine = [](std::string_view& text) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        return line;
    };
    std::vector<json> events;
    while (!lines.empty()) {
        const std::string_view line = takeLine(lines), detail = takeLine(details);
        const std::size_t first = line.find(' ');
        const std::size_t second = first == std::string_view::npos ? first : line.find(' ', first + 1);
        const auto number = app::parseInteger(line.substr(0, first));
        if (!number || second == std::string_view::npos) continue;
        events.push_back({{"event", "message"},
                          {"number", *number},
                          {"kind", line.substr(first + 1, second - first - 1)}});
        addSentence(events.back(), line.substr(second + 1), detail);
    }
    return events;
}

} // namespace bridge
