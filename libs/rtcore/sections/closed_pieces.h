/// Which pieces of a model's parts are closed, so that they have an inside.
#pragma once

#include "rtcore/scene/model.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// Triangles that follow each other: one of Model::parts, or a gap between two of them.
struct PartRange {
    static constexpr std::uint32_t kNoPart = 0xFFFFFFFFU;
    std::uint32_t part; ///< its number, or kNoPart
    std::uint32_t firstTriangle, triangleCount;
};

/// All triangles of the model, ascending; ranges without any are left out.
std::vector<PartRange> rangesOf(const Model& model);

/// Found when they are first asked for, which takes a quarter of a second for the 871,000 triangles of the
/// dragon, and kept: a byte for each. One thread at a time. The model must outlive it.
class ClosedPieces {
  public:
    explicit ClosedPieces(const Model& model);

    const std::vector<PartRange>& ranges() const { return ranges_; }
    /// By triangle of the range: 1 where its piece is closed (inClosedPieces()).
    const std::vector<std::uint8_t>& of(std::size_t range);

  private:
    const Model& model_;
    std::vector<PartRange> ranges_;
    std::vector<std::optional<std::vector<std::uint8_t>>> closed_;
};

} // namespace rtcore
