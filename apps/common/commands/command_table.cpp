#include "common/commands/command_table.h"

#include "common/cli/file_notes.h"

#include "rtcore/math/blackbody.h"

#include <array>
#include <utility>

namespace app {

namespace {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;
using Arguments = std::vector<CommandArgument>;

constexpr double kMostAspect = 32768; ///< an image of so many pixels by one

CommandArgument whole(std::string_view name, double minimum = -kMostWhole, double maximum = kMostWhole) {
    return {.name = name, .type = Integer, .minimum = minimum, .maximum = maximum};
}

CommandArgument number(std::string_view name, double minimum = -kMostNumber, double maximum = kMostNumber) {
    return {.name = name, .type = Number, .minimum = minimum, .maximum = maximum};
}

CommandArgument between(std::string_view name, double minimum, double maximum) {
    return {.name = name, .type = Number, .minimum = minimum, .maximum = maximum, .open = true};
}

CommandArgument choice(std::string_view words) { return {.type = Choice, .words = words}; }

CommandArgument path(std::vector<std::string> files = {}) {
    return {.name = "FILE", .type = Path, .files = std::move(files)};
}

CommandArgument text(std::string_view name, ArgumentType type = Text) { return {.name = name, .type = type}; }

CommandArgument orElse(CommandArgument argument, std::string_view words) {
    argument.words = words;
    return argument;
}

CommandArgument maybe(CommandArgument argument) {
    argument.optional = true;
    return argument;
}

CommandArgument manyOf(CommandArgument argument) {
    argument.repeats = true;
    return argument;
}

Arguments numbers(std::initializer_list<std::string_view> names) {
    Arguments all;
    for (const std::string_view name : names) all.push_back(number(name));
    return all;
}

Arguments operator+(Arguments first, const Arguments& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

CommandArgument fieldOfView() { return maybe(between("FOV", 0, 180)); }

Arguments upright() {
    return {maybe(number("UX")), number("UY"), number("UZ"),
            maybe(number("ASPECT", 1 / kMostAspect, kMostAspect))};
}

std::vector<CommandSpec> shellCommands() {
    return {
        {.id = CommandId::Status,
         .name = "status",
         .effect = Tells,
         .runner = Shell,
         .help = "what the server shows and how fast; --json for programs"},
        {.id = CommandId::Fps, .name = "fps", .effect = Tells, .runner = Shell, .help = "frames per second"},
        {.id = CommandId::Watch,
         .name = "watch",
         .effect = Tells,
         .runner = Shell,
         .help = "a line of statistics each second, until Ctrl-C"},
        {.id = CommandId::List,
         .name = "list",
         .effect = Tells,
         .runner = Shell,
         .help = "all servers of this user, and what dead ones left"},
        {.id = CommandId::Free,
         .name = "free",
         .effect = Tells,
         .runner = Shell,
         .help = "remove the shared memory that a dead server left"},
        {.id = CommandId::About,
         .name = "about",
         .effect = Tells,
         .runner = Shell,
         .help = "what this program is"},
        {.id = CommandId::Script,
         .name = "script",
         .arguments = {orElse(path(), "-")},
         .effect = Tells,
         .runner = Shell,
         .help = "run the commands of a file, or of standard input, line by line",
         .more = "`#` begins a comment. The first error ends it, with its line"},
        {.id = CommandId::Render,
         .name = "render",
         .arguments = {path(), maybe(text("--")), manyOf(text("OPTION"))},
         .effect = Tells,
         .runner = Shell,
         .help = "render what the server shows by the Renderer, which takes the options behind --",
         .more = "Its progress and its exit code are the Renderer's"},
    };
}

std::vector<CommandSpec> serverCommands() {
    return {
        {.id = CommandId::Ping,
         .name = "ping",
         .effect = Tells,
         .needsScene = false,
         .help = "does it answer?"},
        {.id = CommandId::Exit,
         .name = "exit",
         .effect = Steers,
         .needsScene = false,
         .help = "end the server, and wait until it has ended; also: quit"},
        {.id = CommandId::Quit, .name = "quit", .effect = Steers, .needsScene = false, .help = "the same"},
        {.id = CommandId::Parent,
         .name = "parent",
         .arguments = {orElse(whole("PID", 1), "none")},
         .effect = Steers,
         .needsScene = false,
         .help = "end once this process is gone and no client is connected; none: keep running in any case",
         .more = "As the option of RTServer"},
        {.id = CommandId::Pause,
         .name = "pause",
         .effect = Steers,
         .needsScene = false,
         .help = "no more frames for now"},
        {.id = CommandId::Resume,
         .name = "resume",
         .effect = Steers,
         .needsScene = false,
         .help = "frames again"},
        {.id = CommandId::Idle,
         .name = "idle",
         .arguments = {choice("on|off")},
         .effect = Steers,
         .needsScene = false,
         .help = "off: draw every frame, though it equals the last",
         .more = "For measurements"},
        {.id = CommandId::FrameTime,
         .name = "frame-time",
         .arguments = {orElse(number("MS", 0, 10000), "off")},
         .effect = Steers,
         .needsScene = false,
         .help = "after a change, draw a coarser frame at first where the whole one would take longer",
         .more = "As the option of RTServer"},
        {.id = CommandId::Messages,
         .name = "messages",
         .arguments = {maybe(whole("KNOWN", 0))},
         .effect = Tells,
         .needsScene = false,
         .help =
             "print warnings, offers and what keys did since the scene was loaded; KNOWN: after that number",
         .more = "A line each: `3 warning room.obj: the texture wall.png is missing`, `4 event light 2 off`"},
        {.id = CommandId::WaitIdle,
         .name = "wait-idle",
         .effect = Waits,
         .help = "until the next frame would equal the last"},
    };
}

std::vector<CommandSpec> settingCommands() {
    return {
        {.id = CommandId::Resolution,
         .name = "resolution",
         .arguments = {text("WIDTH"), text("HEIGHT")},
         .effect = Changes,
         .help = "pixels of a frame"},
        {.id = CommandId::Set,
         .name = "set",
         .arguments = {text("NAME", Setting), text("VALUE", SettingValue)},
         .effect = Changes,
         .edits = true,
         .help = "change a setting",
         .more = "`Renderer --settings` lists them"},
        {.id = CommandId::Get,
         .name = "get",
         .arguments = {text("NAME", Setting)},
         .effect = Tells,
         .help = "print a setting"},
        {.id = CommandId::Defaults,
         .name = "defaults",
         .edits = true,
         .help = "all settings as they are by default, but the image's size"},
        {.id = CommandId::Settings, .name = "settings", .effect = Tells, .help = "print all settings"},
        {.id = CommandId::State,
         .name = "state",
         .effect = Tells,
         .help = "print scene, camera, settings, lights and environment maps at once, for programs",
         .more = "As TOML, see [protocol.md](protocol.md)"},
    };
}

std::vector<CommandSpec> editCommands() {
    return {
        {.id = CommandId::Undo,
         .name = "undo",
         .arguments = {maybe(whole("EDIT", 1))},
         .help = "take the last edit back, whichever client or key made it, and print what it was",
         .more = "Edits are what changes settings, lights and environment, and commands that place the "
                 "camera; flying, walking and turning are none. The last 5,000 are kept until another scene "
                 "is shown, "
                 "fewer of very large scenes. EDIT, as `state` numbers them: that one or none"},
        {.id = CommandId::Redo,
         .name = "redo",
         .arguments = {maybe(whole("EDIT", 1))},
         .help = "make the edit again that was taken back"},
        {.id = CommandId::Also,
         .name = "also",
         .arguments = {text("COMMAND"), manyOf(text("ARGUMENT"))},
         .help = "run a command as part of the last edit, if that was of the same thing: one step of undo",
         .more = "`also set bloom.radius 8`: a value that follows a hand"},
        {.id = CommandId::By,
         .name = "by",
         .arguments = {whole("PERSON", 1), text("COMMAND"), manyOf(text("ARGUMENT"))},
         .help = "run an edit on behalf of one of those whom this client serves",
         .more = "For programs: `state` tells the client whose the last edit is, and another's is never "
                 "joined to it"},
    };
}

std::vector<CommandSpec> cameraCommands() {
    return {
        {.id = CommandId::CameraGet,
         .name = "camera get",
         .effect = Tells,
         .help = "print the camera, as a .cam file has it"},
        {.id = CommandId::CameraSet,
         .name = "camera set",
         .arguments = numbers({"EX", "EY", "EZ", "FX", "FY", "FZ"}) + Arguments{fieldOfView()} + upright(),
         .effect = Changes,
         .edits = true,
         .help = "look from E into the direction F, with U upwards",
         .more = "FOV, in degrees, is that of an image of that ASPECT, or of any image; with perspective. "
                 "Without FOV that stays as it is"},
        {.id = CommandId::CameraOrthographic,
         .name = "camera orthographic",
         .arguments =
             numbers({"EX", "EY", "EZ", "FX", "FY", "FZ"}) + Arguments{between("WIDTH", 0, 1e18)} + upright(),
         .effect = Changes,
         .edits = true,
         .help = "the same without perspective; WIDTH of the scene from the left edge to the right one"},
        {.id = CommandId::CameraLookAt,
         .name = "camera look-at",
         .arguments = numbers({"EX", "EY", "EZ", "TX", "TY", "TZ"}) + Arguments{fieldOfView()},
         .effect = Changes,
         .edits = true,
         .help = "look from E to the point T"},
        {.id = CommandId::CameraTurn,
         .name = "camera turn",
         .arguments = {number("RIGHT", -360, 360), number("UP", -360, 360)},
         .effect = Changes,
         .help = "turn by these angles, degrees, as the mouse does"},
        {.id = CommandId::CameraPivot,
         .name = "camera pivot",
         .arguments = {maybe(number("RIGHT", 0, 1)), maybe(number("DOWN", 0, 1))},
         .effect = Steers,
         .help = "turn about what is seen there from now on, 0..1 from the left and from the top",
         .more =
             "Without arguments, or where nothing is seen, about the middle of the model. Prints the point"},
        {.id = CommandId::CameraOrbit,
         .name = "camera orbit",
         .arguments = {number("RIGHT", -360, 360), number("UP", -180, 180)},
         .effect = Changes,
         .help = "turn the model about the pivot by these angles, degrees, as one turns a thing in the hand",
         .more = "It is the eye that moves; up stays up, and the pivot stays where it is in the image. "
                 "Walking ends"},
        {.id = CommandId::CameraPan,
         .name = "camera pan",
         .arguments = {number("RIGHT", -10, 10), number("UP", -10, 10)},
         .effect = Changes,
         .help = "move the model across the image, by these parts of its width where the pivot is"},
        {.id = CommandId::CameraApproach,
         .name = "camera approach",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .effect = Changes,
         .help = "go so many times as near to the pivot, which stays where it is in the image"},
        {.id = CommandId::CameraFit,
         .name = "camera fit",
         .arguments = {maybe(manyOf(text("PART")))},
         .effect = Changes,
         .edits = true,
         .help = "show all of the model, or of these parts, from the side where the camera is",
         .more = "PART is a number or a pattern for names, as `part hide` takes them"},
        {.id = CommandId::CameraView,
         .name = "camera view",
         .arguments = {choice("front|back|left|right|top|bottom|three-quarter")},
         .effect = Changes,
         .edits = true,
         .help = "show all of the model from that side"},
        {.id = CommandId::CameraReset,
         .name = "camera reset",
         .effect = Changes,
         .edits = true,
         .help = "look as the scene itself says, walking or not"},
        {.id = CommandId::CameraPaste,
         .name = "camera paste",
         .arguments = {text("TEXT")},
         .edits = true,
         .help = "look through a camera that is given as the text of a .cam file",
         .more = "As `load camera` does by its file"},
        {.id = CommandId::CameraAngle,
         .name = "camera angle",
         .arguments = {between("DEGREES", 0, 180)},
         .effect = Changes,
         .edits = true,
         .help = "the field of view, from the left to the right edge, with perspective"},
        {.id = CommandId::CameraLens,
         .name = "camera lens",
         .arguments = {number("MM", 0.1, 10000)},
         .effect = Changes,
         .edits = true,
         .help = "the same by the focal length of a lens for film of 36 x 24 mm",
         .more = "18 mm are 90 degrees, 50 mm 39.6"},
        {.id = CommandId::CameraZoom,
         .name = "camera zoom",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .effect = Changes,
         .edits = true,
         .help = "show what is in the middle so many times as large, from the same place",
         .more = "The field of view stays between 0.5 and 170 degrees, or where it is. Prints it then, in "
                 "degrees; without perspective, the width"},
        {.id = CommandId::Up,
         .name = "up",
         .arguments = {maybe(choice("+x|-x|+y|-y|+z|-z|auto"))},
         .effect = Changes,
         .edits = true,
         .help = "this axis of the model is up; auto: as it was guessed; print what holds now, and why",
         .more =
             "The model stays where it is: the view of one that brings no camera is found again, else the "
             "view is turned upright"},
        {.id = CommandId::Units,
         .name = "units",
         .arguments = {maybe(orElse(number("METRES", 1e-9, 1e9), "auto|mm|cm|m|in|ft"))},
         .effect = Changes,
         .edits = true,
         .help = "so long is a unit of the model; print what holds now, and why",
         .more = "Walking, flying and depth of field go by it"},
        {.id = CommandId::Focus,
         .name = "focus",
         .arguments = {number("X", 0, 1), number("Y", 0, 1)},
         .effect = Changes,
         .edits = true,
         .help = "focus a lens on what is there, 0..1 from the left and from the top, and print its distance",
         .more = "That is the setting `depthOfField.focus` then. Fails where nothing is seen"},
        {.id = CommandId::Speed,
         .name = "speed",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .effect = Changes,
         .help = "fly so many times as fast as usual",
         .more = "0.001 to 1000, until another scene is shown"},
        {.id = CommandId::Walk,
         .name = "walk",
         .effect = Changes,
         .help = "with a body, on the ground",
         .more = "From a view from outside one begins before the door or the front of the model. Fails where "
                 "there "
                 "is no room to stand and no floor below, and where the model is too small"},
        {.id = CommandId::Fly, .name = "fly", .effect = Changes, .help = "freely"},
    };
}

std::vector<CommandSpec> fileCommands() {
    return {
        {.id = CommandId::LoadCamera,
         .name = "load camera",
         .arguments = {path({"cam"})},
         .effect = Changes,
         .edits = true,
         .help = "look through a .cam file"},
        {.id = CommandId::LoadScene,
         .name = "load scene",
         .arguments = {path(sceneExtensions()),
                       {.name = "CACHED-MODEL", .type = Path, .files = {"bsp"}, .optional = true}},
         .effect = Changes,
         .help = "show another scene or model",
         .more = "A model is imported each time, which takes longer than a `.bsp` made of it by BSPBuilder; "
                 "CACHED-MODEL is such a one, to be read in the model's place"},
        {.id = CommandId::LoadSet,
         .name = "load set",
         .arguments = {path({"set"})},
         .effect = Changes,
         .edits = true,
         .help = "take the table [live] of a .set file over"},
        {.id = CommandId::Save,
         .name = "save",
         .arguments = {maybe(choice("replace"))},
         .effect = Waits,
         .help = "write what is shown into the scene's own .scn file, and print its path",
         .more =
             "Lights, materials, environment, camera, bookmarks, up axis, unit and settings; `state` says "
             "whether there is something to save. A setting that was changed holds for stills, too, the "
             "others of `[still]` stay. A file that was written or changed by hand has comments and a layout "
             "that would be lost: it is refused, and with `replace` kept as `name.scn~`, or `name.scn~2` "
             "and so on where that is taken: 99 old versions at most. The new file is for the same users as "
             "the old one. A model is no scene: `save as`"},
        {.id = CommandId::SaveAs,
         .name = "save as",
         .arguments = {path({"scn"}), maybe(choice("replace"))},
         .effect = Waits,
         .help = "the same into another .scn file, which is the scene's own from now on"},
        {.id = CommandId::Pack,
         .name = "pack",
         .arguments = {text("FOLDER", Path), maybe(choice("outside"))},
         .effect = Waits,
         .help =
             "copy the scene with all files that it needs into a new folder, which can be moved, and print "
             "how many files these are",
         .more =
             "The folder must not exist or be empty. It gets the `.scn`, the model with what it names in "
             "`model`, and `textures` and `environments` of the scene; all paths are relative. It is there "
             "with all of it, or not at all. A model that names files by absolute paths is refused. So are "
             "files that lie outside of the folder of the scene, or of a model that is shown by itself, "
             "all links followed: the answer names them, and `outside` takes them along. What is no image, "
             "and what the model is the same without, is left out and named. It is the scene of the moment "
             "at which the command came: it may be edited meanwhile, and other commands are answered. "
             "Ctrl-C gives the pack up"},
        {.id = CommandId::PackProgress,
         .name = "pack progress",
         .effect = Tells,
         .needsScene = false,
         .help = "print how much of the pack that is being made is done, or off",
         .more = "`on 37 %`. A folder of that name is `./progress`"},
        {.id = CommandId::PackStop,
         .name = "pack stop",
         .effect = Steers,
         .needsScene = false,
         .help = "give up the pack that is being made; nothing of it stays"},
        {.id = CommandId::ExportCamera,
         .name = "export camera",
         .arguments = {path({"cam"}), maybe(whole("WIDTH")), maybe(whole("HEIGHT")),
                       maybe(whole("ANTIALIASING")), maybe(whole("BLOOM"))},
         .effect = Waits,
         .help = "write the camera as a .cam file",
         .more = "It has the exposure of this moment"},
        {.id = CommandId::ExportScene,
         .name = "export scene",
         .arguments = {path({"scn"})},
         .effect = Waits,
         .help = "write a .scn file that shows the same again",
         .more = "It names the same model and spells out lights, camera and all settings. Like `screenshot` "
                 "it is refused where it would be written over a file that the scene was read from, but a "
                 "`.scn` may take the place of the scene's, a `.cam` that of the scene's camera"},
        {.id = CommandId::ExportVideoStart,
         .name = "export video start",
         .arguments = {path({"lst", "txt"}), maybe(number("FPS", 1, 240))},
         .effect = Steers,
         .help = "record the camera, 30 times a second, for 'play' and 'Renderer -l'"},
        {.id = CommandId::ExportVideo,
         .name = "export video",
         .effect = Tells,
         .help = "print whether a recording is under way, its seconds, and the last list",
         .more = "`on 12.3 /home/me/walk.lst`: for so many seconds; or `off`, with the last list"},
        {.id = CommandId::ExportVideoStop,
         .name = "export video stop",
         .arguments = {maybe(text("FILE"))},
         .effect = Steers,
         .help = "end the recording, and print its number of frames"},
        {.id = CommandId::Play,
         .name = "play",
         .arguments = {path({"lst", "txt"})},
         .effect = Changes,
         .help = "show a recorded path"},
        {.id = CommandId::PlayStop, .name = "play stop", .effect = Changes, .help = "no more of it"},
        {.id = CommandId::Screenshot,
         .name = "screenshot",
         .arguments = {path()},
         .effect = Waits,
         .help = "write the live frame; the extension says the format",
         .more = "It is the server's, by Whitted's rays: not what a window renders of it at rest, which F12 "
                 "there writes. `.exr`, `.hdr` and `.pfm` hold linear radiance. The answer says what was "
                 "written: \"live frame, 640 x 480\""},
    };
}

constexpr std::string_view kLightKinds = "point|directional|spot|sphere|rectangle";

/// A place: a word, and the numbers that it takes.
Arguments somewhere(std::string_view words, bool optional) {
    CommandArgument place = choice(words);
    place.optional = optional;
    return {place, maybe(number("X")), number("Y"), maybe(number("Z"))};
}

std::vector<CommandSpec> lightCommands() {
    return {
        {.id = CommandId::Bloom,
         .name = "bloom",
         .arguments = {choice("on|off")},
         .effect = Changes,
         .edits = true,
         .help = "bloom around bright spots",
         .more = "As strong as it was"},
        {.id = CommandId::Light,
         .name = "light",
         .arguments = {whole("N", 1), choice("on|off|toggle")},
         .effect = Changes,
         .edits = true,
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
         .arguments = Arguments{choice(kLightKinds)} + somewhere("here|seen|at", true),
         .effect = Changes,
         .edits = true,
         .help = "add a light, and print its number",
         .more = "Where: `here`, at the camera; `seen`, a little off the surface in the middle of the image, "
                 "or at RIGHT and DOWN, 0 to 1; `at X Y Z`. It shines as the camera looks, off the surface, "
                 "or downwards; a directional one as the camera looks. It gives off 800 lm, and a sphere has "
                 "a radius of 6 cm. An edit of lights but for switching them ends a recording"},
        {.id = CommandId::LightCopy,
         .name = "light copy",
         .arguments = Arguments{whole("N", 1)} + somewhere("here|seen|at", true),
         .effect = Changes,
         .edits = true,
         .help = "add a light like that one, in its place or elsewhere, and print its number"},
        {.id = CommandId::LightRemove,
         .name = "light remove",
         .arguments = {whole("N", 1)},
         .effect = Changes,
         .edits = true,
         .help = "remove a light; the numbers of the others stay"},
        {.id = CommandId::LightMove,
         .name = "light move",
         .arguments = Arguments{whole("N", 1)} + somewhere("here|seen|at", false),
         .effect = Changes,
         .edits = true,
         .help = "put a light elsewhere",
         .more = "`light move 2 seen`: where one looks; `light move 2 at 0 3.5 -1`"},
        {.id = CommandId::LightAim,
         .name = "light aim",
         .arguments = Arguments{whole("N", 1)} + somewhere("ahead|seen|at|along", false),
         .effect = Changes,
         .edits = true,
         .help = "turn a spot, a rectangle or a directional light",
         .more = "`ahead`: as the camera looks; `seen` and `at`: to that point, a directional light from the "
                 "camera to it; `along X Y Z`: into that direction"},
        {.id = CommandId::LightColour,
         .name = "light colour",
         .arguments = {whole("N", 1), number("R", 0), number("G", 0), number("B", 0)},
         .effect = Changes,
         .edits = true,
         .help = "colour a light, which keeps its power; linear, only their ratio counts"},
        {.id = CommandId::LightTemperature,
         .name = "light temperature",
         .arguments = {whole("N", 1),
                       orElse(number("KELVIN", rtcore::kLeastTemperature, rtcore::kMostTemperature), "none")},
         .effect = Changes,
         .edits = true,
         .help = "colour a light as a black body of that temperature, which keeps its power",
         .more = "A bulb has 2700, the sun 5800"},
        {.id = CommandId::LightPower,
         .name = "light power",
         .arguments = {whole("N", 1), between("POWER", 0, kMostNumber), maybe(choice("lm|W|lx"))},
         .effect = Changes,
         .edits = true,
         .help =
             "all that a light gives off, lumens, or radiant watts of 683 lumens each; a directional one: "
             "lux or W/m2 on a surface that faces it",
         .more = "`light power 2 800 lm`. Without a unit it is W where lengths are scene units. Red, green "
                 "and blue are weighted as their luminance is"},
        {.id = CommandId::LightKind,
         .name = "light kind",
         .arguments = {whole("N", 1), choice(kLightKinds)},
         .effect = Changes,
         .edits = true,
         .help = "make a light one of another kind, of the same power"},
        {.id = CommandId::LightSize,
         .name = "light size",
         .arguments = {whole("N", 1), number("SIZE", 0, kMostNumber),
                       maybe(number("HEIGHT", 0, kMostNumber))},
         .effect = Changes,
         .edits = true,
         .help = "radius of a light, or width and height of a rectangle, scene units; of a directional "
                 "light the angle under which it is seen, degrees",
         .more = "The sun has 0.53: shadows get soft edges, and mirrors show its disc"},
        {.id = CommandId::LightAngles,
         .name = "light angles",
         .arguments = {whole("N", 1), number("INNER", 0, 180), number("OUTER", 0, 180)},
         .effect = Changes,
         .edits = true,
         .help = "where the full brightness of a spot ends, and its light; degrees from its axis"},
        {.id = CommandId::LightMirrored,
         .name = "light mirrored",
         .arguments = {whole("N", 1), choice("on|off")},
         .effect = Changes,
         .edits = true,
         .help = "whether mirrors and glass that bends show a sphere or rectangle itself"},
        {.id = CommandId::LightName,
         .name = "light name",
         .arguments = {whole("N", 1), text("NAME")},
         .effect = Changes,
         .edits = true,
         .help = "name a light"},
        {.id = CommandId::Environment,
         .name = "environment",
         .arguments = {whole("N", 1)},
         .effect = Changes,
         .edits = true,
         .help = "choose an environment map; the first one is 1"},
        {.id = CommandId::EnvironmentOpen,
         .name = "environment open",
         .arguments = {path({"hdr", "exr", "pfm", "png", "jpg"})},
         .edits = true,
         .help = "show an environment map and let it light the scene, in place of a sky",
         .more = "Twice as wide as high, or a cross or a strip of six squares"},
        {.id = CommandId::EnvironmentNone,
         .name = "environment none",
         .edits = true,
         .help = "neither environment map nor sky"},
        {.id = CommandId::EnvironmentRotation,
         .name = "environment rotation",
         .arguments = {number("DEGREES", -360, 360)},
         .edits = true,
         .help = "turn the environment map that is shown, to the right about the up axis"},
        {.id = CommandId::EnvironmentStrength,
         .name = "environment strength",
         .arguments = {number("FACTOR", 0, 1e6)},
         .edits = true,
         .help = "how bright it is; 1 is as its file says"},
        {.id = CommandId::Sky,
         .name = "sky",
         .arguments = {choice("on|off")},
         .edits = true,
         .help = "a computed sky with a sun",
         .more = "Each command below switches it on, too. Scene files have it as `[sky]`, see "
                 "[formats.md](formats.md)"},
        {.id = CommandId::SkyHour,
         .name = "sky hour",
         .arguments = {number("HOUR", 0, 24)},
         .edits = true,
         .help = "the time on the clock there: 17.5 is half past five"},
        {.id = CommandId::SkyDate,
         .name = "sky date",
         .arguments = {text("DATE")},
         .edits = true,
         .help = "the day, such as 2026-06-21"},
        {.id = CommandId::SkyPlace,
         .name = "sky place",
         .arguments = {number("LATITUDE", -90, 90), number("LONGITUDE", -180, 180),
                       maybe(number("ZONE", -15, 15))},
         .edits = true,
         .help = "degrees north and east; ZONE: hours that the clock is ahead of universal time"},
        {.id = CommandId::SkyNorth,
         .name = "sky north",
         .arguments = {number("DEGREES", -360, 360)},
         .edits = true,
         .help = "where north is: degrees from straight ahead to the right"},
        {.id = CommandId::SkyDirection,
         .name = "sky direction",
         .arguments = numbers({"X", "Y", "Z"}),
         .edits = true,
         .help = "where the sun is, in place of date and place"},
        {.id = CommandId::SkyTurbidity,
         .name = "sky turbidity",
         .arguments = {number("T", 2, 10)},
         .edits = true,
         .help = "haze: 2 very clear, 3 clear, 6 hazy, 10 thick"},
        {.id = CommandId::SkyStrength,
         .name = "sky strength",
         .arguments = {number("FACTOR", 0, 1e6)},
         .edits = true,
         .help = "factor on sun and sky, or on the walls of a studio"},
        {.id = CommandId::SkyGround,
         .name = "sky ground",
         .arguments = {choice("on|off")},
         .edits = true,
         .help = "a wide ground below the model, which takes its shadow"},
        {.id = CommandId::SkyHaze,
         .name = "sky haze",
         .arguments = {choice("on|off")},
         .edits = true,
         .help = "white at the horizon, into which a light ground fades"},
        {.id = CommandId::Look,
         .name = "look",
         .arguments = {choice("sky|studio|headlight")},
         .edits = true,
         .help = "light the scene so, in place of its lights, its sky and its environment map",
         .more = "As the option `--look` does, for what is seen now"},
        {.id = CommandId::Lights,
         .name = "lights",
         .effect = Tells,
         .help = "print the lights: number, on or off, name",
         .more = "A line each: `2 on chandelier`; the name may be missing"},
        {.id = CommandId::Environments,
         .name = "environments",
         .effect = Tells,
         .help = "print the environment maps: number, active or -, name",
         .more = "A line each: `1 active sunset`"},
        {.id = CommandId::Scene, .name = "scene", .effect = Tells, .help = "print the path of the scene"},
    };
}

std::vector<CommandSpec> bookmarkCommands() {
    return {
        {.id = CommandId::Bookmarks,
         .name = "bookmarks",
         .effect = Tells,
         .help = "print the names of the scene's bookmarks, a line each",
         .more = "Those of its file and those that were added; `save` writes them"},
        {.id = CommandId::BookmarkAdd,
         .name = "bookmark add",
         .arguments = {text("NAME"), {.name = "FILE", .type = Path, .files = {"cam"}, .optional = true}},
         .edits = true,
         .help = "keep the view, or that of a .cam file, under a name; one of that name is replaced"},
        {.id = CommandId::BookmarkGo,
         .name = "bookmark go",
         .arguments = {text("NAME")},
         .edits = true,
         .help = "look through a bookmark of the scene"},
        {.id = CommandId::BookmarkRename,
         .name = "bookmark rename",
         .arguments = {text("NAME"), text("NEW")},
         .edits = true,
         .help = "give a bookmark of the scene another name"},
        {.id = CommandId::BookmarkRemove,
         .name = "bookmark remove",
         .arguments = {text("NAME")},
         .edits = true,
         .help = "remove a bookmark from the scene"},
    };
}

std::vector<CommandSpec> modelCommands() {
    const CommandArgument material = text("MATERIAL"), part = text("PART");
    const CommandArgument from = maybe(whole("FROM", 1));
    return {
        {.id = CommandId::Materials,
         .name = "materials",
         .arguments = {from},
         .effect = Tells,
         .help = "print the model's materials: number, edited or -, name; those from number FROM on",
         .more = "A line each: `3 edited glass`; the name may be missing. As many as an answer has room for"},
        {.id = CommandId::MaterialGet,
         .name = "material get",
         .arguments = {material},
         .effect = Tells,
         .help = "print a material as it is shown, as a [[material]] of a .scn file says it",
         .more = "MATERIAL is a number, or a name or pattern as in a `[[material]]`; the first that fits"},
        {.id = CommandId::MaterialSet,
         .name = "material set",
         .arguments = {material, text("KEY"), text("VALUE"), manyOf(text("VALUE"))},
         .effect = Changes,
         .edits = true,
         .help = "change a material, by the keys of a [[material]]",
         .more = "`material set floor diffuse 0.5 0.4 0.3`, `material set 3 roughness 0.2`, `material set "
                 "glass* opacity 0.1`, `material set wall textures false`. All materials that fit"},
        {.id = CommandId::MaterialReset,
         .name = "material reset",
         .arguments = {material},
         .effect = Changes,
         .edits = true,
         .help = "take all edits of a material back: it is what the files say"},
        {.id = CommandId::Parts,
         .name = "parts",
         .arguments = {from},
         .effect = Tells,
         .help =
             "print the model's parts: number, shown or hidden, triangles, name; those from number FROM on",
         .more =
             "A line each: `12 shown 480 house/door`; parts of parts have slashes between their names. As "
             "many as an answer has room for"},
        {.id = CommandId::PartHide,
         .name = "part hide",
         .arguments = {part, manyOf(part)},
         .effect = Changes,
         .edits = true,
         .help = "hide parts: rays and bodies pass through them",
         .more = "PART is a number or a pattern for names: `part hide 'house/roof*'`"},
        {.id = CommandId::PartShow,
         .name = "part show",
         .arguments = {part, manyOf(part)},
         .effect = Changes,
         .edits = true,
         .help = "show hidden parts again"},
        {.id = CommandId::PartIsolate,
         .name = "part isolate",
         .arguments = {part, manyOf(part)},
         .effect = Changes,
         .edits = true,
         .help = "show these parts, hide all others"},
        {.id = CommandId::PartShowAll,
         .name = "part show-all",
         .effect = Changes,
         .edits = true,
         .help = "show all parts"},
        {.id = CommandId::Seen,
         .name = "seen",
         .arguments = {number("X", 0, 1), number("Y", 0, 1)},
         .effect = Tells,
         .help = "print which part and which material are seen there, 0..1 from the left and from the top",
         .more = "Two lines, `part 12 house/door` and `material 3 oak`. Fails where nothing is seen"},
        {.id = CommandId::Mask,
         .name = "mask",
         .arguments = {choice("part|material"), whole("N", 1)},
         .effect = Tells,
         .help = "print where a part or a material is seen, for programs",
         .more = "Width and height of a coarse image, then lengths of runs of its pixels from the upper left "
                 "corner on, without and with it by turns"},
    };
}

std::vector<CommandSpec> keyCommands() {
    return {
        {.id = CommandId::KeyPress,
         .name = "key press",
         .arguments = {text("KEY", Key), maybe(whole("MS", 1, 3'600'000))},
         .effect = Changes,
         .help = "hold a key down until it is released; with MS, or --for=MS, wait so long and release it",
         .more = "So many milliseconds of the server's motion, to the step of 1/120 s, whatever the rate of "
                 "frames. Keys of the server's own: `w`, `7`, `space`, `left`, `right`, `up`, `down`, "
                 "`pageup`, `pagedown`, `shift`, `control`, `capslock` and others"},
        {.id = CommandId::KeyRelease,
         .name = "key release",
         .arguments = {orElse(text("KEY", Key), "all")},
         .effect = Changes,
         .help = "release it"},
        {.id = CommandId::KeyTap,
         .name = "key tap",
         .arguments = {text("KEY", Key)},
         .effect = Changes,
         .help = "press and release it"},
        {.id = CommandId::Bindings,
         .name = "bindings",
         .effect = Tells,
         .help = "what the keys do",
         .more = "A line each: `W forward`, `M+3 selectEnvironment 3`"},
        {.id = CommandId::BindingsDefault,
         .name = "bindings default",
         .effect = Steers,
         .help = "what they do by default again"},
        {.id = CommandId::Bind,
         .name = "bind",
         .arguments = {orElse(text("KEY", Key), "KEY+KEY"), text("ACTION", Action), maybe(whole("N", 1))},
         .effect = Steers,
         .help = "let a key do something else; 'bindings' shows the actions",
         .more = "`bind k jump`, `bind M+k toggleLight 2`"},
        {.id = CommandId::Unbind,
         .name = "unbind",
         .arguments = {orElse(text("KEY", Key), "KEY+KEY")},
         .effect = Steers,
         .help = "let it do nothing"},
    };
}

} // namespace

std::span<const CommandSpec> commandTable() {
    static const std::vector<CommandSpec> table = [] {
        std::vector<CommandSpec> all;
        for (const auto& group :
             {shellCommands(), serverCommands(), settingCommands(), editCommands(), cameraCommands(),
              fileCommands(), lightCommands(), bookmarkCommands(), modelCommands(), keyCommands()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return table;
}

const CommandSpec& commandOf(CommandId id) { return commandTable()[static_cast<std::size_t>(id)]; }

} // namespace app
