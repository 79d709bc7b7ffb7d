/// Models of any format that Assimp reads, which may crash, hang or eat all memory on a damaged file.
#pragma once

#include "rtcore/io/import/file_import.h"

namespace rtcore {

/// All meshes under all nodes, materials, lights, cameras; throws as importFile() does.
FileImport importWithAssimp(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
