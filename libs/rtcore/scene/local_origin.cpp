#include "rtcore/scene/local_origin.h"

#include "rtcore/math/nearest_float.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

/// Whole units, or the power of ten below the size of what is smaller.
double stepFor(double size) { return size >= 1 ? 1 : std::pow(10.0, std::floor(std::log10(size))); }

} // namespace

Vec3 LocalOrigin::local(const FilePoint& p) const {
    return {nearestFloat(p[0] - at[0]), nearestFloat(p[1] - at[1]), nearestFloat(p[2] - at[2])};
}

FilePoint LocalOrigin::inFile(Vec3 p) const {
    return {double{p.x} + at[0], double{p.y} + at[1], double{p.z} + at[2]};
}

void FileBounds::extend(const FilePoint& p) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return;
    for (std::size_t i = 0; i < 3; ++i) {
        lo[i] = std::min(lo[i], p[i]);
        hi[i] = std::max(hi[i], p[i]);
    }
}

void FileBounds::extend(const FileBounds& other) {
    if (other.empty()) return;
    extend(other.lo);
    extend(other.hi);
}

double FileBounds::size() const {
    return empty() ? 0 : std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]});
}

double FileBounds::farthest() const {
    double result = 0;
    for (std::size_t i = 0; i < 3 && !empty(); ++i)
        result = std::max({result, std::fabs(lo[i]), std::fabs(hi[i])});
    return result;
}

double coarsenessAt(double distance) {
    const float near = nearestFloat(std::fabs(distance));
    return double{std::nextafter(near, std::numeric_limits<float>::infinity())} - double{near};
}

LocalOrigin originOf(const FileBounds& bounds, double part) {
    const double size = bounds.size(), farthest = bounds.farthest();
    // Beyond this nothing is a position (isUsablePosition()).
    constexpr double kFarthest = 1e12;
    if (!(size > 0) || farthest > kFarthest || coarsenessAt(farthest) <= part * size) return {};
    const double step = stepFor(size);
    LocalOrigin origin;
    for (std::size_t i = 0; i < 3; ++i)
        origin.at[i] = std::round((bounds.lo[i] + bounds.hi[i]) / 2 / step) * step + 0.0;
    return origin;
}

} // namespace rtcore
