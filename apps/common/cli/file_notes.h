/// Notes in manual pages on files and environment variables that several programs share.
#pragma once

#include "common/cli/options.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// .scn, .bsp, .cam, .set, and the scenes that are installed.
std::vector<HelpWord> sceneFileNotes();

/// RT_ISA, RT_IMPORTER and TMPDIR.
/// After `first`.
std::vector<HelpWord> importEnvironmentNotes(std::optional<HelpWord> first = {});

/// Extensions of the scenes and models that people have most; the importer reads more.
std::vector<std::string> modelExtensions(); ///< "obj", "ply", ...
std::vector<std::string> sceneExtensions(); ///< "scn", "bsp" and these

} // namespace app
