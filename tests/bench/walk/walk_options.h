/// bench_walk's command line, read.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/progress/progress.h"

#include "rtcore/look/lighting_preset.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace bench {

/// The images that a walk is compared with: by Whitted's rays, as the server's whole frames, or by paths,
/// with all light.
enum class Truth { Rays, Paths };

struct WalkOptions {
    std::filesystem::path scene, list;
    std::vector<rtcore::SettingAssignment> settings; ///< of the command line
    std::optional<rtcore::LightingPreset> preset;    ///< in place of the scene's own light
    int width = 1024, height = 621;
    int threads = 0; ///< 0 = all cores
    double framesPerSecond = 30;
    bool fixed = false;    ///< every camera in a whole frame, however long it takes
    double newSamples = 0; ///< above 0: every camera in a live frame at the full size, with that part new
    bool still = false;    ///< compare with what [still] asks for, not [live]
    Truth truth = Truth::Rays;
    int truthSamples = 256;                  ///< of each pixel of a reference by paths
    int truthWidth = 512, truthHeight = 310; ///< its pixels
    int every = 1;                           ///< only each n-th moment is compared
    int frames = 0;                          ///< of the walk; 0 = all
    float parallelWidth = 0; ///< above 0: the cameras without perspective, so many scene units wide
    std::filesystem::path references;
    std::optional<std::filesystem::path> csv, sheet, pictures;
    std::optional<std::filesystem::path> trace;  ///< gets the steps of the walk
    std::optional<std::filesystem::path> replay; ///< the steps that are drawn
    std::optional<std::filesystem::path> light;  ///< indirect light that draw() begins with
    app::ProgressStyle progress = app::ProgressStyle::None;
};

/// Whether there is one image for each camera, and no clock beside it.
inline bool drawsEach(const WalkOptions& options) { return options.fixed || options.newSamples > 0; }

const app::ProgramSpec& walkSpec();

/// Throws app::UsageError.
WalkOptions readWalkOptions(const app::Arguments& arguments);

} // namespace bench
