/// Texts about packs that the server writes and the programs that ask for a pack read.
#pragma once

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// The answer to `pack progress`: of the pack that is being made `fraction`, 0..1, is done; nothing: none is.
/// `measure progress` answers the same.
std::string packProgressText(std::optional<double> fraction);
/// The other way round.
std::optional<double> packedFraction(std::string_view answer);

/// The form of packRefusal(): {0} are the names.
inline constexpr const char* kPackRefusal =
    "the scene names files outside of its folder: {0}; 'pack FOLDER outside' takes them along";
/// Lines of the answer to `pack`, but for the first: {0} is a file that was left out.
inline constexpr const char* kLeftOut = "left out, since nothing of it is used: {0}";

/// Why a pack is refused: names files, and how they would be taken along all the same. A link is named with
/// the file that it leads to.
rtcore::Sentence packRefusal(std::span<const std::filesystem::path> outside);

} // namespace app
