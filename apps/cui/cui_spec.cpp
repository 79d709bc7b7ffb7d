#include "cui/cui_spec.h"

#include "cui/cui_operands.h"

#include "common/cli/file_notes.h"
#include "common/cli/instance_option.h"
#include "common/commands/command_table.h"

namespace cui {

namespace {

using app::ValueKind;

app::OptionGroup options() {
    return {"Options",
            {{.name = "instance",
              .letter = 'i',
              .value = ValueKind::Text,
              .argument = "NAME",
              .help = "the server's name [that of the only one that runs]",
              .suggest = suggestInstances},
             {.name = "timeout",
              .letter = 't',
              .value = ValueKind::Number,
              .argument = "SECONDS",
              .help = "how long to wait for the answer to a command [60]",
              .minimum = 0,
              .maximum = 1e6},
             {.name = "json", .help = "status, watch and list: print JSON, an object or an array a line"},
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
    for (const app::CommandSpec& command : app::commandTable())
        group.words.push_back({app::commandLabel(command), std::string(command.help)});
    return group;
}

} // namespace

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
        .environment = {app::instanceEnvironmentNote(),
                        {"RT_RENDERER", "the program that 'render' runs [Renderer, beside CUI]"}},
        .files = app::sceneFileNotes(),
    };
    return spec;
}

} // namespace cui
