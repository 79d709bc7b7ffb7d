/// A file that grows by whole pieces.
#pragma once

#include <filesystem>
#include <string_view>

namespace rtcore {

/// A file whose pieces survive the death of this process once appended, however it dies (not that of the
/// machine, unless they were flushed). A death in the middle of append() may leave a beginning of that piece.
/// For one thread.
class AppendFile {
  public:
    /// Makes the file, which must not exist yet, nor be a link; links of others on the way to it are refused
    /// where replaceFile() refuses them. Throws FileError CannotWrite.
    explicit AppendFile(const std::filesystem::path& path);
    ~AppendFile();
    AppendFile(const AppendFile&) = delete;
    AppendFile& operator=(const AppendFile&) = delete;

    /// Throws FileError CannotWrite (a full disk); what there was room for is taken back.
    void append(std::string_view piece);
    /// Returns when the disk has it. Throws FileError CannotWrite.
    void flush();

  private:
    std::filesystem::path path_;
    int file_ = -1;
    long long size_ = 0;
};

} // namespace rtcore
