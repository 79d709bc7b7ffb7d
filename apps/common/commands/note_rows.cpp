// Rows for notes: texts at points of the model.
#include "common/commands/command_rows.h"

#include "rtcore/scene/scene_note.h"

namespace app {

using enum CommandEffect;

namespace {

std::vector<CommandSpec> noteWriting(const CommandArgument& n) {
    const CommandArgument words = text("TEXT", ArgumentType::Note);
    const CommandArgument author = maybe(text("AUTHOR", ArgumentType::Author));
    return {
        {.id = CommandId::NoteAdd,
         .name = "note add",
         .arguments = numbers({"X", "Y", "Z"}) + ArgumentList{words, author},
         .effect = Keeps,
         .step = "note",
         .browser = BrowserUse::Edit,
         .help = "keep a text at a point of the model, and print its number",
         .more =
             "It is shown over the image, saved in `.scn` files with the time, and a step of `undo`; 1,000 "
             "at "
             "most, of 2,000 characters and 6,000 bytes each. Quotation marks hold a text of several words "
             "together. Where the point is in the image, the view is kept with it"},
        {.id = CommandId::NoteAt,
         .name = "note at",
         .arguments = {number("RIGHT", 0, 1), number("DOWN", 0, 1), words, author},
         .effect = Keeps,
         .step = "note",
         .browser = BrowserUse::Edit,
         .help = "the same at what is seen there, 0..1 from the left and from the top"},
        {.id = CommandId::NoteText,
         .name = "note text",
         .arguments = {n, words, author},
         .effect = Keeps,
         .step = "note",
         .browser = BrowserUse::Edit,
         .help = "another text for a note, and, where that is given, another author; \"\": none"},
        {.id = CommandId::NoteRemove,
         .name = "note remove",
         .arguments = {orElse(n, "all")},
         .effect = Keeps,
         .step = "note",
         .browser = BrowserUse::Edit,
         .help = "remove a note, or all"},
    };
}

} // namespace

std::vector<CommandSpec> noteCommands() {
    const CommandArgument n = whole("N", 1, static_cast<double>(rtcore::kMaxNotes));
    std::vector<CommandSpec> all{
        {.id = CommandId::NoteList,
         .name = "note list",
         .arguments = {maybe(whole("FROM", 1))},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the notes of the scene; those from number FROM on",
         .more = "A line each: `1 0 0.5 -2 Ada: too dark here`, the point in the coordinates of the model's "
                 "file; line breaks are blanks, and long texts are shortened. As many as an answer has room "
                 "for"},
        {.id = CommandId::NoteGet,
         .name = "note get",
         .arguments = {n},
         .effect = Tells,
         .browser = BrowserUse::Look,
         .help = "print the text of a note, with its line breaks"}};
    for (CommandSpec& row : noteWriting(n)) all.push_back(std::move(row));
    const std::vector<CommandSpec> rest{
        {.id = CommandId::NoteGo,
         .name = "note go",
         .arguments = {n},
         .step = "note",
         .browser = BrowserUse::Move,
         .help = "look from where a note was written, or, where that is not known, at its point"},
        {.id = CommandId::NoteExport,
         .name = "note export",
         .arguments = {path({"csv"})},
         .effect = Waits,
         .help = "write the notes as a table",
         .more = "Columns are `number,author,written,point,text`, as RFC 4180 has them. A field that begins "
                 "with =, +, - or @ gets a ' before it, so that no table program takes it for a formula"},
    };
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

} // namespace app
