// Rows for storeys, and for drawings to scale.
#include "common/commands/command_rows.h"

namespace app {

using enum CommandEffect;

std::vector<CommandSpec> planCommands() {
    return {
        {.id = CommandId::Plan,
         .name = "plan",
         .arguments = {path({"svg", "pdf", "dxf", "png", "tif", "tiff"}),
                       maybe(choice("above|front|back|left|right|section")),
                       maybe(number("SCALE", 0.01, 1e6)), maybe(choice("sheet|A4|A3|A2|A1|A0")),
                       maybe(whole("STOREY", 0, 1000)), maybe(number("HEIGHT", 0, 1e4)),
                       maybe(number("DPI", 10, 2400))},
         .effect = Waits,
         .help = "draw a plan to scale into a .svg, .pdf, .dxf, .png or .tif file, and print what was found",
         .more = "What is cut, visible edges beyond, and the areas of rooms; see [plans.md](plans.md). "
                 "`above` is a storey: the STOREY-th from below, or, with 0, that of a camera indoors, else "
                 "the lowest; cut HEIGHT metres above its floor [1.2]. `front` and so on are elevations, "
                 "`section` is what the scene's one section leaves. 1 to SCALE [100]; `sheet` is as large as "
                 "it must be, a `.pdf` takes as many sheets of paper as it needs, a `.png` or `.tif`, "
                 "of DPI pixels to an inch [300], as many files. The unit must be known: a "
                 "guess is refused. Other commands are answered meanwhile; Ctrl-C gives it up"},
        {.id = CommandId::PlanOutline,
         .name = "plan outline",
         .arguments = {maybe(whole("N", 1, 1000))},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the lines of the N-th storey's cut, for a small plan; without N, that of the camera",
         .more = "No scale, so the unit need not be known; see [plans.md](plans.md). In the background, once "
                 "for a storey and what is shown"},
        {.id = CommandId::Storeys,
         .name = "storeys",
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the storeys of a building: number, height of the floor, its area; the lowest first",
         .more = "In metres, in the coordinates of the model's file; by the areas of what looks up. Nothing "
                 "where there are none"},
        {.id = CommandId::StoreyGo,
         .name = "storey go",
         .arguments = {whole("N", 1, 1000)},
         .step = "camera",
         .browser = BrowserUse::Move,
         .help = "stand on the floor of the N-th storey, where the camera is"},
    };
}

} // namespace app
