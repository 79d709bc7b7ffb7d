/// Notes as the window tells them. They are texts of strangers: what shows them takes plain text alone.
#pragma once

#include "gui/models/scene_state.h"

#include <QString>

namespace gui {

/// A row of the list, on one line: "2  Ada: too dark here".
QString noteRow(const rtcore::SceneNote& note, int number);
/// Who wrote it, and when, as the user's language writes it; "" where neither is known.
QString noteHead(const rtcore::SceneNote& note);
/// That, and the text below it.
QString wholeNote(const rtcore::SceneNote& note);

} // namespace gui
