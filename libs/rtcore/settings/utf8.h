/// Well-formed UTF-8 (Unicode 15, table 3-7).
#pragma once

#include <cstddef>
#include <string_view>

namespace rtcore {

/// Bytes of the first character; 0 when the text is empty or does not begin with a well-formed one.
std::size_t utf8Length(std::string_view text);

/// The first byte that is not part of a well-formed character, or npos.
std::size_t findInvalidUtf8(std::string_view text);

/// The beginning of `text` of at most `max` bytes, cut between characters; of bytes that are no UTF-8, where
/// a character could begin.
std::string_view utf8Beginning(std::string_view text, std::size_t max);

} // namespace rtcore
