/// The list that `Renderer --settings` prints.
#pragma once

#include <string>

namespace renderer {

/// Every setting with its range, default, unit and meaning, from the table of settings.
std::string settingsList();

} // namespace renderer
