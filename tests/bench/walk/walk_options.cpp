#include "bench/walk/walk_options.h"

#include "common/cli/isa_option.h"
#include "common/cli/threads_option.h"
#include "common/settings/setting_option.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace bench {

namespace {

using app::OptionGroup;
using app::ValueKind;

OptionGroup walkGroup() {
    return {
        "The walk",
        {{.name = "size",
          .value = ValueKind::Text,
          .argument = "WxH",
          .help = "pixels of the window [1024x621]"},
         {.name = "fps",
          .value = ValueKind::Number,
          .argument = "N",
          .help = "the cameras follow each other at N per second, and a frame may take as long [30]",
          .minimum = 1,
          .maximum = 1000},
         {.name = "frames",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "the first N cameras [all]",
          .minimum = 1,
          .maximum = 1'000'000},
         {.name = "parallel",
          .value = ValueKind::Number,
          .argument = "WIDTH",
          .help = "the cameras without perspective, so many scene units wide",
          .minimum = 1e-6,
          .maximum = 1e9},
         {.name = "fixed", .help = "draw every camera at the full size, however long that takes"},
         {.name = "new",
          .value = ValueKind::Number,
          .argument = "PART",
          .help = "draw every camera in a live frame at the full size, with that part of its pixels traced "
                  "anew, however long that takes",
          .minimum = 0.0001,
          .maximum = 1},
         {.name = "light",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "with --new or --replay: begin with the indirect light that this file keeps",
          .files = {"light"}},
         {.name = "look",
          .value = ValueKind::Choice,
          .argument = "LOOK",
          .help = "light the scene so, in place of its own light; without it a model that brings none has a "
                  "headlight",
          .choices = {"sky", "studio", "headlight"}},
         {.name = "trace",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "write down which camera was drawn in what detail"},
         {.name = "replay",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "draw what --trace wrote, however long that takes: the same frames to the bit"},
         app::threadsOption(),
         app::isaOption(),
         {.name = "setting",
          .value = ValueKind::Text,
          .argument = "NAME=VALUE",
          .help = "any setting by its name; may be given several times",
          .suggest = app::suggestAssignments}}};
}

OptionGroup comparisonGroup() {
    return {
        "The comparison",
        {{.name = "references",
          .value = ValueKind::Text,
          .argument = "FOLDER",
          .help =
              "where the references of the cameras are kept; those by paths are rendered before the walk, "
              "and an interrupted run goes on where it ended [references]"},
         {.name = "still", .help = "compare with pictures by the settings [still], not [live]"},
         {.name = "truth",
          .value = ValueKind::Choice,
          .argument = "METHOD",
          .help = "compare with the Renderer's picture by rays, or with the light of two references by "
                  "paths: relMSE by the product of what the light differs from each, mean error of light, "
                  "and FLIP beside their mean, each image with its own exposure [rays]",
          .choices = {"rays", "paths"}},
         {.name = "truth-samples",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "paths for each pixel of a reference [256]",
          .minimum = 1,
          .maximum = 1'000'000},
         {.name = "truth-size",
          .value = ValueKind::Text,
          .argument = "WxH",
          .help = "pixels of the references by paths, in which the walk's light is averaged; in the shape "
                  "of the window [half of it each way]"},
         {.name = "every",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "compare each N-th moment only [1, with paths 30]",
          .minimum = 1,
          .maximum = std::numeric_limits<std::int32_t>::max()},
         {.name = "csv", .value = ValueKind::Text, .argument = "FILE", .help = "a line for each moment"},
         {.name = "sheet",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "a picture of six moments and of the worst one: shown, reference, difference"},
         {.name = "pictures",
          .value = ValueKind::Text,
          .argument = "FOLDER",
          .help = "every picture that was on the screen, as PNG"},
         app::progressOption()}};
}

struct Size {
    int width, height;
};

std::optional<Size> sizeOf(const app::Arguments& arguments, const char* option) {
    const auto text = arguments.text(option);
    if (!text) return std::nullopt;
    const std::size_t cross = text->find('x');
    const auto side = [&](const std::string& digits) {
        const auto value = app::parseInteger(digits);
        if (!value || *value < 8 || *value > 8192)
            throw app::UsageError(fmt::format("option '--{}' takes WxH, such as 1024x621", option));
        return static_cast<int>(*value);
    };
    return Size{side(text->substr(0, cross)),
                side(cross == std::string::npos ? "" : text->substr(cross + 1))};
}

/// What is compared, and with what. The window's size must be known.
void readComparison(const app::Arguments& arguments, WalkOptions& options) {
    options.still = arguments.has("still");
    options.references = arguments.text("references").value_or("references");
    if (arguments.text("truth") == "paths") options.truth = Truth::Paths;
    const bool paths = options.truth == Truth::Paths;
    options.every = static_cast<int>(arguments.integer("every").value_or(paths ? 30 : 1));
    if (!paths && (arguments.has("truth-samples") || arguments.has("truth-size")))
        throw app::UsageError("'--truth-samples' and '--truth-size' go with '--truth=paths'");
    options.truthSamples =
        static_cast<int>(arguments.integer("truth-samples").value_or(options.truthSamples));
    const Size size = sizeOf(arguments, "truth-size").value_or(Size{options.width / 2, options.height / 2});
    // Squares of the window's pixels must meet them in each row (resample.h).
    const double side = static_cast<double>(options.width) / size.width;
    if (paths && (side < 1 || std::abs(options.height - side * size.height) > side))
        throw app::UsageError("option '--truth-size' takes a size in the window's shape, and no larger");
    options.truthWidth = size.width;
    options.truthHeight = size.height;
}

} // namespace

const app::ProgramSpec& walkSpec() {
    static const app::ProgramSpec spec{
        .name = "bench_walk",
        .purpose =
            "Plays a recorded walk as the server shows it, and compares what is on the screen at each "
            "moment with the Renderer's picture of the camera of that moment, or with the light of paths.",
        .positionals = {{.name = "SCENE", .help = "model, .bsp or .scn"},
                        {.name = "LIST", .help = "the recorded walk"}},
        .groups = {walkGroup(), comparisonGroup()},
        .examples = {{"bench_walk nave.scn nave.lst --csv nave.csv --sheet nave.png",
                      "at 30 frames per second, as in the window"},
                     {"bench_walk nave.scn nave.lst --fixed --threads 1", "what a whole frame costs"},
                     {"bench_walk nave.scn nave.lst --new 0.02 --threads 1", "what a live frame costs"},
                     {"bench_walk nave.scn nave.lst --parallel 20", "the same way, 20 units of it in view"},
                     {"bench_walk nave.scn nave.lst --replay steps.txt", "the frames of an earlier walk"},
                     {"bench_walk flat.scn flat.lst --truth=paths --references DIR",
                      "each 30th moment beside all light that there is"}},
    };
    return spec;
}

WalkOptions readWalkOptions(const app::Arguments& arguments) {
    WalkOptions options;
    options.scene = std::filesystem::absolute(arguments.positionals().at(0));
    options.list = std::filesystem::absolute(arguments.positionals().at(1));
    app::useIsa(arguments);
    for (const std::string& setting : arguments.all("setting"))
        options.settings.push_back(app::settingOf(setting));
    if (const auto look = arguments.text("look")) options.preset = rtcore::lightingPresetNamed(*look);
    if (const auto size = sizeOf(arguments, "size")) {
        options.width = size->width;
        options.height = size->height;
    }
    options.threads = app::threadsOf(arguments);
    options.framesPerSecond = arguments.number("fps").value_or(options.framesPerSecond);
    if (const auto frames = arguments.integer("frames")) options.frames = static_cast<int>(*frames);
    options.parallelWidth = static_cast<float>(arguments.number("parallel").value_or(0));
    options.fixed = arguments.has("fixed");
    options.newSamples = arguments.number("new").value_or(0);
    if (const auto light = arguments.text("light")) options.light = *light;
    readComparison(arguments, options);
    const auto path = [&](const char* name) -> std::optional<std::filesystem::path> {
        const auto text = arguments.text(name);
        if (!text) return std::nullopt;
        return *text;
    };
    options.csv = path("csv");
    options.trace = path("trace");
    options.replay = path("replay");
    const int ways = (options.fixed ? 1 : 0) + (options.newSamples > 0 ? 1 : 0) + (options.replay ? 1 : 0);
    if (ways > 1) throw app::UsageError("'--fixed', '--new' and '--replay' exclude each other");
    options.sheet = path("sheet");
    options.pictures = path("pictures");
    options.progress = app::progressStyle(arguments.text("progress").value_or("auto"));
    return options;
}

} // namespace bench
