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
/// no such file. Throws rtcore::FileError: BadData where others may read it, NoInput.
std::optional<std::string> readPrivateFile(const std::string& path);

/// A new file of mode 0600. Throws rtcore::FileError CannotWrite, also where there is one.
void writePrivateFile(const std::string& path, std::string_view text);

} // namespace app
