/// 3MF, the format of 3D printing, as it is packed in an archive.
#pragma once

#include "rtcore/io/import/file_import.h"

#include <optional>

namespace rtcore {

/// Nothing when the file is not called .3mf. Core, production, and materials and properties are read; what
/// the file requires beside these is an error, what it holds of others a warning. Order of triangles: items
/// as they are built, then components, then materials, then as in the file. Throws as importFile() does.
std::optional<FileImport> importThreeMf(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
