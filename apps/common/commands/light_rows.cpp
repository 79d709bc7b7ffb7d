// Rows for lights.
#include "common/commands/command_rows.h"

#include "rtcore/math/blackbody.h"
#include "rtcore/scene/light.h"

namespace app {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;

namespace {

/// A place: a word, and the numbers that it takes.
ArgumentList somewhere(std::string words, bool optional) {
    CommandArgument place = choice(std::move(words));
    place.optional = optional;
    return {place, maybe(number("X")), number("Y"), maybe(number("Z"))};
}

} // namespace

std::vector<CommandSpec> lightCommands() {
    return {
        {.id = CommandId::Bloom,
         .name = "bloom",
         .arguments = {choice("on|off")},
         .step = "bloom",
         .browser = BrowserUse::Edit,
         .sets = {"bloom.radius"},
         .help = "bloom around bright spots",
         .more = "As strong as it was"},
        {.id = CommandId::Light,
         .name = "light",
         .arguments = {whole("N", 1), choice("on|off|toggle")},
         .step = "light",
         .browser = BrowserUse::Edit,
         .help = "switch a light by its number, which keys have, too",
         .more = "`lights` prints the numbers. They are those of the scene's file, or the order 1, 2, 3, and "
                 "stay while other lights come and go"},
        {.id = CommandId::LightGet,
         .name = "light get",
         .arguments = {whole("N", 1)},
         .effect = Tells,
         .help = "print a light as a .scn file has it, and its power"},
        {.id = CommandId::LightAdd,
         .name = "light add",
         .arguments = ArgumentList{choiceOf(rtcore::kLightTraits, &rtcore::LightTraits::name)} +
                      somewhere("here|seen|at", true),
         .step = "add light",
         .browser = BrowserUse::Edit,
         .help = "add a light, and print its number",
         .more = "Where: `here`, at the camera; `seen`, a little off the surface in the middle of the image, "
                 "or at RIGHT and DOWN, 0 to 1; `at X Y Z`. It shines as the camera looks, off the surface, "
                 "or downwards; a directional one as the camera looks. It gives off 800 lm, and a sphere has "
                 "a radius of 6 cm. An edit of lights but for switching them ends a recording"},
        {.id = CommandId::LightCopy,
         .name = "light copy",
         .arguments = ArgumentList{whole("N", 1)} + somewhere("here|seen|at", true),
         .step = "copy light",
         .browser = BrowserUse::Edit,
         .help = "add a light like that one, in its place or elsewhere, and print its number"},
        {.id = CommandId::LightRemove,
         .name = "light remove",
         .arguments = {whole("N", 1)},
         .step = "remove light",
         .browser = BrowserUse::Edit,
         .help = "remove a light; the numbers of the others stay"},
        {.id = CommandId::LightMove,
         .name = "light move",
         .arguments = ArgumentList{whole("N", 1)} + somewhere("here|seen|at", false),
         .step = "move light",
         .browser = BrowserUse::Edit,
         .help = "put a light elsewhere",
         .more = "`light move 2 seen`: where one looks; `light move 2 at 0 3.5 -1`"},
        {.id = CommandId::LightAim,
         .name = "light aim",
         .arguments = ArgumentList{whole("N", 1)} + somewhere("ahead|seen|at|along", false),
         .step = "turn light",
         .browser = BrowserUse::Edit,
         .help = "turn a spot, a rectangle or a directional light",
         .more = "`ahead`: as the camera looks; `seen` and `at`: to that point, a directional light from the "
                 "camera to it; `along X Y Z`: into that direction"},
        {.id = CommandId::LightColour,
         .name = "light colour",
         .arguments = {whole("N", 1), number("R", 0), number("G", 0), number("B", 0)},
         .step = "colour of light",
         .browser = BrowserUse::Edit,
         .help = "colour a light, which keeps its power; linear, only their ratio counts"},
        {.id = CommandId::LightTemperature,
         .name = "light temperature",
         .arguments = {whole("N", 1),
                       orElse(number("KELVIN", rtcore::kMinTemperature, rtcore::kMaxTemperature), "none")},
         .step = "temperature of light",
         .browser = BrowserUse::Edit,
         .help = "colour a light as a black body of that temperature, which keeps its power",
         .more = "A bulb has 2700, the sun 5800"},
        {.id = CommandId::LightPower,
         .name = "light power",
         .arguments = {whole("N", 1), between("POWER", 0, kMaxNumber), maybe(choice("lm|W|lx"))},
         .step = "power of light",
         .browser = BrowserUse::Edit,
         .help =
             "all that a light gives off, lumens, or radiant watts of 683 lumens each; a directional one: "
             "lux or W/m2 on a surface that faces it",
         .more = "`light power 2 800 lm`. Without a unit it is W where lengths are scene units. Red, green "
                 "and blue are weighted as their luminance is"},
        {.id = CommandId::LightKind,
         .name = "light kind",
         .arguments = {whole("N", 1), choiceOf(rtcore::kLightTraits, &rtcore::LightTraits::name)},
         .step = "kind of light",
         .browser = BrowserUse::Edit,
         .help = "make a light one of another kind, of the same power"},
        {.id = CommandId::LightSize,
         .name = "light size",
         .arguments = {whole("N", 1), number("SIZE", 0, kMaxNumber), maybe(number("HEIGHT", 0, kMaxNumber))},
         .step = "size of light",
         .browser = BrowserUse::Edit,
         .help = "radius of a light, or width and height of a rectangle, scene units; of a directional "
                 "light the angle under which it is seen, degrees",
         .more = "The sun has 0.53: shadows get soft edges, and mirrors show its disc"},
        {.id = CommandId::LightAngles,
         .name = "light angles",
         .arguments = {whole("N", 1), number("INNER", 0, 180), number("OUTER", 0, 180)},
         .step = "angles of light",
         .browser = BrowserUse::Edit,
         .help = "where the full brightness of a spot ends, and its light; degrees from its axis"},
        {.id = CommandId::LightMirrored,
         .name = "light mirrored",
         .arguments = {whole("N", 1), choice("on|off")},
         .step = "light in mirrors",
         .browser = BrowserUse::Edit,
         .help = "whether mirrors and glass that bends show a sphere or rectangle itself"},
        {.id = CommandId::LightTurn,
         .name = "light turn",
         .arguments = {whole("N", 1), number("DEGREES", -360, 360)},
         .step = "turn light",
         .browser = BrowserUse::Edit,
         .help = "turn a rectangle or an ies light about its direction",
         .more = "Counter-clockwise, as one looks along it"},
        {.id = CommandId::LightFile,
         .name = "light file",
         .arguments = {whole("N", 1), path({"ies", "ldt"})},
         .step = "file of light",
         .help = "let a light shine as a luminaire of that IES or EULUMDAT file",
         .more = "It becomes one of the kind ies, as bright as the file says, and keeps its colour. C = 0 is "
                 "where `light turn` turns it to"},
        {.id = CommandId::LightName,
         .name = "light name",
         .arguments = {whole("N", 1), text("NAME")},
         .step = "name of light",
         .help = "name a light"},
    };
}

} // namespace app
