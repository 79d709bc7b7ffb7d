/// A smooth curve through points, measured along its length.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rtcore {

/// A centripetal Catmull-Rom spline (Yuksel, Schaefer, Keyser: Parameterization and Applications of
/// Catmull-Rom Curves, CAD 2011), that ends as parabolas do: no cusps, no loops between two points, one
/// direction at each of them. Tangents are shortened where the curve would go more than kMaxOvershoot of the
/// distance of two points beyond one of them. By sums, products, quotients and square roots of doubles alone,
/// so that it is the same everywhere.
class SmoothCurve {
  public:
    static constexpr double kMaxOvershoot = 0.02;

    /// Points are finite, at least one, of a `closed` curve at least three, which leads back to the first
    /// from the last. Two neighbours never coincide.
    SmoothCurve(std::span<const Vec3d> points, bool closed);

    std::size_t segments() const { return segments_.size(); }
    double length() const { return begins_.back(); }
    /// Along the curve from its beginning; `point` may be segments(), of the end.
    double lengthAt(std::size_t point) const { return begins_[point]; }
    /// The point after that length of the curve, which is clamped; exactly one of the points at lengthAt().
    Vec3d at(double along) const;

  private:
    static constexpr std::size_t kParts = 16;
    /// Between two points, by a parameter from 0 to 1: a cubic by its Hermite form.
    struct Segment {
        Vec3d from, to, leaving, arriving;        ///< points and derivatives
        std::array<double, kParts + 1> lengths{}; ///< up to each part of the parameter
        Vec3d at(double t) const;
        Vec3d slope(double t) const;
    };
    static void shorten(Segment& segment);
    static void measure(Segment& segment);

    Vec3d first_;
    std::vector<Segment> segments_;
    std::vector<double> begins_; ///< length at each point, and the whole at the end
};

} // namespace rtcore
