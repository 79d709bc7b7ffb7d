/// glTF 2 by a reader of our own (docs/decisions/0017): what the format says, also where Assimp passes over
/// it, and the same triangles in the same order where it does not.
#pragma once

#include "rtcore/io/import/file_import.h"

#include <optional>

namespace rtcore {

/// Nothing when the file is no glTF 2 by its name and content: then others are to be asked. Memory: at most
/// three times the lists that the file stands for. Throws as importFile() does.
std::optional<FileImport> importGltf(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
