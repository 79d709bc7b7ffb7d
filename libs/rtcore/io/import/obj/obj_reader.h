/// Reading an OBJ file.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/obj/mtl_file.h"
#include "rtcore/io/import/obj/obj_model.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rtcore {

struct ObjFile {
    ObjModel model;
    MtlMaterials materials; ///< numbers of meshes' materials are theirs
};

/// Reads the file and its libraries in pieces; `origin` is taken off the positions. A statement that is not
/// understood costs itself alone: a position of that kind is no number, but counts; one warning for each file
/// tells the first of them. Freeform curves and surfaces are such statements. Warns of libraries that are
/// missing, and of lines and points. `alive` is called now and then. Throws what InputFile throws, and
/// std::bad_alloc.
ObjFile readObj(const std::filesystem::path& path, const LocalOrigin& origin, ImportReport& report,
                const std::function<void()>& alive);

} // namespace rtcore
