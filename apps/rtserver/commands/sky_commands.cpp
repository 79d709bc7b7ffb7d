// Commands for the sky and for what environments look like.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/sky_edits.h"

#include "rtcore/io/images/environment_file.h"
#include "rtcore/io/text/sun_date.h"
#include "rtcore/look/lighting_preset.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/sky/scene_sky.h"

#include "common/cli/command_line.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

/// With the sky or the studio that the scene has, or a usual sky, changed; it lights from then on.
template <typename Change>
Result editLighting(const Call& call, Change change) {
    rtcore::Sky sky = call.document().scene()->sky.value_or(rtcore::Sky{.haze = true});
    change(sky);
    setSky(call.document(), sky);
    return {};
}

/// A usual sky in place of a studio.
template <typename Change>
Result editSky(const Call& call, Change change) {
    return editLighting(call, [&](rtcore::Sky& sky) {
        if (sky.studio) sky = {.strength = sky.strength, .ground = sky.ground, .haze = true};
        change(sky);
    });
}

rtcore::SunDate& dateOf(rtcore::Sky& sky) {
    if (!sky.date) sky.date.emplace();
    return *sky.date;
}

Result skySwitch(const Call& call) {
    if (flag(call[0])) return editSky(call, [](rtcore::Sky&) {});
    setSky(call.document(), std::nullopt);
    return {};
}

Result skyHour(const Call& call) {
    return editSky(
        call, [&](rtcore::Sky& sky) { dateOf(sky).second = rtcore::secondOfHour(preciseNumber(call[0])); });
}

Result skyDate(const Call& call) {
    const auto day = rtcore::calendarDateOf(call[0]);
    if (!day)
        throw app::UsageError(
            rtcore::say("'{0}' is no day from 1800 to 2200 such as {1}", call[0], std::string("2026-06-21")));
    return editSky(call, [&](rtcore::Sky& sky) {
        rtcore::SunDate& date = dateOf(sky);
        date.year = day->year;
        date.month = day->month;
        date.day = day->day;
    });
}

Result skyPlace(const Call& call) {
    return editSky(call, [&](rtcore::Sky& sky) {
        rtcore::SunDate& date = dateOf(sky);
        date.latitude = preciseNumber(call[0]);
        date.longitude = preciseNumber(call[1]);
        if (call.size() > 2) date.timeZone = preciseNumber(call[2]);
    });
}

Result skyNorth(const Call& call) {
    return editSky(call, [&](rtcore::Sky& sky) { sky.north = number(call[0]); });
}

Result skyDirection(const Call& call) {
    const rtcore::Vec3 direction{number(call[0]), number(call[1]), number(call[2])};
    if (normalize(direction) == rtcore::Vec3{}) throw app::UsageError("the direction to the sun is not zero");
    return editSky(call, [&](rtcore::Sky& sky) {
        sky.date.reset();
        sky.direction = direction;
    });
}

Result skyTurbidity(const Call& call) {
    return editSky(call, [&](rtcore::Sky& sky) { sky.turbidity = number(call[0]); });
}

Result skyStrength(const Call& call) {
    return editLighting(call, [&](rtcore::Sky& sky) { sky.strength = number(call[0]); });
}

Result skyGround(const Call& call) {
    return editLighting(call, [&](rtcore::Sky& sky) { sky.ground = flag(call[0]); });
}

Result skyHaze(const Call& call) {
    return editSky(call, [&](rtcore::Sky& sky) { sky.haze = flag(call[0]); });
}

Result look(const Call& call) {
    setLightingPreset(call.document(), *rtcore::lightingPresetNamed(call[0]));
    return {};
}

Result environmentRotation(const Call& call) {
    rotateEnvironment(call.document(), number(call[0]));
    return {};
}

Result environmentStrength(const Call& call) {
    scaleEnvironment(call.document(), number(call[0]));
    return {};
}

Result environmentOpen(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), &document = call.document()]() -> Finish {
                auto opened = std::make_shared<rtcore::OpenedEnvironment>(rtcore::openEnvironment(path));
                return [opened, &document] {
                    addEnvironment(document, opened->file, std::move(opened->environment));
                    return std::string();
                };
            }};
}

Result environmentNone(const Call& call) {
    leaveEnvironment(call.document());
    return {};
}

constexpr std::array kSkyFunctions{
    CommandFunction{app::CommandId::Sky, skySwitch},
    CommandFunction{app::CommandId::SkyHour, skyHour},
    CommandFunction{app::CommandId::SkyDate, skyDate},
    CommandFunction{app::CommandId::SkyPlace, skyPlace},
    CommandFunction{app::CommandId::SkyNorth, skyNorth},
    CommandFunction{app::CommandId::SkyDirection, skyDirection},
    CommandFunction{app::CommandId::SkyTurbidity, skyTurbidity},
    CommandFunction{app::CommandId::SkyStrength, skyStrength},
    CommandFunction{app::CommandId::SkyGround, skyGround},
    CommandFunction{app::CommandId::SkyHaze, skyHaze},
    CommandFunction{app::CommandId::Look, look},
    CommandFunction{app::CommandId::EnvironmentRotation, environmentRotation},
    CommandFunction{app::CommandId::EnvironmentStrength, environmentStrength},
    CommandFunction{app::CommandId::EnvironmentOpen, environmentOpen},
    CommandFunction{app::CommandId::EnvironmentNone, environmentNone},
};

} // namespace

std::span<const CommandFunction> skyFunctions() { return kSkyFunctions; }

} // namespace rtserver
