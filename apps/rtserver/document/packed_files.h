/// Copies of files in a folder that is not seen by others yet.
#pragma once

#include "rtserver/document/pack_progress.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rtserver {

/// Each file is copied once, however often it is asked for. A copy is readable by no more users than its
/// source. All throw rtcore::FileError, CannotWrite or Stopped, and std::filesystem::filesystem_error.
class PackedFiles {
  public:
    /// `progress` must outlive it.
    PackedFiles(std::filesystem::path root, PackProgress& progress);

    const std::filesystem::path& root() const { return root_; }
    PackProgress& progress() const { return progress_; }
    int count() const { return static_cast<int>(copies_.size()); }
    /// Sources that were asked for and that the pack does not hold, since they are not what they were taken
    /// for.
    const std::vector<std::filesystem::path>& leftOut() const { return leftOut_; }

    /// Copies a file into a folder of the pack, under a name that is free there.
    std::filesystem::path take(const std::filesystem::path& source, const char* folder);
    /// The same under that name, which must be free.
    std::filesystem::path copy(const std::filesystem::path& source, const std::filesystem::path& target);
    /// Takes the copy away again.
    void leaveOut(const std::filesystem::path& copy);
    void noteMissing(const std::filesystem::path& source);

  private:
    std::filesystem::path root_;
    PackProgress& progress_;
    std::map<std::filesystem::path, std::filesystem::path> copies_; ///< by source, as plainPath() has it
    std::vector<std::filesystem::path> leftOut_;
};

void throwIfStopped(const PackProgress& progress);

} // namespace rtserver
