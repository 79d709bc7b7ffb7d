/// A scene as a .scn describes it.
#pragma once

#include "rtcore/io/loading/loading.h"

#include <filesystem>

namespace rtcore {

/// Reads the .scn, its model and all other files that it names.
void readDescribed(Loading& loading, const std::filesystem::path& path);

} // namespace rtcore
