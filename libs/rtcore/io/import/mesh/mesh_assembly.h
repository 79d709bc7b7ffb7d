/// Many meshes into the flat arrays of a model.
#pragma once

#include "rtcore/io/import/mesh/mesh_lists.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One mesh where it stands in the scene. All spans but `positions` and `triangles` may be empty, else they
/// are as long as `positions`.
struct SourceMesh {
    std::span<const Vec3> positions = {}; ///< any floats
    std::span<const Vec3> normals = {};   ///< any length; zero or not finite = to be computed
    std::span<const Vec2> texcoords = {}; ///< (0, 0) = lower left of the image
    std::span<const Colour> colours = {}; ///< linear
    std::span<const float> alphas = {};
    std::span<const Triangle> triangles = {}; ///< indices below positions.size(); the caller has checked
    std::uint32_t material = 0;
    /// Of further sets; at most kMaxFurtherSets, where there are `texcoords`.
    std::span<const std::vector<Vec2>> furtherTexcoords = {};
    /// The lists themselves, where they are as long as the spans and the caller needs them no more.
    struct {
        std::vector<Vec3>*positions = nullptr, *normals = nullptr;
        std::vector<Vec2>* texcoords = nullptr;
        std::vector<Triangle>* triangles = nullptr;
    } spare = {};
};

/// Puts meshes together, in the order in which they come: welds vertices whose positions are equal (what is
/// nearer to 0 than 1e-30 is 0), so that neighbours share them; drops and counts triangles without area and
/// those with a coordinate that is no number or beyond 1e12. Entries of normals, texture coordinates of all
/// sets, colours and alphas are shared where all of them are equal. By the threads of OpenMP for large
/// meshes; the result does not depend on them.
class MeshAssembler {
  public:
    /// Upper bounds of all that will be added.
    void reserve(std::size_t vertices, std::size_t triangles);
    void add(const SourceMesh& mesh);
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(lists_.triangles.size()); }
    /// Behind the last mesh.
    void weld();
    /// Those of the model, behind weld() and before finish().
    std::span<const Vertex> vertices() const { return welded_.vertices; }
    /// Fills the geometry of `model`; computes the normals that are missing (crease_normals.h). Call it once,
    /// behind weld().
    void finish(ModelBuffers& model, float creaseAngle);

    /// Behind weld(): the bounds of all finite triangles added, even without area.
    const Box3& bounds() const { return bounds_; }
    std::uint64_t degenerateTriangles() const { return degenerate_; }
    std::uint64_t nonFiniteTriangles() const { return nonFinite_; }

  private:
    enum class Use : std::uint8_t { Good, NonFinite, WithoutArea };
    std::vector<Use> measure(const SourceMesh& mesh);
    void addTriangles(const SourceMesh& mesh, const std::vector<Use>& uses);
    void addVertices(const SourceMesh& mesh);

    MeshLists lists_;
    ModelBuffers welded_;
    std::size_t expectedVertices_ = 0, expectedTriangles_ = 0;
    Box3 bounds_;
    std::uint64_t degenerate_ = 0, nonFinite_ = 0;
};

} // namespace rtcore
