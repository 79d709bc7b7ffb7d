// Rows for the server itself, its settings and its keys, and for what CUI does itself.
#include "common/commands/command_rows.h"

#include "ipc/layout/limits.h"

#include "rtcore/settings/quality.h"

namespace app {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;

namespace {

CommandArgument side(std::string_view name) { return whole(name, 1, ipc::kMaxFrameSide); }

std::vector<std::string_view> settingsOfQualities() {
    std::vector<std::string_view> names;
    for (const rtcore::QualityRow& row : rtcore::qualityTable()) names.push_back(row.setting);
    return names;
}

} // namespace

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
         .browser = BrowserUse::Edit,
         .needsScene = false,
         .help = "no more frames for now"},
        {.id = CommandId::Resume,
         .name = "resume",
         .effect = Steers,
         .browser = BrowserUse::Edit,
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
        {.id = CommandId::RestLight,
         .name = "rest-light",
         .arguments = {choice("view|walk")},
         .effect = Steers,
         .needsScene = false,
         .help = "the indirect light of whole frames: learned for the view alone, as Renderer does, or "
                 "what the walk has learned",
         .more =
             "The second is there at once, for clients that refine what rests with another program. Frames "
             "that a command writes to a file have the first"},
        {.id = CommandId::Messages,
         .name = "messages",
         .arguments = {maybe(whole("KNOWN", 0))},
         .effect = Tells,
         .browser = BrowserUse::Own,
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
         .arguments = {side("WIDTH"), side("HEIGHT")},
         .browser = BrowserUse::Edit,
         .sets = {"width", "height"},
         .help = "pixels of a frame"},
        {.id = CommandId::Set,
         .name = "set",
         .arguments = {text("NAME", Setting), text("VALUE", SettingValue)},
         .step = "setting",
         .browser = BrowserUse::Edit,
         .help = "change a setting",
         .more = "`Renderer --settings` lists them"},
        {.id = CommandId::Get,
         .name = "get",
         .arguments = {text("NAME", Setting)},
         .effect = Tells,
         .help = "print a setting"},
        {.id = CommandId::Defaults,
         .name = "defaults",
         .step = "defaults",
         .browser = BrowserUse::Edit,
         .help = "all settings as they are by default, but the image's size"},
        {.id = CommandId::Quality,
         .name = "quality",
         .arguments = {maybe(choiceOf(rtcore::kQualityNames))},
         .step = "quality",
         .browser = BrowserUse::Edit,
         .sets = settingsOfQualities(),
         .help = "set how much work an image may be; print what holds now",
         .more =
             "A group of settings at once: samples, rays and bounces. Prints `custom` where they are as in "
             "none of the three"},
        {.id = CommandId::Settings, .name = "settings", .effect = Tells, .help = "print all settings"},
        {.id = CommandId::State,
         .name = "state",
         .effect = Tells,
         .browser = BrowserUse::Own,
         .help = "print scene, camera, settings, lights and environment maps at once, for programs",
         .more = "As TOML, see [protocol.md](protocol.md)"},
    };
}

std::vector<CommandSpec> editCommands() {
    return {
        {.id = CommandId::Undo,
         .name = "undo",
         .arguments = {maybe(whole("EDIT", 1))},
         .browser = BrowserUse::Edit,
         .help = "take the last edit back, whichever client or key made it, and print what it was",
         .more = "Edits are what changes settings, lights and environment, and commands that place the "
                 "camera; flying, walking and turning are none. The last 5,000 are kept until another scene "
                 "is shown, "
                 "fewer of very large scenes. EDIT, as `state` numbers them: that one or none"},
        {.id = CommandId::Redo,
         .name = "redo",
         .arguments = {maybe(whole("EDIT", 1))},
         .browser = BrowserUse::Edit,
         .help = "make the edit again that was taken back"},
        {.id = CommandId::Also,
         .name = "also",
         .arguments = {text("COMMAND"), manyOf(text("ARGUMENT"))},
         .browser = BrowserUse::Own,
         .help = "run a command as part of the last edit, if that was of the same thing: one step of undo",
         .more = "`also set bloom.radius 8`: a value that follows a hand"},
        {.id = CommandId::By,
         .name = "by",
         .arguments = {whole("PERSON", 1), text("COMMAND"), manyOf(text("ARGUMENT"))},
         .browser = BrowserUse::Own,
         .help = "run an edit on behalf of one of those whom this client serves",
         .more = "For programs: `state` tells the client whose the last edit is, and another's is never "
                 "joined to it"},
        {.id = CommandId::Visitor,
         .name = "visitor",
         .arguments = {text("COMMAND"), manyOf(text("ARGUMENT"))},
         .effect = Keeps,
         .browser = BrowserUse::Own,
         .help = "add a note of one who only looks: it is no step of undo, and redo stays",
         .more = "For programs: `visitor note add 0 1.2 -8 dark Ada`. `undo` and `redo` of other edits leave "
                 "the note; `note remove` is a step"},
    };
}

std::vector<CommandSpec> keyCommands() {
    return {
        {.id = CommandId::KeyPress,
         .name = "key press",
         .arguments = {text("KEY", Key), maybe(whole("MS", 1, 3'600'000))},
         .help = "hold a key down until it is released; with MS, or --for=MS, wait so long and release it",
         .more = "So many milliseconds of the server's motion, to the step of 1/120 s, whatever the rate of "
                 "frames. Keys of the server's own: `w`, `7`, `space`, `left`, `right`, `up`, `down`, "
                 "`pageup`, `pagedown`, `shift`, `control`, `capslock` and others"},
        {.id = CommandId::KeyRelease,
         .name = "key release",
         .arguments = {orElse(text("KEY", Key), "all")},
         .help = "release it"},
        {.id = CommandId::KeyTap,
         .name = "key tap",
         .arguments = {text("KEY", Key)},
         .help = "press and release it"},
        {.id = CommandId::Bindings,
         .name = "bindings",
         .effect = Tells,
         .browser = BrowserUse::Own,
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

} // namespace app
