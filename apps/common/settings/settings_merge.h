/// Settings from all places, in their order: default < .scn < .set < .cam < command line.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app {

/// Each may be empty.
struct SettingSources {
    std::span<const rtcore::SettingAssignment> scene = {}; ///< the .scn's and those of the .set that it names
    std::span<const rtcore::SettingAssignment> settingsFile = {}; ///< of --set
    const rtcore::CameraFile* camera = nullptr;                   ///< its own fields only
    std::span<const rtcore::SettingAssignment> commandLine = {};
};

/// Where the command line names the width or the height alone, the other one follows: the image keeps the
/// aspect that the other places give it. Throws std::invalid_argument for a value that the table of settings
/// refuses.
rtcore::RenderSettings mergeSettings(const SettingSources& sources);

/// The settings that a .cam file's own fields assign.
std::vector<rtcore::SettingAssignment> settingsOf(const rtcore::CameraFile& camera);

/// Switches the lights and picks the environment that a .cam file asks for. Where the scene lacks some of
/// them, or has fewer than a .cam of version 1 switches, the .cam was made for another scene: these stay as
/// they are, and a warning that names `file` is returned, else "".
rtcore::Sentence applyCameraToScene(const rtcore::CameraFile& camera, const std::filesystem::path& file,
                                    rtcore::Scene& scene);

} // namespace app
