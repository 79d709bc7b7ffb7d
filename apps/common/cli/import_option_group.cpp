#include "common/cli/import_option_group.h"

namespace app {

std::vector<Option> frameOptions() {
    return {{.name = "up",
             .value = ValueKind::Choice,
             .argument = "AXIS",
             .help = "the model's axis that is up [auto: what its file says, else a guess]",
             .more = "See \"Up axis and units\"",
             .choices = {"auto", "+x", "-x", "+y", "-y", "+z", "-z"}},
            {.name = "units",
             .value = ValueKind::Text,
             .argument = "UNIT",
             .help = "the model's unit: mm, cm, m, in, ft or metres per unit [auto]"}};
}

OptionGroup importOptionGroup() {
    OptionGroup group{
        "Importing models",
        {{.name = "crease-angle",
          .value = ValueKind::Number,
          .argument = "DEG",
          .help = "where the file has no normals, edges sharper than this stay sharp [40]",
          .minimum = 0,
          .maximum = 180},
         {.name = "deflection",
          .value = ValueKind::Number,
          .argument = "F",
          .help = "how far triangles may lie off the surfaces of CAD files, as a fraction of the model's "
                  "diagonal [0.0005]",
          .more = "STEP, IGES and BREP",
          .minimum = 1e-6,
          .maximum = 0.1},
         {.name = "flip-textures", .help = "turn textures upside down: some exporters count from the top"},
         {.name = "pose",
          .value = ValueKind::Text,
          .argument = "POSE",
          .help = "rest, first or NAME@SECONDS of a model with animations [rest]",
          .more = "Of a server, for its first scene. See [import.md](import.md#poses)"},
         {.name = "memory-limit",
          .value = ValueKind::Integer,
          .argument = "MB",
          .help = "memory that importing may take [half of the machine's]",
          .minimum = 16,
          .maximum = 1e8},
         {.name = "time-limit",
          .value = ValueKind::Number,
          .argument = "S",
          .help = "seconds that one step of importing may take [15, and 2 more for each MB of the file; 5 "
                  "for a tiny one]",
          .more = "A step is the parsing of the file, an image or a mesh. Tiny is a file below 64 kB that is "
                  "no `.gltf`",
          .minimum = 0.01,
          .maximum = 1e6}}};
    const std::vector<Option> frame = frameOptions();
    group.options.insert(group.options.begin(), frame.begin(), frame.end());
    return group;
}

} // namespace app
