/// A primitive where it stands in the scene.
#pragma once

#include "rtcore/io/import/gltf/primitive.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/io/import/mesh/mesh_assembly.h"

#include <span>
#include <vector>

namespace rtcore::gltf {

/// Keeps its memory from one primitive to the next.
class MeshPlacer {
  public:
    /// `joints` are those of the primitive's skin, which then takes the place of `toWorld`; none: it has
    /// none. Valid until the next call, as long as `primitive` lives. Turns triangles over where they are
    /// mirrored.
    SourceMesh place(const Primitive& primitive, const Affine& toWorld, std::span<const Affine> joints);
    /// For a primitive that is placed only once: its lists that `mesh` shows may be taken.
    static void spareLists(Primitive& primitive, SourceMesh& mesh);

  private:
    void move(const Primitive& primitive, const Affine& toWorld);
    void pose(const Primitive& primitive, std::span<const Affine> joints);

    std::vector<Triangle> triangles_;
    std::vector<Vec3> positions_, normals_;
};

} // namespace rtcore::gltf
