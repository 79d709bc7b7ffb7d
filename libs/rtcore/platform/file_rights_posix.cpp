#include "rtcore/platform/file_rights_posix.h"

#include <cerrno>

#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/xattr.h>
#endif

namespace rtcore {

namespace {

constexpr mode_t kAllRights = 0777, kOwnerRights = 0700, kOthersRights = 0007;
constexpr unsigned kGroupShift = 3;

#ifdef __linux__
constexpr const char* kAccessList = "system.posix_acl_access";

std::string accessListOf(const std::filesystem::path& path) {
    const ssize_t size = ::getxattr(path.c_str(), kAccessList, nullptr, 0);
    std::string list(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    const ssize_t got = list.empty() ? 0 : ::getxattr(path.c_str(), kAccessList, list.data(), list.size());
    return got == size ? list : std::string();
}

/// In place of one that the folder's default gave it.
bool setAccessList(int file, const std::string& list) {
    if (!list.empty()) return ::fsetxattr(file, kAccessList, list.data(), list.size(), 0) == 0;
    ::fremovexattr(file, kAccessList);
    return true;
}
#else
std::string accessListOf(const std::filesystem::path& /*path*/) { return {}; }
bool setAccessList(int /*file*/, const std::string& list) { return list.empty(); }
#endif

bool takeOwner(int file, const FileRights& rights) {
    struct stat now {};
    if (::fstat(file, &now) != 0) return false;
    if (now.st_uid != rights.owner && ::fchown(file, rights.owner, rights.group) == 0) return true;
    return now.st_gid == rights.group || ::fchown(file, static_cast<uid_t>(-1), rights.group) == 0;
}

} // namespace

std::optional<FileRights> rightsOf(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileRights{status.st_mode & kAllRights, status.st_uid, status.st_gid, accessListOf(path)};
}

bool takeRights(int file, const FileRights& rights) {
    const bool sameGroup = takeOwner(file, rights);
    if (setAccessList(file, rights.accessList) && sameGroup) return ::fchmod(file, rights.mode) == 0;
    // Members of either group are others, or were: they get what both had.
    setAccessList(file, "");
    const mode_t both = rights.mode & (rights.mode >> kGroupShift) & kOthersRights;
    return ::fchmod(file, (rights.mode & kOwnerRights) | both << kGroupShift | both) == 0;
}

} // namespace rtcore
