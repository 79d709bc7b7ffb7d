/// Triangles of the faces of CAD parts.
#pragma once

#include "rtcore/io/import/cad/cad_parts.h"
#include "rtcore/scene/local_origin.h"
#include "rtcore/scene/mesh.h"

#include <vector>

namespace rtcore {

/// In the coordinates of the document, less an origin.
struct FaceMesh {
    std::vector<Vec3> positions, normals; ///< a normal is zero where the surface has none
    std::vector<Triangle> triangles;
};

/// Appends those of a face that was meshed, where the part stands; nothing where it was not.
void addFace(const TopoDS_Shape& face, const TopLoc_Location& location, const LocalOrigin& origin,
             FaceMesh& mesh);

} // namespace rtcore
