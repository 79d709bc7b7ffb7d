/// Which users may do what with a file: mode, owner, group and access list (POSIX sources only).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace rtcore {

/// The rights of a file that another one is to replace.
struct FileRights {
    mode_t mode = 0; ///< its lowest nine bits
    uid_t owner = 0;
    gid_t group = 0;
    std::string accessList; ///< as the system keeps it; empty: there is none, the mode says all
};

/// Nothing where there is no regular file.
std::optional<FileRights> rightsOf(const std::filesystem::path& path);

/// Gives an open file these rights. Where the group or the list cannot be kept, the rights that hang on them
/// are dropped: no user may do more than with the file that had the rights. False with errno set.
bool takeRights(int file, const FileRights& rights);

} // namespace rtcore
