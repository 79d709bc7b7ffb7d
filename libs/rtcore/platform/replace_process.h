/// This process goes on as another program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rtcore {

/// Runs `program` with `arguments` (without its own name) in place of this one: number, limits, parent and
/// standard streams stay, what is buffered is lost. Returns only when that cannot be done.
void becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);

} // namespace rtcore
