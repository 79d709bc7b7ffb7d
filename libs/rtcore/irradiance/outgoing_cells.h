/// The radiance that the surfaces of a scene send out, as a mean for each cell of a grid and side that they
/// face.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// Grids of nine levels, each of cells twice as large as the one before: rays read cells as large as they are
/// long. Reading is safe from many threads, while none adds. 32 bytes for each cell that has samples, two to
/// four times.
class OutgoingCells {
  public:
    static constexpr int kLevels = 9;
    static constexpr int kNowhere = -1; ///< level of a ray that meets nothing
    /// Where light leaves: the level that a ray of this length reads, the point and the normal of the face,
    /// of unit length, on the side of the ray.
    struct Site {
        int level = kNowhere;
        Vec3 point;
        Vec3 normal;
        float length = 0;
        std::uint32_t surface = 0; ///< its number: light of one is not taken for that of another
    };

    /// A cell that has samples.
    struct Cell {
        std::uint64_t key = 0;
        Colour sum;
        float squares = 0;       ///< sum of those of luminances
        std::uint32_t count = 0; ///< of samples
        std::uint32_t frame = 0; ///< of the last sample

        friend bool operator==(const Cell&, const Cell&) = default;
    };
    static_assert(sizeof(Cell) == 32);

    /// Forgets all cells; those to come lie within the bounds, or not far from them.
    void clear(const Box3& bounds);
    /// All cells, ascending by key.
    std::vector<Cell> state() const;
    /// Becomes what had these cells and bounds, to the bit.
    void restore(const Box3& bounds, std::span<const Cell> cells);
    /// Whether these may be keys of cells: ascending, and spread so evenly that they are quickly found.
    static bool areKeys(std::span<const Cell> cells);
    /// The level whose cells are about an eighth of the length, but not finer than the finest.
    int levelOf(float length) const;
    /// The level whose cells are about that large.
    int levelOfSide(float side) const;
    /// Adds a sample of the radiance to the cells of its level, of two finer and of all coarser ones.
    /// `frame`: does not descend.
    void add(const Site& site, Colour radiance, std::uint32_t frame = 0);
    /// Begins to fetch the cells that add() will change from memory.
    void prefetch(const Site& site) const;
    /// Where there are more than so many cells, forgets about half of them: those that no sample was added to
    /// for longest.
    void bound(std::size_t max);
    /// How many samples the cell of the site's level has.
    std::uint32_t samples(const Site& site) const;
    /// The mean of the cell of the site's level; of a finer one where that knows enough, or of a coarser one
    /// where it does not. Nothing where none knows anything.
    std::optional<Colour> radiance(const Site& site) const;
    /// The mean of the cell of the site's level, with that of cells up to eight times as large for samples
    /// that it lacks: so it has little noise where it is read alone. Nothing where none knows anything.
    std::optional<Colour> smoothRadiance(const Site& site) const;
    /// The same of several sites, which is quicker. Nowhere there is nothing.
    void samples(std::span<const Site> sites, std::span<std::uint32_t> found) const;
    void radiance(std::span<const Site> sites, std::span<std::optional<Colour>> found) const;

    /// The smallest cell, from that of the site's level on, that has so many samples; where none has, that
    /// which has most of them, or null.
    const Cell* cellOf(const Site& site, std::uint32_t minSamples) const;
    /// Takes over what `old`, of the same bounds, knows of the cells that add() would change at these sites:
    /// as that of `kept`, by site, samples at most, and nothing where that is 0 for one of a cell. `old` is
    /// not to be used any more.
    void takeOver(OutgoingCells& old, std::span<const Site> sites, std::span<const std::uint32_t> kept);

    bool empty() const { return used_ == 0; }
    std::size_t size() const { return used_; } ///< cells
    std::size_t memory() const { return slots_.capacity() * sizeof(Slot); }

  private:
    using Slot = Cell; ///< with the key 0: free
    /// What the keys of a site's cells are made of.
    struct Place {
        std::int32_t x = 0, y = 0, z = 0; ///< of the finest cell; of level n it is at these shifted by n
        std::uint64_t kind = 0;           ///< added to the key: side and surface
        std::uint64_t keyOf(int level) const;
    };
    static bool samplesDiffer(const Slot& slot);
    static Colour meanOf(const Slot& slot) { return slot.sum / static_cast<float>(slot.count); }
    Place placeOf(const Site& site) const;
    const Slot* find(std::uint64_t key) const;
    void prefetch(std::uint64_t key) const;
    std::optional<Colour> radianceAt(const Place& place, const Site& site) const;
    std::optional<Colour> coarserAt(const Place& place, const Site& site, const Slot* own) const;
    template <typename Use>
    void forEachCell(const Site& site, Use&& use);
    void clearCells();
    Slot& slotFor(std::uint64_t key);
    void rehash(std::size_t slots, std::uint32_t fromFrame);

    Vec3 origin_;
    float finest_ = 1;        ///< side of a cell
    std::vector<Slot> slots_; ///< hashed, a power of two
    std::size_t used_ = 0;
};

} // namespace rtcore
