/// Names and values of settings, for completion.
#pragma once

#include <string>
#include <vector>

namespace app {

std::vector<std::string> settingNames();
/// What the setting of that name takes, where that is a few words; else nothing.
std::vector<std::string> settingValues(const std::string& name);

} // namespace app
