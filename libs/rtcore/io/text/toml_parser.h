/// TOML text into a tree of values. toml++ is behind this header and nowhere else.
#pragma once

#include "rtcore/io/text/text_value.h"

#include <string>
#include <string_view>

namespace rtcore {

/// The root table (its content is a TextTable). `file` is named in errors.
/// Throws FileError BadData, with line and column, when `text` is no TOML 1.0 in UTF-8 or exceeds the bounds
/// of toml_guard.h. Safe from many threads.
TextValue parseToml(std::string_view text, const std::string& file);

} // namespace rtcore
