/// The importer programs but for what they read: command line, limits, report and exit codes.
#pragma once

#include "rtcore/io/import/file_import.h"

#include <filesystem>

namespace importer {

using Reader = rtcore::FileImport (*)(const std::filesystem::path& path,
                                      const rtcore::FileImportOptions& options);

/// The whole program; returns its exit code. Ends the process at once where it succeeds.
int runImporter(int argc, char** argv, Reader read);

} // namespace importer
