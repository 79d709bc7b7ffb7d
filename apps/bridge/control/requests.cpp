#include "bridge/control/requests.h"

#include "bridge/control/request_fields.h"
#include "bridge/control/setting_value.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <algorithm>
#include <array>

namespace bridge {

namespace {

using app::CommandId;
using Fields = const RequestFields&;
using Words = CommandWords;

/// One request.
struct RequestRow {
    std::string_view name;
    CommandId command;
    Words (*words)(Fields, const RequestSurroundings&);
    bool anyone = false;
    AnswerShape shape = AnswerShape::Text;
    std::span<const std::string_view> sets{}; ///< settings that it changes
};

constexpr std::array<std::string_view, 2> kSize{"width", "height"};
constexpr std::array<std::string_view, 1> kBloom{"bloom.radius"};
constexpr std::array<std::string_view, 2> kFocus{"depthOfField.on", "depthOfField.focus"};
constexpr std::array<std::string_view, 3> kLook{"skyLight.on", "ambientOcclusion.on", "exposure.key"};
constexpr std::array<std::string_view, 1> kFirstSky{"skyLight.on"}; // of a scene that has none

void checkLocks(const RequestRow& row, const RequestSurroundings& around) {
    if (row.sets.data() == kFirstSky.data() && around.sky) return;
    for (const std::string_view name : row.sets)
        if (around.limits.isLocked(name)) throw Refused(fmt::format("{} is locked", name));
}

/// The arguments are whole before the list begins: when one of them throws within braces, GCC 12 may destroy
/// strings that were never made.
template <typename... Each>
Words wordList(Each&&... each) {
    Words words;
    (words.emplace_back(std::forward<Each>(each)), ...);
    return words;
}

Words none(Fields, const RequestSurroundings&) { return {}; }

// --- Camera ---

Words ifGiven(Fields f, std::string_view key) { return f.has(key) ? wordList(f.word(key)) : Words(); }

/// `camera set` takes what is up only behind the field of view, so without that the server's stays.
Words camera(Fields f, const RequestSurroundings&) {
    Words words = f.vector("eye") + f.vector("forward") + ifGiven(f, "fov");
    return f.has("up") && f.has("fov") ? words + f.vector("up") : words;
}
Words orthographic(Fields f, const RequestSurroundings&) {
    Words words = f.vector("eye") + f.vector("forward") + wordList(f.word("width"));
    return f.has("up") ? words + f.vector("up") : words;
}
Words lookAt(Fields f, const RequestSurroundings&) {
    return f.vector("eye") + f.vector("target") + ifGiven(f, "fov");
}
Words seen(Fields f, const RequestSurroundings&) { return wordList(f.word("x"), f.word("y")); }
Words pivot(Fields f, const RequestSurroundings& around) {
    return f.has("x") || f.has("y") ? seen(f, around) : Words();
}
Words across(Fields f, const RequestSurroundings&) { return wordList(f.word("right"), f.word("up")); }
Words side(Fields f, const RequestSurroundings&) {
    return wordList(f.choice("side", {"front", "back", "left", "right", "top", "bottom", "three-quarter"}));
}
Words bookmark(Fields f, const RequestSurroundings& around) {
    const std::int64_t number = f.integer("number");
    if (number < 1 || number > static_cast<std::int64_t>(around.bookmarks.size()))
        throw Refused("there is no such bookmark");
    return wordList(around.bookmarks[static_cast<std::size_t>(number - 1)]);
}

// --- Settings ---

Words set(Fields f, const RequestSurroundings& around) {
    return wordList(f.text("name"), settingValueText(f.text("name"), f.value("value"), around.limits));
}
Words defaults(Fields, const RequestSurroundings& around) {
    if (!around.limits.locked.empty()) throw Refused("some settings are locked; reset others one by one");
    return {};
}
Words resolution(Fields f, const RequestSurroundings& around) {
    const std::int64_t width = f.integer("width"), height = f.integer("height");
    constexpr std::int64_t kMostSide = 16384;
    if (width < 1 || height < 1 || width > kMostSide || height > kMostSide)
        throw Refused("width and height are from 1 to 16384");
    if (width * height > around.limits.maxPixels)
        throw Refused(fmt::format("{} x {} are more than {} pixels", width, height, around.limits.maxPixels));
    return wordList(f.whole("width"), f.whole("height"));
}

// --- Lights ---

std::string kind(Fields f) {
    return f.choice("kind", {"point", "directional", "spot", "sphere", "rectangle"});
}
Words light(Fields f, const RequestSurroundings&) { return wordList(f.whole("light"), f.onOff("on")); }
void checkRoomForLight(const RequestSurroundings& around) {
    if (around.lights >= kMostLights)
        throw Refused(fmt::format("there are {} lights, the most that pages may have", around.lights));
}
Words lightAdd(Fields f, const RequestSurroundings& around) {
    checkRoomForLight(around);
    return wordList(kind(f));
}
Words lightCopy(Fields f, const RequestSurroundings& around) {
    checkRoomForLight(around);
    return wordList(f.whole("light"));
}
Words lightOnly(Fields f, const RequestSurroundings&) { return wordList(f.whole("light")); }
Words lightKind(Fields f, const RequestSurroundings&) { return wordList(f.whole("light"), kind(f)); }
Words seenAt(Fields f) {
    return f.has("x") || f.has("y") ? wordList("seen", f.word("x"), f.word("y")) : wordList("seen");
}
Words place(Fields f, std::string_view other) {
    if (f.isArray("to")) return wordList("at") + f.vector("to");
    const std::string to = f.choice("to", {other, "seen"});
    return to == "seen" ? seenAt(f) : wordList(to);
}
Words lightMove(Fields f, const RequestSurroundings&) {
    return wordList(f.whole("light")) + place(f, "here");
}
Words lightAim(Fields f, const RequestSurroundings&) {
    const Words light = wordList(f.whole("light"));
    return f.has("along") ? light + wordList("along") + f.vector("along") : light + place(f, "ahead");
}
Words lightColour(Fields f, const RequestSurroundings&) {
    return wordList(f.whole("light")) + f.vector("colour");
}
Words lightTemperature(Fields f, const RequestSurroundings&) {
    return wordList(f.whole("light"), f.isNull("kelvin") ? "none" : f.word("kelvin"));
}
Words lightPower(Fields f, const RequestSurroundings&) {
    if (f.has("lumens")) return wordList(f.whole("light"), f.word("lumens"), "lm");
    if (f.has("lux")) return wordList(f.whole("light"), f.word("lux"), "lx");
    return wordList(f.whole("light"), f.word("watts"));
}
Words lightSize(Fields f, const RequestSurroundings&) {
    if (f.has("radius")) return wordList(f.whole("light"), f.word("radius"));
    if (f.has("angle")) return wordList(f.whole("light"), f.word("angle"));
    return wordList(f.whole("light"), f.word("width"), f.word("height"));
}
Words lightAngles(Fields f, const RequestSurroundings&) {
    return wordList(f.whole("light"), f.word("inner"), f.word("outer"));
}

Words lightMirrored(Fields f, const RequestSurroundings&) {
    return wordList(f.whole("light"), f.onOff("on"));
}

// --- Surroundings ---

Words environment(Fields f, const RequestSurroundings&) { return wordList(f.whole("number")); }
Words degrees(Fields f, const RequestSurroundings&) { return wordList(f.word("degrees")); }
Words factor(Fields f, const RequestSurroundings&) { return wordList(f.word("factor")); }
Words onOff(Fields f, const RequestSurroundings&) { return wordList(f.onOff("on")); }
Words look(Fields f, const RequestSurroundings&) {
    return wordList(f.choice("name", {"sky", "studio", "headlight"}));
}
Words skyHour(Fields f, const RequestSurroundings&) { return wordList(f.word("hour")); }
Words skyDate(Fields f, const RequestSurroundings&) {
    const std::int64_t year = f.integer("year"), month = f.integer("month"), day = f.integer("day");
    if (year < 1800 || year > 2200 || month < 1 || month > 12 || day < 1 || day > 31)
        throw Refused("there is no such day from 1800 to 2200");
    return wordList(fmt::format("{:04}-{:02}-{:02}", year, month, day));
}
Words skyPlace(Fields f, const RequestSurroundings&) {
    return wordList(f.word("latitude"), f.word("longitude")) + ifGiven(f, "zone");
}
Words skyDirection(Fields f, const RequestSurroundings&) { return f.vector("direction"); }
Words skyTurbidity(Fields f, const RequestSurroundings&) { return wordList(f.word("turbidity")); }

// --- The model ---

Words from(Fields f, const RequestSurroundings&) {
    return f.has("from") ? wordList(f.whole("from")) : Words();
}
Words partList(Fields f, const RequestSurroundings&) {
    constexpr std::size_t kMostParts = 64;
    const nlohmann::json& parts = f.value("parts");
    if (!parts.is_array() || parts.empty() || parts.size() > kMostParts)
        throw Refused("'parts' is a list of 1 to 64 numbers");
    Words words;
    for (const nlohmann::json& each : parts)
        words.push_back(
            fmt::format("{}", std::max<std::int64_t>(0, RequestFields::integerOf(each, "parts"))));
    return words;
}
std::string materialNumber(Fields f) {
    if (f.integer("number") < 1) throw Refused("'number' is from 1");
    return f.whole("number");
}
Words material(Fields f, const RequestSurroundings&) { return wordList(materialNumber(f)); }
Words materialSet(Fields f, const RequestSurroundings&) {
    const Words start =
        wordList(materialNumber(f),
                 f.choice("key", {"diffuse", "specular", "shininess", "roughness", "metallic", "reflectivity",
                                  "fresnel", "opacity", "transmission", "attenuationDistance",
                                  "indexOfRefraction", "emission", "textures", "flipTextures"}));
    if (f.isArray("value")) return start + f.vector("value");
    if (f.value("value").is_boolean()) return start + wordList(f.boolean("value") ? "true" : "false");
    return start + wordList(f.word("value"));
}

constexpr std::array kRows{
    RequestRow{"parts", CommandId::Parts, from, true, AnswerShape::Parts},
    RequestRow{"materials", CommandId::Materials, from, true, AnswerShape::Materials},
    RequestRow{"material", CommandId::MaterialGet, material, true, AnswerShape::Material},
    RequestRow{"seen", CommandId::Seen, seen, true, AnswerShape::Seen},
    RequestRow{"camera", CommandId::CameraSet, camera},
    RequestRow{"orthographic", CommandId::CameraOrthographic, orthographic},
    RequestRow{"lookAt", CommandId::CameraLookAt, lookAt},
    RequestRow{"pivot", CommandId::CameraPivot, pivot},
    RequestRow{"orbit", CommandId::CameraOrbit, across},
    RequestRow{"pan", CommandId::CameraPan, across},
    RequestRow{"approach", CommandId::CameraApproach, factor},
    RequestRow{"fit", CommandId::CameraFit, none},
    RequestRow{"side", CommandId::CameraView, side},
    RequestRow{"reset", CommandId::CameraReset, none},
    RequestRow{"angle", CommandId::CameraAngle, degrees},
    RequestRow{"lens", CommandId::CameraLens,
               [](Fields f, const RequestSurroundings&) { return wordList(f.word("mm")); }},
    RequestRow{"zoom", CommandId::CameraZoom, factor},
    RequestRow{"focus", CommandId::Focus, seen, false, AnswerShape::Text, kFocus},
    RequestRow{"speed", CommandId::Speed, factor},
    RequestRow{"walk", CommandId::Walk, none},
    RequestRow{"fly", CommandId::Fly, none},
    RequestRow{"bookmark", CommandId::BookmarkGo, bookmark},
    RequestRow{"pause", CommandId::Pause, none},
    RequestRow{"resume", CommandId::Resume, none},
    RequestRow{"set", CommandId::Set, set},
    RequestRow{"defaults", CommandId::Defaults, defaults},
    RequestRow{"resolution", CommandId::Resolution, resolution, false, AnswerShape::Text, kSize},
    RequestRow{"bloom", CommandId::Bloom, onOff, false, AnswerShape::Text, kBloom},
    RequestRow{"undo", CommandId::Undo, none},
    RequestRow{"redo", CommandId::Redo, none},
    RequestRow{"light", CommandId::Light, light},
    RequestRow{"lightAdd", CommandId::LightAdd, lightAdd, false, AnswerShape::Light},
    RequestRow{"lightCopy", CommandId::LightCopy, lightCopy, false, AnswerShape::Light},
    RequestRow{"lightRemove", CommandId::LightRemove, lightOnly},
    RequestRow{"lightKind", CommandId::LightKind, lightKind},
    RequestRow{"lightMove", CommandId::LightMove, lightMove},
    RequestRow{"lightAim", CommandId::LightAim, lightAim},
    RequestRow{"lightColour", CommandId::LightColour, lightColour},
    RequestRow{"lightTemperature", CommandId::LightTemperature, lightTemperature},
    RequestRow{"lightPower", CommandId::LightPower, lightPower},
    RequestRow{"lightSize", CommandId::LightSize, lightSize},
    RequestRow{"lightAngles", CommandId::LightAngles, lightAngles},
    RequestRow{"lightMirrored", CommandId::LightMirrored, lightMirrored},
    RequestRow{"environment", CommandId::Environment, environment},
    RequestRow{"environmentNone", CommandId::EnvironmentNone, none},
    RequestRow{"environmentRotation", CommandId::EnvironmentRotation, degrees},
    RequestRow{"environmentStrength", CommandId::EnvironmentStrength, factor},
    RequestRow{"look", CommandId::Look, look, false, AnswerShape::Text, kLook},
    RequestRow{"sky", CommandId::Sky, onOff, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyHour", CommandId::SkyHour, skyHour, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyDate", CommandId::SkyDate, skyDate, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyPlace", CommandId::SkyPlace, skyPlace, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyNorth", CommandId::SkyNorth, degrees, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyDirection", CommandId::SkyDirection, skyDirection, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyTurbidity", CommandId::SkyTurbidity, skyTurbidity, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyStrength", CommandId::SkyStrength, factor, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyGround", CommandId::SkyGround, onOff, false, AnswerShape::Text, kFirstSky},
    RequestRow{"skyHaze", CommandId::SkyHaze, onOff, false, AnswerShape::Text, kFirstSky},
    RequestRow{"partHide", CommandId::PartHide, partList},
    RequestRow{"partShow", CommandId::PartShow, partList},
    RequestRow{"partIsolate", CommandId::PartIsolate, partList},
    RequestRow{"partShowAll", CommandId::PartShowAll, none},
    RequestRow{"materialSet", CommandId::MaterialSet, materialSet},
    RequestRow{"materialReset", CommandId::MaterialReset, material},
};

const RequestRow& rowOf(Fields fields) {
    const std::string name = fields.text("do");
    const bool noEnvironment = name == "environment" && fields.isNull("number");
    const auto* const found = std::ranges::find(
        kRows, noEnvironment ? std::string_view("environmentNone") : name, &RequestRow::name);
    if (found == kRows.end()) throw Refused("there is no such request");
    return *found;
}

/// What a page changes for all, but the way of the camera.
bool isEdit(const app::CommandSpec& spec) {
    const bool camera = spec.name.starts_with("camera ") || spec.id == CommandId::BookmarkGo;
    constexpr std::array kOthers{CommandId::Resolution, CommandId::Undo, CommandId::Redo, CommandId::Pause,
                                 CommandId::Resume};
    return (spec.edits && !camera && spec.id != CommandId::Focus) ||
           std::ranges::find(kOthers, spec.id) != kOthers.end();
}

std::string lineOf(const app::CommandSpec& spec, const Words& words) {
    const std::string arguments = app::joinWords(words);
    return std::string(spec.name) + (arguments.empty() ? "" : " ") + arguments;
}

} // namespace

PlannedCommand planRequest(const nlohmann::json& request, const RequestSurroundings& surroundings) {
    if (!request.is_object()) throw Refused("a request is an object");
    const RequestFields fields(request);
    const RequestRow& row = rowOf(fields);
    const app::CommandSpec& spec = app::commandOf(row.command);
    if (isEdit(spec) && surroundings.limits.isLocked("edits")) throw Refused("edits are locked here");
    checkLocks(row, surroundings);
    const Words words = row.words(fields, surroundings);
    try {
        app::checkArguments(spec, words);
    } catch (const app::UsageError& error) {
        throw Refused(error.what());
    }
    PlannedCommand planned{row.command, lineOf(spec, words),
                           row.anyone,  spec.edits,
                           row.shape,   row.command == CommandId::Set ? words.front() : std::string()};
    const bool also = fields.has("also") && fields.boolean("also");
    if (also && spec.edits) planned.line = "also " + planned.line;
    return planned;
}

std::vector<RequestName> requestNames() {
    std::vector<RequestName> names;
    for (const RequestRow& row : kRows) names.push_back({row.name, row.command});
    return names;
}

} // namespace bridge
