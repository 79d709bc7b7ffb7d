// Commands for notes: texts at points of the model.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/measured_points.h"
#include "rtserver/commands/note_views.h"
#include "rtserver/commands/seen_surface.h"
#include "rtserver/commands/table_text.h"

#include "ipc/layout/limits.h"

#include "common/cli/command_line.h"

#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_plane.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <string>
#include <utility>

namespace rtserver {

namespace {

using rtcore::SceneNote;
using rtcore::SceneNotes;

std::string timeNow() {
    namespace time = std::chrono;
    const auto now = time::floor<time::seconds>(time::system_clock::now());
    const auto day = time::floor<time::days>(now);
    const time::year_month_day date(day);
    const time::hh_mm_ss hours(now - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       hours.hours().count(), hours.minutes().count(), hours.seconds().count());
}

void checkNote(const SceneNote& note) {
    if (const auto problem = problemOf(note)) throw rtcore::BadValue(problem->why);
}

/// `texts`: the argument that is the text, before that of the author.
Result addNote(const Call& call, const rtcore::Vec3d& point, std::size_t texts) {
    SceneNotes all = call.document().notes();
    if (all.size() >= rtcore::kMaxNotes)
        throw rtcore::Refusal(
            rtcore::say("there are {0} notes already; remove one first", rtcore::kMaxNotes));
    SceneNote note{.point = point,
                   .text = rtcore::noteText(call[texts]),
                   .author = call.size() > texts + 1 ? rtcore::noteAuthor(call[texts + 1]) : "",
                   .view = viewOnto(call.document(), point),
                   .written = timeNow()};
    checkNote(note);
    if (call.visitor) {
        call.document().addToAllNotes(note);
    } else {
        all.push_back(std::move(note));
        call.document().setNotes(std::move(all));
    }
    return {.answer = std::to_string(call.document().notes().size())};
}

Result addNoteAtPoint(const Call& call) {
    const rtcore::FilePoint& zero = call.document().scene()->origin.at;
    return addNote(call, filePointAt(call, 0) - rtcore::Vec3d{zero[0], zero[1], zero[2]}, 3);
}

Result addNoteAtSeen(const Call& call) {
    const auto seen = surfaceAt(call.document(), number(call[0]), number(call[1]));
    if (!seen) throw rtcore::Refusal("nothing of the model is seen there");
    return addNote(call, rtcore::exact(seen->position), 2);
}

/// All notes, and that which the first argument numbers.
std::pair<SceneNotes, std::size_t> chosenNote(const Call& call) {
    SceneNotes all = call.document().notes();
    const auto number = static_cast<std::size_t>(integer(call[0]));
    if (number > all.size())
        throw rtcore::Refusal(rtcore::say("there is no note {0}; 'note list' lists them", number));
    return {std::move(all), number - 1};
}

Result changeNote(const Call& call) {
    auto [all, i] = chosenNote(call);
    all[i].text = rtcore::noteText(call[1]);
    if (call.size() > 2) all[i].author = rtcore::noteAuthor(call[2]);
    checkNote(all[i]);
    call.document().setNotes(std::move(all));
    return {};
}

Result removeNote(const Call& call) {
    if (call[0] == "all") {
        call.document().setNotes({});
        return {};
    }
    auto [all, i] = chosenNote(call);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    call.document().setNotes(std::move(all));
    return {};
}

Result goToNote(const Call& call) {
    const auto [all, i] = chosenNote(call);
    const SceneNote& note = all[i];
    call.document().setCamera(note.view ? *note.view : viewTowards(call.document(), note.point));
    return {};
}

std::string lineOf(const Call& call, std::size_t index) {
    constexpr std::size_t kShownBytes = 200;
    const SceneNote& note = call.document().notes()[index];
    std::string text = note.text;
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    const std::string author = note.author.empty() ? "" : note.author + ": ";
    return fmt::format("{} {} {}{}\n", index + 1, pointText(note.point, call.document().scene()->origin),
                       author, rtcore::shortened(text, kShownBytes));
}

Result listNotes(const Call& call) {
    std::string text;
    for (auto i = static_cast<std::size_t>(call.size() > 0 ? integer(call[0]) - 1 : 0);
         i < call.document().notes().size(); ++i) {
        const std::string line = lineOf(call, i);
        if (text.size() + line.size() > ipc::kMaxAnswerText) break;
        text += line;
    }
    if (!text.empty()) text.pop_back();
    return {.answer = text};
}

Result tellNote(const Call& call) {
    const auto [all, i] = chosenNote(call);
    return {.answer = all[i].text};
}

std::string noteTable(const Call& call) {
    std::string table = "number,author,written,point,text\r\n";
    std::size_t number = 0;
    for (const SceneNote& note : call.document().notes())
        table += fmt::format("{},{},{},{},{}\r\n", ++number, tableField(note.author), note.written,
                             pointText(note.point, call.document().scene()->origin), tableField(note.text));
    return table;
}

Result exportNotes(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), table = noteTable(call),
                     inputs = call.document().world().inputs]() -> Finish {
                refuseInput(inputs, path, "");
                const std::array<std::span<const std::byte>, 1> pieces{std::as_bytes(std::span(table))};
                rtcore::writeFileAtomically(path, pieces);
                return [path] { return path.string(); };
            }};
}

constexpr std::array kNoteFunctions{
    CommandFunction{app::CommandId::NoteList, listNotes},
    CommandFunction{app::CommandId::NoteGet, tellNote},
    CommandFunction{app::CommandId::NoteAdd, addNoteAtPoint},
    CommandFunction{app::CommandId::NoteAt, addNoteAtSeen},
    CommandFunction{app::CommandId::NoteText, changeNote},
    CommandFunction{app::CommandId::NoteRemove, removeNote},
    CommandFunction{app::CommandId::NoteGo, goToNote},
    CommandFunction{app::CommandId::NoteExport, exportNotes},
};

} // namespace

std::span<const CommandFunction> noteFunctions() { return kNoteFunctions; }

} // namespace rtserver
