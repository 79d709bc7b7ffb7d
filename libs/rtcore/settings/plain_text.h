/// Text of others - names in files, of files and of people - for places that obey what they show: terminals,
/// logs, windows, pages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// The code point of a character that is a command where text is shown, nothing for all others: a control
/// character (C0, DEL, C1), a separator of lines or paragraphs (U+2028, U+2029), or a mark that changes the
/// direction of what stands around it (the property Bidi_Control of Unicode 15: U+061C, U+200E, U+200F,
/// U+202A to U+202E, U+2066 to U+2069). `character` is one of well-formed UTF-8.
std::optional<unsigned> controlCode(std::string_view character);

/// `text` fit for a message on one line, for a terminal and for a page: what has a controlCode(), and what is
/// no UTF-8, as `\xNN`, byte by byte; cut to `limit` bytes and "..." when longer. All else stays as it is.
std::string printable(std::string_view text, std::size_t limit = std::string_view::npos);
/// The same for a name, in single quotes; 64 bytes at most.
std::string inQuotes(std::string_view text);
/// The same with what is no text left out, and cut to `max` characters.
std::string withoutControls(std::string_view text, std::size_t max);

} // namespace rtcore
