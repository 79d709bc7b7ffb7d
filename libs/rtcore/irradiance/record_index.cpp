#include "rtcore/irradiance/record_index.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::size_t kFirstSlots = 1024;

} // namespace

void RecordIndex::clear(const Box3& bounds) {
    const float diagonal = length(bounds.size());
    origin_ = diagonal > 0 ? bounds.lo : Vec3{};
    finest_ = diagonal > 0 ? diagonal / 65536 : 1;
    levels_ = 0;
    slots_.assign(kFirstSlots, {});
    used_ = 0;
    chunks_.clear();
    free_ = kNone;
}

RecordIndex::Cell RecordIndex::cellOf(Vec3 point) const {
    const Vec3 at = (point - origin_) / finest_;
    return {cellCoordinate(at.x), cellCoordinate(at.y), cellCoordinate(at.z)};
}

/// 19 bits for each coordinate: what lies so far apart that they are the same is told apart by distance.
std::uint64_t RecordIndex::keyOf(int level, Cell cell) {
    const auto bits = [&](std::int32_t x) {
        return std::uint64_t{static_cast<std::uint32_t>(x >> level) & 0x7FFFFU};
    };
    return std::uint64_t{1} << 63 | static_cast<std::uint64_t>(level) << 57 | bits(cell.z) << 38 |
           bits(cell.y) << 19 | bits(cell.x);
}

int RecordIndex::levelOf(float radius) const {
    int level = 0;
    while (level < kLevels - 1 && side(level) < 2 * radius) ++level;
    return level;
}

/// That of the key, or the free one that it would get.
std::size_t RecordIndex::slotOf(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hashOfCell(key) & mask;
    while (slots_[i].key != 0 && slots_[i].key != key) i = (i + 1) & mask;
    return i;
}

std::uint32_t RecordIndex::firstOf(int level, Cell cell) const {
    return slots_[slotOf(keyOf(level, cell))].first;
}

/// Calls `use` with the key of each cell that the ball touches.
template <typename Use>
void RecordIndex::forEachCell(int level, Vec3 position, float radius, Use&& use) const {
    const float reach = std::min(radius, maxRadius()) * 1.0001F; // distances are rounded
    const Vec3 around{reach, reach, reach};
    const Cell low = cellOf(position - around), high = cellOf(position + around);
    const auto gap = [&](float centre, std::int32_t cell, float origin) {
        const float begin = origin + static_cast<float>(cell) * side(level), end = begin + side(level);
        return std::max({begin - centre, centre - end, 0.0F});
    };
    for (std::int32_t z = low.z >> level; z <= high.z >> level; ++z) {
        for (std::int32_t y = low.y >> level; y <= high.y >> level; ++y) {
            for (std::int32_t x = low.x >> level; x <= high.x >> level; ++x) {
                const Vec3 apart{gap(position.x, x, origin_.x), gap(position.y, y, origin_.y),
                                 gap(position.z, z, origin_.z)};
                if (dot(apart, apart) <= reach * reach)
                    use(keyOf(0, {x, y, z}) | static_cast<std::uint64_t>(level) << 57);
            }
        }
    }
}

void RecordIndex::add(std::uint32_t record, Vec3 position, float radius) {
    const int level = levelOf(radius);
    levels_ |= 1U << level;
    forEachCell(level, position, radius, [&](std::uint64_t key) {
        if (2 * (used_ + 1) > slots_.size()) grow();
        Slot& slot = slots_[slotOf(key)];
        if (slot.key == 0) ++used_;
        slot.key = key;
        if (slot.first == kNone || chunks_[slot.first].count == kChunk) {
            const std::uint32_t added = newChunk();
            chunks_[added].next = slot.first;
            slot.first = added;
        }
        Chunk& chunk = chunks_[slot.first];
        chunk.x[chunk.count] = position.x;
        chunk.y[chunk.count] = position.y;
        chunk.z[chunk.count] = position.z;
        chunk.radius[chunk.count] = radius;
        chunk.record[chunk.count++] = record;
    });
}

/// The last of the first chunk takes its position.
void RecordIndex::remove(std::uint32_t record, Vec3 position, float radius) {
    forEachCell(levelOf(radius), position, radius, [&](std::uint64_t key) {
        Slot& slot = slots_[slotOf(key)];
        for (std::uint32_t number = slot.first; number != kNone; number = chunks_[number].next) {
            Chunk& chunk = chunks_[number];
            const auto end = chunk.record.begin() + chunk.count;
            const auto found = std::find(chunk.record.begin(), end, record);
            if (found == end) continue;
            const auto at = static_cast<std::size_t>(found - chunk.record.begin());
            Chunk& first = chunks_[slot.first];
            const std::size_t last = --first.count;
            chunk.x[at] = first.x[last];
            chunk.y[at] = first.y[last];
            chunk.z[at] = first.z[last];
            chunk.radius[at] = first.radius[last];
            chunk.record[at] = first.record[last];
            if (first.count > 0) return;
            const std::uint32_t freed = slot.first;
            slot.first = first.next;
            first.next = free_;
            free_ = freed;
            return;
        }
    });
}

std::uint32_t RecordIndex::newChunk() {
    if (free_ == kNone) {
        chunks_.emplace_back();
        return static_cast<std::uint32_t>(chunks_.size() - 1);
    }
    const std::uint32_t taken = free_;
    free_ = chunks_[taken].next;
    chunks_[taken].next = kNone;
    return taken;
}

void RecordIndex::grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
        if (slot.key != 0) slots_[slotOf(slot.key)] = slot;
}

std::size_t RecordIndex::memory() const {
    return slots_.capacity() * sizeof(Slot) + chunks_.capacity() * sizeof(Chunk);
}

} // namespace rtcore
