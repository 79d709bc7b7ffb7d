#include "bspbuilder/builder_spec.h"

#include "common/cli/file_notes.h"
#include "common/cli/import_option_group.h"
#include "common/cli/parent_option.h"
#include "common/cli/threads_option.h"
#include "common/progress/progress.h"

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
              .help = "with --fast (1 to 4 are alike): 1 is quickest to build, 10 quickest to trace [5]",
              .minimum = 1,
              .maximum = 10}}};
}

OptionGroup runOptions() {
    return {"Running",
            {{.name = "verbose", .letter = 'v', .help = "report the model and times on standard output"},
             {.name = "very-verbose",
              .thesis = {"-vv"},
              .help = "report also the tree, the time of each phase, and whether the tree passes every check",
              .more = "Of the tree: nodes, leaves, depth, references, expected cost of a ray, memory"},
             {.name = "histogram",
              .thesis = {"-hist"},
              .value = ValueKind::Integer,
              .argument = "N",
              .help = "draw histograms of the leaves' size and depth in N bands",
              .more = "The size is the number of triangles",
              .minimum = 1,
              .maximum = 1000},
             app::threadsOption(),
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

} // namespace bspbuilder
