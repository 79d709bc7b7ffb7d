#include "rtcore/irradiance/irradiance_cache.h"

#include "rtcore/irradiance/record_lookup.h"

#include <algorithm>

namespace rtcore {

namespace {

/// A record whose radius gets smaller by less is left where it is in the index. (closes() knows.)
constexpr float kLittleSmaller = 0.7F;

/// So many receivers that lie together, or fewer.
std::size_t sizeOfGroup(std::span<const Receiver> receivers) {
    constexpr float kMaxPixels = 32; // from the first: more lists would be visited for all of them
    const Receiver& first = receivers.front();
    const float reach = kMaxPixels * first.pixel;
    std::size_t size = 1;
    while (size < std::min(kLookupGroup, receivers.size())) {
        const Vec3 apart = receivers[size].position - first.position;
        if (!(dot(apart, apart) < reach * reach)) break;
        ++size;
    }
    return size;
}

} // namespace

void IrradianceCache::clear(const Box3& bounds) {
    records_.clear();
    indexed_.clear();
    lastUse_.clear();
    bounds_ = bounds;
    index_.clear(bounds);
    guess_ = {};
}

IrradianceState IrradianceCache::state() const { return {records_, indexed_, lastUse_, guess_}; }

void IrradianceCache::restore(const Box3& bounds, const IrradianceState& kept) {
    clear(bounds);
    records_ = kept.records;
    indexed_ = kept.indexed;
    lastUse_ = kept.lastUse;
    guess_ = kept.guess;
    for (std::size_t number = 0; number < records_.size(); ++number)
        index_.add(static_cast<std::uint32_t>(number), records_[number].position, indexed_[number]);
}

/// Backwards: the last ones of lists are quickly taken out.
void IrradianceCache::removeLast(std::size_t count) {
    for (; count > 0; --count) {
        const auto number = static_cast<std::uint32_t>(records_.size() - 1);
        index_.remove(number, records_[number].position, indexed_[number]);
        records_.pop_back();
        indexed_.pop_back();
        lastUse_.pop_back();
    }
}

void IrradianceCache::keep(std::span<const std::uint8_t> kept) {
    index_.clear(bounds_);
    std::uint32_t next = 0;
    for (std::size_t number = 0; number < records_.size(); ++number) {
        if (kept[number] == 0) continue;
        records_[next] = records_[number];
        lastUse_[next] = lastUse_[number];
        indexed_[next] = records_[next].radius;
        index_.add(next, records_[next].position, indexed_[next]);
        ++next;
    }
    records_.resize(next);
    lastUse_.resize(next);
    indexed_.resize(next);
}

std::uint32_t IrradianceCache::add(const IrradianceRecord& record) {
    const auto number = static_cast<std::uint32_t>(records_.size());
    records_.push_back(record);
    records_.back().radius = std::min(record.radius, index_.maxRadius());
    indexed_.push_back(records_.back().radius);
    lastUse_.push_back(0);
    index_.add(number, record.position, indexed_.back());
    return number;
}

void IrradianceCache::shrink(std::uint32_t number, float radius) {
    IrradianceRecord& record = records_[number];
    if (!(radius < record.radius)) return;
    record.radius = radius;
    if (radius >= kLittleSmaller * indexed_[number]) return;
    index_.remove(number, record.position, indexed_[number]);
    indexed_[number] = radius;
    index_.add(number, record.position, radius);
}

void IrradianceCache::lookUp(std::span<const Receiver> receivers, std::span<ArrivingLight> arriving,
                             std::uint32_t frame) const {
    const LookupTask task{records_.data(), index_, frame, lastUse_.data()};
    for (std::size_t first = 0; first < receivers.size();) {
        const std::size_t size = sizeOfGroup(receivers.subspan(first));
        lookUpGroup(task, receivers.subspan(first, size), arriving.subspan(first, size));
        first += size;
    }
    guessUnknown(receivers, arriving);
}

ArrivingLight IrradianceCache::lookUpWithout(std::uint32_t number, const Receiver& receiver) const {
    ArrivingLight arriving;
    const LookupTask task{records_.data(), index_, 0, lastUse_.data(), number};
    lookUpGroup(task, {&receiver, 1}, {&arriving, 1});
    return arriving;
}

/// Where no record that knows something tells of the point: the nearest of those around, else the guess.
void IrradianceCache::guessUnknown(std::span<const Receiver> receivers,
                                   std::span<ArrivingLight> arriving) const {
    constexpr float kMinCosine = 0.3F;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Receiver& receiver = receivers[i];
        if (arriving[i].weight > 0 || !(receiver.pixel > 0)) continue;
        float nearest = std::numeric_limits<float>::max();
        arriving[i].irradiance = guess_;
        forEachAround(receiver.position, [&](std::uint32_t number) {
            const IrradianceRecord& record = records_[number];
            const Vec3 apart = record.position - receiver.position;
            const float square = dot(apart, apart);
            if (!(record.confidence > 0) || !(square < nearest) ||
                !(dot(record.normal, receiver.face) > kMinCosine))
                return;
            nearest = square;
            arriving[i].irradiance = record.irradiance;
        });
    }
}

std::size_t IrradianceCache::memory() const {
    return records_.capacity() * sizeof(IrradianceRecord) + indexed_.capacity() * sizeof(float) +
           lastUse_.capacity() * sizeof(std::uint32_t) + index_.memory();
}

} // namespace rtcore
