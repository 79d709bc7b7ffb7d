/// What the server says of a pack and the programs that ask for one understand.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// The answer to `pack progress`: of the pack that is being made `fraction`, 0..1, is done; nothing: none is.
std::string packProgressText(std::optional<double> fraction);
/// The other way round.
std::optional<double> packedFraction(std::string_view answer);

/// Why a pack is refused: names files, and how they would be taken along all the same. A link is named with
/// the file that it leads to.
std::string packRefusal(std::span<const std::filesystem::path> outside);
/// The names in a message that holds such a one; nothing in others.
std::optional<std::string> refusedFiles(std::string_view message);

} // namespace app
