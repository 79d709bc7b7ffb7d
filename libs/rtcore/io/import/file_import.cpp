#include "rtcore/io/import/file_import.h"

#include "rtcore/io/import/assimp_import.h"
#include "rtcore/io/import/foreign_formats.h"
#include "rtcore/io/import/scan_import.h"
#include "rtcore/platform/error.h"

#include <utility>

namespace rtcore {

FileImport importFile(const std::filesystem::path& path, const FileImportOptions& options) {
    if (const auto sentence = unreadFormat(path)) throw FileError(FailureKind::BadData, "", *sentence);
    if (auto scan = importScan(path, options)) return std::move(*scan);
    return importWithAssimp(path, options);
}

} // namespace rtcore
