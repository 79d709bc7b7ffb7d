/// Vertices that joints move.
#pragma once

#include "rtcore/io/import/mesh/affine.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// How far a vertex goes with a joint.
struct JointWeight {
    std::uint32_t vertex = 0, joint = 0;
    float weight = 0;
};

/// The joints of each vertex of a mesh. Safe from many threads.
class VertexJoints {
  public:
    /// Weights that are not above 0 or not finite do not count, nor do those of vertices that do not exist.
    VertexJoints(std::span<const JointWeight> weights, std::size_t vertices);

    /// The weighted mean of the joints of a vertex; `otherwise` where it has none. `joints` are as many as
    /// the weights name.
    Affine of(std::size_t vertex, std::span<const Affine> joints, const Affine& otherwise) const;

  private:
    struct Entry {
        std::uint32_t joint;
        float weight;
    };
    std::vector<std::uint32_t> begins_; ///< in `entries_`, by vertex, and the end of all
    std::vector<Entry> entries_;
};

} // namespace rtcore
