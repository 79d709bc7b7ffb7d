#include "cui/cui_spec.h"

#include "cui/cui_operands.h"

#include "common/cli/command_line.h"
#include "common/cli/file_notes.h"

#include "rtcore/settings/nearest_name.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cui {

namespace {

using app::ValueKind;

constexpr std::array kCommands{
    CommandSpec{"status", "", "what the server shows and how fast; --json for programs", Doer::Local},
    CommandSpec{"fps", "", "frames a second", Doer::Local},
    CommandSpec{"watch", "", "a line of figures each second, until Ctrl-C", Doer::Local},
    CommandSpec{"list", "", "all servers of this user", Doer::Local},
    CommandSpec{"free", "", "remove the shared memory that a dead server left", Doer::Local},
    CommandSpec{"about", "", "what this program is", Doer::Local},
    CommandSpec{"script", "FILE|-", "run the commands of a file, or of standard input, line by line",
                Doer::Local},
    CommandSpec{"render", "FILE [-- OPTION...]",
                "render what the server shows by the Renderer, which takes the options behind --",
                Doer::Local},
    CommandSpec{"ping", "", "does it answer?"},
    CommandSpec{"exit", "", "end the server, and wait until it has ended; also: quit"},
    CommandSpec{"quit", "", "the same"},
    CommandSpec{"parent", "PID|none",
                "end once this process is gone and no client is connected; none: go on in any case"},
    CommandSpec{"pause", "", "no more frames for now"},
    CommandSpec{"resume", "", "frames again"},
    CommandSpec{"idle", "on|off", "off: draw every frame, though it equals the last"},
    CommandSpec{"frame-time", "MS|off",
                "after a change, draw a coarser frame at first where the whole one would take longer"},
    CommandSpec{"messages", "[KNOWN]",
                "print the warnings and what keys did since the scene was loaded; KNOWN: after that number"},
    CommandSpec{"wait-idle", "", "until the next frame would equal the last"},
    CommandSpec{"resolution", "WIDTH HEIGHT", "pixels of a frame"},
    CommandSpec{"set", "NAME VALUE", "change a setting"},
    CommandSpec{"get", "NAME", "print a setting"},
    CommandSpec{"settings", "", "print all settings"},
    CommandSpec{"camera get", "", "print the camera, as a .cam file has it"},
    CommandSpec{"camera set", "EX EY EZ FX FY FZ [FOV]", "look from E into the direction F"},
    CommandSpec{"camera look-at", "EX EY EZ TX TY TZ [FOV]", "look from E to the point T"},
    CommandSpec{"camera turn", "RIGHT UP", "turn by these angles, degrees"},
    CommandSpec{"camera reset", "", "look as the scene itself says"},
    CommandSpec{"focus", "X Y",
                "focus a lens on what is there, 0..1 from the left and from the top, and print its distance"},
    CommandSpec{"speed", "FACTOR", "fly so many times as fast as usual"},
    CommandSpec{"walk", "", "with a body, on the ground"},
    CommandSpec{"fly", "", "freely"},
    CommandSpec{"load camera", "FILE", "look through a .cam file", Doer::Server, true},
    CommandSpec{"load scene", "FILE", "show another scene or model", Doer::Server, true},
    CommandSpec{"load set", "FILE", "take the table [live] of a .set file over", Doer::Server, true},
    CommandSpec{"export camera", "FILE [WIDTH HEIGHT ANTIALIASING BLOOM]", "write the camera as a .cam file",
                Doer::Server, true},
    CommandSpec{"export scene", "FILE", "write a .scn file that shows the same again", Doer::Server, true},
    CommandSpec{"export video start", "FILE [FPS]",
                "record the camera, 30 times a second, for 'play' and 'Renderer -l'", Doer::Server, true},
    CommandSpec{"export video", "", "print whether a recording is under way, its seconds, and the last list"},
    CommandSpec{"export video stop", "[FILE]", "end the recording, and print its number of frames"},
    CommandSpec{"play", "FILE", "show a recorded path", Doer::Server, true},
    CommandSpec{"play stop", "", "no more of it"},
    CommandSpec{"screenshot", "FILE", "write the frame; the extension says the format", Doer::Server, true},
    CommandSpec{"bloom", "on|off", "the glow around bright spots"},
    CommandSpec{"light", "N on|off|toggle", "switch a light; the first one is 1, as on the keys"},
    CommandSpec{"environment", "N", "choose an environment map; the first one is 1"},
    CommandSpec{"lights", "", "print the lights: number, on or off, name"},
    CommandSpec{"environments", "", "print the environment maps: number, active or -, name"},
    CommandSpec{"scene", "", "print the path of the scene"},
    CommandSpec{"key press", "KEY",
                "hold a key down until it is released; with --for=MS wait so long and release it"},
    CommandSpec{"key release", "KEY|all", "release it"},
    CommandSpec{"key tap", "KEY", "press and release it"},
    CommandSpec{"bindings", "", "what the keys do"},
    CommandSpec{"bindings default", "", "what they do by default again"},
    CommandSpec{"bind", "KEY|KEY+KEY ACTION [N]",
                "let a key do something else; 'bindings' shows the actions"},
    CommandSpec{"unbind", "KEY|KEY+KEY", "let it do nothing"},
};

app::OptionGroup options() {
    return {"Options",
            {{.name = "instance",
              .letter = 'i',
              .value = ValueKind::Text,
              .argument = "NAME",
              .help = "the server's name [default]",
              .suggest = suggestInstances},
             {.name = "timeout",
              .letter = 't',
              .value = ValueKind::Number,
              .argument = "SECONDS",
              .help = "how long to wait for the answer to a command [60]",
              .minimum = 0,
              .maximum = 1e6},
             {.name = "json", .help = "print status and list for programs"},
             {.name = "for",
              .value = ValueKind::Integer,
              .argument = "MS",
              .help = "key press: release the key after so many milliseconds",
              .minimum = 1,
              .maximum = 3'600'000},
             {.name = "count",
              .value = ValueKind::Integer,
              .argument = "N",
              .help = "watch: end after N lines",
              .minimum = 1,
              .maximum = 1e9}}};
}

app::OptionGroup commandGroup() {
    app::OptionGroup group{"Commands", {}};
    for (const CommandSpec& command : kCommands) {
        std::string label(command.name);
        if (!command.arguments.empty()) label.append(" ").append(command.arguments);
        group.words.push_back({label, std::string(command.help)});
    }
    return group;
}

} // namespace

std::span<const CommandSpec> commands() { return kCommands; }

FoundCommand findCommand(std::span<const std::string> words) {
    if (words.empty()) throw app::UsageError("no command is given");
    constexpr std::size_t kMostWords = 3;
    for (std::size_t used = std::min(words.size(), kMostWords); used > 0; --used) {
        std::string name = words[0];
        for (std::size_t i = 1; i < used; ++i) name += " " + words[i];
        for (const CommandSpec& command : kCommands) {
            if (command.name == name) return {&command, used};
        }
    }
    const std::string two = words.size() > 1 ? words[0] + " " + words[1] : words[0];
    std::vector<std::string_view> names;
    for (const CommandSpec& command : kCommands) {
        names.push_back(command.name);
        if (command.name.starts_with(words[0] + " "))
            throw app::UsageError(rtcore::quoted(words[0]) +
                                  " is the beginning of several commands; see --help");
    }
    throw app::UsageError(rtcore::unknownNameMessage("command", two, names));
}

const app::ProgramSpec& cuiSpec() {
    static const app::ProgramSpec spec{
        .name = "CUI",
        .purpose = "Commands a running RTServer. Answers go to standard output.",
        .positionals = {{"COMMAND", "what to do, and its arguments", true}},
        .groups = {commandGroup(), options()},
        .examples = {{"CUI resolution 1280 720", "larger frames"},
                     {"CUI render now.png -- -a 4 -w 3840 -h 2160", "the same view, large and smooth"},
                     {"CUI --instance=cow screenshot cow.png", "what the server 'cow' shows"}},
        .operands = operands(),
        .environment = {{"RT_RENDERER", "the program that 'render' runs [Renderer, beside CUI]"}},
        .files = app::sceneFileNotes(),
    };
    return spec;
}

} // namespace cui
