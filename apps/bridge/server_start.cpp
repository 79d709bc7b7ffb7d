#include "bridge/server_start.h"

#include "bridge/helper_program.h"

#include "ipc/platform/system.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace bridge {

namespace {

/// Of the user; empty: there is none.
std::string cacheFolder() {
    const char* const cache = std::getenv("XDG_CACHE_HOME"); // NOLINT(concurrency-mt-unsafe)
    if (cache != nullptr && *cache == '/') return std::string(cache) + "/rts";
    const char* const home = std::getenv("HOME"); // NOLINT(concurrency-mt-unsafe)
    return home != nullptr && *home == '/' ? std::string(home) + "/.cache/rts" : std::string();
}

} // namespace

std::unique_ptr<app::StartedProcess> startServer(const std::filesystem::path& scene,
                                                 const std::string& instance) {
    std::error_code unknown;
    if (!std::filesystem::exists(scene, unknown))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, scene.string(), "there is no such file");
    std::vector<std::string> arguments{"--instance=" + instance, fmt::format("--parent={}", ipc::processId()),
                                       "--frame-time=33"};
    if (const std::string cache = cacheFolder(); !cache.empty())
        arguments.push_back("--light-cache=" + cache + "/light");
    arguments.insert(arguments.end(), {"--", scene.string()});
    return std::make_unique<app::StartedProcess>(helperProgram("RTServer", "RT_SERVER"), arguments);
}

} // namespace bridge
