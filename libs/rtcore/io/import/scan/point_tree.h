/// A tree over points that finds the nearest ones.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rtcore {

inline constexpr std::size_t kNeighbours = 8;

/// Those of a point, the nearest first, without itself.
struct Neighbours {
    std::array<std::uint32_t, kNeighbours> points{};
    std::array<float, kNeighbours> squares{}; ///< of distances
    std::size_t count = 0;
};

/// A balanced k-d tree: each half of a list of points lies on one side of their median. 16 bytes for each
/// point. Built and asked by the threads of OpenMP; nothing depends on them.
class PointTree {
  public:
    /// `positions` are finite, and no two are equal; at most 2^32 - 2 of them. They must outlive the object.
    explicit PointTree(std::span<const Vec3> positions);

    /// Calls `use` for every point, by the threads of OpenMP in any order, with its nearest ones; of equal
    /// distances the lower number counts. `alive` is called by one of them now and then.
    using UseNeighbours = std::function<void(std::uint32_t point, const Neighbours& nearest)>;
    void forEach(const UseNeighbours& use, const std::function<void()>& alive) const;

  private:
    struct Entry {
        Vec3 position;
        std::uint32_t point;
    };
    void split(std::size_t begin, std::size_t end);
    Neighbours nearestOf(const Entry& entry) const;
    void search(std::size_t begin, std::size_t end, const Entry& entry, Neighbours& nearest) const;

    std::vector<Entry> entries_;
    std::vector<std::uint8_t> axes_; ///< by the number of the entry in the middle
};

} // namespace rtcore
