#include "gui/gui_spec.h"

#include "common/cli/file_notes.h"
#include "common/cli/import_option_group.h"
#include "common/cli/instance_option.h"

#include "rtcore/platform/error.h"

#include <filesystem>

namespace gui {

const app::ProgramSpec& guiSpec() {
    using app::ValueKind;
    static const app::ProgramSpec spec{
        .name = "GUI",
        .purpose = "A window on a running RTServer. With a scene or a model it starts a server of its own.",
        .positionals = {{.name = "SCENE",
                         .help = "scene description (.scn), kd-tree (.bsp) or any model file",
                         .optional = true,
                         .files = app::sceneExtensions()}},
        .groups = {{"Options",
                    {{.name = "instance",
                      .letter = 'i',
                      .value = ValueKind::Text,
                      .argument = "NAME",
                      .help = "the server's name [that of the preferences]"},
                     {.name = "connect", .letter = 'c', .help = "connect to the server that runs"}}},
                   {"Importing models", app::frameOptions()}},
        .examples = {{"GUI nave.scn", "start a server with this scene and walk in it"},
                     {"GUI --connect --instance=cow", "look at what the server 'cow' shows"}},
        .environment = app::importEnvironmentNotes(app::instanceEnvironmentNote()),
        .files = app::sceneFileNotes(),
    };
    return spec;
}

Options readOptions(const app::Arguments& arguments) {
    Options options;
    options.instance = app::instanceOf(arguments).value_or("");
    options.connect = arguments.has("connect");
    for (const char* name : {"up", "units"}) {
        if (const auto value = arguments.text(name))
            options.server.push_back("--" + std::string(name) + "=" + *value);
    }
    if (arguments.positionals().empty()) {
        if (!options.server.empty()) throw app::UsageError("--up and --units need a model to open");
        return options;
    }
    if (options.connect) throw app::UsageError("--connect and a scene exclude each other");
    options.file = std::filesystem::absolute(arguments.positionals().front()).string();
    return options;
}

void requireFile(const Options& options) {
    if (options.file.empty() || std::filesystem::is_regular_file(options.file)) return;
    throw rtcore::FileError(rtcore::FailureKind::NoInput, options.file,
                            std::filesystem::is_directory(options.file)
                                ? "this is a folder, no scene or model"
                                : "there is no such file");
}

} // namespace gui
