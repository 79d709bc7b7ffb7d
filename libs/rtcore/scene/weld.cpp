#include "rtcore/scene/weld.h"

#include "rtcore/math/box.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace rtcore {

namespace {

/// How far apart what is one point may be, in each coordinate.
double toleranceOf(const Box3& box) {
    constexpr double kOfSize = 1e-6, kOfPlace = 0x1p-22; // two units in the last place
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::fabs(double{box.lo[axis]}), std::fabs(double{box.hi[axis]})});
    return std::max(
        {kOfSize * double{box.diagonal()}, kOfPlace * farthest, double{std::numeric_limits<float>::min()}});
}

/// The first point of each cell of space.
class CellTable {
  public:
    explicit CellTable(std::size_t points)
        : entries_(std::bit_ceil(points + points / 2 + 1)), mask_(entries_.size() - 1) {}

    void clear() { std::fill(entries_.begin(), entries_.end(), Entry{}); }
    /// That of the cell `key`; `point` where there is none yet.
    std::uint32_t firstOf(std::uint64_t key, std::uint32_t point) {
        std::size_t at = key & mask_;
        while (entries_[at].point != kNone && entries_[at].key != key) at = (at + 1) & mask_;
        if (entries_[at].point == kNone) entries_[at] = {key, point};
        return entries_[at].point;
    }

  private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t point = kNone;
    };
    std::vector<Entry> entries_;
    std::size_t mask_;
};

/// Steele, Lea and Flood 2014 (SplitMix64): a bijection.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9U;
    x = (x ^ x >> 27) * 0x94D049BB133111EBU;
    return x ^ x >> 31;
}

/// Joins points of one part that are within its tolerance: cells are twice as wide, and of the eight grids
/// that are moved by half a cell along some axes, one has two such points in the same cell.
void joinWithin(std::span<const Vec3> points, std::span<const std::uint32_t> which,
                std::span<const std::uint32_t> part, std::span<const double> tolerance, DisjointSets& same) {
    CellTable cells(which.size());
    for (int grid = 0; grid < 8; ++grid) {
        cells.clear();
        for (const std::uint32_t i : which) {
            std::uint64_t key = part[i];
            for (int axis = 0; axis < 3; ++axis) {
                const double place = double{points[i][axis]} / (2 * tolerance[part[i]]);
                const double moved = place + ((grid >> axis & 1) != 0 ? 0.5 : 0);
                key = mixed(key + static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(moved))));
            }
            if (const std::uint32_t first = cells.firstOf(key, i); first != i) same.join(i, first);
        }
    }
}

} // namespace

DisjointSets weldPoints(std::span<const Vec3> points, std::span<const std::uint32_t> triangles,
                        std::span<const std::uint32_t> which) {
    Box3 all;
    for (const Vec3 p : points) all.extend(p);
    DisjointSets connected(points.size());
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        connected.join(triangles[i], triangles[i + 1]);
        connected.join(triangles[i], triangles[i + 2]);
    }
    std::vector<std::uint32_t> part(points.size());
    std::vector<double> tolerance{toleranceOf(all)};
    joinWithin(points, which, part, tolerance, connected);

    std::uint32_t parts = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (connected.find(i) == i) part[i] = parts++;
    }
    std::vector<Box3> boxes(parts);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        part[i] = part[connected.find(i)];
        boxes[part[i]].extend(points[i]);
    }
    tolerance.resize(parts);
    std::transform(boxes.begin(), boxes.end(), tolerance.begin(), toleranceOf);
    DisjointSets same(points.size());
    joinWithin(points, which, part, tolerance, same);
    return same;
}

} // namespace rtcore
