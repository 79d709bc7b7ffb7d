/// STL files of text.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/scan/scan_mesh.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace rtcore {

/// The solids of a file, each by the first word of its name. Nothing when the file does not begin with
/// "solid" or "facet", in letters of any case. Normals are left out, whatever stands there: they are those of
/// the triangles. A facet of more than three corners is a polygon; one of fewer is left out, with a warning
/// of the first. `origin` is taken off the positions. `alive` is called now and then. Throws what InputFile
/// throws, and std::bad_alloc.
std::optional<std::vector<ScanPart>> readTextStl(const std::filesystem::path& path, const LocalOrigin& origin,
                                                 ImportReport& report, const std::function<void()>& alive);

} // namespace rtcore
