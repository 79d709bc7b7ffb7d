// Rows for measuring light.
#include "common/commands/command_rows.h"

namespace app {

using enum CommandEffect;

std::vector<CommandSpec> measureCommands() {
    return {
        {.id = CommandId::MeasureLight,
         .name = "measure light",
         .arguments = {number("X", 0, 1), number("Y", 0, 1), maybe(whole("PATHS", 1, 1 << 19))},
         .effect = Waits,
         .browser = BrowserUse::Move,
         .help =
             "print the light on the surface that is seen there, 0..1 from the left and from the top, and "
             "how bright it is",
         .more = "Lines `illuminance 512.3 lx, standard error 3.1`, `luminance 120.1 cd/m2, standard error "
                 "1.0` and `at 1 0.85 2`; where nothing is seen, the luminance alone. Beside a computed sky "
                 "and other light, two lines more say how much is of which. The last line names the light "
                 "that has no absolute unit, if there is any. Takes some seconds, and goes on beside other "
                 "commands. It ends when the standard error is 1 % of the value, or after 262144 paths; with "
                 "PATHS after so many, rounded up to a power of two from 512 on"},
        {.id = CommandId::MeasureLightAt,
         .name = "measure light at",
         .arguments =
             numbers({"X", "Y", "Z"}) + ArgumentList{maybe(number("NX")), number("NY"), number("NZ")},
         .effect = Waits,
         .help =
             "print the light at a point, on a surface that faces along the normal N: without it, upwards",
         .more = "In the coordinates of the model's file: `measure light at 2 0.85 3`"},
        {.id = CommandId::MeasureLightGrid,
         .name = "measure light grid",
         .arguments = {path({"csv"}), maybe(number("HEIGHT", 0, 1000)),
                       maybe(number("SPACING", 0.001, 1000))},
         .effect = Waits,
         .help =
             "write the light on a level grid, 0.85 metres over the floor below the viewpoint, as a table",
         .more = "Columns are `x,y,z,lux,standard_error`. HEIGHT and SPACING, 0.5 by default, are metres: a "
                 "unit that is only guessed is to be said first, by `units`. Points have that floor below "
                 "them, within 0.3 m, or what stands on it; they are under a roof if the viewpoint is, and "
                 "not in solids. The answer has their number, mean, min, max and uniformity, min over "
                 "mean. Ctrl-C gives it up"},
        {.id = CommandId::MeasureProgress,
         .name = "measure progress",
         .effect = Tells,
         .needsScene = false,
         .help = "print how much of a measured grid is done, or off",
         .more = "`on 37 %`"},
        {.id = CommandId::MeasureStop,
         .name = "measure stop",
         .effect = Steers,
         .needsScene = false,
         .help = "give up the light that is being measured; nothing is written"},
    };
}

} // namespace app
