/// Where an output goes whose name is a symbolic link (POSIX sources only).
#pragma once

#include <filesystem>

namespace rtcore {

/// In a folder that everybody may write into, only links of this user and of the folder's owner are followed,
/// whether they stand for the file or for a folder on the way (as the kernel's protected_symlinks, which a
/// program that resolves links goes around). Throws FileError CannotWrite for others.
void refuseForeignLinks(const std::filesystem::path& path);

/// Where the chain of links at `path` ends; the end need not exist. Throws FileError CannotWrite when it is a
/// circle, and as refuseForeignLinks() does for what stands on the way.
std::filesystem::path followLinks(std::filesystem::path path);

} // namespace rtcore
