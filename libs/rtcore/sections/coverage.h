/// How much of each pixel areas cover.
#pragma once

#include "rtcore/sections/cut_plane.h"

#include <cstddef>
#include <span>
#include <vector>

namespace rtcore {

/// Sums the signed areas between lines and the left edge of the image, pixel by pixel: exact for any
/// polygons, and in time of their lines' lengths. Anticlockwise ones count once, clockwise ones -1 times, in
/// pixels whose y grows downwards. One thread. (R. Levien 2016, "Inside the fastest font renderer in the
/// world")
class Coverage {
  public:
    Coverage(int width, int height);

    /// Points in pixels from the upper left corner, anywhere; those that are not finite leave the loop out.
    void add(std::span<const FlatPoint> loop);

    /// Rows and columns [left, right) x [top, bottom) outside of which nothing is covered.
    struct Area {
        int left, top, right, bottom;
        bool empty() const { return left >= right || top >= bottom; }
    };
    Area area() const;

    /// Calls `use(x, y, part)` for each pixel of which a part is covered, 0 < part <= 1: how often all loops
    /// wind around it, at most once. Begins anew afterwards.
    template <typename Use>
    void take(const Use& use) {
        const Area touched = area();
        for (int y = touched.top; y < touched.bottom; ++y) {
            float* const row = sums_.data() + static_cast<std::size_t>(y) * stride_;
            float sum = 0;
            for (int x = touched.left; x < width_; ++x) {
                sum += row[x];
                row[x] = 0;
                const float part = clampedPart(sum);
                if (part > 0) use(x, y, part);
                if (x >= touched.right && part <= 0) break;
            }
            for (int x = touched.left; x < static_cast<int>(stride_); ++x) row[x] = 0;
        }
        forget();
    }

  private:
    static float clampedPart(float sum);
    void forget();
    void addLine(FlatPoint a, FlatPoint b);
    void addInside(FlatPoint a, FlatPoint b);
    void addRow(int y, double height, double x0, double x1);

    int width_, height_;
    std::size_t stride_;
    std::vector<float> sums_;
    int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
};

} // namespace rtcore
