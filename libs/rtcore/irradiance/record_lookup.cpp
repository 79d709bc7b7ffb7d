#include "rtcore/irradiance/record_lookup.h"

#include <algorithm>
#include <array>
#include <atomic>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/irradiance/record_lookup.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_IRRADIANCE_RECORD_LOOKUP_TYPES
#define RTCORE_IRRADIANCE_RECORD_LOOKUP_TYPES
namespace rtcore {

inline constexpr int kBuckets =
    kDensities + 1; ///< of records: by the finest density that they suit, and none

/// A number for each receiver of a group, with room for a whole vector behind them.
using OfGroup = std::array<float, 2 * kLookupGroup>;

struct GroupVectors {
    OfGroup x, y, z;
};

/// Sums over records.
struct RecordSums {
    OfGroup kernel;     ///< of all, whatever they know
    OfGroup known;      ///< times confidence
    OfGroup weight;     ///< times confidence over the square of the radius
    GroupVectors light; ///< that times irradiance
};

/// The receivers of a group, what is summed up for them, and for which of them levels are still visited.
struct LookupGroup {
    std::size_t count = 0;
    Vec3 centre;
    float reach = 0; ///< of all receivers from the centre
    GroupVectors position, face, normal;
    OfGroup pixel;
    std::array<std::uint32_t, 2 * kLookupGroup> list; ///< of the level: its first chunk
    std::array<RecordIndex::Cell, kLookupGroup> cells;
    std::array<bool, kLookupGroup> open;
    std::array<RecordSums, kBuckets> sums;
    OfGroup distance; ///< kernel times distance
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

inline constexpr float kMinCosine = 0.6F;     ///< of faces that agree
inline constexpr float kMaxOff = 0.25F;       ///< of the radius: from the plane
inline constexpr float kTolerance = 1.42F;    ///< radii so much larger than wanted are fine enough
inline constexpr float kCovered = 1;          ///< kernel sum of a density that is dense enough
inline constexpr float kMinOfSide = 0.7F / 4; ///< radii of a level over its side, when some have shrunk
inline constexpr float kSureness = 1.5F;      ///< of kCovered: visits end there

HWY_INLINE void addTo(OfGroup& sum, std::size_t i, Float value) { store(load(&sum[i]) + value, &sum[i]); }

/// Adds what a record tells to the receivers from `i` on for which `list` is the list of their cell.
HWY_INLINE Mask addRecord(const IrradianceRecord& record, std::uint32_t list, LookupGroup& group,
                          std::size_t i) {
    const Float3 apart =
        load(&group.position.x[i], &group.position.y[i], &group.position.z[i]) - broadcast(record.position);
    const Float square = dot(apart, apart), radiusSquare = record.radius * record.radius;
    const Mask near = (load(&group.list[i]) == Uint(list)) & (square < radiusSquare);
    if (none(near)) return near;
    const Float3 face = load(&group.face.x[i], &group.face.y[i], &group.face.z[i]),
                 own = broadcast(record.normal);
    const Float agreement = dot(face, own);
    const Float off = abs(0.5F * dot(apart, face + own)), maxOff = kMaxOff * record.radius;
    const Float3 position = apart + broadcast(record.position);
    Mask used = near & (agreement > kMinCosine) & (off < maxOff);
    for (const RecordWall& wall : record.walls)
        used = used & (dot(position, broadcast(wall.normal)) >= wall.offset);
    if (none(used)) return used;
    const Float nearness = 1.0F - square / radiusSquare, offness = off / maxOff;
    const Float kernel = selectOrZero(used, nearness * nearness * (1.0F - offness * offness) *
                                                ((agreement - kMinCosine) / (1 - kMinCosine)));
    const Float known = kernel * record.confidence;
    const Float weight = known / radiusSquare;
    const Float3 normal = load(&group.normal.x[i], &group.normal.y[i], &group.normal.z[i]);
    const Float leaning =
        max(dot(own + broadcast(record.slant), normal) + 0.5F * (1.0F - dot(own, normal)), 0.0F);
    const Float3 light = broadcast(record.irradiance) * (weight * leaning);
    addTo(group.distance, i, selectOrZero(used, kernel * record.distance));
    const Float pixel = load(&group.pixel[i]);
    const Float wanted = clamp(Float(RecordRadii::kOfDistance * record.distance),
                               RecordRadii::kMinPixels * pixel, RecordRadii::kMaxPixels * pixel);
    Mask left = used;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        Mask suits = left;
        if (bucket < kDensities) {
            const Float radius =
                min(wanted * RecordRadii::kScale[bucket], pixel * RecordRadii::kMaxPixelsOf[bucket]);
            suits = left & (Float(record.radius) <= radius * kTolerance);
        }
        left = without(left, suits);
        if (none(suits)) continue;
        RecordSums& sums = group.sums[static_cast<std::size_t>(bucket)];
        addTo(sums.kernel, i, selectOrZero(suits, kernel));
        addTo(sums.known, i, selectOrZero(suits, known));
        addTo(sums.weight, i, selectOrZero(suits, weight));
        addTo(sums.light.x, i, selectOrZero(suits, light.x));
        addTo(sums.light.y, i, selectOrZero(suits, light.y));
        addTo(sums.light.z, i, selectOrZero(suits, light.z));
    }
    return used;
}

/// The records of a chunk that reach the group, with room for a whole vector behind them.
using ChunkRecords = std::array<std::uint32_t, RecordIndex::kChunk + kLanes>;

/// Finds them, and returns how many there are.
HWY_INLINE std::size_t findReaching(const RecordIndex::Chunk& chunk, const LookupGroup& group,
                                    ChunkRecords& found) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < chunk.count; i += lanes()) {
        const Float3 apart = load(&chunk.x[i], &chunk.y[i], &chunk.z[i]) - broadcast(group.centre);
        const Float reach = load(&chunk.radius[i]) + group.reach;
        const Compressor reaching((dot(apart, apart) <= reach * reach) & (iota(i) < Uint(chunk.count)));
        reaching.store(load(&chunk.record[i]), &found[count]);
        count += reaching.count();
    }
    return count;
}

/// Adds the records of a list to those receivers whose list it is.
void addList(const LookupTask& task, std::uint32_t list, LookupGroup& group) {
    ChunkRecords found;
    for (std::uint32_t at = list; at != RecordIndex::kNone; at = task.index.chunk(at).next) {
        const RecordIndex::Chunk& chunk = task.index.chunk(at);
        const std::size_t count = findReaching(chunk, group, found);
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t number = found[k];
            if (number == task.without) continue;
            const IrradianceRecord& record = task.records[number];
            bool used = false;
            for (std::size_t i = 0; i < group.count; i += lanes())
                used |= any(addRecord(record, list, group, i));
            if (!used || task.frame == 0) continue;
            const std::atomic_ref lastUse(task.lastUse[number]);
            if (lastUse.load(std::memory_order_relaxed) != task.frame)
                lastUse.store(task.frame, std::memory_order_relaxed);
        }
    }
}

/// Whether coarser levels are not visited for a receiver: the finest density covers it, or a coarser one does
/// and they have no records of finer ones.
bool closes(const LookupGroup& group, std::size_t i, float side) {
    float known = 0;
    for (std::size_t density = 0; density < kDensities; ++density) {
        known += group.sums[density].known[i];
        if (known < kSureness * kCovered) continue;
        const float larger = density == 0 ? 0 : kTolerance * RecordRadii::kMaxPixelsOf[density - 1];
        return kMinOfSide * side >= larger * group.pixel[i];
    }
    return false;
}

HWY_INLINE bool areOneCell(int level, RecordIndex::Cell a, RecordIndex::Cell b) {
    return (((a.x ^ b.x) | (a.y ^ b.y) | (a.z ^ b.z)) >> level) == 0;
}

void visitLevel(const LookupTask& task, int level, LookupGroup& group) {
    std::array<std::uint32_t, kLookupGroup> lists;
    std::size_t count = 0, last = group.count; // the receiver that was asked for last
    for (std::size_t i = 0; i < group.count; ++i) {
        group.list[i] = RecordIndex::kNone;
        if (!group.open[i]) continue;
        group.list[i] = last < i && areOneCell(level, group.cells[last], group.cells[i])
                            ? group.list[last]
                            : task.index.firstOf(level, group.cells[i]);
        last = i;
        const std::uint32_t list = group.list[i];
        if (list == RecordIndex::kNone || (count > 0 && lists[count - 1] == list)) continue;
        if (std::find(lists.begin(), lists.begin() + count, list) == lists.begin() + count)
            lists[count++] = list;
    }
    for (std::size_t i = 0; i < count; ++i) addList(task, lists[i], group);
}

/// The coarsest density that is too sparse there.
HWY_INLINE std::int8_t lackingOf(const LookupGroup& group, std::size_t i) {
    float kernel = 0;
    std::int8_t lacking = -1;
    for (std::size_t density = 0; density < kDensities; ++density) {
        kernel += group.sums[density].kernel[i];
        if (kernel < kCovered) lacking = static_cast<std::int8_t>(density);
    }
    return lacking;
}

/// Fine densities over coarse ones, each as far as it covers the point; the rest is the mean of all.
HWY_INLINE void blend(const LookupGroup& group, std::size_t i, ArrivingLight& to) {
    to.lacking = lackingOf(group, i);
    float kernel = 0, known = 0, weight = 0, rest = 1;
    Colour light, blended;
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
        const RecordSums& sums = group.sums[bucket];
        kernel += sums.kernel[i];
        known += sums.known[i];
        weight += sums.weight[i];
        light += Colour{sums.light.x[i], sums.light.y[i], sums.light.z[i]};
        if (!(weight > 0)) continue;
        const float part = bucket < kDensities ? std::min(1.0F, kSureness * known / kCovered) : 1;
        blended += light * (rest * part / weight);
        rest *= 1 - part;
    }
    to.irradiance = blended;
    to.weight = weight;
    to.distance = kernel > 0 ? group.distance[i] / kernel : std::numeric_limits<float>::infinity();
}

void fillGroup(const LookupTask& task, std::span<const Receiver> receivers, LookupGroup& group) {
    group.count = receivers.size();
    const std::size_t whole = (group.count + lanes() - 1) / lanes() * lanes();
    Vec3 low = receivers[0].position, high = low;
    for (std::size_t i = 0; i < whole; ++i) {
        const Receiver& receiver = receivers[std::min(i, group.count - 1)];
        const auto put = [&](GroupVectors& to, Vec3 v) {
            to.x[i] = v.x;
            to.y[i] = v.y;
            to.z[i] = v.z;
        };
        put(group.position, receiver.position);
        put(group.face, receiver.face);
        put(group.normal, receiver.normal);
        group.pixel[i] = receiver.pixel;
        group.list[i] = RecordIndex::kNone;
        group.distance[i] = 0;
        for (RecordSums& sums : group.sums) {
            for (OfGroup* const sum :
                 {&sums.kernel, &sums.known, &sums.weight, &sums.light.x, &sums.light.y, &sums.light.z})
                (*sum)[i] = 0;
        }
        if (i >= group.count) continue;
        group.open[i] = receiver.pixel > 0;
        group.cells[i] = task.index.cellOf(receiver.position);
        low = {std::min(low.x, receiver.position.x), std::min(low.y, receiver.position.y),
               std::min(low.z, receiver.position.z)};
        high = {std::max(high.x, receiver.position.x), std::max(high.y, receiver.position.y),
                std::max(high.z, receiver.position.z)};
    }
    group.centre = (low + high) * 0.5F;
    constexpr float kRounding = 1e-5F;
    group.reach =
        length(high - low) * (0.5F + kRounding) +
        kRounding * (std::fabs(group.centre.x) + std::fabs(group.centre.y) + std::fabs(group.centre.z));
}

void lookUp(const LookupTask& task, std::span<const Receiver> receivers, std::span<ArrivingLight> arriving) {
    LookupGroup group;
    fillGroup(task, receivers, group);
    for (std::uint32_t levels = task.index.levels(); levels != 0; levels &= levels - 1) {
        const int level = std::countr_zero(levels);
        visitLevel(task, level, group);
        bool open = false;
        for (std::size_t i = 0; i < group.count; ++i) {
            if (group.open[i] && closes(group, i, task.index.side(level))) group.open[i] = false;
            open |= group.open[i];
        }
        if (!open) break;
    }
    for (std::size_t i = 0; i < group.count; ++i) {
        arriving[i] = {};
        if (receivers[i].pixel > 0) blend(group, i, arriving[i]);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(lookUp);

void lookUpGroup(const LookupTask& task, std::span<const Receiver> receivers,
                 std::span<ArrivingLight> arriving) {
    HWY_DYNAMIC_DISPATCH(lookUp)(task, receivers, arriving);
}

} // namespace rtcore
#endif
