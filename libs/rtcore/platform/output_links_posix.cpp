#include "rtcore/platform/output_links_posix.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/platform/sibling_file_posix.h"

#include <cerrno>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

/// Whether a user put it there who is neither this one nor the owner of a folder that all may write into.
bool isForeignLink(const fs::path& path) {
    struct stat link {
    }, folder{};
    if (::lstat(path.c_str(), &link) != 0 || !S_ISLNK(link.st_mode)) return false;
    const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (::stat(parent.c_str(), &folder) != 0 || (folder.st_mode & S_IWOTH) == 0) return false;
    return link.st_uid != ::geteuid() && link.st_uid != folder.st_uid;
}

} // namespace

void refuseForeignLinks(const fs::path& path) {
    fs::path at;
    for (const fs::path& part : path) {
        at /= part;
        if (isForeignLink(at))
            throw FileError(FailureKind::CannotWrite, path.string(),
                            say("cannot be written: {0} is a link that another user put into a folder where "
                                "everybody may write; choose another name or another folder",
                                at.string()));
    }
}

fs::path followLinks(fs::path path) {
    const fs::path shown = path;
    for (int i = 0; i < 40; ++i) {
        refuseForeignLinks(path);
        std::error_code error;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return path;
        path = path.parent_path() / next;
        // Links of /proc/self/fd name files that are open: only they can be written, the names lead
        // elsewhere.
        if (path.string().starts_with("/proc/")) return path;
    }
    failWriting(shown, ELOOP);
}

} // namespace rtcore
