#include "rtcore/gathering/record_passes.h"

#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// Passes after which a record compares itself with the others around.
bool isOneOf(std::uint32_t passes, std::initializer_list<std::uint32_t> some) {
    return std::ranges::find(some, passes) != some.end();
}

/// Off the surface: more than positions are rounded, and less than is seen.
Vec3 originOf(const IrradianceRecord& record, float pixel) {
    const Vec3 p = record.position;
    const float size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return p + record.normal * (4e-6F * size + 0.05F * pixel);
}

} // namespace

std::uint32_t RecordPasses::add(IrradianceCache& cache, const Receiver& receiver, const ArrivingLight& around,
                                int density) {
    IrradianceRecord record;
    record.position = receiver.position;
    record.normal = receiver.face;
    record.distance = around.distance;
    record.radius = RecordRadii::of(density, around.distance, receiver.pixel);
    History history;
    history.pixel = receiver.pixel;
    history.density = static_cast<std::uint8_t>(density);
    history.name = mixBits(names_++ * 747796405U + 2891336453U);
    histories_.push_back(history);
    return cache.add(record);
}

GatherPass RecordPasses::next(const IrradianceCache& cache, std::uint32_t number) const {
    const IrradianceRecord& record = cache.record(number);
    const History& history = histories_[number];
    return {number, originOf(record, history.pixel), record.normal, history.name, history.allPasses};
}

void RecordPasses::enter(IrradianceCache& cache, std::uint32_t number, const PassResult& result) {
    History& history = histories_[number];
    IrradianceRecord& record = cache.values(number);
    ++history.passes;
    ++history.allPasses;
    history.inverseLengths += result.inverseLengths;
    history.walls.meet(result.walls);
    record.walls = history.walls.walls();
    // The first passes know least of what their rays meet, so that they fade.
    const float weight = 2.0F / static_cast<float>(history.passes + 1);
    history.irradiance = history.irradiance * (1 - weight) + result.light.irradiance * weight;
    history.vector = history.vector * (1 - weight) + result.light.vector * weight;
    record.irradiance = history.irradiance;
    const float light = luminance(history.irradiance);
    Vec3 slant = light > 0 ? history.vector / light : Vec3{};
    slant = slant - record.normal * dot(slant, record.normal);
    const float size = length(slant);
    record.slant = size > 1 ? slant / size : slant;
    record.confidence = std::min(1.0F, 0.25F * static_cast<float>(history.passes + 1));
    if (isOneOf(history.allPasses, {1, 2, 4})) learnDistance(cache, number);
    if (history.density == 0 && isOneOf(history.passes, {4, 8, 16, 32}))
        adapt(cache, number, result.deviation);
}

/// Neighbours know of things that this record missed, and the other way round: no distance exceeds that of
/// a neighbour by more than how far that is. (Krivanek, Bouatouch, Pattanaik and Zara 2006)
void RecordPasses::learnDistance(IrradianceCache& cache, std::uint32_t number) {
    constexpr float kMinCosine = 0.7F;
    const History& history = histories_[number];
    IrradianceRecord& record = cache.values(number);
    const auto rays = static_cast<float>(history.allPasses * kPassRays);
    float distance = rays / std::max(history.inverseLengths, 1e-15F);
    around_.clear();
    cache.forEachAround(record.position, [&](std::uint32_t other) {
        const IrradianceRecord& neighbour = cache.record(other);
        if (other == number || histories_[other].allPasses == 0 ||
            dot(neighbour.normal, record.normal) < kMinCosine)
            return;
        around_.push_back(other);
        distance = std::min(distance, neighbour.distance + length(neighbour.position - record.position));
    });
    record.distance = distance;
    setRadius(cache, number);
    for (const std::uint32_t other : around_) {
        IrradianceRecord& neighbour = cache.values(other);
        const float max = distance + length(neighbour.position - record.position);
        if (!(neighbour.distance > max)) continue;
        neighbour.distance = max;
        setRadius(cache, other);
    }
}

/// Shrinks the record where the others around would show something else there.
void RecordPasses::adapt(IrradianceCache& cache, std::uint32_t number, float deviation) {
    constexpr float kTolerance = 0.08F, kNoise = 0.6F, kShrink = 0.6F;
    History& history = histories_[number];
    const IrradianceRecord& record = cache.record(number);
    const ArrivingLight others =
        cache.lookUpWithout(number, {record.position, record.normal, record.normal, history.pixel});
    if (!(others.weight > 0)) return;
    const float here = luminance(record.irradiance), there = luminance(others.irradiance);
    const float noise =
        std::max(kNoise, deviation) / std::sqrt(static_cast<float>(history.passes * kPassRays));
    if (!(std::fabs(here - there) > (kTolerance + noise) * 0.5F * (here + there))) return;
    history.shrink *= kShrink;
    setRadius(cache, number);
}

void RecordPasses::setRadius(IrradianceCache& cache, std::uint32_t number) const {
    const History& history = histories_[number];
    const float radius =
        RecordRadii::of(history.density, cache.record(number).distance, history.pixel) * history.shrink;
    cache.shrink(number, std::max(radius, RecordRadii::kMinPixels * history.pixel));
}

void RecordPasses::keep(std::span<const std::uint8_t> kept) {
    std::size_t next = 0;
    for (std::size_t number = 0; number < histories_.size(); ++number)
        if (kept[number] != 0) histories_[next++] = histories_[number];
    histories_.resize(next);
}

void RecordPasses::fade(IrradianceCache& cache, std::uint32_t number, std::uint32_t passes, Colour ratio) {
    History& history = histories_[number];
    const float before = luminance(history.irradiance);
    history.passes = std::min(history.passes, passes);
    history.irradiance *= ratio;
    if (before > 0) history.vector *= luminance(history.irradiance) / before;
    cache.values(number).irradiance = history.irradiance;
}

void RecordPasses::forgetLight() {
    for (History& history : histories_) history.passes = 0;
}

} // namespace rtcore
