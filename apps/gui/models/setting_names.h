/// What the settings are called in the window. A setting that is added to the core gets a name by itself;
/// the ones known here are translated, too.
#pragma once

#include <QString>

#include <string_view>

namespace gui {

/// "ambientOcclusion.samples": the part before the dot, as "Ambient occlusion"; of a setting without a dot
/// the general group.
QString settingGroup(std::string_view name);
/// The part behind the dot, or all of it: "maxDepth" is "Max depth".
QString settingLabel(std::string_view name);
QString settingUnit(std::string_view unit);
QString settingHelp(std::string_view help);

} // namespace gui
