/// Files of which the end is missing, by what their own heads and ends say.
#pragma once

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>

namespace rtcore {

/// That the file is cut off, how that is known, and what to do, as one sentence without a name; nothing where
/// all is there or its format does not say how long it is (OBJ). A length that lies has the same look: ask
/// about a file that cannot be read, or of which some may have been passed over.
std::optional<Sentence> cutOff(const std::filesystem::path& path);

} // namespace rtcore
