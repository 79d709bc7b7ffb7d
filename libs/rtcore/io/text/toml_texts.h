/// Texts of toml++ (3.0 to 3.4) about what is no TOML, and their meaning for people.
#pragma once

#include "rtcore/settings/library_text.h"

#include <array>

namespace rtcore {

namespace toml_forms {

inline constexpr const char
    *kOpenText = form("a text does not end; close its quotes on the same line"),
    *kBackslash = form("a backslash has a meaning of its own in double quotes; write two of them, or put the "
                       "text in single quotes"),
    *kNoValue = form("this is no value; a text stands in quotes, a switch is true or false"),
    *kNoNumber = form("this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"),
    *kTooLarge = form("{1} is too large a number"),
    *kNoDate = form("this is no date and no time; a text stands in quotes, a number is like 7, -0.5 or 1e6"),
    *kInvisible = form("a character stands here that cannot be seen; delete it"),
    *kKey = form("a key cannot hold '{0}'; it is of letters, digits, - and _, or stands in quotes"),
    *kQuotedKey = form("a key stands on one line; use one quote at each end, not three"),
    *kEnds = form("the file ends in the middle of a line or a list; complete it"),
    *kHeading = form("a section begins with [name] or [[name]]"),
    *kOpenHeading = form("a ] should stand here, not '{0}'; a section begins with [name] or [[name]]"),
    *kTwice = form("'{2}' is there twice; keep one of them"),
    *kTwiceInAll = form("a key is there twice, or once as a value and once as a section; keep one of them"),
    *kEquals = form("a = should stand here, not '{0}'; a line reads key = value"),
    *kMissing = form("a value is missing here"),
    *kTooMuch = form("'{1}' does not belong on this line; begin a new one, or a comment with #"),
    *kLine = form("a line cannot begin with '{0}'; it reads key = value, or [name]"),
    *kList = form("a comma or ] should stand here, not '{0}'"),
    *kBraces = form("what stands in braces reads { key = value, key = value }, all on one line");

} // namespace toml_forms

/// In the order in which they are to be tried: in one scope of toml++, in any scope, and all else of a scope.
inline constexpr auto kTomlTexts = std::to_array<LibraryText>({
    {"Error while parsing string: encountered end-of-file", toml_forms::kOpenText},
    {"Error while parsing string: unescaped control characters {0}", toml_forms::kOpenText},
    {"Error while parsing literal string: encountered end-of-file", toml_forms::kOpenText},
    {"Error while parsing literal string: control characters {0}", toml_forms::kOpenText},
    {"Error while parsing floating-point: expected '{0}', saw '{1}'", toml_forms::kNoValue},
    {"Error while parsing value: unexpected control character", toml_forms::kInvisible},
    {"Error while parsing key: expected bare key starting character or string delimiter, saw '{0}'",
     toml_forms::kKey},
    {"Error while parsing key: multi-line strings are prohibited in {0}", toml_forms::kQuotedKey},
    {"Error while parsing table header: expected ']', saw '{0}'", toml_forms::kOpenHeading},
    {"Error while parsing key-value pair: expected '=', saw '{0}'", toml_forms::kEquals},
    {"Error while parsing key-value pair: expected value, saw '{0}'", toml_forms::kMissing},
    {"Error while parsing root table: expected keys, tables, whitespace or comments, saw '{0}'",
     toml_forms::kLine},
    {"Error while parsing array: expected value or closing ']', saw comma", toml_forms::kMissing},
    {"Error while parsing array: expected comma or closing ']', saw '{0}'", toml_forms::kList},

    {"Error while parsing {0}: '{1}' is not representable in 64 bits", toml_forms::kTooLarge},
    {"Error while parsing {0}: '{1}' could not be interpreted as a value", toml_forms::kTooLarge},
    {"Error while parsing {0}: expected space or tab, saw '{1}'", toml_forms::kInvisible},
    {"Error while parsing {0}: expected '\\n' after '\\r', saw {1}", toml_forms::kInvisible},
    {"Error while parsing {0}: vertical tabs '\\v' {1}", toml_forms::kInvisible},
    {"Error while parsing {0}: expected a comment or whitespace, saw '{1}'", toml_forms::kTooMuch},
    {"Error while parsing {0}: cannot redefine existing {1} as dotted key-value pair",
     toml_forms::kTwiceInAll},
    {"Error while parsing {0}: cannot redefine existing {1} '{2}' as {3}", toml_forms::kTwice},
    {"Error while parsing {0}: cannot redefine existing {1} '{2}'", toml_forms::kTwice},
    {"Error while parsing {0}: cannot insert '{1}' into {2}", toml_forms::kTwiceInAll},

    {"Error while parsing string: {0}", toml_forms::kBackslash},
    {"Error while parsing unicode scalar sequence: {0}", toml_forms::kBackslash},
    {"Error while parsing comment: {0}", toml_forms::kInvisible},
    {"Error while parsing floating-point: {0}", toml_forms::kNoNumber},
    {"Error while parsing hexadecimal floating-point: {0}", toml_forms::kNoNumber},
    {"Error while parsing {0} integer: {1}", toml_forms::kNoNumber},
    {"Error while parsing date: {0}", toml_forms::kNoDate},
    {"Error while parsing time: {0}", toml_forms::kNoDate},
    {"Error while parsing date-time: {0}", toml_forms::kNoDate},
    {"Error while parsing date-time offset: {0}", toml_forms::kNoDate},
    {"Error while parsing boolean: {0}", toml_forms::kNoValue},
    {"Error while parsing value: {0}", toml_forms::kNoValue},
    {"Error while parsing {0}: encountered end-of-file", toml_forms::kEnds},
    {"Error while parsing table header: {0}", toml_forms::kHeading},
    {"Error while parsing inline table: {0}", toml_forms::kBraces},
});

} // namespace rtcore
