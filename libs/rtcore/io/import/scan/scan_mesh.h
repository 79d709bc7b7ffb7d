/// Meshes that a reader of scans makes of a file.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/local_origin.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rtcore {

/// One mesh, whose positions are those of the file less `origin`; the lists of normals, texture coordinates
/// and colours are empty or as long as `positions`.
struct ScanMesh {
    LocalOrigin origin;
    bool inFloats = false; ///< the file has its positions in floats
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;            ///< (0, 0) = lower left of the image
    std::vector<Colour> colours;            ///< linear
    std::vector<Triangle> triangles;        ///< indices below positions.size()
    std::uint64_t ignoredPrimitives = 0;    ///< faces of less than three corners
    std::uint64_t unconnectedTriangles = 0; ///< left out: a corner does not exist
};

/// A mesh that has a name in its file.
struct ScanPart {
    std::string name;
    ScanMesh mesh;
};

} // namespace rtcore
