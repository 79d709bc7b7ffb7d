#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>

namespace rtcore {

namespace {

SceneNote readNote(StrictTable& table, Vec3 up) {
    const auto point = table.precisePosition("point");
    const auto text = table.text("text");
    SceneNote note;
    note.author = table.text("author").value_or("");
    note.written = table.text("written").value_or("");
    const bool seen =
        std::ranges::any_of(kCameraKeys, [&](std::string_view key) { return table.value(key) != nullptr; });
    if (seen)
        note.view = readCamera(table, up, true);
    else
        table.finish();
    const FilePoint p = table.require("point", point);
    note.point = {p[0], p[1], p[2]};
    note.text = table.require("text", text);
    if (const auto problem = problemOf(note)) table.fail(problem->key, problem->why);
    return note;
}

} // namespace

SceneNotes readNotes(StrictTable& root, Vec3 up) {
    SceneNotes notes;
    for (StrictTable& table : root.tables("note")) {
        root.needVersion(2, "note");
        if (notes.size() == kMaxNotes)
            table.fail("text", say("there are more than {0} notes; leave some out", kMaxNotes));
        notes.push_back(readNote(table, up));
    }
    return notes;
}

void writeNote(TomlWriter& writer, const SceneNote& note) {
    writer.section("[[note]]");
    writer.add("point", FilePoint{note.point.x, note.point.y, note.point.z});
    writer.add("text", note.text);
    if (!note.author.empty()) writer.add("author", note.author);
    if (!note.written.empty()) writer.add("written", note.written);
    if (note.view) writeCamera(writer, *note.view);
}

} // namespace rtcore
