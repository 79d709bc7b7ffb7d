/// Binary STL files.
#pragma once

#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/files.h"

#include <functional>
#include <optional>

namespace rtcore {

struct StlFile {
    ScanMesh mesh;
    Colour colour = kWhite; ///< of all of it
};

/// `origin` is taken off the positions. Nothing when the size is not that of a binary STL file with the
/// number of triangles that stands in it. Colours of facets are read by the rule of Magics where the head
/// says "COLOR=", else by that of VisCAM. Normals are left out: they are those of the triangles. `alive` is
/// called now and then. Throws FileError BadData for a file that ends before it should by now, what InputFile
/// throws, and std::bad_alloc.
std::optional<StlFile> readStl(const InputFile& file, const LocalOrigin& origin,
                               const std::function<void()>& alive);

} // namespace rtcore
