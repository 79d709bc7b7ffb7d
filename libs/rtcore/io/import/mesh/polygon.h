/// Polygons to triangles.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Cuts simple polygons, convex or not, into triangles by ear clipping over a grid of the inward corners.
/// An object keeps its memory from one polygon to the next; one thread at a time.
class PolygonCutter {
  public:
    /// n - 2 triangles with the winding of the polygon, as indices into `corners` (n >= 3), which may be a
    /// little off a plane. Corners on a straight edge stay corners of triangles with area where that is
    /// possible, so that a neighbour that has them, too, meets no gap. Polygons that cross themselves or have
    /// no area or non-finite corners give n - 2 triangles all the same, though not useful ones. The result is
    /// valid until the next call.
    std::span<const Triangle> cut(std::span<const Vec3> corners);

  private:
    struct Point {
        double x, y;
    };
    bool flatten(std::span<const Vec3> corners);
    void fan(std::uint32_t first);
    void findInward();
    void fillGrid();
    void clipEars();
    bool isEar(std::uint32_t i) const;
    void removeCorner(std::uint32_t i);
    double turn(std::uint32_t i) const;
    std::size_t cell(double value, double low, double scale) const;

    std::vector<Point> points_;
    std::vector<std::uint32_t> previous_, next_; ///< ring of the corners that are left
    std::vector<char> inward_;                   ///< the corner is not convex and still there
    std::vector<std::uint32_t> cellStart_, cellCorners_;
    std::size_t gridSide_ = 1;
    Point low_{}, scale_{};
    std::vector<Triangle> triangles_;
};

} // namespace rtcore
