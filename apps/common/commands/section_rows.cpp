// Rows for the planes that cut the model open.
#include "common/commands/command_rows.h"

#include "rtcore/scene/section_planes.h"

namespace app {

using enum CommandEffect;

std::vector<CommandSpec> sectionCommands() {
    const CommandArgument section = whole("N", 1, rtcore::kMaxSectionPlanes),
                          part = text("PART", ArgumentType::Part);
    return {
        {.id = CommandId::Sections,
         .name = "sections",
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help =
             "print the planes that cut the model open: number, a point, the normal; then what light knows, "
             "and how solids are closed",
         .more = "A line each, `1 0 1.2 0 0 1 0`, and `light whole` or `light cut`, `caps own`, `colour 0.1 "
                 "0.1 0.1` "
                 "and `hatching off` at the end; then `open NAME` for each part that is cut and has no cap, "
                 "since it is not closed, and `uncut NAME` for each that is left whole. The model is taken "
                 "away on the side that the normal points to"},
        {.id = CommandId::SectionAdd,
         .name = "section add",
         .arguments = numbers({"X", "Y", "Z", "NX", "NY", "NZ"}),
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "cut the model open: take away what lies beyond the point, along the normal N",
         .more = "`section add 0 1.2 0 0 1 0` takes away all above 1.2. Up to six, each of which takes more "
                 "away: corners cannot be cut out, since what is left must be convex"},
        {.id = CommandId::SectionHere,
         .name = "section here",
         .arguments = {number("RIGHT", 0, 1), number("DOWN", 0, 1)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "cut along the face that is seen there, 0..1 from the left and from the top",
         .more = "What lies before the face is taken away, and the face stays; `section move` goes on from "
                 "there"},
        {.id = CommandId::SectionThrough,
         .name = "section through",
         .arguments = {choice("x|y|z|-x|-y|-z")},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "cut through the middle of the model: take away what lies on that side of it",
         .more = "The middle of what `camera fit` shows: of the model without wide surroundings"},
        {.id = CommandId::SectionBox,
         .name = "section box",
         .arguments = numbers({"X", "Y", "Z", "X2", "Y2", "Z2"}),
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "leave what is in a box between two corners; in place of all sections"},
        {.id = CommandId::SectionMove,
         .name = "section move",
         .arguments = {section, number("DISTANCE")},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "move a section along its normal, in scene units; below 0: takes more away"},
        {.id = CommandId::SectionAt,
         .name = "section at",
         .arguments = ArgumentList{section} + numbers({"X", "Y", "Z"}),
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "let a section go through that point; its normal stays"},
        {.id = CommandId::SectionPlane,
         .name = "section plane",
         .arguments = ArgumentList{section} + numbers({"X", "Y", "Z", "NX", "NY", "NZ"}),
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "turn a section: it goes through that point, and takes away what lies along the normal N"},
        {.id = CommandId::SectionTurn,
         .name = "section turn",
         .arguments = {section},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "take away the other side"},
        {.id = CommandId::SectionRemove,
         .name = "section remove",
         .arguments = {section},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "remove a section"},
        {.id = CommandId::SectionClear,
         .name = "section clear",
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "remove all sections: the model is whole again"},
        {.id = CommandId::SectionLight,
         .name = "section light",
         .arguments = {choiceOf(rtcore::kSectionLights)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "whole: rooms keep their light, as if nothing was cut; cut: light falls in"},
        {.id = CommandId::SectionCaps,
         .name = "section caps",
         .arguments = {choiceOf(rtcore::kCapColours)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help =
             "close solids that are cut: own: in the colours of their materials; one: all in one; none: not"},
        {.id = CommandId::SectionColour,
         .name = "section colour",
         .arguments = {number("R", 0, 1), number("G", 0, 1), number("B", 0, 1)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "the one colour of caps: linear, as a display shows it"},
        {.id = CommandId::SectionHatching,
         .name = "section hatching",
         .arguments = {choice("on|off")},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "lines across caps"},
        {.id = CommandId::SectionLeave,
         .name = "section leave",
         .arguments = {part, manyOf(part)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "leave these parts whole, whatever is cut",
         .more =
             "PART is a number or a pattern for names: `section leave 'house/stairs*'`. Such parts have no "
             "caps, and stay in the way of a walker"},
        {.id = CommandId::SectionCut,
         .name = "section cut",
         .arguments = {part, manyOf(part)},
         .step = "section",
         .browser = BrowserUse::Edit,
         .help = "cut these parts again"},
    };
}

} // namespace app
