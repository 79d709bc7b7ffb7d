/// Shell patterns for names.
#pragma once

#include <string_view>

namespace rtcore {

/// True when `name` fits `pattern` as a whole: '*' stands for any characters or none, '?' for one character
/// (one byte at least, all of its bytes in UTF-8), everything else for itself. Upper and lower case differ.
/// Time at most the product of the lengths; does not allocate.
bool matchesPattern(std::string_view pattern, std::string_view name);

/// Whether it stands for other names than itself.
inline bool isPattern(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

} // namespace rtcore
