/// Light on a microsurface, followed from facet to facet by random walks: what rough metals scatter, without
/// an approximation (Heitz, Hanika, d'Eon and Dachsbacher 2016, "Multiple-Scattering Microfacet BSDFs with
/// the Smith Model"). In double, by formulas of its own. The surface's normal is z.
#pragma once

#include "rtcore/math/vec.h"

#include "support/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace test {

class Microsurface {
  public:
    explicit Microsurface(double roughness) : alpha_(roughness * roughness) {}

    /// Follows a path from the viewer into the surface until it leaves. Calls `meet(back, below, cosine)` for
    /// each facet that it meets: the direction back, the height as free() takes it, and the cosine at which
    /// it is mirrored there.
    template <typename Meet>
    void walk(rtcore::Vec3d toViewer, Random& random, Meet meet) const {
        constexpr int kMax = 200;
        rtcore::Vec3d direction = toViewer * -1.0;
        double below = 1; // the fraction of the surface that lies lower
        for (int facets = 0; facets < kMax && goOn(direction, number(random), below); ++facets) {
            const rtcore::Vec3d back = direction * -1.0;
            const rtcore::Vec3d facet = sampleFacet(back, random);
            const double cosine = dot(back, facet);
            meet(back, below, cosine);
            direction = normalize(facet * (2 * cosine) - back);
        }
    }

    /// The chance that light leaves into a direction above the surface from that height.
    double free(rtcore::Vec3d direction, double below) const {
        return direction.z > 0 ? std::pow(below, lambda(direction.z)) : 0;
    }
    /// The density by solid angle with which a facet met from `back` mirrors light to `direction`.
    double phase(rtcore::Vec3d back, rtcore::Vec3d direction) const {
        const rtcore::Vec3d half = normalize(back + direction);
        if (half.z <= 0 || dot(back, half) <= 0) return 0;
        const double c = half.z, t = c * c * (alpha_ * alpha_ - 1) + 1;
        return alpha_ * alpha_ / (std::numbers::pi * t * t) / (4 * seenArea(back.z));
    }

    static double number(Random& random) {
        return (static_cast<double>(random.index(std::size_t{1} << 32U)) + 0.5) * 0x1p-32;
    }

  private:
    /// Smith's, of directions that go up; of those that go down -1 - that of the opposite.
    double lambda(double cosine) const {
        const double tangent2 = (1 - cosine * cosine) / (cosine * cosine);
        const double root = std::sqrt(1 + alpha_ * alpha_ * tangent2);
        return (cosine > 0 ? root - 1 : -root - 1) / 2;
    }
    double seenArea(double cosine) const {
        return (cosine + std::sqrt(cosine * cosine + (1 - cosine * cosine) * alpha_ * alpha_)) / 2;
    }
    /// To the next facet; false: it leaves.
    bool goOn(rtcore::Vec3d direction, double chance, double& below) const {
        const double l = lambda(direction.z);
        if (direction.z > 0 && (l <= 0 || chance > 1 - std::pow(below, l))) return false;
        below = std::clamp(below / std::pow(1 - chance, 1 / l), 1e-300, 1.0);
        return true;
    }
    /// Heitz 2018, also for what comes from below.
    rtcore::Vec3d sampleFacet(rtcore::Vec3d from, Random& random) const {
        const rtcore::Vec3d view = normalize(rtcore::Vec3d{alpha_ * from.x, alpha_ * from.y, from.z});
        const double flat = view.x * view.x + view.y * view.y;
        const rtcore::Vec3d aside =
            flat > 1e-20 ? rtcore::Vec3d{-view.y, view.x, 0} * (1 / std::sqrt(flat)) : rtcore::Vec3d{1, 0, 0};
        const rtcore::Vec3d along = cross(view, aside);
        const double radius = std::sqrt(number(random)), turn = 2 * std::numbers::pi * number(random);
        const double x = radius * std::cos(turn), seen = (1 + view.z) / 2;
        const double y = (1 - seen) * std::sqrt(1 - x * x) + seen * radius * std::sin(turn);
        const rtcore::Vec3d n = aside * x + along * y + view * std::sqrt(std::max(0.0, 1 - x * x - y * y));
        return normalize(rtcore::Vec3d{alpha_ * n.x, alpha_ * n.y, std::max(n.z, 1e-9)});
    }

    double alpha_;
};

} // namespace test
