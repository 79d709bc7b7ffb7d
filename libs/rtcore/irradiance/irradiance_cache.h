/// Irradiance records of a scene, and the light that they tell points of.
#pragma once

#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/irradiance/record_index.h"
#include "rtcore/math/box.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// All that an IrradianceCache remembers.
struct IrradianceState {
    std::vector<IrradianceRecord> records;
    std::vector<float> indexed;         ///< by record: the radius that the index knows, not below its own
    std::vector<std::uint32_t> lastUse; ///< by record
    Colour guess;

    friend bool operator==(const IrradianceState&, const IrradianceState&) = default;
};

/// Looking up is safe from many threads, while none changes the cache. Throws std::bad_alloc. About 400 bytes
/// for each record, by the lists that it is in.
class IrradianceCache {
  public:
    /// Forgets all; records to come lie in these bounds, or near them.
    void clear(const Box3& bounds);
    IrradianceState state() const;
    /// Becomes the cache with these bounds that the state was of, to the bit.
    void restore(const Box3& bounds, const IrradianceState& kept);
    const Box3& bounds() const { return bounds_; }

    std::size_t size() const { return records_.size(); }
    const IrradianceRecord& record(std::uint32_t number) const { return records_[number]; }
    std::uint32_t add(const IrradianceRecord& record); ///< returns its number
    /// For all but its position and radius.
    IrradianceRecord& values(std::uint32_t number) { return records_[number]; }
    /// Only ever smaller.
    void shrink(std::uint32_t number, float radius);
    /// Forgets the last ones, as if they had not been added.
    void removeLast(std::size_t count);
    /// Forgets all but those that `kept`, by record, is not 0 of; they get the numbers from 0 on, in their
    /// order.
    void keep(std::span<const std::uint8_t> kept);
    /// The irradiance where no record knows any.
    void setGuess(Colour irradiance) { guess_ = irradiance; }
    Colour guess() const { return guess_; }

    /// The light of each receiver: it depends on nothing but the receiver and the cache, not on what is asked
    /// beside it, nor on the instruction set. Those that lie together should follow each other. `frame`, not
    /// 0, becomes lastUse() of the records that tell something.
    void lookUp(std::span<const Receiver> receivers, std::span<ArrivingLight> arriving,
                std::uint32_t frame = 0) const;
    /// The light of one as if a record was not there.
    ArrivingLight lookUpWithout(std::uint32_t number, const Receiver& receiver) const;
    void use(std::uint32_t number, std::uint32_t frame) { lastUse_[number] = frame; }
    std::uint32_t lastUse(std::uint32_t number) const { return lastUse_[number]; }

    /// Calls `use` with the number of each record whose radius may reach the point, of the same or
    /// other faces; with some of them more than once.
    template <typename Use>
    void forEachAround(Vec3 point, Use&& use) const {
        const RecordIndex::Cell cell = index_.cellOf(point);
        for (int level = 0; level < RecordIndex::kLevels; ++level) {
            if ((index_.levels() >> level & 1U) == 0) continue;
            for (std::uint32_t at = index_.firstOf(level, cell); at != RecordIndex::kNone;
                 at = index_.chunk(at).next) {
                const RecordIndex::Chunk& chunk = index_.chunk(at);
                for (std::size_t i = 0; i < chunk.count; ++i) use(chunk.record[i]);
            }
        }
    }

    const RecordIndex& index() const { return index_; }
    std::size_t memory() const; ///< bytes

  private:
    void guessUnknown(std::span<const Receiver> receivers, std::span<ArrivingLight> arriving) const;

    std::vector<IrradianceRecord> records_;
    std::vector<float> indexed_; ///< the radius that the index knows
    mutable std::vector<std::uint32_t> lastUse_;
    RecordIndex index_;
    Box3 bounds_;
    Colour guess_;
};

} // namespace rtcore
