#include "rtcore/scene/scene_note.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using rtcore::SceneNote;

std::string keyOfProblem(const SceneNote& note) {
    const auto problem = problemOf(note);
    return problem ? std::string(problem->key) : "";
}

SceneNote darkCorner() {
    return {.point = {1, 2, 3}, .text = "Too dark,\nsays \xC5\xBD", .author = "Ada", .view = {}};
}

TEST(SceneNote, IsRefusedByTheKeyThatIsWrong) {
    EXPECT_EQ(keyOfProblem(darkCorner()), "");
    SceneNote note = darkCorner();
    note.point.y = std::nan("");
    EXPECT_EQ(keyOfProblem(note), "point");
    note = darkCorner();
    for (const char* const text : {"", " \n\t", "bell \a", "\xFF", "esc \x1B[0m", "turned \xE2\x80\xAE"}) {
        note.text = text;
        EXPECT_EQ(keyOfProblem(note), "text") << text;
    }
    note = darkCorner();
    for (const char* const author : {"a\nb", "a\tb", "\x7F", "\xC3"}) {
        note.author = author;
        EXPECT_EQ(keyOfProblem(note), "author") << author;
    }
    note = darkCorner();
    note.written = "yesterday";
    EXPECT_EQ(keyOfProblem(note), "written");
}

TEST(SceneNote, HasBoundsOfCharactersAndOfBytes) {
    const auto repeated = [](const std::string& character, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += character;
        return text;
    };
    SceneNote note = darkCorner();
    note.text = repeated("\xE2\x82\xAC", rtcore::kMaxNoteText);
    EXPECT_EQ(keyOfProblem(note), "") << "2,000 of three bytes";
    note.text += "x";
    EXPECT_EQ(keyOfProblem(note), "text");
    note.text = repeated("\xF0\x9F\x98\x80", 1501);
    EXPECT_EQ(keyOfProblem(note), "text") << "6,004 bytes";
    note = darkCorner();
    note.author = repeated("\xF0\x9F\x98\x80", rtcore::kMaxNoteAuthor);
    EXPECT_EQ(keyOfProblem(note), "");
    note.author += "x";
    EXPECT_EQ(keyOfProblem(note), "author");
}

TEST(SceneNote, HasATimeAsIso8601HasIt) {
    for (const char* const good : {"2026-11-30T18:40:00Z", "2024-02-29T00:00:00", "2000-02-29T23:59:60+01:00",
                                   "0001-01-01T00:00:00-11:30"})
        EXPECT_TRUE(rtcore::isDateTime(good)) << good;
    for (const char* const bad :
         {"", "2026-11-30", "2026-11-30 18:40:00Z", "2026-13-01T00:00:00Z", "2026-02-29T00:00:00Z",
          "1900-02-29T00:00:00Z", "2026-00-01T00:00:00Z", "2026-01-00T00:00:00Z", "0000-01-01T00:00:00Z",
          "2026-01-01T24:00:00Z", "2026-01-01T00:60:00Z", "2026-01-01T00:00:61Z", "2026-01-01T00:00:00z",
          "2026-01-01T00:00:00+1:00", "2026-01-01T00:00:00+01:00Z", "2026-01-01T00:00:00.5Z",
          "2O26-01-01T00:00:00Z", "2026-01-01T00:00", "2026-01-01T00:00:00+24:00"})
        EXPECT_FALSE(rtcore::isDateTime(bad)) << bad;
}

TEST(SceneNote, TakesWhatPeopleTypeWithoutWhatTerminalsObey) {
    EXPECT_EQ(rtcore::noteText(" a\r\nb\rc\xE2\x80\xA9 d\te \n"), "a\nb\nc\n d\te");
    EXPECT_EQ(rtcore::noteText(std::string("\x1B[1mbold\0\xFF\xE2\x80\xAEx", 14)), "[1mboldx");
    EXPECT_EQ(rtcore::noteText("\a \r\n"), "");
    EXPECT_EQ(rtcore::noteAuthor(" Ada\n\tLovelace\x7F "), "Ada  Lovelace");
    EXPECT_EQ(rtcore::noteText("<b>\"=1+2\""), "<b>\"=1+2\"") << "markup is text";
}

TEST(SceneNote, IsShortenedByWholeCharacters) {
    EXPECT_EQ(rtcore::shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(rtcore::shortened("abcdefg", 6), "abc\xE2\x80\xA6");
    EXPECT_EQ(rtcore::shortened("ab\xE2\x82\xAC\xE2\x82\xAC", 7), "ab\xE2\x80\xA6");
    EXPECT_EQ(rtcore::shortened("abcdefg", 2), "\xE2\x80\xA6");
}

} // namespace
