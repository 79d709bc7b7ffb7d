/// Surfaces of CAD programs - STEP, IGES and BREP - by Open CASCADE, which only rtimport_cad links.
#pragma once

#include "rtcore/io/import/file_import.h"

namespace rtcore {

/// Triangles that lie off the surfaces by at most options.deflection of the model's diagonal, and of a part's
/// by ten times that, and turn by at most 20 degrees from one to the next; normals are those of the surfaces.
/// Parts are solids under their assemblies, by name, each once for every place where it stands. Colours of
/// faces, solids and instances are materials. Lengths become millimetres; BREP has no unit. Throws as
/// importFile() does; Open CASCADE may crash.
FileImport importCad(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
