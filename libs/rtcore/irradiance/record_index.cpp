#include "rtcore/irradiance/record_index.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::size_t kFirstSlots = 1024;

/// A record in a list.
struct Entry {
    float x, y, z, radius;
    std::uint32_t record;
};

Entry entryOf(const RecordIndex::Chunk& chunk, std::size_t i) {
    return {chunk.x[i], chunk.y[i], chunk.z[i], chunk.radius[i], chunk.record[i]};
}

void put(const Entry& entry, RecordIndex::Chunk& chunk, std::size_t i) {
    chunk.x[i] = entry.x;
    chunk.y[i] = entry.y;
    chunk.z[i] = entry.z;
    chunk.radius[i] = entry.radius;
    chunk.record[i] = entry.record;
}

using Chunks = std::vector<RecordIndex::Chunk>;

/// Puts it into the list whose last place is free: those of higher numbers move up by one.
void insert(const Entry& added, std::uint32_t first, Chunks& chunks) {
    RecordIndex::Chunk* at = &chunks[first];
    std::size_t i = at->count - 1;
    while (i > 0 || at->next != RecordIndex::kNone) {
        RecordIndex::Chunk& below = i > 0 ? *at : chunks[at->next];
        const std::size_t last = i > 0 ? i - 1 : RecordIndex::kChunk - 1;
        if (below.record[last] < added.record) break;
        put(entryOf(below, last), *at, i);
        at = &below;
        i = last;
    }
    put(added, *at, i);
}

/// Takes it out of the list that it is in: those of higher numbers move down by one.
void takeOut(std::uint32_t record, std::uint32_t first, Chunks& chunks) {
    RecordIndex::Chunk* at = &chunks[first];
    std::size_t i = --at->count;
    Entry moved = entryOf(*at, i);
    while (moved.record != record) {
        if (i == 0) at = &chunks[at->next];
        i = i > 0 ? i - 1 : RecordIndex::kChunk - 1;
        const Entry next = entryOf(*at, i);
        put(moved, *at, i);
        moved = next;
    }
}

} // namespace

void RecordIndex::clear(const Box3& bounds) {
    const float diagonal = length(bounds.size());
    origin_ = diagonal > 0 ? bounds.lo : Vec3{};
    finest_ = diagonal > 0 ? diagonal / 65536 : 1;
    levels_ = 0;
    records_ = {};
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
    ++records_[static_cast<std::size_t>(level)];
    forEachCell(level, position, radius, [&](std::uint64_t key) {
        if (2 * (used_ + 1) > slots_.size()) grow();
        Slot& slot = slots_[slotOf(key)];
        if (slot.key == 0) ++used_;
        slot.key = key;
        append(slot);
        insert({position.x, position.y, position.z, radius, record}, slot.first, chunks_);
    });
}

void RecordIndex::remove(std::uint32_t record, Vec3 position, float radius) {
    const int level = levelOf(radius);
    if (--records_[static_cast<std::size_t>(level)] == 0) levels_ &= ~(1U << level);
    forEachCell(level, position, radius, [&](std::uint64_t key) {
        Slot& slot = slots_[slotOf(key)];
        takeOut(record, slot.first, chunks_);
        Chunk& first = chunks_[slot.first];
        if (first.count > 0) return;
        const std::uint32_t freed = slot.first;
        slot.first = first.next;
        first.next = free_;
        free_ = freed;
    });
}

void RecordIndex::appendKeys(Vec3 position, float radius, std::vector<std::uint64_t>& keys) const {
    forEachCell(levelOf(radius), position, radius, [&](std::uint64_t key) { keys.push_back(key); });
}

/// Makes room for one more record in a list.
void RecordIndex::append(Slot& slot) {
    if (slot.first == kNone || chunks_[slot.first].count == kChunk) {
        const std::uint32_t added = newChunk();
        chunks_[added].next = slot.first;
        slot.first = added;
    }
    ++chunks_[slot.first].count;
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
