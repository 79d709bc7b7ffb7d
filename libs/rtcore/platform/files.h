/// Files as the operating system gives them.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace rtcore {

/// The bytes of a whole file, read-only, as long as `owner` lives. The first byte is aligned for any type
/// (16). Files up to 1 GB, pipes and devices are read into memory, and nothing that happens to the file later
/// changes the bytes. Larger files are memory-mapped: one that another process truncates while it is used
/// makes an access fail with SIGBUS, and what is written into it appears here. Files of this suite are
/// replaced by rename, never rewritten, so this happens only to what is copied over in place.
struct FileBytes {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};
/// Throws FileError: NoInput when the file is missing, a folder or unreadable, or a pipe without a writer
/// for writing within 10 s; BadData for a file of more than 4 GB nearly all of which are holes; Stopped
/// (file_waits.h).
FileBytes openFileBytes(const std::filesystem::path& path);

/// A file that is looked into before it is read. Opened once: what was looked at is what is read.
class InputFile {
  public:
    /// Throws as openFileBytes() does.
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;

    /// The first bytes, `max` at most, fewer where the file ends. Valid until the next call. Of a pipe or a
    /// device all of it is read. Throws as openFileBytes() does.
    std::span<const std::byte> head(std::size_t max);
    /// All of it; call it once, and nothing after it.
    FileBytes read();

    /// Bytes of a regular file as it was when it was opened; 0 for what is none.
    std::uint64_t size() const;
    /// Copies bytes from `offset` on, as many as fit and are there: fewer where the file ends by now. Only
    /// for regular files. Throws as openFileBytes() does.
    std::size_t readAt(std::uint64_t offset, std::span<std::byte> room) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The lines of a file as they come, of a pipe while it is still written. "-" is standard input.
class LineReader {
  public:
    /// Throws as openFileBytes() does.
    explicit LineReader(const std::filesystem::path& path);
    ~LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;

    /// The next line without its end; the last one may lack it. Nothing when there is none. Throws FileError:
    /// NoInput, BadData for a line of more than a megabyte, Stopped.
    std::optional<std::string> next();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The bytes that a file takes on the disk's account, without its holes; 0 for what is no regular file.
std::uint64_t storedBytes(const std::filesystem::path& path);

/// Which file a name leads to: the same for all its names, also by links, symbolic and hard.
struct FileIdentity {
    std::uint64_t device = 0, number = 0;
    friend auto operator<=>(const FileIdentity&, const FileIdentity&) = default;
};
/// Nothing when there is no such file.
std::optional<FileIdentity> identityOf(const std::filesystem::path& path);

/// The whole text of a file. Throws as openFileBytes does, and BadData when it is larger than `limit` bytes.
std::string readTextFile(const std::filesystem::path& path, std::size_t limit = std::size_t{64} << 20);

/// Writes a file so that `path` always names the old content or all of the new: into a temporary file beside
/// it, flushed to the disk, then renamed. `write` gets the name of the temporary file, which exists and is
/// empty. When `write` throws, the temporary file is removed and the exception passes on. A file that is
/// replaced hands on its mode, its access list and, where the system allows it, owner and group; no user may
/// do more with the new file than with the old one. A new file has mode 0666 less the umask. Follows symbolic
/// links, but those that other users put into a folder where everybody may write. A path that is no regular
/// file (/dev/stdout, a pipe) is written to directly. Throws FileError: CannotWrite, with the reason; Stopped
/// (file_waits.h).
void replaceFile(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for content that is in memory, in pieces that are written one after another.
void writeFileAtomically(const std::filesystem::path& path,
                         std::span<const std::span<const std::byte>> pieces);

/// Removes the temporary files that replaceFile has open in this process; async-signal-safe, for handlers of
/// SIGINT and SIGTERM.
void removeTemporaryFiles() noexcept;

/// Removes the temporary files of this user that replaceFile left in `folder` (empty: the current one) when a
/// process was killed: files with such a name that are older than so many seconds and that no process on this
/// machine is writing. Does not throw; what cannot be removed stays.
void removeForgottenFiles(const std::filesystem::path& folder, std::int64_t seconds = 3600);

/// The folder that holds the running program.
std::filesystem::path programFolder();

} // namespace rtcore
