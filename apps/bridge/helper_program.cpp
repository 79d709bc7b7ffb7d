#include "bridge/helper_program.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <fmt/core.h>

#include <cstdlib>
#include <system_error>

namespace bridge {

std::filesystem::path helperProgram(const std::string& name, const char* variable) {
    // The environment does not change meanwhile.
    const char* const chosen = std::getenv(variable); // NOLINT(concurrency-mt-unsafe)
    std::filesystem::path program =
        chosen != nullptr && *chosen != '\0' ? std::filesystem::path(chosen) : rtcore::programFolder() / name;
    std::error_code unknown;
    if (std::filesystem::exists(program, unknown)) return program;
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, program.string(),
        fmt::format("the {} is missing; install it beside RTBridge or name it in {}", name, variable));
}

} // namespace bridge
