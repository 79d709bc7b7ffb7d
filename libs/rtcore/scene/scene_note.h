/// Notes: texts at points of a scene, by whomever they are.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/camera.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

inline constexpr std::size_t kMaxNotes = 1000;
inline constexpr std::size_t kMaxNoteText = 2000;  ///< characters
inline constexpr std::size_t kMaxNoteBytes = 6000; ///< of them: a command has room for no more
inline constexpr std::size_t kMaxNoteAuthor = 64;  ///< characters

struct SceneNote {
    Vec3d point;                ///< scene units from the scene's zero, in doubles
    std::string text;           ///< UTF-8, not empty; with line breaks (\n) and tabs
    std::string author{};       ///< the same on one line; may be ""
    std::optional<Camera> view; ///< from which it was written; nameOffset is 0
    std::string written{};      ///< isDateTime(); may be ""
    friend bool operator==(const SceneNote&, const SceneNote&) = default;
};

using SceneNotes = std::vector<SceneNote>; ///< kMaxNotes at most

/// A key of [[note]] and why its value cannot be kept.
struct NoteProblem {
    std::string_view key;
    Sentence why;
};
/// A point beyond 1e12, a text or a name that is too long, no UTF-8 or has what has a
/// controlCode() (settings/plain_text.h) other than line breaks and tabs in the text, a text of blanks alone,
/// a time that is none.
std::optional<NoteProblem> problemOf(const SceneNote& note);

/// A date and a time of day as ISO 8601 has them, extended, of the years 1 to 9999: "2026-11-30T18:40:00Z",
/// with "+01:00" in place of the Z, or neither; a leap second is 60.
bool isDateTime(std::string_view text);

/// What people typed or pasted as a note has it: line breaks are \n, what has a controlCode() otherwise and
/// what is no UTF-8 is left out, and so are blanks and line breaks at both ends. Of any length.
std::string noteText(std::string_view typed);
/// The same for the name of an author, on one line: breaks and tabs are blanks.
std::string noteAuthor(std::string_view typed);

/// At most `max` bytes of it, by whole characters, with an ellipsis behind it where it was longer.
std::string shortened(const std::string& text, std::size_t max);

} // namespace rtcore
