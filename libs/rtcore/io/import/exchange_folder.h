/// A folder through which one program hands files to another.
#pragma once

#include "rtcore/platform/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace rtcore {

/// A TemporaryFolder, in memory (/dev/shm) when `bytes` are free there, else in the folder for temporary
/// files.
class ExchangeFolder {
  public:
    /// Throws FileError CannotWrite.
    explicit ExchangeFolder(std::uint64_t bytes);
    const std::filesystem::path& path() const { return folder_->path(); }

  private:
    std::optional<TemporaryFolder> folder_; ///< always there
};

} // namespace rtcore
