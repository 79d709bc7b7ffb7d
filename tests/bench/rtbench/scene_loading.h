/// Loading a scene with progress shown and Ctrl-C heeded.
#pragma once

#include "bench/rtbench/bench_options.h"

#include "common/progress/progress.h"

#include "rtcore/io/scene_loader.h"

#include <filesystem>

namespace rtbench {

/// As the Renderer does, with an exact tree unless options.fast. Throws FileError.
rtcore::LoadedScene loadForBench(const std::filesystem::path& path, const BenchOptions& options,
                                 app::Progress& progress);

} // namespace rtbench
