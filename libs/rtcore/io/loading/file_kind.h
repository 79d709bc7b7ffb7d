/// The kinds of files that scenes are loaded from.
#pragma once

#include "rtcore/platform/files.h"

#include <filesystem>

namespace rtcore {

enum class FileKind { Scene, Bsp, Model };

/// By its content, and by its name where that says nothing; loadScene() has the rules.
FileKind kindOfFile(const std::filesystem::path& path, InputFile& file);

} // namespace rtcore
