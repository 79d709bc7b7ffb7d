/// Numbers of the connected surfaces of a mesh: light that one sends out is not taken for that of another,
/// however near it is.
#pragma once

#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// 2 bytes for each triangle.
class ConnectedSurfaces {
  public:
    /// Takes some 50 ns for each triangle. Those that share a vertex are connected. Of surfaces that are less
    /// than a hundredth as large as the mesh, as leaves and pebbles are, nothing is told apart.
    void find(const Mesh& mesh);

    /// 0: of one that is small, or no triangle of the mesh, as those of a ground.
    std::uint32_t of(std::uint32_t triangle) const {
        return triangle < numbers_.size() ? numbers_[triangle] : 0;
    }

  private:
    std::vector<std::uint16_t> numbers_;
};

} // namespace rtcore
