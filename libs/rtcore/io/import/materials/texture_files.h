/// Where the image is that a model names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rtcore {

/// `text` with %20 and the like decoded; what is no such code stays.
std::string percentDecoded(const std::string& text);

/// The file that `name` in a model in `folder` means. Tried in this order, each with / for \ and, where
/// nothing of that spelling exists, whatever the case of its letters: the path itself relative to `folder`
/// (or absolute), the same with %20 and the like decoded; then, as models are moved without their folders,
/// its shorterPaths() in `folder`, and its last part alone in `folder`/textures and `folder`/../textures.
/// Nothing when there is no such file.
std::optional<std::filesystem::path> findTextureFile(const std::filesystem::path& folder,
                                                     const std::string& name);

/// The regular file at `relative`, which may be absolute, whatever the case of its letters where nothing of
/// that spelling exists. Nothing when there is none.
std::optional<std::filesystem::path> fileOfAnyCase(const std::filesystem::path& folder,
                                                   const std::filesystem::path& relative);

/// The ends of `path` that are shorter than it, longest first: "b/c" and "c" of "a/b/c".
std::vector<std::filesystem::path> shorterPaths(const std::filesystem::path& path);

} // namespace rtcore
