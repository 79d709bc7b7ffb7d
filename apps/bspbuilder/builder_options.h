/// BSPBuilder's command line, read.
#pragma once

#include "bspbuilder/builder_spec.h"

#include "common/cli/command_line.h"
#include "common/progress/progress.h"

#include "rtcore/accel/build_options.h"
#include "rtcore/io/import/model_import.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace bspbuilder {

enum class Verbosity { Quiet, Verbose, VeryVerbose };

struct BuilderOptions {
    std::filesystem::path input, output;
    rtcore::BuildOptions build;
    rtcore::ImportOptions import;
    Verbosity verbosity = Verbosity::Quiet;
    std::optional<int> histogramBands;
    std::optional<std::int64_t> parent; ///< the end of which ends the program
    app::ProgressStyle progress = app::ProgressStyle::None;
};

BuilderOptions readBuilderOptions(const app::Arguments& arguments);

/// A hash of all options that decide which tree is built, for BspIdentity; never 0.
std::uint32_t buildOptionsHash(const BuilderOptions& options);

} // namespace bspbuilder
