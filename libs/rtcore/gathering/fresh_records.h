/// The records that a step has made so far, and whether they changed what others say at a point.
#pragma once

#include "rtcore/irradiance/irradiance_cache.h"
#include "rtcore/irradiance/record_index.h"
#include "rtcore/math/box.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Numbers of versions are sizes of the cache, so that a look-up is known to be as good as new while none of
/// the records that were added since reaches the point.
class FreshRecords {
  public:
    void begin(const IrradianceCache& cache, const Box3& bounds) {
        index_.clear(bounds);
        levels_ = cache.index().levels();
        newestLevels_ = static_cast<std::uint32_t>(cache.size());
    }
    /// The last record of the cache.
    void add(const IrradianceCache& cache) {
        const auto number = static_cast<std::uint32_t>(cache.size() - 1);
        const IrradianceRecord& record = cache.record(number);
        index_.add(number, record.position, record.radius);
        // Look-ups may end at another level once there are more.
        if (cache.index().levels() != levels_) newestLevels_ = number + 1;
        levels_ = cache.index().levels();
    }
    /// Whether a look-up at the point, when the cache was of that size, may tell something else now.
    bool change(Vec3 point, std::uint32_t size) const {
        if (size < newestLevels_) return true;
        const RecordIndex::Cell cell = index_.cellOf(point);
        for (std::uint32_t levels = index_.levels(); levels != 0; levels &= levels - 1) {
            std::uint32_t at = index_.firstOf(std::countr_zero(levels), cell);
            for (; at != RecordIndex::kNone; at = index_.chunk(at).next)
                if (reaches(index_.chunk(at), point, size)) return true;
        }
        return false;
    }

  private:
    static bool reaches(const RecordIndex::Chunk& chunk, Vec3 point, std::uint32_t size) {
        for (std::size_t i = 0; i < chunk.count; ++i) {
            const Vec3 apart = point - Vec3{chunk.x[i], chunk.y[i], chunk.z[i]};
            if (chunk.record[i] >= size && dot(apart, apart) < chunk.radius[i] * chunk.radius[i]) return true;
        }
        return false;
    }

    RecordIndex index_;
    std::uint32_t levels_ = 0;
    std::uint32_t newestLevels_ = 0; ///< the size since which no level was added
};

} // namespace rtcore
