/// The formats of scans - binary PLY and STL - many times as fast as by Assimp, and the same model to the
/// bit.
#pragma once

#include "rtcore/io/import/file_import.h"

#include <optional>

namespace rtcore {

/// Nothing when the file is of another format or holds more than scans do (ply_file.h, stl_file.h): then
/// Assimp is to be asked. Memory: at most 150 bytes for each that the file has. Throws as importFile() does:
/// also for a file that is shorter than it says or becomes so while it is read.
std::optional<FileImport> importScan(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
