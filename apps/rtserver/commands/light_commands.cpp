// Commands for lights: switching, adding and changing them.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/seen_surface.h"
#include "rtserver/commands/state_report_of.h"
#include "rtserver/document/light_edits.h"
#include "rtserver/document/light_list.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

using rtcore::LightDescription;
using rtcore::Vec3;

Result switchOne(const Call& call) {
    const bool toggle = call[1] == "toggle";
    switchLight(call.document(), integer(call[0]), toggle ? std::nullopt : std::optional(flag(call[1])));
    return {};
}

Result listLights(const Call& call) {
    std::string text;
    for (const app::ReportedLight& light : lightsOf(call.document()))
        text += fmt::format("{}{} {}{}{}", text.empty() ? "" : "\n", light.id, light.on ? "on" : "off",
                            light.name.empty() ? "" : " ", rtcore::printable(light.name));
    return {.answer = std::move(text)};
}

Result describe(const Call& call) {
    const rtcore::Scene& scene = *call.document().scene();
    LightDescription light =
        rtcore::describeLight(scene, lightOf(*call.document().scene(), integer(call[0])));
    if (rtcore::findInvalidUtf8(light.name) != std::string::npos) light.name = rtcore::printable(light.name);
    const std::filesystem::path file = std::exchange(light.file, {});
    rtcore::TomlWriter writer;
    rtcore::writeLight(writer, light, {}, scene.origin);
    // Whole: who asks may be in another folder.
    if (!file.empty()) writer.add("file", rtcore::printable(rtcore::pathToUtf8(rtcore::plainPath(file))));
    const bool placed = traitsOf(light.light).position;
    const double watts =
        rtcore::radiantWatts(light.light, double{powerOf(light)}, double{scene.metresPerUnit});
    return {.answer = writer.text() + fmt::format("# {:.6g} {}, {:.6g} {}", watts, placed ? "W" : "W/m2",
                                                  watts * rtcore::kLumensPerWatt, placed ? "lm" : "lx")};
}

// --- Places ---

/// A guessed unit counts only where it makes the model as large as a place that electric lights light.
std::optional<float> unitForLights(const rtcore::ModelUnits& units, float diagonal) {
    constexpr float kSmallest = 1, kLargest = 10'000; // m
    const float metres = diagonal * units.metresPerUnit;
    const bool counts =
        units.unitSaid != rtcore::Said::Guessed || (metres >= kSmallest && metres <= kLargest);
    return counts ? std::optional(units.metresPerUnit) : std::nullopt;
}

SceneExtent sceneExtentOf(const Document& document) {
    const rtcore::Box3 bounds = document.world().loaded.tree.bounds;
    const float size = bounds.diagonal();
    return {bounds.centre(), size > 0 ? size : 1, -document.scene()->up,
            unitForLights(document.modelUnits(), size)};
}

rtcore::LightKind kindOf(const std::string& name) {
    const auto row = std::ranges::find(rtcore::kLightTraits, name, &rtcore::LightTraits::name);
    return static_cast<rtcore::LightKind>(row - rtcore::kLightTraits.begin());
}

/// The words from `first` on: a place and the numbers behind it.
class Place {
  public:
    Place(const Call& call, std::size_t first) : call_(call), word_(call[first]), first_(first + 1) {
        const std::size_t numbers = call.size() - first_;
        const bool fits = word_ == "seen"                     ? numbers == 0 || numbers == 2
                          : word_ == "at" || word_ == "along" ? numbers == 3
                                                              : numbers == 0;
        if (!fits)
            throw app::UsageError(rtcore::say(word_ == "seen" ? "{0} takes nothing, or RIGHT and DOWN"
                                              : word_ == "at" || word_ == "along" ? "{0} takes three numbers"
                                                                                  : "{0} takes no numbers",
                                              word_));
    }

    const std::string& word() const { return word_; }
    Vec3 vector() const { return vectorAt(call_, first_); }
    Vec3 position() const { return positionAt(call_, first_); }
    /// Throws std::runtime_error where nothing is.
    SeenSurface surface() const {
        const auto fraction = [&](std::size_t i) {
            const float value = number(call_[i]);
            if (!(value >= 0 && value <= 1))
                throw app::UsageError(rtcore::say("seen takes numbers from 0 to 1, not '{0}'", call_[i]));
            return value;
        };
        const bool given = call_.size() > first_;
        const auto surface = given ? surfaceAt(call_.document(), fraction(first_), fraction(first_ + 1))
                                   : surfaceAt(call_.document(), 0.5F, 0.5F);
        if (!surface) throw rtcore::Refusal("there is no surface there; the light stays as it was");
        return *surface;
    }

  private:
    const Call& call_;
    const std::string& word_;
    std::size_t first_;
};

/// A little off the surface, so that the light falls on it.
Vec3 before(const SeenSurface& surface, const SceneExtent& extent) {
    constexpr float kOfSize = 0.02F, kOfDistance = 0.1F;
    return surface.position +
           surface.normal * std::fmin(kOfSize * extent.size, kOfDistance * surface.distance);
}

LightPlace placeOf(const Call& call, std::size_t first) {
    const SceneExtent extent = sceneExtentOf(call.document());
    const rtcore::Camera& camera = call.document().camera();
    if (call.size() <= first) {
        const auto surface = surfaceAt(call.document(), 0.5F, 0.5F);
        return surface ? LightPlace{before(*surface, extent), extent.downwards}
                       : LightPlace{camera.eye, camera.forward};
    }
    const Place place(call, first);
    if (place.word() == "at") return {place.position(), extent.downwards};
    if (place.word() == "here") return {camera.eye, camera.forward};
    const SeenSurface surface = place.surface();
    return {before(surface, extent), surface.normal};
}

// --- Lights ---

template <typename Change>
Result change(const Call& call, Change&& apply) {
    changeLight(call.document(), integer(call[0]), apply);
    return {};
}

Result add(const Call& call) {
    const rtcore::LightKind kind = kindOf(call[0]);
    LightPlace place = placeOf(call, 1);
    if (!rtcore::traitsOf(kind).position) place.direction = call.document().camera().forward;
    const int id = addLight(call.document(), newLight(kind, place, sceneExtentOf(call.document())));
    return {.answer = std::to_string(id)};
}

Result copy(const Call& call) {
    LightDescription light =
        rtcore::describeLight(*call.document().scene(), lightOf(*call.document().scene(), integer(call[0])));
    if (call.size() > 1) setPosition(light, placeOf(call, 1).position);
    return {.answer = std::to_string(addLight(call.document(), std::move(light)))};
}

Result remove(const Call& call) {
    removeLight(call.document(), integer(call[0]));
    return {};
}

Result moveTo(const Call& call) {
    return change(call, [&](LightDescription& light) { setPosition(light, placeOf(call, 1).position); });
}

Result aim(const Call& call) {
    const Place place(call, 1);
    return change(call, [&](LightDescription& light) {
        if (place.word() == "ahead") return setDirection(light, call.document().camera().forward);
        if (place.word() == "along") return setDirection(light, place.vector());
        const Vec3 target = place.word() == "at" ? place.position() : place.surface().position;
        const bool far = !traitsOf(light.light).position;
        setDirection(light, target - (far ? call.document().camera().eye : light.light.position));
    });
}

Result colour(const Call& call) {
    return change(call, [&](LightDescription& light) {
        setColour(light, {number(call[1]), number(call[2]), number(call[3])});
    });
}

Result temperature(const Call& call) {
    return change(call, [&](LightDescription& light) {
        setTemperature(light, call[1] == "none" ? std::nullopt : std::optional(number(call[1])));
    });
}

/// As powerOf() counts it.
float powerOfWords(const Call& call, const rtcore::Light& light) {
    const double value = preciseNumber(call[1]);
    if (call.size() < 3) return static_cast<float>(value);
    const std::string& unit = call[2];
    const bool placed = traitsOf(light).position;
    if (unit == (placed ? "lx" : "lm"))
        throw rtcore::BadValue(placed ? "lx is for directional lights; others give off lm or W"
                                      : "a directional light has no lm; give lx, or W for W/m2");
    const double watts = unit == "W" ? value : value / rtcore::kLumensPerWatt;
    return static_cast<float>(
        rtcore::powerOfWatts(light, watts, double{call.document().scene()->metresPerUnit}));
}

Result power(const Call& call) {
    return change(call, [&](LightDescription& light) { setPower(light, powerOfWords(call, light.light)); });
}

Result kind(const Call& call) {
    return change(call, [&](LightDescription& light) {
        setKind(light, kindOf(call[1]), sceneExtentOf(call.document()));
    });
}

Result size(const Call& call) {
    return change(call, [&](LightDescription& light) {
        setSize(light, preciseNumber(call[1]),
                call.size() > 2 ? std::optional(preciseNumber(call[2])) : std::nullopt);
    });
}

Result angles(const Call& call) {
    return change(call, [&](LightDescription& light) { setAngles(light, number(call[1]), number(call[2])); });
}

Result mirrored(const Call& call) {
    return change(call, [&](LightDescription& light) { setMirrored(light, flag(call[1])); });
}

Result turn(const Call& call) {
    return change(call, [&](LightDescription& light) { setTurn(light, preciseNumber(call[1])); });
}

Result takeFile(const Call& call) {
    std::vector<rtcore::Sentence> warnings;
    const Document& document = call.document();
    change(call, [&](LightDescription& light) {
        setFile(light, pathOf(call[1]), sceneExtentOf(document), document.scene()->metresPerUnit, warnings);
    });
    if (warnings.empty()) return {};
    const Answer told = warningAnswer(warnings.front());
    return {.answer = told.text, .detail = told.detail};
}

Result rename(const Call& call) {
    if (rtcore::findInvalidUtf8(call[1]) != std::string::npos)
        throw rtcore::BadValue("the name of a light is a text in UTF-8");
    return change(call, [&](LightDescription& light) { light.name = call[1]; });
}

constexpr std::array kLightFunctions{
    CommandFunction{app::CommandId::Light, switchOne},
    CommandFunction{app::CommandId::LightGet, describe},
    CommandFunction{app::CommandId::LightAdd, add},
    CommandFunction{app::CommandId::LightCopy, copy},
    CommandFunction{app::CommandId::LightRemove, remove},
    CommandFunction{app::CommandId::LightMove, moveTo},
    CommandFunction{app::CommandId::LightAim, aim},
    CommandFunction{app::CommandId::LightColour, colour},
    CommandFunction{app::CommandId::LightTemperature, temperature},
    CommandFunction{app::CommandId::LightPower, power},
    CommandFunction{app::CommandId::LightKind, kind},
    CommandFunction{app::CommandId::LightSize, size},
    CommandFunction{app::CommandId::LightAngles, angles},
    CommandFunction{app::CommandId::LightMirrored, mirrored},
    CommandFunction{app::CommandId::LightTurn, turn},
    CommandFunction{app::CommandId::LightFile, takeFile},
    CommandFunction{app::CommandId::LightName, rename},
    CommandFunction{app::CommandId::Lights, listLights},
};

} // namespace

std::span<const CommandFunction> lightFunctions() { return kLightFunctions; }

} // namespace rtserver
