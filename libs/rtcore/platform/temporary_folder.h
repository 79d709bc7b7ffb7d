/// A folder for files that one program hands to another.
#pragma once

#include "rtcore/platform/temporary_names.h"

#include <deque>
#include <filesystem>
#include <string>

namespace rtcore {

/// A new empty folder that only this user can enter (mode 0700), removed with all that is in it by the
/// destructor. What a killed program left behind is removed by the next one that makes a folder of that
/// `prefix` in the same parent.
class TemporaryFolder {
  public:
    /// In the folder for temporary files. Throws FileError CannotWrite.
    explicit TemporaryFolder(const std::string& prefix);
    TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// The path of a file of that name in the folder, which removeTemporaryFiles() knows from now on; the
    /// folder itself goes with its known files. Not safe from several threads.
    std::filesystem::path file(const std::string& name);

  private:
    std::filesystem::path path_;
    TemporaryName name_;
    std::deque<TemporaryName> files_;
};

} // namespace rtcore
