/// Sections of a .scn that are for something of the model: by a pattern of its name or by its number.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// Whether a section for `pattern`, or for the `number` counted from 1, is for the element `index` of a list.
bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index, std::string_view name);

/// The warning of a section that is for no `what` of the model; `path` of the .scn.
std::string unusedSection(const std::filesystem::path& path, const std::string& what,
                          const std::string& pattern, std::optional<int> number);

} // namespace rtcore
