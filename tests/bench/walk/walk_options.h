/// bench_walk's command line, read.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/progress/progress.h"

#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace bench {

struct WalkOptions {
    std::filesystem::path scene, list;
    std::vector<rtcore::SettingAssignment> settings; ///< of the command line
    int width = 1024, height = 621;
    int threads = 0; ///< 0 = all cores
    double framesPerSecond = 30;
    bool fixed = false; ///< every camera in a whole frame, however long it takes
    bool still = false; ///< compare with what [still] asks for, not [live]
    int every = 1;      ///< only each n-th moment is compared
    int frames = 0;     ///< of the walk; 0 = all
    std::filesystem::path references;
    std::optional<std::filesystem::path> csv, sheet, pictures;
    app::ProgressStyle progress = app::ProgressStyle::None;
};

const app::ProgramSpec& walkSpec();

/// Throws app::UsageError.
WalkOptions readWalkOptions(const app::Arguments& arguments);

} // namespace bench
