/// Binary PLY files as scanners write them, and whether those of text are whole.
#pragma once

#include "rtcore/io/import/scan/ply_header.h"
#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/files.h"

#include <functional>
#include <optional>

namespace rtcore {

/// Whether readPly() reads a file with this head: binary, vertices of a fixed size with x, y and z, then
/// faces with one list, of indices; other elements of a fixed size are passed over. No strips, no materials,
/// no texture coordinates of faces.
bool isScan(const PlyHeader& header);

/// Whether it reads one of points alone: binary, vertices as above, no lists.
bool isPlyCloud(const PlyHeader& header);

/// Positions, less `origin`, and where they are there normals, texture coordinates and colours (as sRGB).
/// Polygons are cut into triangles (polygon.h). Memory follows the file's bytes, whatever its head says.
/// `alive` is called now and then. Throws FileError BadData for a file that is shorter than its head says and
/// for a face that names no vertex, what InputFile throws, and std::bad_alloc.
ScanMesh readPly(const InputFile& file, const PlyHeader& header, const LocalOrigin& origin,
                 const std::function<void()>& alive);

/// Whether readPlyMesh() reads a file with this head, of text or not: vertices as above, then faces, strips
/// or neither, whose one list are their indices. No materials, no texture coordinates of faces.
bool isPlyMesh(const PlyHeader& header);
/// Whether its faces have colours.
bool hasFaceColours(const PlyHeader& header);
/// The same as readPly(), not as fast, with strips (`tristrips`) and colours of faces, which count where
/// vertices have none. Faces that name a vertex that does not exist are left out and counted.
ScanMesh readPlyMesh(const InputFile& file, const PlyHeader& header, const LocalOrigin& origin,
                     const std::function<void()>& alive);

/// Assimp makes up what a file of text lacks. Throws FileError BadData where it has fewer lines than its head
/// promises elements, and what InputFile throws. `alive` is called now and then.
void refuseCutOffText(const InputFile& file, const PlyHeader& header, const std::function<void()>& alive);

} // namespace rtcore
