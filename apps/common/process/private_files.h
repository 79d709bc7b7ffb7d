/// Files and folders that no other user may look into, for secrets and sockets.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// `$XDG_RUNTIME_DIR/NAME`, or `/tmp/NAME-UID` without that, made with mode 0700 where it is missing. Throws
/// rtcore::FileError CannotWrite where it is not a folder of this user alone.
std::string privateRuntimeFolder(const std::string& name);

/// The text of a regular file of this user that others may not read, up to 4096 bytes; nothing where there is
/// no such file, or an empty one. Throws rtcore::FileError: BadData where others may read it, NoInput.
std::optional<std::string> readPrivateFile(const std::string& path);

/// A new file of mode 0600, all of it or none: a full disk or a death leaves no beginning. An empty file is
/// as none. False where there is one, or another process makes one. Throws rtcore::FileError CannotWrite.
bool writePrivateFile(const std::string& path, std::string_view text);

/// Makes the folder and those above it that are missing, with mode 0700. One of this user that is there gets
/// that mode. False where that cannot be.
bool makePrivateFolder(const std::string& path) noexcept;
/// The same for an empty file, mode 0600: a program that writes into it leaves the mode as it is.
bool makePrivateFile(const std::string& path) noexcept;

/// All that this process makes from now on is for its user alone. Async-signal-safe.
void keepOthersOut() noexcept;

} // namespace app
