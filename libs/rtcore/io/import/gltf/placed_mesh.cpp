#include "rtcore/io/import/gltf/placed_mesh.h"

#include "rtcore/io/import/gltf/skin.h"
#include "rtcore/platform/large_vector.h"

#include <utility>

namespace rtcore::gltf {

namespace {

/// Fewer are not worth the threads.
constexpr std::size_t kManyVertices = 50'000;

} // namespace

void MeshPlacer::move(const Primitive& primitive, const Affine& toWorld) {
    resizeLarge(positions_, primitive.positions.size());
    resizeLarge(normals_, primitive.normals.size());
#pragma omp parallel if (positions_.size() > kManyVertices)
    {
#pragma omp for schedule(static) nowait
        for (std::size_t i = 0; i < positions_.size(); ++i)
            positions_[i] = toWorld.point(primitive.positions[i]);
#pragma omp for schedule(static)
        for (std::size_t i = 0; i < normals_.size(); ++i) normals_[i] = toWorld.normal(primitive.normals[i]);
    }
}

void MeshPlacer::pose(const Primitive& primitive, std::span<const Affine> joints) {
    resizeLarge(positions_, primitive.positions.size());
    resizeLarge(normals_, primitive.normals.size());
#pragma omp parallel for schedule(static) if (positions_.size() > kManyVertices)
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        const Affine skin = skinOf(primitive.influences, i, joints);
        positions_[i] = skin.point(primitive.positions[i]);
        if (!normals_.empty()) normals_[i] = skin.normal(primitive.normals[i]);
    }
}

SourceMesh MeshPlacer::place(const Primitive& primitive, const Affine& toWorld,
                             std::span<const Affine> joints) {
    const bool posed = !joints.empty() && !primitive.influences.empty();
    SourceMesh mesh{primitive.positions, primitive.normals, primitive.texcoords,
                    primitive.colours,   primitive.alphas,  primitive.list.triangles};
    mesh.furtherTexcoords = primitive.furtherTexcoords;
    if (primitive.list.triangles.empty()) return mesh;
    if (posed || !toWorld.identity()) {
        if (posed) {
            pose(primitive, joints);
        } else {
            move(primitive, toWorld);
        }
        mesh.positions = positions_;
        mesh.normals = normals_;
        mesh.spare.positions = &positions_;
        mesh.spare.normals = &normals_;
    }
    const Affine first =
        posed ? skinOf(primitive.influences, primitive.list.triangles[0].v[0], joints) : toWorld;
    if (first.determinant() < 0) {
        triangles_ = primitive.list.triangles;
        for (Triangle& t : triangles_) std::swap(t.v[1], t.v[2]);
        mesh.triangles = triangles_;
        mesh.spare.triangles = &triangles_;
    }
    return mesh;
}

void MeshPlacer::spareLists(Primitive& primitive, SourceMesh& mesh) {
    if (mesh.positions.data() == primitive.positions.data()) {
        mesh.spare.positions = &primitive.positions;
        mesh.spare.normals = &primitive.normals;
    }
    mesh.spare.texcoords = &primitive.texcoords;
    if (mesh.triangles.data() == primitive.list.triangles.data())
        mesh.spare.triangles = &primitive.list.triangles;
}

} // namespace rtcore::gltf
