/// Programs that the bridge starts.
#pragma once

#include <filesystem>
#include <string>

namespace bridge {

/// The one that the environment's `variable` names, else the one beside this program. Throws
/// rtcore::FileError NoInput where it is missing.
std::filesystem::path helperProgram(const std::string& name, const char* variable);

} // namespace bridge
