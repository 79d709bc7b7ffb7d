#include "common/cli/input_files.h"

#include "common/cli/command_line.h"

namespace app {

void InputFiles::add(const std::filesystem::path& path) {
    if (const auto identity = rtcore::identityOf(path)) names_.try_emplace(*identity, path);
}

void InputFiles::add(std::span<const std::filesystem::path> paths) {
    for (const std::filesystem::path& path : paths) add(path);
}

std::optional<std::filesystem::path> InputFiles::find(const std::filesystem::path& path) const {
    const auto identity = rtcore::identityOf(path);
    const auto found = identity ? names_.find(*identity) : names_.end();
    return found == names_.end() ? std::nullopt : std::optional(found->second);
}

void InputFiles::refuse(const std::filesystem::path& output) const {
    const auto input = find(output);
    if (!input) return;
    const std::string link = *input == output ? "" : " by the name " + input->string();
    throw UsageError("input and output are the same file, " + output.string() + ", which is read" + link +
                     "; give the output another name");
}

} // namespace app
