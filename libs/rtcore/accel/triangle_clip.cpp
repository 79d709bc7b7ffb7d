#include "rtcore/accel/triangle_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

using Point = std::array<double, 3>;

/// Six planes add at most one corner each to the three; a sliver that rounding bends may gain a few more.
struct Polygon {
    std::array<Point, 16> points;
    int count = 0;

    void add(const Point& p) { points[static_cast<std::size_t>(count++)] = p; }
};

/// Keeps the part of `in` where sign * (coordinate - limit) <= 0: `in` itself if that is all, or `out`.
Polygon* clipAgainst(Polygon* in, std::size_t axis, double limit, double sign, Polygon* out) {
    const auto count = static_cast<std::size_t>(in->count);
    std::array<double, 16> distance;
    bool outside = false;
    for (std::size_t i = 0; i < count; ++i) {
        distance[i] = sign * (in->points[i][axis] - limit);
        outside |= distance[i] > 0;
    }
    if (!outside) return in;
    out->count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = i + 1 == count ? 0 : i + 1;
        const Point& a = in->points[i];
        const double da = distance[i];
        const double db = distance[next];
        if (da <= 0) out->add(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
            const Point& b = in->points[next];
            const double fraction = da / (da - db);
            Point p;
            for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + fraction * (b[k] - a[k]);
            p[axis] = limit;
            out->add(p);
        }
    }
    return out;
}

} // namespace

float clipMargin(const Box3& bounds) {
    float largest = 0;
    for (int a = 0; a < 3; ++a) {
        largest = std::max({largest, std::fabs(bounds.lo[a]), std::fabs(bounds.hi[a])});
    }
    return largest * 0x1p-21F;
}

Box3 clippedBounds(const std::array<Vec3, 3>& corners, const Box3& cell, float margin) {
    Box3 own;
    for (const Vec3 p : corners) own.extend(p);
    Polygon polygons[2];
    Polygon* current = &polygons[0];
    Polygon* next = &polygons[1];
    for (const Vec3 p : corners) current->add({p.x, p.y, p.z});
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = static_cast<double>(cell.lo[axis]) - margin;
        const double hi = static_cast<double>(cell.hi[axis]) + margin;
        const auto a = static_cast<std::size_t>(axis);
        const auto clip = [&](double limit, double sign) {
            Polygon* const clipped = clipAgainst(current, a, limit, sign, next);
            if (clipped != current) next = std::exchange(current, clipped);
        };
        if (own.lo[axis] < lo) clip(lo, -1);
        if (own.hi[axis] > hi) clip(hi, 1);
        if (current->count == 0) return {};
    }
    Box3 result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        double lo = current->points[0][a];
        double hi = lo;
        for (int i = 1; i < current->count; ++i) {
            lo = std::min(lo, current->points[static_cast<std::size_t>(i)][a]);
            hi = std::max(hi, current->points[static_cast<std::size_t>(i)][a]);
        }
        result.lo[axis] = std::max({static_cast<float>(lo - margin), own.lo[axis], cell.lo[axis]});
        result.hi[axis] = std::min({static_cast<float>(hi + margin), own.hi[axis], cell.hi[axis]});
        // A triangle that only the margin brought in lies outside the cell: it touches the nearer face.
        if (result.lo[axis] > result.hi[axis]) {
            const float face = own.lo[axis] > cell.hi[axis] ? cell.hi[axis] : cell.lo[axis];
            result.lo[axis] = result.hi[axis] = std::clamp(face, cell.lo[axis], cell.hi[axis]);
        }
    }
    return result;
}

} // namespace rtcore
