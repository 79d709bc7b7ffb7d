/// Primitives that are compressed by KHR_draco_mesh_compression.
#pragma once

#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore::gltf {

inline constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";

/// Whether this program was built with the library.
bool readsDraco();

class DracoMesh {
  public:
    /// Nothing where the code is damaged.
    static std::unique_ptr<DracoMesh> decode(std::span<const std::byte> code);
    DracoMesh() = default;
    virtual ~DracoMesh() = default;
    DracoMesh(const DracoMesh&) = delete;
    DracoMesh& operator=(const DracoMesh&) = delete;

    virtual std::uint32_t vertices() const = 0;
    virtual std::vector<Triangle> triangles() const = 0;
    /// The first `components` numbers of each vertex of the attribute with this number, 0 for those that it
    /// does not have; none where there is no such attribute.
    virtual std::vector<float> floats(std::uint32_t attribute, std::uint32_t components) const = 0;
};

} // namespace rtcore::gltf
