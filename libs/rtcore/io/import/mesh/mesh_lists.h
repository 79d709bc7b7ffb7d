/// Meshes behind each other, as they come from a file.
#pragma once

#include "rtcore/scene/mesh.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Lists of vertices but `positions` are empty where no mesh has any, else as long as `positions`.
struct MeshLists {
    /// Elements that begin behind those of the run before.
    struct Run {
        std::uint32_t end, value;
    };
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    std::vector<Vec2> texcoords;
    std::vector<Colour> colours;
    std::vector<float> alphas;
    std::vector<std::vector<Vec2>> furtherTexcoords; ///< by set
    std::vector<Triangle> triangles;
    std::vector<Run> materials; ///< of triangles
    std::vector<Run> bare;      ///< vertices: 1 for those of meshes of positions alone, else 0
    /// Some mesh has them, even if none of its triangles is any good.
    bool hasAttributes = false, hasTexcoords = false, hasColours = false, hasAlphas = false;
};

/// Welds vertices whose positions are equal, and those corners at them that agree in all else; numbers both
/// in the order in which triangles come to them. Fills the geometry of `model` - where all meshes are bare,
/// without normals - and takes the lists. By the threads of OpenMP; the result does not depend on them.
void weld(MeshLists lists, ModelBuffers& model);

} // namespace rtcore
