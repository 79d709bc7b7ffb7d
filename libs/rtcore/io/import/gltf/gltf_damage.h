/// Files that are glTF and that no reader takes.
#pragma once

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>

namespace rtcore {

/// Why no reader takes a file that is glTF by its content or its name: its version, or where it is damaged;
/// what to do, as one sentence without a name. Nothing when it is no glTF, or no reason is found.
std::optional<Sentence> gltfDamage(const std::filesystem::path& path);

} // namespace rtcore
