// Rows for files: scenes, recordings, images.
#include "common/commands/command_rows.h"

#include "common/cli/file_notes.h"

namespace app {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;

std::vector<CommandSpec> fileCommands() {
    return {
        {.id = CommandId::LoadCamera,
         .name = "load camera",
         .arguments = {path({"cam"})},
         .step = "camera",
         .help = "look through a .cam file"},
        {.id = CommandId::LoadScene,
         .name = "load scene",
         .arguments = {path(sceneExtensions()),
                       {.name = "CACHED-MODEL", .type = Path, .files = {"bsp"}, .optional = true}},
         .help = "show another scene or model",
         .more = "A model is imported each time, which takes longer than a `.bsp` made of it by BSPBuilder; "
                 "CACHED-MODEL is such a one, to be read in the model's place"},
        {.id = CommandId::LoadSet,
         .name = "load set",
         .arguments = {path({"set"})},
         .step = "settings",
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
         .help = "show a recorded path"},
        {.id = CommandId::PlayStop, .name = "play stop", .help = "no more of it"},
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

} // namespace app
