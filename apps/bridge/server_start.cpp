#include "bridge/server_start.h"

#include "ipc/platform/system.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <fmt/core.h>

#include <cstdlib>
#include <system_error>

namespace bridge {

namespace {

std::filesystem::path serverProgram() {
    // The environment does not change meanwhile.
    const char* const chosen = std::getenv("RT_SERVER"); // NOLINT(concurrency-mt-unsafe)
    std::filesystem::path program = chosen != nullptr && *chosen != '\0'
                                        ? std::filesystem::path(chosen)
                                        : rtcore::programFolder() / "RTServer";
    std::error_code unknown;
    if (std::filesystem::exists(program, unknown)) return program;
    throw rtcore::FileError(rtcore::FailureKind::NoInput, program.string(),
                            "the RTServer is missing; install it beside RTBridge or name it in RT_SERVER");
}

} // namespace

std::unique_ptr<app::StartedProcess> startServer(const std::filesystem::path& scene,
                                                 const std::string& instance) {
    std::error_code unknown;
    if (!std::filesystem::exists(scene, unknown))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, scene.string(), "there is no such file");
    const std::vector<std::string> arguments{"--instance=" + instance,
                                             fmt::format("--parent={}", ipc::processId()), "--frame-time=33",
                                             "--", scene.string()};
    return std::make_unique<app::StartedProcess>(serverProgram(), arguments);
}

} // namespace bridge
