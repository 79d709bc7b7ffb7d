#include "rtserver/server_options.h"

#include "common/cli/file_notes.h"
#include "common/cli/import_options.h"
#include "common/cli/instance_option.h"
#include "common/cli/isa_option.h"
#include "common/cli/lighting_option_group.h"
#include "common/cli/selection_option_group.h"
#include "common/cli/threads_option.h"
#include "common/settings/lighting_options.h"
#include "common/settings/setting_option.h"

#include "ipc/endpoint/instances.h"
#include "ipc/layout/limits.h"

#include <fmt/core.h>

#include <limits>
#include <stdexcept>

namespace rtserver {

namespace {

using app::OptionGroup;
using app::ValueKind;

OptionGroup viewOptions() {
    return {
        "View",
        {{.name = "camera",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "begin with this .cam file, its size, anti-aliasing, exposure, lights and environment",
          .files = {"cam"}},
         {.name = "resolution",
          .letter = 'r',
          .value = ValueKind::Text,
          .argument = "WxH",
          .help = "pixels of a frame",
          .more = fmt::format("Up to {} each way", ipc::kMaxFrameSide)},
         {.name = "play",
          .value = ValueKind::Text,
          .argument = "LIST",
          .help = "show this recorded path first",
          .files = {"lst", "txt"}},
         {.name = "cached-model",
          .formerly = {"built-model"},
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "a .bsp that BSPBuilder made of the model: loaded instead of it, which is quicker; the "
                  "model keeps its name",
          .more = "The model is imported, with a warning, when the `.bsp` cannot be read",
          .files = {"bsp"}},
         {.name = "light",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "walks begin with the indirect light of this file, which the Renderer made of the scene",
          .more = "By `--make-light`",
          .files = {"light"}},
         {.name = "light-cache",
          .value = ValueKind::Text,
          .argument = "DIR",
          .help = "keep the indirect light that walks learn in this folder, so that the next visit of a "
                  "scene begins with it",
          .more = "A file for each scene, some 10 to 60 MB; beyond 500 MB the oldest go. That of edits "
                  "that are not saved is not kept"},
         {.name = "set",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "take settings from the table [live] of this .set file",
          .files = {"set"}},
         {.name = "setting",
          .value = ValueKind::Text,
          .argument = "NAME=VALUE",
          .help = "any setting by its name; may be given several times; 'Renderer --settings' lists them",
          .suggest = app::suggestAssignments}}};
}

OptionGroup runOptions() {
    return {
        "Running",
        {{.name = "instance",
          .letter = 'i',
          .value = ValueKind::Text,
          .argument = "NAME",
          .help =
              "the name by which clients find this server [default, or default-2, ... where that is taken]",
          .more =
              "1 to 32 letters, digits, `_` or `-`. Of two servers with one name the second ends with 75"},
         app::threadsOption(),
         {.name = "fps-limit",
          .value = ValueKind::Number,
          .argument = "X",
          .help = "at most X frames per second; 0 is no limit [0]",
          .minimum = 0,
          .maximum = 10000},
         {.name = "frame-time",
          .value = ValueKind::Number,
          .argument = "MS",
          .help = "after a change and while something moves, draw a coarser frame where the whole one would "
                  "take longer; 0 is always all [33 with --daemon, else 0]",
          .minimum = 0,
          .maximum = 10000},
         {.name = "parent",
          .value = ValueKind::Integer,
          .argument = "PID",
          .help = "once this process is no more, end as soon as no client is connected",
          .more = "The window names itself, so that a server of its own does not outlive it, whatever ends "
                  "it. Programs that only look are no clients",
          .minimum = 1,
          .maximum = std::numeric_limits<std::int32_t>::max()},
         {.name = "daemon",
          .letter = 'd',
          .help = "go on in the background once the first frame is there",
          .more = "The command returns then, with 0, or with the exit code of what went wrong"},
         app::isaOption()}};
}

void readResolution(const std::string& text, std::vector<rtcore::SettingAssignment>& settings) {
    const std::size_t cross = text.find_first_of("xX");
    if (cross == std::string::npos)
        throw app::UsageError("option '--resolution' takes WxH, such as 1280x720");
    settings.push_back(app::settingOf("resolution", "width", text.substr(0, cross)));
    settings.push_back(app::settingOf("resolution", "height", text.substr(cross + 1)));
}

void readSetting(const std::string& text, std::vector<rtcore::SettingAssignment>& settings) {
    settings.push_back(app::settingOf(text));
    try {
        rtcore::checkLive(rtcore::requireSetting(settings.back().name), settings.back().value);
    } catch (const std::invalid_argument& error) {
        throw app::UsageError(std::string("option '--setting': ") + error.what());
    }
}

std::optional<std::filesystem::path> readPath(const app::Arguments& arguments, const char* name) {
    const std::optional<std::string> text = arguments.text(name);
    if (!text) return std::nullopt;
    return std::filesystem::absolute(*text);
}

} // namespace

const app::ProgramSpec& serverSpec() {
    static const app::ProgramSpec spec{
        .name = "RTServer",
        .purpose =
            "Renders a scene in real time. Programs of this machine look at its frames in shared memory, "
            "move about by keys, and command it: see CUI.",
        .positionals = {{.name = "SCENE",
                         .help = "scene description (.scn), kd-tree (.bsp) or any model file",
                         .files = app::sceneExtensions()}},
        .groups = {viewOptions(), runOptions(), app::lightingOptionGroup(), app::selectionOptionGroup(),
                   app::importOptionGroup()},
        .examples = {{"RTServer nave.scn --resolution=1280x720 --daemon", "a server in the background"},
                     {"RTServer cow.obj --instance=cow",
                      "a second one, which 'CUI --instance=cow' commands"}},
        .environment = app::importEnvironmentNotes(app::instanceEnvironmentNote()),
        .files = app::sceneFileNotes(),
    };
    return spec;
}

Options readOptions(const app::Arguments& arguments) {
    Options options;
    options.scene = std::filesystem::absolute(arguments.positionals().at(0));
    options.instance = app::instanceOf(arguments).value_or(ipc::availableName("default"));
    options.camera = readPath(arguments, "camera");
    options.settingsFile = readPath(arguments, "set");
    options.path = readPath(arguments, "play");
    options.cachedModel = readPath(arguments, "cached-model");
    options.light = readPath(arguments, "light");
    options.lightCache = readPath(arguments, "light-cache");
    for (const app::Occurrence& given : arguments.options()) {
        if (given.name == "resolution") readResolution(given.value, options.settings);
        if (given.name == "setting") readSetting(given.value, options.settings);
    }
    options.threads = app::threadsOf(arguments);
    options.framesPerSecond = arguments.number("fps-limit").value_or(0);
    options.parent = arguments.integer("parent");
    options.daemon = arguments.has("daemon");
    constexpr double kInteractive = 33;
    options.frameSeconds = arguments.number("frame-time").value_or(options.daemon ? kInteractive : 0) * 1e-3;
    app::useIsa(arguments);
    options.import = app::readImportOptions(arguments);
    options.lighting = app::readLightingOptions(arguments);
    options.selection = app::readSelection(arguments);
    options.import.threads = options.threads;
    return options;
}

} // namespace rtserver
