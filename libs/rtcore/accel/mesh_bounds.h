/// The box of a mesh.
#pragma once

#include "rtcore/scene/mesh.h"

namespace rtcore {

/// As Mesh::bounds(), the same to the last bit, by all threads of the OpenMP region that one thread has
/// entered.
Box3 boundsInTasks(const Mesh& mesh);

} // namespace rtcore
