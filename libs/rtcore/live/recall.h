/// Finds what the frame before knew of points. (Reprojection: Nehab et al. 2007, "Accelerating Real-Time
/// Shading with Reverse Reprojection Caching"; samples that keep their position: Walter, Drettakis and Parker
/// 1999, "Interactive Rendering using the Render Cache")
#pragma once

#include "rtcore/live/live_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Points of the present frame, as the past may have seen them: one array for each value, with room for whole
/// vectors. Keeps its memory.
class AskedPoints {
  public:
    void clear() { size_ = 0; }
    /// `position`: of a point that is LivePoint::kFar away its direction. `normal`: unit, on the side of the
    /// viewer.
    void push(Vec3 position, Vec3 normal, float depth);
    std::size_t size() const { return size_; }

    enum Value : std::size_t { X, Y, Z, NormalX, NormalY, NormalZ, Depth, kValues };
    const float* values(Value value) const { return values_[value].data(); }

  private:
    std::array<std::vector<float>, kValues> values_;
    std::size_t size_ = 0;
};

/// What was found of them, in their order. Keeps its memory.
class RecalledPoints {
  public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    /// For each point, of the four pixels of `past` around it, that one whose light is from nearest to it, at
    /// most about a pixel away, on the same surface: normals within 20 degrees, and not more than 1 % of the
    /// depth off its plane.
    void recall(const LiveImage& past, const AskedPoints& asked);

    /// Whether the past saw that surface where the point would have been.
    bool wasSeen(std::size_t i) const { return seen_[i] != 0; }
    /// Gives `point` the light that was found, with where it is from. False: there is none, and `point` is as
    /// it was.
    bool takeLight(const LiveImage& past, std::size_t i, LivePoint& point) const;

  private:
    std::vector<std::uint32_t> from_;  ///< indices of pixels, or kNone
    std::vector<float> across_, down_; ///< pixels to where the light is from
    std::vector<std::uint32_t> seen_;
};

} // namespace rtcore
