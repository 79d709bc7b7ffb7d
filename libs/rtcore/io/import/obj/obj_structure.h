/// Objects, groups and materials of an OBJ file: which mesh the next face belongs to.
#pragma once

#include "rtcore/io/import/obj/obj_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rtcore {

/// Parts models as Assimp does, so that parts keep their names and triangles their order: a group and an
/// object begin a part each, and so does another material within them; an object whose name comes up again is
/// the one of before, but faces go on in the mesh at hand until the material changes.
class ObjStructure {
  public:
    explicit ObjStructure(ObjModel& model) : model_(model) {}

    void beginObject(std::string_view name);
    void beginGroup(std::string_view name);
    void setMaterial(std::uint32_t material, const std::string& name);
    /// The mesh of the face, line or points that come next.
    std::size_t meshOfNext();

  private:
    void createObject(const std::string& name);
    void createMesh(const std::string& name);

    ObjModel& model_;
    std::optional<std::size_t> mesh_;
    std::uint32_t object_ = kNoIndex, material_ = kNoIndex;
    std::string group_;
    std::unordered_map<std::string, std::uint32_t> objects_; ///< the first of each name
};

} // namespace rtcore
