/// The lines that a client sends, made from the table of commands: one function for each command that our
/// programs send, with arguments that the compiler checks. Paths are absolute.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app::command {

/// In the coordinates of the model's file, scene units.
using Position = std::array<double, 3>;

/// The arguments of `camera set` and `camera orthographic`.
struct View {
    Position eye{};
    std::array<float, 3> forward{}; ///< not zero
    float width = 0;                ///< degrees, or, without perspective, scene units
    bool orthographic = false;
    std::array<float, 3> up{};
    float aspect = 0; ///< that `width` is for; 0: any
};

std::string ping();
std::string exit();
std::string parent(std::int64_t process);
std::string noParent();
std::string pause();
std::string resume();
std::string frameTime(int milliseconds); ///< 0: any
std::string restLight(bool ofWalk);      ///< indirect light of whole frames: else of their view
std::string messages(std::uint32_t known);

std::string resolution(int width, int height);
std::string set(const std::string& name, const std::string& value);
std::string defaults();
std::string quality(const std::string& name); ///< of rtcore::kQualityNames
std::string state();
std::string undo();
std::string redo();
std::string undo(int edit); ///< that one or none
std::string redo(int edit);
/// A line of one that edits, on behalf of a person of this client's, from 1.
std::string by(int person, const std::string& edit);
/// A line of one that adds a note, of one who only looks: no step of undo.
std::string visitor(const std::string& note);
/// A line of one that edits, as part of the last edit.
std::string also(const std::string& line);

// Lights, by their ids. Kinds are named as in .scn files.
std::string light(int id, bool on);
std::string lightAdd(const std::string& kind); ///< where one looks
std::string lightCopy(int id);
std::string lightRemove(int id);
std::string lightName(int id, const std::string& name);
std::string lightKind(int id, const std::string& kind);
std::string lightFile(int id, const std::string& path);
std::string lightTurn(int id, double degrees);
std::string lightMove(int id, const Position& position);
std::string lightMoveHere(int id);
std::string lightMoveSeen(int id);
std::string lightMoveSeen(int id, double right, double down); ///< 0..1
std::string lightAim(int id, const std::array<float, 3>& direction);
std::string lightAimAhead(int id);
std::string lightAimSeen(int id);
std::string lightColour(int id, const std::array<float, 3>& colour); ///< linear
std::string lightTemperature(int id, double kelvin);
std::string lightNoTemperature(int id);
std::string lightPower(int id, double power, const std::string& unit); ///< lm, lx, W
std::string lightSize(int id, double radius); ///< or the angle of a directional light, degrees
std::string lightSize(int id, double width, double height);
std::string lightAngles(int id, double inner, double outer); ///< degrees
std::string lightMirrored(int id, bool on);

std::string environment(int number); ///< from 1
std::string environmentOpen(const std::string& path);
std::string environmentNone();
std::string environmentRotation(double degrees);
std::string environmentStrength(double factor);
std::string look(const std::string& name); ///< of rtcore::kLightingPresetNames

// The sky, which each but the first switches on.
std::string sky(bool on);
std::string skyHour(double hour);
std::string skyDate(const std::string& date); ///< "2026-06-21"
/// Degrees north and east; hours ahead of universal time.
std::string skyPlace(double latitude, double longitude, double zone);
std::string skyNorth(double degrees);
std::string skyDirection(const std::array<float, 3>& toSun);
std::string skyTurbidity(double turbidity);
std::string skyStrength(double factor);
std::string skyGround(bool on);
std::string skyHaze(bool on);

std::string parts(int from);     ///< from 1
std::string materials(int from); ///< from 1
/// Numbers or patterns.
std::string partHide(const std::vector<std::string>& parts);
std::string partShow(const std::vector<std::string>& parts);
std::string partIsolate(const std::vector<std::string>& parts);
std::string partShowAll();
std::string materialGet(int number);
std::string materialSet(int number, const std::string& key, const std::vector<double>& values);
std::string materialSwitch(int number, const std::string& key, bool on);
std::string materialPresets();
std::string materialCopy(int from, const std::vector<std::string>& to); ///< numbers or patterns
std::string materialPreset(int number, const std::string& name);
std::string materialReset(int number);
std::string materialReset(const std::string& pattern);
std::string seen(double right, double down);   ///< 0..1
std::string mask(bool ofMaterial, int number); ///< of a part, else

// Sections, counted from 1.
std::string sectionLeave(const std::vector<std::string>& parts); ///< numbers or patterns
std::string sectionCut(const std::vector<std::string>& parts);
std::string sectionHere(double right, double down);  ///< 0..1
std::string sectionThrough(const std::string& axis); ///< "-z"
std::string sectionAt(int number, const Position& point);
std::string sectionPlane(int number, const Position& point, const Position& normal);
std::string sectionTurn(int number);
std::string sectionRemove(int number);
std::string sectionClear();
std::string sectionLight(const std::string& name);   ///< of rtcore::kSectionLights
std::string sectionCaps(const std::string& colours); ///< of rtcore::kCapColours
std::string sectionColour(const std::array<float, 3>& linear);
std::string sectionHatching(bool on);

/// `storey` 0: that of the camera; `paper`: "sheet", or a size.
std::string plan(const std::string& file, const std::string& side, double scale, const std::string& paper,
                 int storey, double height, double dpi);
std::string planOutline(); ///< of the storey of the camera
std::string planOutline(int storey);
std::string storeys();
std::string storeyGo(int number);

/// All of the camera.
std::string camera(const View& view);
/// Where it is and looks to; what is up, as the scene has it. Without a field of view that stays as it is.
std::string cameraSet(const Position& eye, const std::array<float, 3>& forward,
                      std::optional<float> fieldOfView = {});
std::string cameraTurn(double right, double up); ///< degrees
std::string cameraPivot();
std::string cameraPivot(double right, double down); ///< 0..1
std::string cameraOrbit(double right, double up);   ///< degrees
std::string cameraPan(double right, double up);     ///< of the image's width
std::string cameraApproach(double factor);
std::string cameraFit(const std::vector<std::string>& parts = {});
std::string cameraView(const std::string& side); ///< a word of the table's
std::string cameraReset();
std::string cameraAngle(double degrees); ///< of the field of view
std::string cameraZoom(double factor);
std::string cameraPaste(const std::string& text); ///< of a .cam file
std::string up(const std::string& axis);          ///< "+z"
std::string units(float metres);
std::string unitsAsGuessed();
std::string focus(double right, double down); ///< 0..1
std::string speed(double factor);
std::string walk();
std::string fly();

std::string loadCamera(const std::string& path);
std::string loadScene(const std::string& path, const std::string& cachedModel = {}); ///< "": none
std::string loadSet(const std::string& path);
std::string save(bool replace);
std::string saveAs(const std::string& path, bool replace);
std::string pack(const std::string& folder, bool outside = false);
std::string packProgress();
std::string packStop();
/// The light seen there, 0..1 from the left and from the top, by so many paths, rounded up to a power of
/// two from 512 on.
std::string measureLight(double x, double y, int paths);
std::string measureProgress();
std::string measureStop();

// Measures that are kept, counted from 1.
std::string measurePoint(double right, double down); ///< 0..1
std::string measureHidden();
std::string measureKeepDistance(const Position& from, const Position& to);
std::string measureKeepChain(const std::vector<Position>& points); ///< 3 to 64
std::string measureKeepAngle(const Position& from, const Position& at, const Position& to);
std::string measureKeepHeight(const Position& point);
std::string measureKeepFace(double right, double down); ///< 0..1
std::string measureKeepVolume(const std::string& part);
std::string measureName(int number, const std::string& name);
std::string measureRemove(int number);
std::string measureRemoveAll();
std::string measureUnit(const std::string& unit, int decimals); ///< of rtcore::kLengthUnits
std::string measureExport(const std::string& path);

// Notes, counted from 1; an author may be "".
std::string noteGet(int number);
std::string noteAdd(const Position& point, const std::string& text, const std::string& author);
std::string noteText(int number, const std::string& text, const std::string& author);
std::string noteRemove(int number);
std::string noteGo(int number);
std::string noteExport(const std::string& path);

// Flights, by their names; key frames counted from 1.
std::string flightThrough(const std::string& name, double seconds); ///< all bookmarks of the scene
std::string flightTurntable(const std::string& name, double seconds);
std::string flightRename(const std::string& name, const std::string& to);
std::string flightRemove(const std::string& name);
std::string flightSeconds(const std::string& name, double seconds);
std::string flightTiming(const std::string& name, const std::string& timing); ///< of rtcore::kFlightTimings
std::string flightClosed(const std::string& name, bool on);
std::string flightKeyAdd(const std::string& name); ///< the current view, also of a flight that is new
std::string flightKeySet(const std::string& name, int number);
std::string flightKeyMove(const std::string& name, int number, int to);
std::string flightKeyTime(const std::string& name, int number, double seconds);
std::string flightKeyRemove(const std::string& name, int number);
std::string flightGo(const std::string& name, double seconds);
std::string flightPlay(const std::string& name, double from); ///< seconds

// Variants, by their names.
std::string variantAdd(const std::string& name);
std::string variantUpdate(const std::string& name);
std::string variantRename(const std::string& name, const std::string& to);
std::string variantRemove(const std::string& name);
std::string variantRebase();
std::string variantGo(const std::string& name);
std::string variantLeave();

std::string exportCamera(const std::string& path);
std::string exportCamera(const std::string& path, int width, int height, int antialiasing, int bloom);
std::string exportScene(const std::string& path);
std::string screenshot(const std::string& path);
std::string play(const std::string& path);
std::string playStop();
std::string exportVideo();
std::string exportVideoStart(const std::string& path);
std::string exportVideoStop();

std::string bookmarkAdd(const std::string& name, const std::string& cameraFile);
std::string bookmarkAdd(const std::string& name);                ///< the current view
std::string bookmarkMove(const std::string& name, int position); ///< from 1
std::string bookmarkGo(const std::string& name);
std::string bookmarkRename(const std::string& name, const std::string& to);
std::string bookmarkRemove(const std::string& name);

std::string cameraGet();
std::string scene();
std::string bindings();
std::string bind(const std::string& keys, const std::string& action);
std::string bind(const std::string& keys, const std::string& action, int number);
std::string unbind(const std::string& keys);

} // namespace app::command
