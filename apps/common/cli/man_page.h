/// The manual page of a program, made from its table of options.
#pragma once

#include "common/cli/options.h"

#include <string>
#include <string_view>

namespace app {

/// `Program --man-page` prints it; the build writes it to a file.
inline constexpr std::string_view kManPageOption = "--man-page";

/// Section 1, in roff with the macros of man(7). `spec` without --help and --version, which are added.
std::string manPage(const ProgramSpec& spec);

} // namespace app
