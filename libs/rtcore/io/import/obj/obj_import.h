/// Wavefront files (.obj) with their material libraries.
#pragma once

#include "rtcore/io/import/file_import.h"

#include <filesystem>
#include <optional>

namespace rtcore {

/// Nothing when the file does not end in .obj. Throws as importFile() does.
std::optional<FileImport> importObj(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
