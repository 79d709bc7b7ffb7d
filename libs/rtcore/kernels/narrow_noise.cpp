#include "rtcore/kernels/narrow_noise.h"

#include "rtcore/math/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr double kRounding = 0x1p-24;

using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;

Point pointOf(Vec3 v) { return {v.x, v.y, v.z}; }

Point normalOf(const Corners& p) {
    const auto edge = [&](int to, int axis) { return p[to][axis] - p[0][axis]; };
    const auto part = [&](int x, int y) { return edge(1, x) * edge(2, y) - edge(1, y) * edge(2, x); };
    return {part(1, 2), part(2, 0), part(0, 1)};
}

double spanOf(const Corners& p, int axis) {
    const auto [min, max] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
    return max - min;
}

/// How much the weighted distances err since rounding moves corners, times twice the area, in roundings. With
/// x, y, z the sizes of the box, z along the ray's dominant axis: a corner moves across the ray by at most
/// 2 x + 2 z, along it by z, and sums of distances weighted by the edge functions by 3 z. The corners' shares
/// halve that, and only its part along the normal counts.
double positionsNoise(const Point& sizes, const Point& normal) {
    double noise = 0;
    const double longest = std::max({sizes[0], sizes[1], sizes[2]});
    for (int axis = 0; axis < 3; ++axis) noise += std::fabs(normal[axis]) * (sizes[axis] + 2.5 * longest);
    return noise;
}

/// The same for the roundings of the edge functions' products, of places that span x + z and y + z, weighted
/// by the corners' distances: at most this, of corners in a row and a ray at a third of it.
double maxOfProducts(const Point& sizes) {
    const auto [x, y, z] = sizes;
    return 8.0 / 9 * std::max({(y + x) * (z + x) * x, (x + y) * (z + y) * y, (x + z) * (y + z) * z});
}

/// That for rays of dominant axis `kz` and shear (sx, sy) that start at `origin`.
double productsAt(const Corners& p, const Point& origin, int kz, double sx, double sy) {
    const int kx = (kz + 1) % 3;
    const int ky = (kz + 2) % 3;
    Point x{};
    Point y{};
    Point z{};
    for (int i = 0; i < 3; ++i) {
        z[i] = p[i][kz] - origin[kz];
        x[i] = std::fabs(p[i][kx] - origin[kx] - sx * z[i]);
        y[i] = std::fabs(p[i][ky] - origin[ky] - sy * z[i]);
    }
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum += std::fabs(z[i]) * (x[j] * y[k] + x[k] * y[j]);
    }
    return sum;
}

/// The most of it for a grid of origins on the triangle and the four shears that count (it is convex in
/// each), and a tenth for what lies between.
double productsNoise(const Corners& p) {
    constexpr int kSteps = 8;
    double max = 0;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
            Point origin{};
            for (int axis = 0; axis < 3; ++axis) {
                origin[axis] = (i * p[0][axis] + j * p[1][axis] + (kSteps - i - j) * p[2][axis]) / kSteps;
            }
            for (int kz = 0; kz < 3; ++kz) {
                for (const double sx : {-1.0, 1.0}) {
                    for (const double sy : {-1.0, 1.0})
                        max = std::max(max, productsAt(p, origin, kz, sx, sy));
                }
            }
        }
    }
    return 1.1 * max;
}

/// surfaceClearance() but for the rounding of where rays start, times twice the area.
double surelyClear(const Corners& p, Vec3 a, Vec3 b, Vec3 c, const Point& normal, double twiceArea) {
    constexpr double kStart = 6; // roundings of a point on a triangle, and of the step off it
    double across = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = std::max({std::fabs(p[0][axis]), std::fabs(p[1][axis]), std::fabs(p[2][axis])});
        across += extent * std::fabs(normal[axis]);
    }
    const Vec3 unit{static_cast<float>(normal[0] / twiceArea), static_cast<float>(normal[1] / twiceArea),
                    static_cast<float>(normal[2] / twiceArea)};
    return surfaceClearance(a, b, c, unit) * twiceArea - kStart * kRounding * across;
}

} // namespace

float narrowNoise(Vec3 a, Vec3 b, Vec3 c) {
    constexpr double kMuch = 0x1p-19; // of the triangle's size: at most half of what traversal allows for
    const Corners p{pointOf(a), pointOf(b), pointOf(c)};
    const Point normal = normalOf(p);
    const double twiceArea = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const Point sizes{spanOf(p, 0), spanOf(p, 1), spanOf(p, 2)};
    const double positions = positionsNoise(sizes, normal);
    const double clear = surelyClear(p, a, b, c, normal, twiceArea);
    if ((positions + maxOfProducts(sizes)) * kRounding <= clear) return 0;
    const double noise = (positions + productsNoise(p)) * kRounding;
    if (noise <= clear) return 0;
    // Written so that NaN, of a triangle without area, is the narrowest.
    const bool matters = !(noise <= kMuch * (sizes[0] + sizes[1] + sizes[2]) * twiceArea);
    return matters ? std::numeric_limits<float>::infinity() : static_cast<float>(noise);
}

// With L the longest side of the box, M its largest coordinate and n the normal: positionsNoise() is at most
// 3.5 L times the sum of n's numbers, of which the largest is no more than n's length; maxOfProducts() is at
// most 32 / 9 L^3; surelyClear() is at least 16 M times n's length, in roundings. What is left out of that is
// more than single precision errs by where n is not much shorter than L^2.
bool isSurelyCommon(Float4 a, Float4 b, Float4 c) {
    constexpr float kMin = 1e-9F, kMax = 1e9F; // so that no product vanishes or is infinite
    constexpr float kMinNormal = 0x1p-10F;
    const auto size = [](Float4 v) { return max4(v, -v); };
    const auto next = [](Float4 v) { return __builtin_shufflevector(v, v, 1, 2, 0, 0); };
    const auto largest = [&](Float4 v) { return max4(max4(v, next(v)), next(next(v)))[0]; };
    const Float4 ab = b - a, ac = c - a;
    const float longest = largest(max4(max4(size(ab), size(ac)), size(c - b)));
    const float extent = largest(max4(max4(size(a), size(b)), size(c)));
    const float normal = largest(size(ab * next(ac) - next(ab) * ac));
    // No branch before the last.
    const bool usual = static_cast<int>(longest >= kMin) & static_cast<int>(extent <= kMax) &
                       static_cast<int>(normal >= kMinNormal * longest * longest);
    return static_cast<int>(usual) &
           static_cast<int>(4 * longest * longest * longest <= normal * (15 * extent - 6.5F * longest));
}

} // namespace rtcore
