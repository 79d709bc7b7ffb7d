#include "rtcore/io/import/mesh/polygon.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// Twice the signed area of a, b, c.
template <typename Point>
double area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace

std::span<const Triangle> PolygonCutter::cut(std::span<const Vec3> corners) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    triangles_.clear();
    if (n == 3) {
        triangles_.push_back({{0, 1, 2}});
        return triangles_;
    }
    next_.resize(n);
    previous_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        next_[i] = i + 1 == n ? 0 : i + 1;
        previous_[i] = i == 0 ? n - 1 : i - 1;
    }
    if (flatten(corners)) {
        findInward();
        if (n == 4 && std::ranges::find(inward_, 1) == inward_.end()) {
            // As clipEars() would have it.
            triangles_.push_back({{0, 1, 2}});
            triangles_.push_back({{2, 3, 0}});
            return triangles_;
        }
        fillGrid();
        clipEars();
    } else {
        fan(0);
    }
    return triangles_;
}

/// Drops the axis along which the normal is largest, so that coordinates keep their bits and turns are exact.
/// False when there is no normal.
bool PolygonCutter::flatten(std::span<const Vec3> corners) {
    double normal[3] = {0, 0, 0};
    const Vec3 origin = corners[0];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const double ax = double{corners[i].x} - origin.x, ay = double{corners[i].y} - origin.y,
                     az = double{corners[i].z} - origin.z;
        const double bx = double{corners[i + 1].x} - origin.x, by = double{corners[i + 1].y} - origin.y,
                     bz = double{corners[i + 1].z} - origin.z;
        normal[0] += ay * bz - az * by;
        normal[1] += az * bx - ax * bz;
        normal[2] += ax * by - ay * bx;
    }
    const auto largest =
        std::max_element(normal, normal + 3, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    if (!(std::fabs(*largest) > 0) || !std::isfinite(normal[0] + normal[1] + normal[2])) return false;
    const auto axis = static_cast<int>(largest - normal);
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (*largest < 0) std::swap(u, v);
    points_.clear();
    for (const Vec3 p : corners) points_.push_back({p[u], p[v]});
    return true;
}

void PolygonCutter::fan(std::uint32_t first) {
    for (std::uint32_t i = next_[first]; next_[i] != first; i = next_[i]) {
        triangles_.push_back({{first, i, next_[i]}});
    }
}

double PolygonCutter::turn(std::uint32_t i) const {
    return area(points_[previous_[i]], points_[i], points_[next_[i]]);
}

void PolygonCutter::findInward() {
    inward_.resize(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) inward_[i] = turn(i) <= 0 ? 1 : 0;
}

std::size_t PolygonCutter::cell(double value, double low, double scale) const {
    const double at = (value - low) * scale;
    return at > 0 ? std::min(static_cast<std::size_t>(at), gridSide_ - 1) : 0;
}

/// Counting sort of the inward corners into a square grid over the polygon.
void PolygonCutter::fillGrid() {
    Point high = low_ = points_[0];
    for (const Point p : points_) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto count = static_cast<std::size_t>(std::count(inward_.begin(), inward_.end(), 1));
    gridSide_ =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(count))), 1, 512);
    const auto side = static_cast<double>(gridSide_);
    scale_ = {side / std::max(high.x - low_.x, 1e-300), side / std::max(high.y - low_.y, 1e-300)};
    const auto cellOf = [this](std::uint32_t i) {
        return cell(points_[i].y, low_.y, scale_.y) * gridSide_ + cell(points_[i].x, low_.x, scale_.x);
    };
    cellStart_.assign(gridSide_ * gridSide_ + 1, 0);
    cellCorners_.resize(count);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        if (inward_[i] != 0) ++cellStart_[cellOf(i) + 1];
    }
    for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
    std::vector<std::uint32_t> at(cellStart_.begin(), cellStart_.end() - 1);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        if (inward_[i] != 0) cellCorners_[at[cellOf(i)]++] = i;
    }
}

/// Convex, and no inward corner lies in or on the triangle that would be cut off.
bool PolygonCutter::isEar(std::uint32_t i) const {
    if (inward_[i] != 0 || turn(i) <= 0) return false;
    const std::uint32_t ia = previous_[i], ic = next_[i];
    const Point a = points_[ia], b = points_[i], c = points_[ic];
    const std::size_t x0 = cell(std::min({a.x, b.x, c.x}), low_.x, scale_.x);
    const std::size_t x1 = cell(std::max({a.x, b.x, c.x}), low_.x, scale_.x);
    const std::size_t y0 = cell(std::min({a.y, b.y, c.y}), low_.y, scale_.y);
    const std::size_t y1 = cell(std::max({a.y, b.y, c.y}), low_.y, scale_.y);
    const auto same = [](Point p, Point q) { return p.x == q.x && p.y == q.y; };
    for (std::size_t y = y0; y <= y1; ++y) {
        for (std::uint32_t k = cellStart_[y * gridSide_ + x0]; k < cellStart_[y * gridSide_ + x1 + 1]; ++k) {
            const std::uint32_t j = cellCorners_[k];
            if (inward_[j] == 0 || j == ia || j == ic) continue;
            const Point p = points_[j];
            // Polygons with holes run along one cut twice: the same point is there two times.
            if (same(p, a) || same(p, b) || same(p, c)) continue;
            if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
        }
    }
    return true;
}

void PolygonCutter::removeCorner(std::uint32_t i) {
    const std::uint32_t a = previous_[i], c = next_[i];
    triangles_.push_back({{a, i, c}});
    next_[a] = c;
    previous_[c] = a;
    inward_[i] = 0;
    for (const std::uint32_t j : {a, c}) {
        if (inward_[j] != 0) inward_[j] = turn(j) <= 0 ? 1 : 0;
    }
}

void PolygonCutter::clipEars() {
    auto left = static_cast<std::uint32_t>(points_.size());
    constexpr int kMaxForced = 16; // then the polygon crosses itself and any cut is as good
    int forced = 0;
    std::uint32_t tried = 0;
    std::uint32_t i = 1;
    while (left > 3) {
        const bool ear = isEar(i);
        if (!ear && ++tried < left) {
            i = next_[i];
            continue;
        }
        if (!ear && ++forced > kMaxForced) break;
        const std::uint32_t after = next_[i];
        removeCorner(i);
        --left;
        tried = 0;
        // Every other corner first: rounder triangles than a fan.
        i = left > 3 ? next_[after] : after;
    }
    fan(i);
}

} // namespace rtcore
