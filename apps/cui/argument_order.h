/// Commands take numbers, and numbers may be negative.
#pragma once

#include "common/cli/options.h"

#include <string>
#include <vector>

namespace cui {

/// The same words, options first, then "--" and all others: so "-1.5" is no option. What follows a "--" is
/// left alone.
std::vector<std::string> optionsFirst(const app::ProgramSpec& spec, const std::vector<std::string>& words);

} // namespace cui
