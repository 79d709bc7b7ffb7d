/// A folder through which one program hands files to another.
#pragma once

#include <cstdint>
#include <filesystem>

namespace rtcore {

/// A new empty folder that only this user can enter, removed with all that is in it by the destructor. In
/// memory
/// (/dev/shm) when `bytes` are free there, else in the folder for temporary files. What a killed program left
/// behind is removed by the next one that makes such a folder.
class HandOverFolder {
  public:
    /// Throws FileError CannotWrite.
    explicit HandOverFolder(std::uint64_t bytes);
    ~HandOverFolder();
    HandOverFolder(const HandOverFolder&) = delete;
    HandOverFolder& operator=(const HandOverFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

} // namespace rtcore
