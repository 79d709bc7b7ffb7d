// Rows for variants: sets of edits that are switched at once.
#include "common/commands/command_rows.h"

namespace app {

using enum CommandEffect;

std::vector<CommandSpec> variantCommands() {
    const CommandArgument name = text("NAME", ArgumentType::Variant);
    return {
        {.id = CommandId::VariantList,
         .name = "variant list",
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the variants of the scene: whether it is shown, name",
         .more = "A line each: `on oak floor`, `off walnut`"},
        {.id = CommandId::VariantGet,
         .name = "variant get",
         .arguments = {name},
         .effect = Tells,
         .help = "print a variant as a [[variant]] of a .scn file says it"},
        {.id = CommandId::VariantAdd,
         .name = "variant add",
         .arguments = {name},
         .effect = Keeps,
         .step = "variant",
         .help = "keep what differs from the base as a variant: materials, hidden parts, lights, the sky",
         .more = "The base is the scene as it was opened, or as `variant rebase` left it. A variant of that "
                 "name is replaced"},
        {.id = CommandId::VariantUpdate,
         .name = "variant update",
         .arguments = {maybe(name)},
         .effect = Keeps,
         .step = "variant",
         .help = "keep what a variant names as it is shown now; without NAME: the one that is shown"},
        {.id = CommandId::VariantRename,
         .name = "variant rename",
         .arguments = {name, text("NEW")},
         .effect = Keeps,
         .step = "variant",
         .help = "give a variant another name"},
        {.id = CommandId::VariantRemove,
         .name = "variant remove",
         .arguments = {name},
         .effect = Keeps,
         .step = "variant",
         .help = "remove a variant; what is shown stays"},
        {.id = CommandId::VariantRebase,
         .name = "variant rebase",
         .effect = Keeps,
         .step = "variant",
         .help = "let what is shown be the base of all variants"},
        {.id = CommandId::VariantGo,
         .name = "variant go",
         .arguments = {name},
         .step = "variant",
         .browser = BrowserUse::Edit,
         .sets = {"skyLight.on"},
         .help = "show a variant in place of the one that is shown",
         .more = "What that one changed and NAME does not name becomes as in the base. Edits of what neither "
                 "names stay"},
        {.id = CommandId::VariantLeave,
         .name = "variant leave",
         .step = "variant",
         .browser = BrowserUse::Edit,
         .sets = {"skyLight.on"},
         .help = "show the base in place of a variant"},
    };
}

} // namespace app
