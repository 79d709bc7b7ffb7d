/// A file under a passing name beside the one that it becomes, for POSIX sources (here and in
/// apps/common/process).
#pragma once

#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/temporary_names.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace rtcore {

/// Throws FileError CannotWrite for what errno says, with a remedy. `shown` is the name that the user knows.
[[noreturn]] void failWriting(const std::filesystem::path& shown, int error);

/// A new empty file that is removed again unless it gets its name. Its lock tells other processes that it is
/// still being written, its name removeForgottenFiles() what it is. All throw FileError CannotWrite.
class SiblingFile {
  public:
    /// `mode` less the umask.
    SiblingFile(std::filesystem::path shown, const std::filesystem::path& target, mode_t mode);
    ~SiblingFile();
    SiblingFile(const SiblingFile&) = delete;
    SiblingFile& operator=(const SiblingFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Its rights are those of `target`, where that is there; its content is on the disk.
    void complete(const std::filesystem::path& target);
    /// Takes the place of what has that name.
    void renameTo(const std::filesystem::path& target);
    /// Gets a name that is free; false when it is not, and no link there is followed.
    bool nameNew(const std::filesystem::path& target);

  private:
    std::filesystem::path shown_, path_;
    TemporaryName name_;
    Descriptor lock_;
    bool renamed_ = false;
};

/// Whether SiblingFile makes such names.
bool isTemporaryName(std::string_view name);

} // namespace rtcore
