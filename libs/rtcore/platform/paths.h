/// Names of files, as the system follows them.
#pragma once

#include <filesystem>

namespace rtcore {

/// `path` absolute, without "." and ".." where the plain name leads to the same file, or to the same folder
/// for a file to come: behind a link to a folder, ".." is not the folder that the link stands in.
std::filesystem::path plainPath(const std::filesystem::path& path);

} // namespace rtcore
