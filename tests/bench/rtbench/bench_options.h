/// rtbench's command line, read.
#pragma once

#include "bench/rtbench/ray_test.h"

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/progress/progress.h"

#include "rtcore/io/import/model_import.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace rtbench {

struct BenchOptions {
    std::vector<std::filesystem::path> scenes;
    std::optional<std::filesystem::path> views;
    std::vector<const RayTest*> tests; ///< in the order of kRayTests
    int size = 1024;                   ///< pixels of a side of the square image whose rays are traced
    int threads = 1;                   ///< that trace; trees are built with all cores
    int rounds = 12;                   ///< at most
    bool embree = true;
    bool fast = false;  ///< fast trees
    bool modes = false; ///< print all of Embree's, not only the best
    bool frames = false;
    int frameWidth = 1280, frameHeight = 720; ///< pixels
    std::optional<std::filesystem::path> json;
    rtcore::ImportOptions import;
    app::ProgressStyle progress = app::ProgressStyle::None;
};

/// The table of options.
const app::ProgramSpec& benchSpec();

/// Also makes the vector code use the instruction set that --isa names. Throws app::UsageError.
BenchOptions readBenchOptions(const app::Arguments& arguments);

} // namespace rtbench
