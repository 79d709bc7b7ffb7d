/// Writes scenes where the user's own files may stand.
#pragma once

#include "rtcore/io/text/scn.h"

#include <filesystem>

namespace rtserver {

/// Replaces `path` by the scene, whole or not at all. A file there that no program of the suite wrote, or
/// that was changed by hand since, is refused unless `replace`; then it is kept (keepBackup()).
/// Throws app::UsageError for a name that does not end in .scn, and FileError CannotWrite, with the old file
/// as it was.
void saveScene(const std::filesystem::path& path, const rtcore::SceneFile& scene, bool replace);

} // namespace rtserver
