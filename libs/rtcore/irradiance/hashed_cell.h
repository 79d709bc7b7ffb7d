/// Numbers of cells of a grid, and hashes of their keys.
#pragma once

#include <cstdint>
#include <span>

namespace rtcore {

/// The cell that a coordinate, in sides of cells, lies in; of any number there is one.
inline std::int32_t cellCoordinate(float at) {
    constexpr float kMax = 0x1p29F;
    if (!(at > -kMax)) return -(1 << 29); // NaN, too
    if (!(at < kMax)) return 1 << 29;
    const auto towardsZero = static_cast<std::int32_t>(at); // floor() is a call on old processors
    return towardsZero - (static_cast<float>(towardsZero) > at ? 1 : 0);
}

/// (Stafford's mix of MurmurHash3's finalizer)
constexpr std::uint64_t hashOfCell(std::uint64_t key) {
    key = (key ^ key >> 30) * 0xBF58476D1CE4E5B9U;
    key = (key ^ key >> 27) * 0x94D049BB133111EBU;
    return key ^ key >> 31;
}

/// Whether a table with two slots or more for each of these hashes, which all differ, finds them quickly: as
/// those of honest keys, but not those that were chosen to collide.
bool areSpread(std::span<const std::uint64_t> hashes);

} // namespace rtcore
