// Rows for lengths, angles, areas and volumes.
#include "common/commands/command_rows.h"

namespace app {

using enum CommandEffect;

std::vector<CommandSpec> dimensionCommands() {
    const CommandArgument right = number("RIGHT", 0, 1), down = number("DOWN", 0, 1);
    const CommandArgument part = text("PART", ArgumentType::Part);
    return {
        {.id = CommandId::MeasurePoint,
         .name = "measure point",
         .arguments = {right, down},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print what a pointer catches there, 0..1 from the left and from the top: corner, middle, "
                 "edge or "
                 "face, and where that is",
         .more = "`corner 1 0 2.5`, in the coordinates of the model's file: a corner within 8 pixels, else "
                 "the middle "
                 "of an edge, else a point of one, else the surface. Edges are where a surface ends or bends "
                 "by more "
                 "than 20 degrees. What is hidden or cut away is not caught"},
        {.id = CommandId::MeasureSeen,
         .name = "measure seen",
         .arguments = {right, down, number("RIGHT2", 0, 1), number("DOWN2", 0, 1)},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the distance between what a pointer catches at two places of the image",
         .more = "The lines of `measure point` for both, then those of `measure distance`"},
        {.id = CommandId::MeasureDistance,
         .name = "measure distance",
         .arguments = numbers({"X", "Y", "Z", "X2", "Y2", "Z2"}),
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the distance between two points, in the plane and in height",
         .more = "Lines `distance 5 m`, `level 4 m` and `height 3 m`, up from the first point. Where the "
                 "unit is a "
                 "guess, a last line says so"},
        {.id = CommandId::MeasureAngle,
         .name = "measure angle",
         .arguments = numbers({"X", "Y", "Z", "X2", "Y2", "Z2", "X3", "Y3", "Z3"}),
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the angle at the second of three points, in degrees"},
        {.id = CommandId::MeasureFace,
         .name = "measure face",
         .arguments = {right, down},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the area of the face that is seen there, how much room is before it, and how high "
                 "the point "
                 "is above the floor",
         .more =
             "The area is of all triangles in one plane that hang together. `clearance 2.5 m` is along the "
             "face's normal up to the next surface, `above 0.75 m` straight down to one; a line is left out "
             "where "
             "there is none"},
        {.id = CommandId::MeasureVolume,
         .name = "measure volume",
         .arguments = {part, manyOf(part)},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print what closed parts enclose, without their hollows",
         .more = "An open part is refused; what two of them overlap counts twice"},
    };
}

} // namespace app
