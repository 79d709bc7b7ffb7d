// Rows for measures that are kept with the scene.
#include "common/commands/command_rows.h"

#include "rtcore/scene/kept_measure.h"

namespace app {

using enum CommandEffect;

namespace {

/// One that adds a measure: a driver's page may.
CommandSpec keeping(CommandId id, std::string_view name, ArgumentList arguments) {
    return {.id = id,
            .name = name,
            .arguments = std::move(arguments),
            .effect = Keeps,
            .step = "measure",
            .browser = BrowserUse::Edit,
            .help = {}};
}

CommandSpec with(CommandSpec row, std::string_view help, std::string_view more = {}) {
    row.help = help;
    row.more = more;
    return row;
}

std::vector<CommandSpec> keepingCommands() {
    const CommandArgument right = number("RIGHT", 0, 1), down = number("DOWN", 0, 1);
    const ArgumentList three = numbers({"X", "Y", "Z", "X2", "Y2", "Z2", "X3", "Y3", "Z3"});
    return {
        with(keeping(CommandId::MeasureKeepDistance, "measure keep distance",
                     numbers({"X", "Y", "Z", "X2", "Y2", "Z2"})),
             "keep the distance between two points with the scene, and print it",
             "It is shown over the image, saved in `.scn` files, and a step of `undo`; 1,000 at most"),
        with(keeping(CommandId::MeasureKeepChain, "measure keep chain",
                     three + ArgumentList{manyOf(number("MORE"))}),
             "keep the lengths along 3 to 64 points, and their sum"),
        with(keeping(CommandId::MeasureKeepAngle, "measure keep angle", three),
             "keep the angle at the second of three points"),
        with(keeping(CommandId::MeasureKeepHeight, "measure keep height", numbers({"X", "Y", "Z"})),
             "keep how high a point is above the floor, with its foot there"),
        with(keeping(CommandId::MeasureKeepSeen, "measure keep seen",
                     {right, down, number("RIGHT2", 0, 1), number("DOWN2", 0, 1)}),
             "keep the distance between what a pointer catches at two places of the image"),
        with(keeping(CommandId::MeasureKeepFace, "measure keep face", {right, down}),
             "keep the area of the face that is seen there"),
        with(keeping(CommandId::MeasureKeepVolume, "measure keep volume", {text("PART", ArgumentType::Part)}),
             "keep what a closed part encloses", "PART is a number, or a name that one part has"),
    };
}

} // namespace

std::vector<CommandSpec> keptMeasureCommands() {
    const CommandArgument n = whole("N", 1, static_cast<double>(rtcore::kMaxMeasures));
    std::vector<CommandSpec> all{
        {.id = CommandId::MeasureList,
         .name = "measure list",
         .arguments = {maybe(whole("FROM", 1))},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the measures that are kept; those from number FROM on",
         .more =
             "A line each: `1 distance 2.350 m 0 0 0, 2.35 0 0 door`, points in the coordinates of the "
             "model's file; the name may be missing. As many as an answer has room for. Where the unit is "
             "a guess, a last line says so"},
        {.id = CommandId::MeasureHidden,
         .name = "measure hidden",
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the points of kept measures that something hides from the camera",
         .more =
             "A line for each measure that has such points: its number, then theirs, from 1: `2 1` is the "
             "first end of the second measure. Glass hides, too; volumes, whose point is inside of what "
             "they tell, are left out, and so are points behind the camera. As many measures as an answer "
             "has room for"}};
    for (CommandSpec& row : keepingCommands()) all.push_back(std::move(row));
    const std::vector<CommandSpec> rest{
        {.id = CommandId::MeasureName,
         .name = "measure name",
         .arguments = {n, text("NAME")},
         .effect = Keeps,
         .step = "measure",
         .help = "name a measure, for its label; \"\": without a name"},
        {.id = CommandId::MeasureRemove,
         .name = "measure remove",
         .arguments = {orElse(n, "all")},
         .effect = Keeps,
         .step = "measure",
         .browser = BrowserUse::Edit,
         .help = "remove a measure, or all"},
        {.id = CommandId::MeasureUnit,
         .name = "measure unit",
         .arguments = {choiceOf(rtcore::kLengthUnits),
                       maybe(whole("DECIMALS", 0, rtcore::kMaxMeasureDecimals))},
         .effect = Keeps,
         .step = "measure",
         .browser = BrowserUse::Edit,
         .help = "the unit in which labels tell measures, and how many decimals they have"},
        {.id = CommandId::MeasureExport,
         .name = "measure export",
         .arguments = {path({"csv"})},
         .effect = Waits,
         .help = "write the measures that are kept as a table",
         .more =
             "Columns are `number,kind,name,value,unit,points`, as RFC 4180 has them: values with all "
             "digits in the unit of the labels, points in the coordinates of the model's file. A name that "
             "begins with =, +, - or @ gets a ' before it, so that no table program takes it for a formula"},
    };
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

} // namespace app
