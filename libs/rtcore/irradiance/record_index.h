/// Finds the records whose radius reaches a point: lists of them in the cells of grids whose sides are powers
/// of two.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Reading is safe from many threads, while none writes.
class RecordIndex {
  public:
    static constexpr int kLevels = 16;
    static constexpr std::size_t kChunk = 16; ///< records of a list that lie together
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    /// A piece of a list, for vector code.
    struct Chunk {
        std::array<float, kChunk> x{}, y{}, z{}, radius{};
        std::array<std::uint32_t, kChunk> record{};
        std::uint32_t next = kNone, count = 0;
    };
    /// Where a point is in the grid of the finest level; in that of level n it is at these shifted by n.
    struct Cell {
        std::int32_t x = 0, y = 0, z = 0;
    };

    /// Forgets all records; those to come lie within the bounds, or not far from them.
    void clear(const Box3& bounds);
    void add(std::uint32_t record, Vec3 position, float radius);
    /// With the position and radius that it was added with.
    void remove(std::uint32_t record, Vec3 position, float radius);

    /// The levels that have records, as bits; the finest is the lowest.
    std::uint32_t levels() const { return levels_; }
    /// The side of the cells of a level: radii of its records are above a quarter of it, up to half.
    float side(int level) const { return finest_ * static_cast<float>(1 << level); }
    /// Larger ones are of no use.
    float maxRadius() const { return side(kLevels - 1) / 2; }
    Cell cellOf(Vec3 point) const;
    /// The first chunk of the list of that cell; kNone: it has none. It has all records of the level that
    /// reach into the cell, and others, in an order that depends on nothing but what is in it: by number, the
    /// highest ones in the first chunk, of 1 to kChunk, and as many as fit in all others.
    std::uint32_t firstOf(int level, Cell cell) const;
    const Chunk& chunk(std::uint32_t number) const { return chunks_[number]; }
    /// Appends the keys of all lists that such a record is in, or would be.
    void appendKeys(Vec3 position, float radius, std::vector<std::uint64_t>& keys) const;

    std::size_t memory() const; ///< bytes

  private:
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t first = kNone;
    };
    static std::uint64_t keyOf(int level, Cell cell);
    int levelOf(float radius) const;
    std::size_t slotOf(std::uint64_t key) const;
    template <typename Use>
    void forEachCell(int level, Vec3 position, float radius, Use&& use) const;
    void grow();
    std::uint32_t newChunk();
    void append(Slot& slot);

    Vec3 origin_;
    float finest_ = 1; ///< side of a cell
    std::uint32_t levels_ = 0;
    std::array<std::uint32_t, kLevels> records_{}; ///< by level
    std::vector<Slot> slots_;                      ///< hashed, a power of two
    std::size_t used_ = 0;
    std::vector<Chunk> chunks_;
    std::uint32_t free_ = kNone; ///< the first of the chunks that are not used
};

} // namespace rtcore
