/// Settings from all places, in their order: default < .scn < .set < .cam < command line.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <span>

namespace app {

/// Each may be empty.
struct SettingSources {
    std::span<const rtcore::SettingAssignment> scene = {}; ///< the .scn's and those of the .set that it names
    std::span<const rtcore::SettingAssignment> settingsFile = {}; ///< of --set
    const rtcore::CameraFile* camera = nullptr;                   ///< its own fields only
    std::span<const rtcore::SettingAssignment> commandLine = {};
};

/// Throws std::invalid_argument for a value that the table of settings refuses.
rtcore::RenderSettings mergeSettings(const SettingSources& sources);

/// Switches the lights and picks the environment that a .cam file asks for.
/// Throws rtcore::FileError BadData when the scene has fewer of them; `file` is named in the message.
void applyCameraToScene(const rtcore::CameraFile& camera, const std::filesystem::path& file,
                        rtcore::Scene& scene);

} // namespace app
