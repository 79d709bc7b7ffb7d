/// Where the image is that a model names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// `text` with %20 and the like decoded; what is no such code stays.
std::string percentDecoded(const std::string& text);

/// The file that `name` in a model in `folder` means. Tried in this order, each with / for \ and, where
/// nothing of that spelling exists, whatever the case of its letters: the path itself relative to `folder`
/// (or absolute), the same with %20 and the like decoded; then its last part alone in `folder`,
/// `folder`/textures and `folder`/../textures, as models are moved without their folders. Nothing when there
/// is no such file.
std::optional<std::filesystem::path> findTextureFile(const std::filesystem::path& folder,
                                                     const std::string& name);

} // namespace rtcore
