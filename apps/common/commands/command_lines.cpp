#include "common/commands/command_lines.h"

#include "common/commands/command_table.h"
#include "common/commands/quoting.h"

#include "rtcore/settings/number_text.h"

#include <fmt/core.h>

#include <concepts>
#include <string_view>
#include <vector>

namespace app::command {

namespace {

using Words = std::vector<std::string>;

void add(Words& words, const std::string& text) { words.push_back(text); }
void add(Words& words, const char* text) { words.emplace_back(text); }

template <std::integral Number>
void add(Words& words, Number value) {
    words.push_back(fmt::format("{}", value));
}

// Numbers are read as doubles, floats too.
void add(Words& words, double value) { words.push_back(rtcore::shortestText(value)); }
void add(Words& words, float value) { add(words, static_cast<double>(value)); }

void add(Words& words, const std::vector<double>& values) {
    for (const double value : values) add(words, value);
}

void add(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

template <typename Number>
void add(Words& words, const std::array<Number, 3>& vector) {
    for (const Number value : vector) add(words, value);
}

template <typename... Arguments>
std::string line(CommandId id, const Arguments&... arguments) {
    Words words;
    (add(words, arguments), ...);
    const std::string text = joinWords(words);
    return std::string(commandOf(id).name) + (text.empty() ? "" : " ") + text;
}

} // namespace

std::string ping() { return line(CommandId::Ping); }
std::string exit() { return line(CommandId::Exit); }
std::string parent(std::int64_t process) { return line(CommandId::Parent, process); }
std::string noParent() { return line(CommandId::Parent, "none"); }
std::string pause() { return line(CommandId::Pause); }
std::string resume() { return line(CommandId::Resume); }

std::string frameTime(int milliseconds) {
    return milliseconds > 0 ? line(CommandId::FrameTime, milliseconds) : line(CommandId::FrameTime, "off");
}

std::string restLight(bool ofWalk) { return line(CommandId::RestLight, ofWalk ? "walk" : "view"); }
std::string messages(std::uint32_t known) { return line(CommandId::Messages, known); }

std::string resolution(int width, int height) { return line(CommandId::Resolution, width, height); }

std::string set(const std::string& name, const std::string& value) {
    return line(CommandId::Set, name, value);
}

std::string defaults() { return line(CommandId::Defaults); }
std::string quality(const std::string& name) { return line(CommandId::Quality, name); }
std::string state() { return line(CommandId::State); }
std::string undo() { return line(CommandId::Undo); }
std::string redo() { return line(CommandId::Redo); }
std::string undo(int edit) { return line(CommandId::Undo, edit); }
std::string redo(int edit) { return line(CommandId::Redo, edit); }
std::string by(int person, const std::string& edit) { return line(CommandId::By, person) + ' ' + edit; }
std::string visitor(const std::string& note) { return line(CommandId::Visitor) + ' ' + note; }
std::string also(const std::string& edit) { return line(CommandId::Also) + ' ' + edit; }

std::string light(int id, bool on) { return line(CommandId::Light, id, on ? "on" : "off"); }
std::string lightAdd(const std::string& kind) { return line(CommandId::LightAdd, kind); }
std::string lightCopy(int id) { return line(CommandId::LightCopy, id); }
std::string lightRemove(int id) { return line(CommandId::LightRemove, id); }
std::string lightName(int id, const std::string& name) { return line(CommandId::LightName, id, name); }
std::string lightFile(int id, const std::string& path) { return line(CommandId::LightFile, id, path); }
std::string lightTurn(int id, double degrees) { return line(CommandId::LightTurn, id, degrees); }
std::string lightKind(int id, const std::string& kind) { return line(CommandId::LightKind, id, kind); }
std::string lightMove(int id, const Position& position) {
    return line(CommandId::LightMove, id, "at", position);
}
std::string lightMoveHere(int id) { return line(CommandId::LightMove, id, "here"); }
std::string lightMoveSeen(int id) { return line(CommandId::LightMove, id, "seen"); }
std::string lightMoveSeen(int id, double right, double down) {
    return line(CommandId::LightMove, id, "seen", right, down);
}
std::string lightAim(int id, const std::array<float, 3>& direction) {
    return line(CommandId::LightAim, id, "along", direction);
}
std::string lightAimAhead(int id) { return line(CommandId::LightAim, id, "ahead"); }
std::string lightAimSeen(int id) { return line(CommandId::LightAim, id, "seen"); }
std::string lightColour(int id, const std::array<float, 3>& colour) {
    return line(CommandId::LightColour, id, colour);
}
std::string lightTemperature(int id, double kelvin) { return line(CommandId::LightTemperature, id, kelvin); }
std::string lightNoTemperature(int id) { return line(CommandId::LightTemperature, id, "none"); }
std::string lightPower(int id, double power, const std::string& unit) {
    return line(CommandId::LightPower, id, power, unit);
}
std::string lightSize(int id, double radius) { return line(CommandId::LightSize, id, radius); }
std::string lightSize(int id, double width, double height) {
    return line(CommandId::LightSize, id, width, height);
}
std::string lightMirrored(int id, bool on) { return line(CommandId::LightMirrored, id, on ? "on" : "off"); }
std::string lightAngles(int id, double inner, double outer) {
    return line(CommandId::LightAngles, id, inner, outer);
}

std::string environment(int number) { return line(CommandId::Environment, number); }
std::string environmentOpen(const std::string& path) { return line(CommandId::EnvironmentOpen, path); }
std::string environmentNone() { return line(CommandId::EnvironmentNone); }
std::string environmentRotation(double degrees) { return line(CommandId::EnvironmentRotation, degrees); }
std::string environmentStrength(double factor) { return line(CommandId::EnvironmentStrength, factor); }
std::string look(const std::string& name) { return line(CommandId::Look, name); }

std::string sky(bool on) { return line(CommandId::Sky, on ? "on" : "off"); }
std::string skyHour(double hour) { return line(CommandId::SkyHour, hour); }
std::string skyDate(const std::string& date) { return line(CommandId::SkyDate, date); }
std::string skyPlace(double latitude, double longitude, double zone) {
    return line(CommandId::SkyPlace, latitude, longitude, zone);
}
std::string skyNorth(double degrees) { return line(CommandId::SkyNorth, degrees); }
std::string skyDirection(const std::array<float, 3>& toSun) { return line(CommandId::SkyDirection, toSun); }
std::string skyTurbidity(double turbidity) { return line(CommandId::SkyTurbidity, turbidity); }
std::string skyStrength(double factor) { return line(CommandId::SkyStrength, factor); }
std::string skyGround(bool on) { return line(CommandId::SkyGround, on ? "on" : "off"); }
std::string skyHaze(bool on) { return line(CommandId::SkyHaze, on ? "on" : "off"); }

std::string parts(int from) { return line(CommandId::Parts, from); }
std::string materials(int from) { return line(CommandId::Materials, from); }
std::string partHide(const Words& parts) { return line(CommandId::PartHide, parts); }
std::string partShow(const Words& parts) { return line(CommandId::PartShow, parts); }
std::string partIsolate(const Words& parts) { return line(CommandId::PartIsolate, parts); }
std::string partShowAll() { return line(CommandId::PartShowAll); }
std::string materialGet(int number) { return line(CommandId::MaterialGet, number); }

std::string materialSet(int number, const std::string& key, const std::vector<double>& values) {
    return line(CommandId::MaterialSet, number, key, values);
}

std::string materialSwitch(int number, const std::string& key, bool on) {
    return line(CommandId::MaterialSet, number, key, on ? "true" : "false");
}

std::string materialPresets() { return line(CommandId::MaterialPresets); }
std::string materialCopy(int from, const Words& to) { return line(CommandId::MaterialCopy, from, to); }
std::string materialPreset(int number, const std::string& name) {
    return line(CommandId::MaterialPreset, number, name);
}
std::string materialReset(int number) { return line(CommandId::MaterialReset, number); }
std::string materialReset(const std::string& pattern) { return line(CommandId::MaterialReset, pattern); }
std::string seen(double right, double down) { return line(CommandId::Seen, right, down); }

std::string mask(bool ofMaterial, int number) {
    return line(CommandId::Mask, ofMaterial ? "material" : "part", number);
}

std::string sectionHere(double right, double down) { return line(CommandId::SectionHere, right, down); }
std::string sectionThrough(const std::string& axis) { return line(CommandId::SectionThrough, axis); }
std::string sectionAt(int number, const Position& point) { return line(CommandId::SectionAt, number, point); }
std::string sectionPlane(int number, const Position& point, const Position& normal) {
    return line(CommandId::SectionPlane, number, point, normal);
}
std::string sectionTurn(int number) { return line(CommandId::SectionTurn, number); }
std::string sectionRemove(int number) { return line(CommandId::SectionRemove, number); }
std::string sectionClear() { return line(CommandId::SectionClear); }
std::string sectionLight(const std::string& name) { return line(CommandId::SectionLight, name); }
std::string sectionCaps(const std::string& colours) { return line(CommandId::SectionCaps, colours); }
std::string sectionColour(const std::array<float, 3>& linear) {
    return line(CommandId::SectionColour, linear);
}
std::string sectionLeave(const Words& parts) { return line(CommandId::SectionLeave, parts); }
std::string sectionCut(const Words& parts) { return line(CommandId::SectionCut, parts); }
std::string sectionHatching(bool on) { return line(CommandId::SectionHatching, on ? "on" : "off"); }

std::string plan(const std::string& file, const std::string& side, double scale, const std::string& paper,
                 int storey, double height, double dpi) {
    return line(CommandId::Plan, file, side, scale, paper, storey, height, dpi);
}
std::string planOutline() { return line(CommandId::PlanOutline); }
std::string planOutline(int storey) { return line(CommandId::PlanOutline, storey); }
std::string storeys() { return line(CommandId::Storeys); }
std::string storeyGo(int number) { return line(CommandId::StoreyGo, number); }

std::string camera(const View& view) {
    const CommandId id = view.orthographic ? CommandId::CameraOrthographic : CommandId::CameraSet;
    if (view.aspect > 0) return line(id, view.eye, view.forward, view.width, view.up, view.aspect);
    return line(id, view.eye, view.forward, view.width, view.up);
}

std::string cameraSet(const Position& eye, const std::array<float, 3>& forward,
                      std::optional<float> fieldOfView) {
    return fieldOfView ? line(CommandId::CameraSet, eye, forward, *fieldOfView)
                       : line(CommandId::CameraSet, eye, forward);
}

std::string cameraTurn(double right, double up) { return line(CommandId::CameraTurn, right, up); }
std::string cameraPivot() { return line(CommandId::CameraPivot); }
std::string cameraPivot(double right, double down) { return line(CommandId::CameraPivot, right, down); }
std::string cameraOrbit(double right, double up) { return line(CommandId::CameraOrbit, right, up); }
std::string cameraPan(double right, double up) { return line(CommandId::CameraPan, right, up); }
std::string cameraApproach(double factor) { return line(CommandId::CameraApproach, factor); }
std::string cameraFit(const std::vector<std::string>& parts) { return line(CommandId::CameraFit, parts); }
std::string cameraView(const std::string& side) { return line(CommandId::CameraView, side); }
std::string cameraReset() { return line(CommandId::CameraReset); }
std::string cameraAngle(double degrees) { return line(CommandId::CameraAngle, degrees); }
std::string cameraZoom(double factor) { return line(CommandId::CameraZoom, factor); }
std::string cameraPaste(const std::string& text) { return line(CommandId::CameraPaste, text); }
std::string up(const std::string& axis) { return line(CommandId::Up, axis); }
std::string units(float metres) { return line(CommandId::Units, fmt::format("{}", metres)); }
std::string unitsAsGuessed() { return line(CommandId::Units, "auto"); }
std::string focus(double right, double down) { return line(CommandId::Focus, right, down); }
std::string speed(double factor) { return line(CommandId::Speed, factor); }
std::string walk() { return line(CommandId::Walk); }
std::string fly() { return line(CommandId::Fly); }

std::string loadCamera(const std::string& path) { return line(CommandId::LoadCamera, path); }

std::string loadScene(const std::string& path, const std::string& cachedModel) {
    return cachedModel.empty() ? line(CommandId::LoadScene, path)
                               : line(CommandId::LoadScene, path, cachedModel);
}

std::string loadSet(const std::string& path) { return line(CommandId::LoadSet, path); }
std::string save(bool replace) { return replace ? line(CommandId::Save, "replace") : line(CommandId::Save); }

std::string saveAs(const std::string& path, bool replace) {
    return replace ? line(CommandId::SaveAs, path, "replace") : line(CommandId::SaveAs, path);
}

std::string pack(const std::string& folder, bool outside) {
    return outside ? line(CommandId::Pack, folder, "outside") : line(CommandId::Pack, folder);
}
std::string packProgress() { return line(CommandId::PackProgress); }
std::string packStop() { return line(CommandId::PackStop); }
std::string measureLight(double x, double y, int paths) { return line(CommandId::MeasureLight, x, y, paths); }
std::string measureProgress() { return line(CommandId::MeasureProgress); }
std::string measureStop() { return line(CommandId::MeasureStop); }

std::string measurePoint(double right, double down) { return line(CommandId::MeasurePoint, right, down); }
std::string measureHidden() { return line(CommandId::MeasureHidden); }
std::string measureKeepDistance(const Position& from, const Position& to) {
    return line(CommandId::MeasureKeepDistance, from, to);
}
std::string measureKeepChain(const std::vector<Position>& points) {
    Words words;
    for (const Position& point : points) add(words, point);
    return line(CommandId::MeasureKeepChain, words);
}
std::string measureKeepAngle(const Position& from, const Position& at, const Position& to) {
    return line(CommandId::MeasureKeepAngle, from, at, to);
}
std::string measureKeepHeight(const Position& point) { return line(CommandId::MeasureKeepHeight, point); }
std::string measureKeepFace(double right, double down) {
    return line(CommandId::MeasureKeepFace, right, down);
}
std::string measureKeepVolume(const std::string& part) { return line(CommandId::MeasureKeepVolume, part); }
std::string measureName(int number, const std::string& name) {
    return line(CommandId::MeasureName, number, name);
}
std::string measureRemove(int number) { return line(CommandId::MeasureRemove, number); }
std::string measureRemoveAll() { return line(CommandId::MeasureRemove, "all"); }
std::string measureUnit(const std::string& unit, int decimals) {
    return line(CommandId::MeasureUnit, unit, decimals);
}
std::string measureExport(const std::string& path) { return line(CommandId::MeasureExport, path); }

std::string noteGet(int number) { return line(CommandId::NoteGet, number); }
std::string noteAdd(const Position& point, const std::string& text, const std::string& author) {
    return line(CommandId::NoteAdd, point, text, author);
}
std::string noteText(int number, const std::string& text, const std::string& author) {
    return line(CommandId::NoteText, number, text, author);
}
std::string noteRemove(int number) { return line(CommandId::NoteRemove, number); }
std::string noteGo(int number) { return line(CommandId::NoteGo, number); }
std::string noteExport(const std::string& path) { return line(CommandId::NoteExport, path); }

std::string flightThrough(const std::string& name, double seconds) {
    return line(CommandId::FlightThrough, name, seconds);
}
std::string flightTurntable(const std::string& name, double seconds) {
    return line(CommandId::FlightTurntable, name, seconds);
}
std::string flightRename(const std::string& name, const std::string& to) {
    return line(CommandId::FlightRename, name, to);
}
std::string flightRemove(const std::string& name) { return line(CommandId::FlightRemove, name); }
std::string flightSeconds(const std::string& name, double seconds) {
    return line(CommandId::FlightSeconds, name, seconds);
}
std::string flightTiming(const std::string& name, const std::string& timing) {
    return line(CommandId::FlightTiming, name, timing);
}
std::string flightClosed(const std::string& name, bool on) {
    return line(CommandId::FlightClosed, name, on ? "on" : "off");
}
std::string flightKeyAdd(const std::string& name) { return line(CommandId::FlightKeyAdd, name); }
std::string flightKeySet(const std::string& name, int number) {
    return line(CommandId::FlightKeySet, name, number);
}
std::string flightKeyMove(const std::string& name, int number, int to) {
    return line(CommandId::FlightKeyMove, name, number, to);
}
std::string flightKeyTime(const std::string& name, int number, double seconds) {
    return line(CommandId::FlightKeyTime, name, number, seconds);
}
std::string flightKeyRemove(const std::string& name, int number) {
    return line(CommandId::FlightKeyRemove, name, number);
}
std::string flightGo(const std::string& name, double seconds) {
    return line(CommandId::FlightGo, name, seconds);
}
std::string variantAdd(const std::string& name) { return line(CommandId::VariantAdd, name); }
std::string variantUpdate(const std::string& name) { return line(CommandId::VariantUpdate, name); }
std::string variantRename(const std::string& name, const std::string& to) {
    return line(CommandId::VariantRename, name, to);
}
std::string variantRemove(const std::string& name) { return line(CommandId::VariantRemove, name); }
std::string variantRebase() { return line(CommandId::VariantRebase); }
std::string variantGo(const std::string& name) { return line(CommandId::VariantGo, name); }
std::string variantLeave() { return line(CommandId::VariantLeave); }

std::string flightPlay(const std::string& name, double from) {
    return line(CommandId::FlightPlay, name, from);
}

std::string exportCamera(const std::string& path) { return line(CommandId::ExportCamera, path); }

std::string exportCamera(const std::string& path, int width, int height, int antialiasing, int bloom) {
    return line(CommandId::ExportCamera, path, width, height, antialiasing, bloom);
}

std::string exportScene(const std::string& path) { return line(CommandId::ExportScene, path); }
std::string screenshot(const std::string& path) { return line(CommandId::Screenshot, path); }
std::string playStop() { return line(CommandId::PlayStop); }
std::string play(const std::string& path) { return line(CommandId::Play, path); }
std::string exportVideo() { return line(CommandId::ExportVideo); }
std::string exportVideoStart(const std::string& path) { return line(CommandId::ExportVideoStart, path); }
std::string exportVideoStop() { return line(CommandId::ExportVideoStop); }

std::string bookmarkAdd(const std::string& name, const std::string& cameraFile) {
    return line(CommandId::BookmarkAdd, name, cameraFile);
}

std::string bookmarkAdd(const std::string& name) { return line(CommandId::BookmarkAdd, name); }

std::string bookmarkMove(const std::string& name, int position) {
    return line(CommandId::BookmarkMove, name, position);
}

std::string bookmarkGo(const std::string& name) { return line(CommandId::BookmarkGo, name); }

std::string bookmarkRename(const std::string& name, const std::string& to) {
    return line(CommandId::BookmarkRename, name, to);
}

std::string bookmarkRemove(const std::string& name) { return line(CommandId::BookmarkRemove, name); }

std::string cameraGet() { return line(CommandId::CameraGet); }
std::string scene() { return line(CommandId::Scene); }
std::string bindings() { return line(CommandId::Bindings); }

std::string bind(const std::string& keys, const std::string& action) {
    return line(CommandId::Bind, keys, action);
}

std::string bind(const std::string& keys, const std::string& action, int number) {
    return line(CommandId::Bind, keys, action, number);
}

std::string unbind(const std::string& keys) { return line(CommandId::Unbind, keys); }

} // namespace app::command
