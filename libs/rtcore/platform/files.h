/// Files as the operating system gives them. The only place (with processes.h) of this library that calls it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace rtcore {

/// The bytes of a whole file, read-only, as long as `owner` lives. Memory-mapped (private) where it can be;
/// small files (< 64 KiB), pipes and devices are read instead. The first byte is aligned for any type (16).
/// A file that another process truncates while it is mapped makes an access fail with SIGBUS; .bsp files are
/// replaced by rename, never rewritten, so this happens only to files that somebody edits in place.
struct FileBytes {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};
/// Throws FileError: NoInput when the file is missing, a folder or unreadable.
FileBytes openFileBytes(const std::filesystem::path& path);

/// The whole text of a file. Throws as openFileBytes does, and BadData when it is larger than `limit` bytes.
std::string readTextFile(const std::filesystem::path& path, std::size_t limit = std::size_t{64} << 20);

/// Writes a file so that `path` always names the old content or all of the new: into a temporary file beside
/// it, flushed to the disk, then renamed. `write` gets the name of the temporary file, which exists and is
/// empty. When `write` throws, the temporary file is removed and the exception passes on. Follows a symbolic
/// link at `path`. A path that is no regular file (/dev/stdout, a pipe) is written to directly. Throws
/// FileError CannotWrite, with the system's reason.
void replaceFile(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for content that is in memory, in pieces that are written one after another.
void writeFileAtomically(const std::filesystem::path& path,
                         std::span<const std::span<const std::byte>> pieces);

/// Removes the temporary files that replaceFile has open in this process; async-signal-safe, for handlers of
/// SIGINT and SIGTERM.
void removeTemporaryFiles() noexcept;

/// A new empty file of this process' own (mode 0600) in the folder for temporary files.
/// The destructor removes it.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& prefix);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The folder that holds the running program.
std::filesystem::path programFolder();

} // namespace rtcore
