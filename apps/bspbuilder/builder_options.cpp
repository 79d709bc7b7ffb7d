#include "bspbuilder/builder_options.h"

#include "common/file_notes.h"
#include "common/import_options.h"
#include "common/parent.h"
#include "common/threads.h"

#include <bit>

namespace bspbuilder {

namespace {

using app::OptionGroup;
using app::ValueKind;

OptionGroup treeOptions() {
    return {"Tree",
            {{.name = "fast",
              .letter = 'f',
              .help = "build in less than half the time; the tree is about a sixth slower to trace"},
             {.name = "quality",
              .letter = 'm',
              .value = ValueKind::Integer,
              .argument = "N",
              .help = "with --fast: 1 is quickest to build, 10 quickest to trace [5]",
              .minimum = 1,
              .maximum = 10}}};
}

OptionGroup runOptions() {
    return {
        "Running",
        {{.name = "verbose", .letter = 'v', .help = "report the model and times on standard output"},
         {.name = "very-verbose",
          .thesis = {"-vv"},
          .help = "report also the tree, the time of each phase, and whether the tree passes every check"},
         {.name = "histogram",
          .thesis = {"-hist"},
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "draw histograms of the leaves' size and depth in N bands",
          .minimum = 1,
          .maximum = 1000},
         {.name = "threads",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "use N threads; 0 is all cores; the tree is the same for every number [0]",
          .minimum = 0,
          .maximum = 1024},
         app::progressOption(),
         app::parentOption()}};
}

} // namespace

const app::ProgramSpec& builderSpec() {
    static const app::ProgramSpec spec{
        .name = "BSPBuilder",
        .purpose =
            "Builds the kd-tree of a model and writes both to a .bsp file, which RTServer and Renderer "
            "load very quickly.",
        .positionals = {{.name = "INPUT",
                         .help = "model file: .obj, .ply, .gltf, .glb, .3ds, .x, .fbx, .dae, .stl, ...",
                         .files = app::modelExtensions()},
                        {.name = "OUTPUT", .help = "the .bsp file", .files = {"bsp"}}},
        .groups = {treeOptions(), app::importOptionGroup(), runOptions()},
        .examples = {{"BSPBuilder nave.obj nave.bsp -vv", "the best tree, with a report"},
                     {"BSPBuilder dragon.ply dragon.bsp -f -m 3", "a quick build"}},
        .environment = app::importEnvironmentNotes(),
        .files = {app::sceneFileNotes()[1]},
    };
    return spec;
}

BuilderOptions readBuilderOptions(const app::Arguments& arguments) {
    BuilderOptions options;
    options.input = arguments.positionals().at(0);
    options.output = arguments.positionals().at(1);
    if (arguments.has("fast")) options.build.method = rtcore::BuildMethod::Fast;
    if (const auto quality = arguments.integer("quality"))
        options.build.fastQuality = static_cast<int>(*quality);
    options.build.threads = app::threadCount(arguments.integer("threads"));
    options.import = app::readImportOptions(arguments);
    options.import.threads = options.build.threads;
    if (arguments.has("verbose")) options.verbosity = Verbosity::Verbose;
    if (arguments.has("very-verbose")) options.verbosity = Verbosity::VeryVerbose;
    if (const auto bands = arguments.integer("histogram")) options.histogramBands = static_cast<int>(*bands);
    if (arguments.has("parent")) options.parent = app::parentOf(arguments);
    options.progress = app::progressStyle(arguments.text("progress").value_or("auto"));
    return options;
}

std::uint32_t buildOptionsHash(const BuilderOptions& options) {
    const rtcore::BuildOptions& build = options.build;
    const bool fast = build.method == rtcore::BuildMethod::Fast;
    const float numbers[] = {fast ? 1.0F : 0.0F,
                             build.traversalCost,
                             build.intersectionCost,
                             build.emptyBonus,
                             static_cast<float>(build.lookAhead),
                             fast ? static_cast<float>(build.fastQuality) : 0,
                             options.import.creaseAngle.value_or(rtcore::kCreaseAngle),
                             options.import.flipTextures.value_or(false) ? 1.0F : 0.0F};
    std::uint32_t hash = 2166136261U; // FNV-1a
    for (const float number : numbers) {
        for (std::uint32_t bits = std::bit_cast<std::uint32_t>(number), byte = 0; byte < 4;
             ++byte, bits >>= 8U) {
            hash = (hash ^ (bits & 0xFFU)) * 16777619U;
        }
    }
    return hash == 0 ? 1 : hash;
}

} // namespace bspbuilder
