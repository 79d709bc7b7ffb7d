/// Which server is meant: the option --instance, or the environment.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// Instances that begin so are Renderers that a window shows; they take no commands.
inline constexpr std::string_view kPreviewPrefix = "preview-";

/// The instance that --instance names, or else the environment variable RT_INSTANCE; nothing without both.
std::optional<std::string> instanceOf(const Arguments& arguments);
/// For manual pages.
HelpWord instanceEnvironmentNote();

} // namespace app
