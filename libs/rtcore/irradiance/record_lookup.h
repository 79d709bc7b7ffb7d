/// Interpolates between irradiance records at points that lie together: vector code.
#pragma once

#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/irradiance/record_index.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

inline constexpr std::size_t kLookupGroup = 64; ///< receivers at once, at most

struct LookupTask {
    const IrradianceRecord* records;
    const RecordIndex& index;
    std::uint32_t frame;                        ///< as of IrradianceCache::lookUp()
    std::uint32_t* lastUse;                     ///< by record
    std::uint32_t without = RecordIndex::kNone; ///< a record that does not count
};

/// For at most kLookupGroup receivers. A record counts by the kernel
/// (1 - d^2/r^2)^2 (1 - o^2) n confidence / r^2, with its distance d, how far off the plane o, and n for how
/// much their faces agree. Levels of the index are visited from the finest on until the finest density
/// covers the point; densities are blended, fine over coarse.
void lookUpGroup(const LookupTask& task, std::span<const Receiver> receivers,
                 std::span<ArrivingLight> arriving);

} // namespace rtcore
