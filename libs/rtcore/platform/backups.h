/// Old files that are kept when they are replaced.
#pragma once

#include <filesystem>

namespace rtcore {

inline constexpr int kMaxBackups = 99; ///< of one file, beside it

/// Gives the file a second name, with ~ behind it, or with ~2, ~3 and so on where that is taken, and returns
/// it. Whatever has such a name stays, and no link there is followed. The name keeps the content, with all
/// its rights, once replaceFile() puts another file in its place. Where there are no second names, it is a
/// copy that no more users can read. Throws FileError CannotWrite, also where all names are taken.
std::filesystem::path keepBackup(const std::filesystem::path& path);

} // namespace rtcore
