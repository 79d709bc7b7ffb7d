/// The surfaces of a model that an edit hides or shows.
#pragma once

#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Some KB. Read by many threads.
class ChangedSurfaces {
  public:
    /// By triangle of the mesh, not 0 where it is hidden.
    void find(const Mesh& mesh, std::span<const std::uint8_t> before, std::span<const std::uint8_t> now);

    bool empty() const { return boxes_.empty(); }
    /// Whether a record lies on them, or so near that its radius, or the walls that it knows, may be others
    /// now.
    bool areNear(const IrradianceRecord& record) const;

  private:
    std::vector<Box3> boxes_; ///< all of them lie in one
};

} // namespace rtcore
