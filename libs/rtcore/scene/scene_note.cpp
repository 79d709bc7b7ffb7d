#include "rtcore/scene/scene_note.h"

#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::string_view kBlank = " \t\n";

bool hasCoordinatesNearby(Vec3d p) {
    constexpr double kFarthest = 1e12;
    return std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest && std::fabs(p.z) <= kFarthest;
}

/// Characters of UTF-8; nothing: it is none, or one of them is a control character that is not `allowed`.
std::optional<std::size_t> charactersOf(std::string_view text, std::string_view allowed) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) {
        const std::size_t bytes = utf8Length(text);
        if (bytes == 0) return std::nullopt;
        const bool taken = bytes == 1 && allowed.find(text[0]) != std::string_view::npos;
        if (!taken && controlCode(text.substr(0, bytes))) return std::nullopt;
        text.remove_prefix(bytes);
    }
    return count;
}

std::optional<Sentence> problemOfText(const std::string& text) {
    const auto characters = charactersOf(text, "\n\t");
    if (!characters)
        return say("the text of a note is UTF-8 without control characters, but for line breaks and tabs");
    if (text.find_first_not_of(kBlank) == std::string::npos) return say("the note has no text");
    if (*characters > kMaxNoteText || text.size() > kMaxNoteBytes)
        return say("the text of a note has at most {0} characters and {1} bytes", kMaxNoteText,
                   kMaxNoteBytes);
    return std::nullopt;
}

std::string withoutBlankEnds(const std::string& text) {
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

/// Two digits at that index; -1: there are none.
int twoDigits(std::string_view text, std::size_t at) {
    const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    return digit(at) && digit(at + 1) ? (text[at] - '0') * 10 + (text[at + 1] - '0') : -1;
}

int daysOf(int year, int month) {
    constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    return kDays.at(static_cast<std::size_t>(month - 1)) + (leap && month == 2 ? 1 : 0);
}

bool isDate(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    const int century = twoDigits(text, 0), rest = twoDigits(text, 2);
    const int month = twoDigits(text, 5), day = twoDigits(text, 8), year = 100 * century + rest;
    return century >= 0 && rest >= 0 && year > 0 && month >= 1 && month <= 12 && day >= 1 &&
           day <= daysOf(year, month);
}

/// "18:40".
bool isHourAndMinute(std::string_view text) {
    const int hour = twoDigits(text, 0), minute = twoDigits(text, 3);
    return text.size() == 5 && text[2] == ':' && hour >= 0 && hour < 24 && minute >= 0 && minute < 60;
}

bool isZone(std::string_view text) {
    if (text.empty() || text == "Z") return true;
    return (text[0] == '+' || text[0] == '-') && isHourAndMinute(text.substr(1));
}

} // namespace

bool isDateTime(std::string_view text) {
    constexpr std::size_t kDate = 10, kSeconds = 17, kZone = 19;
    if (text.size() < kZone || text[kDate] != 'T' || text[kSeconds - 1] != ':') return false;
    const int second = twoDigits(text, kSeconds);
    return isDate(text.substr(0, kDate)) && isHourAndMinute(text.substr(kDate + 1, 5)) && second >= 0 &&
           second <= 60 && isZone(text.substr(kZone));
}

std::optional<NoteProblem> problemOf(const SceneNote& note) {
    if (!hasCoordinatesNearby(note.point))
        return NoteProblem{
            "point", say("the point of the note has a coordinate beyond 1e12; give one near the model")};
    if (auto why = problemOfText(note.text)) return NoteProblem{"text", *std::move(why)};
    const auto letters = charactersOf(note.author, "");
    if (!letters || *letters > kMaxNoteAuthor)
        return NoteProblem{"author", say("the name of an author is UTF-8 of at most {0} characters, without "
                                         "control characters",
                                         kMaxNoteAuthor)};
    if (!note.written.empty() && !isDateTime(note.written))
        return NoteProblem{"written", say("written is no time such as 2026-11-30T18:40:00Z")};
    return std::nullopt;
}

std::string noteText(std::string_view typed) {
    std::string text;
    while (!typed.empty()) {
        const std::size_t bytes = std::max<std::size_t>(utf8Length(typed), 1);
        const std::string_view character = typed.substr(0, bytes);
        typed.remove_prefix(bytes);
        const bool ends = character == "\n" || character == "\xE2\x80\xA8" || character == "\xE2\x80\xA9";
        if (ends || (character == "\r" && !typed.starts_with('\n')))
            text += '\n';
        else if (character == "\t" || (utf8Length(character) > 0 && !controlCode(character)))
            text += character;
    }
    return withoutBlankEnds(text);
}

std::string noteAuthor(std::string_view typed) {
    std::string text = noteText(typed);
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return text;
}

std::string shortened(const std::string& text, std::size_t max) {
    constexpr std::string_view kEllipsis = "\xE2\x80\xA6";
    if (text.size() <= max) return text;
    const std::size_t room = max > kEllipsis.size() ? max - kEllipsis.size() : 0;
    return std::string(utf8Beginning(text, room)).append(kEllipsis);
}

} // namespace rtcore
