/// What the user may have meant: suggestions for misspelt names in files and on command lines.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rtcore {

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`, upper and lower case
/// counting as equal (optimal string alignment, Damerau 1964). Time and memory grow with the product of the
/// lengths.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The member of `known` that is nearest to `name`, or "" when none is near (more than half of the letters
/// differ) or `name` is longer than any name. A dotted name is also found by its last part alone.
std::string_view nearestName(std::string_view name, std::span<const std::string_view> known);

/// `text` fit for a message on one line, and for a terminal: control characters, and what is no UTF-8, as
/// `\xNN`; cut to `limit` bytes and "..." when longer. What is printable stays as it is.
std::string printable(std::string_view text, std::size_t limit = std::string_view::npos);
/// The same for a name, in single quotes.
std::string inQuotes(std::string_view text);

/// Says that `name` is none of `known`, with the nearest one, or with all of them when none is near:
///   unknown key 'eey'; did you mean 'eye'?
std::string unknownNameMessage(std::string_view what, std::string_view name,
                               std::span<const std::string_view> known);

} // namespace rtcore
