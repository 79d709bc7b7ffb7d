#include "rtcore/gathering/indirect_state.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kMaxNumber = 1e18F; ///< so that squares are finite
/// Of lengths whose squares irradiance is divided by, and of irradiance: so that what they give is finite.
constexpr float kMinLength = 1e-12F, kMaxIrradiance = 1e12F;
constexpr float kMinShrink = 0.05F;
/// The vector of a history over its irradiance is far below this, of which the first is divided by the
/// second.
constexpr float kMaxLean = 1e6F, kDark = 1e-20F;
constexpr float kRounding = 1.001F; ///< of lengths up to 1

bool isNumber(float x) { return std::fabs(x) <= kMaxNumber; }
bool isNumber(Vec3 v) { return isNumber(v.x) && isNumber(v.y) && isNumber(v.z); }
bool isNumber(Colour c) { return isNumber(c.r) && isNumber(c.g) && isNumber(c.b); }
bool isIrradiance(Colour c) {
    return std::fabs(c.r) <= kMaxIrradiance && std::fabs(c.g) <= kMaxIrradiance &&
           std::fabs(c.b) <= kMaxIrradiance;
}
/// Of lengths.
bool isAmount(float x) { return x >= 0 && x <= kMaxNumber; }
bool isUnit(Vec3 v) { return isNumber(v) && std::fabs(dot(v, v) - 1) <= 1e-3F; }

/// A plane that a record met, or none.
bool isWall(const RecordWall& wall, float distance) {
    if (wall == RecordWall{}) return distance == NearestWalls::kNone;
    return isNumber(wall.normal) && length(wall.normal) <= kRounding && isNumber(wall.offset) &&
           isAmount(distance);
}

/// That of a record that knows something is a weight that others are divided by.
bool isConfidence(float x) { return x == 0 || (x >= 0.25F && x <= 1); }

bool isRecord(const IrradianceRecord& record, float indexed) {
    return isNumber(record.position) && isUnit(record.normal) && record.radius >= kMinLength &&
           record.radius <= indexed && isAmount(indexed) && isConfidence(record.confidence) &&
           isIrradiance(record.irradiance) && isNumber(record.slant) && length(record.slant) <= kRounding &&
           record.distance >= 0;
}

bool isLean(Vec3 vector, Colour irradiance) {
    return isNumber(vector) && length(vector) <= kMaxLean * std::max(luminance(irradiance), kDark);
}

bool isHistory(const RecordHistory& history, const IrradianceRecord& record, std::uint32_t steps) {
    const std::array<RecordWall, 2>& walls = history.walls.walls();
    const std::array<float, 2>& distances = history.walls.distances();
    // Before the first pass nothing is in the way.
    const bool seen = history.allPasses > 0 ? isAmount(record.distance) : record.confidence == 0;
    return seen && history.irradiance == record.irradiance && isLean(history.vector, history.irradiance) &&
           walls == record.walls && isWall(walls[0], distances[0]) && isWall(walls[1], distances[1]) &&
           isAmount(history.pixel) && history.pixel >= kMinLength && history.shrink >= kMinShrink &&
           history.shrink <= 1 && isAmount(history.inverseLengths) && history.density < kDensities &&
           history.passes <= history.allPasses && history.allPasses <= steps;
}

bool isCell(const OutgoingCells::Cell& cell, std::uint32_t steps) {
    return isNumber(cell.sum) && isAmount(cell.squares / kMaxNumber) && cell.count > 0 && cell.frame <= steps;
}

/// Whether lists of records are as short, and as quickly found, as they are where records lack before they
/// are made.
bool areApart(const IndirectState& kept) {
    constexpr std::size_t kMaxList = 4096;
    RecordIndex index;
    index.clear(kept.bounds);
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 0; i < kept.irradiance.records.size(); ++i)
        index.appendKeys(kept.irradiance.records[i].position, kept.irradiance.indexed[i], keys);
    std::ranges::sort(keys);
    for (std::size_t i = kMaxList; i < keys.size(); ++i)
        if (keys[i] == keys[i - kMaxList]) return false;
    const auto others = std::ranges::unique(keys);
    keys.erase(others.begin(), others.end());
    for (std::uint64_t& key : keys) key = hashOfCell(key);
    return areSpread(keys);
}

} // namespace

std::optional<Sentence> checkIndirectState(const IndirectState& kept) {
    constexpr std::uint32_t kMaxSteps = 1U << 31;
    const IrradianceState& irradiance = kept.irradiance;
    const std::vector<RecordHistory>& histories = kept.passes.histories;
    const std::size_t count = irradiance.records.size();
    if (count > IndirectState::kMaxRecords || kept.cells.size() > IndirectState::kMaxCells)
        return form("there are too many records or cells");
    if (irradiance.indexed.size() != count || irradiance.lastUse.size() != count ||
        histories.size() != count || kept.passes.names < count)
        return form("its numbers of records differ");
    if (kept.frame > kMaxSteps || !isIrradiance(irradiance.guess))
        return form("its guess or its steps make no sense");
    for (std::size_t i = 0; i < count; ++i) {
        // A step that was stopped may have used it, too.
        if (!isRecord(irradiance.records[i], irradiance.indexed[i]) ||
            !isHistory(histories[i], irradiance.records[i], kept.frame) ||
            irradiance.lastUse[i] > kept.frame + 1)
            return say("record {0} makes no sense", i);
    }
    for (std::size_t i = 0; i < kept.cells.size(); ++i)
        if (!isCell(kept.cells[i], kept.frame)) return say("cell {0} makes no sense", i);
    if (!OutgoingCells::areKeys(kept.cells)) return form("its cells are not in order");
    if (!areApart(kept)) return form("too many of its records are in one place");
    return std::nullopt;
}

} // namespace rtcore
