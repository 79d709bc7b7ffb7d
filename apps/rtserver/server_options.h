/// RTServer's command line, read.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/settings/selection_options.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/settings/settings_table.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

struct Options {
    std::filesystem::path scene; ///< absolute, as all paths here
    std::string instance = "default";
    std::optional<std::filesystem::path> camera, settingsFile, path, cachedModel;
    std::optional<std::filesystem::path> light, lightCache; ///< indirect light, of the first scene; of all
    std::vector<rtcore::SettingAssignment> settings;        ///< in the order of the command line
    int threads = 0;                                        ///< 0 = all cores
    double framesPerSecond = 0;                             ///< at most; 0 = as many as there can be
    double frameSeconds = 0;            ///< that the frame after a change may take; 0 = any time
    std::optional<std::int64_t> parent; ///< when this process is gone, end as soon as no client is connected
    bool daemon = false;
    rtcore::ImportOptions import;
    rtcore::LightingOptions lighting; ///< of the first scene
    app::Selection selection;         ///< the same
};

const app::ProgramSpec& serverSpec();

/// Throws app::UsageError for values that make no sense.
Options readOptions(const app::Arguments& arguments);

} // namespace rtserver
