#include "bridge/server_start.h"

#include "bridge/helper_program.h"

#include "ipc/platform/system.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <system_error>

namespace bridge {

std::unique_ptr<app::StartedProcess> startServer(const std::filesystem::path& scene,
                                                 const std::string& instance) {
    std::error_code unknown;
    if (!std::filesystem::exists(scene, unknown))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, scene.string(), "there is no such file");
    const std::vector<std::string> arguments{"--instance=" + instance,
                                             fmt::format("--parent={}", ipc::processId()), "--frame-time=33",
                                             "--", scene.string()};
    return std::make_unique<app::StartedProcess>(helperProgram("RTServer", "RT_SERVER"), arguments);
}

} // namespace bridge
