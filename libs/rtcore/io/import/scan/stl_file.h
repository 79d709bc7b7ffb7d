/// Binary STL files.
#pragma once

#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/files.h"

#include <functional>
#include <optional>

namespace rtcore {

/// Nothing when the size is not that of a binary STL file with the number of triangles that stands in it, or
/// when it has colours. Normals are left out: they are those of the triangles. `alive` is called now and
/// then. Throws FileError BadData for a file that ends before it should by now, what InputFile throws, and
/// std::bad_alloc.
std::optional<ScanMesh> readStl(const InputFile& file, const std::function<void()>& alive);

} // namespace rtcore
