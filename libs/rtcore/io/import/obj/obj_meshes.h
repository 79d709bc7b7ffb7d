/// Meshes of an OBJ file with indices of their own.
#pragma once

#include "rtcore/io/import/mesh/mesh_assembly.h"
#include "rtcore/io/import/mesh/polygon.h"
#include "rtcore/io/import/obj/mtl_file.h"
#include "rtcore/io/import/obj/obj_model.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// Makes SourceMeshes of the meshes of a model, and keeps its memory from one to the next.
class ObjMeshes {
  public:
    /// Colours of `model` are decoded. It must outlive the object.
    explicit ObjMeshes(ObjModel& model);

    /// Corners of one position that agree in texture coordinate and normal are one vertex. A face of which a
    /// corner names a position that does not exist is left out; other names that lead nowhere count as none.
    /// Valid until the next call. After the `last` mesh the model's lists are gone, to make room.
    SourceMesh read(const ObjMesh& mesh, const MtlLayout& layout, bool last);

    std::uint64_t ignoredFaces() const { return ignored_; } ///< so far, of less than three corners
    std::uint64_t unconnectedTriangles() const { return unconnected_; } ///< so far

  private:
    struct Corner {
        std::uint32_t position, texcoord, normal;
    };
    struct Known {
        std::uint32_t texcoord, normal, next;
    };
    bool isIndexed(const ObjMesh& mesh) const;
    SourceMesh asItStands(const MtlLayout& layout);
    void readRun(const ObjRun& run);
    void gatherVertices(const MtlLayout& layout);
    void releaseModel();
    void readFace(std::size_t first, std::size_t size);
    void cutPolygon(std::size_t first, std::size_t size);
    Corner cornerAt(std::size_t corner) const;
    std::uint32_t vertexOf(const Corner& corner);
    void forgetVertices();

    ObjModel& model_;
    std::uint64_t ignored_ = 0, unconnected_ = 0;
    std::vector<std::uint32_t> newest_; ///< by position: the last vertex there of this mesh
    std::vector<Known> known_;          ///< by vertex
    std::vector<std::uint32_t> positionOf_;
    std::vector<Triangle> triangles_;
    std::vector<Vec3> positions_, normals_, places_;
    std::vector<Vec2> texcoords_;
    std::vector<Colour> colours_;
    std::vector<std::uint32_t> polygon_;
    PolygonCutter cutter_;
    bool hasTexcoords_ = false, hasNormals_ = false;
};

} // namespace rtcore
