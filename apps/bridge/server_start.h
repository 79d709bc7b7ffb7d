/// The RTServer that --start runs.
#pragma once

#include "common/process/started_process.h"

#include <filesystem>
#include <memory>
#include <string>

namespace bridge {

/// It ends with the bridge, however that ends, and keeps the indirect light of walks in the user's cache.
/// Throws rtcore::FileError NoInput when the program or the scene is missing.
std::unique_ptr<app::StartedProcess> startServer(const std::filesystem::path& scene,
                                                 const std::string& instance);

} // namespace bridge
