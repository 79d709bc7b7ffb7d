// Rows for bookmarks, materials and parts.
#include "common/commands/command_rows.h"

namespace app {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;

std::vector<CommandSpec> bookmarkCommands() {
    return {
        {.id = CommandId::Bookmarks,
         .name = "bookmarks",
         .effect = Tells,
         .help = "print the names of the scene's bookmarks, a line each",
         .more = "Those of its file and those that were added; `save` writes them"},
        {.id = CommandId::BookmarkAdd,
         .name = "bookmark add",
         .arguments = {text("NAME"), {.name = "FILE", .type = Path, .files = {"cam"}, .optional = true}},
         .step = "bookmark",
         .help = "keep the view, or that of a .cam file, under a name; one of that name is replaced"},
        {.id = CommandId::BookmarkGo,
         .name = "bookmark go",
         .arguments = {text("NAME", Bookmark)},
         .step = "bookmark",
         .browser = BrowserUse::Move,
         .help = "look through a bookmark of the scene"},
        {.id = CommandId::BookmarkRename,
         .name = "bookmark rename",
         .arguments = {text("NAME"), text("NEW")},
         .effect = Keeps,
         .step = "bookmark",
         .help = "give a bookmark of the scene another name"},
        {.id = CommandId::BookmarkMove,
         .name = "bookmark move",
         .arguments = {text("NAME"), whole("POSITION", 1)},
         .effect = Keeps,
         .step = "bookmark",
         .help = "give a bookmark of the scene that position among them, from 1; a larger one than there are "
                 "is the last"},
        {.id = CommandId::BookmarkRemove,
         .name = "bookmark remove",
         .arguments = {text("NAME")},
         .effect = Keeps,
         .step = "bookmark",
         .help = "remove a bookmark from the scene"},
    };
}

std::vector<CommandSpec> modelCommands() {
    const CommandArgument material = text("MATERIAL", Material), part = text("PART", Part);
    const CommandArgument from = maybe(whole("FROM", 1));
    return {
        {.id = CommandId::Materials,
         .name = "materials",
         .arguments = {from},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the model's materials: number, edited or -, name; those from number FROM on",
         .more = "A line each: `3 edited glass`; the name may be missing. As many as an answer has room for"},
        {.id = CommandId::MaterialGet,
         .name = "material get",
         .arguments = {material},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print a material as it is shown, as a [[material]] of a .scn file says it",
         .more = "MATERIAL is a number, or a name or pattern as in a `[[material]]`; the first that fits"},
        {.id = CommandId::MaterialPresets,
         .name = "material presets",
         .effect = Tells,
         .needsScene = false,
         .help = "print the names of ready-made materials, a line each"},
        {.id = CommandId::MaterialSet,
         .name = "material set",
         .arguments = {material, text("KEY", MaterialKey), text("VALUE", MaterialValue),
                       manyOf(text("VALUE", MaterialValue))},
         .step = "material",
         .browser = BrowserUse::Edit,
         .help = "change a material, by the keys of a [[material]]",
         .more = "`material set floor diffuse 0.5 0.4 0.3`, `material set 3 roughness 0.2`, `material set "
                 "glass* opacity 0.1`, `material set wall textures false`. All materials that fit"},
        {.id = CommandId::MaterialCopy,
         .name = "material copy",
         .arguments = {text("FROM", Material), text("TO", Material), manyOf(text("TO", Material))},
         .step = "material",
         .help = "give materials the look of another one, with its edits, in place of their own",
         .more = "`material copy oak 'door*' 7`. Textures stay where the files give TO the same ones; other "
                 "images are copied by their mean colour, holes and normal maps not. The priority is copied, "
                 "too"},
        {.id = CommandId::MaterialPreset,
         .name = "material preset",
         .arguments = {material, text("NAME")},
         .step = "material",
         .help = "make a material a ready-made one, in place of its textures and edits",
         .more = "`material preset 'frame*' brass`; `material presets` lists them. All materials that fit; "
                 "their priority stays"},
        {.id = CommandId::MaterialReset,
         .name = "material reset",
         .arguments = {material},
         .step = "material",
         .browser = BrowserUse::Edit,
         .help = "take all edits of a material back: it is what the files say"},
        {.id = CommandId::Parts,
         .name = "parts",
         .arguments = {from},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help =
             "print the model's parts: number, shown or hidden, triangles, name; those from number FROM on",
         .more =
             "A line each: `12 shown 480 house/door`; parts of parts have slashes between their names. As "
             "many as an answer has room for"},
        {.id = CommandId::PartHide,
         .name = "part hide",
         .arguments = {part, manyOf(part)},
         .step = "visible parts",
         .browser = BrowserUse::Edit,
         .help = "hide parts: rays and bodies pass through them",
         .more = "PART is a number or a pattern for names: `part hide 'house/roof*'`"},
        {.id = CommandId::PartShow,
         .name = "part show",
         .arguments = {part, manyOf(part)},
         .step = "visible parts",
         .browser = BrowserUse::Edit,
         .help = "show hidden parts again"},
        {.id = CommandId::PartIsolate,
         .name = "part isolate",
         .arguments = {part, manyOf(part)},
         .step = "visible parts",
         .browser = BrowserUse::Edit,
         .help = "show these parts, hide all others"},
        {.id = CommandId::PartShowAll,
         .name = "part show-all",
         .step = "visible parts",
         .browser = BrowserUse::Edit,
         .help = "show all parts"},
        {.id = CommandId::Seen,
         .name = "seen",
         .arguments = {number("X", 0, 1), number("Y", 0, 1)},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print which part and which material are seen there, 0..1 from the left and from the top",
         .more = "Two lines, `part 12 house/door` and `material 3 oak`. Fails where nothing is seen"},
        {.id = CommandId::Mask,
         .name = "mask",
         .arguments = {choice("part|material"), whole("N", 1)},
         .effect = Tells,
         .help = "print where a part or a material is seen, for programs",
         .more = "Width and height of a coarse image, then lengths of runs of its pixels from the upper left "
                 "corner on, without and with it by turns"},
    };
}

} // namespace app
