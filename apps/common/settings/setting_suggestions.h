/// Names and values of settings, for completion.
#pragma once

#include <string>
#include <vector>

namespace app {

std::vector<std::string> settingNames();
/// The values of the setting of that name where these are a few words; else none.
std::vector<std::string> settingValues(const std::string& name);

} // namespace app
