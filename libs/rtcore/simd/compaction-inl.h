// Compaction: selected lanes of vectors side by side. Included once for each target.
#if defined(RTCORE_SIMD_COMPACTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SIMD_COMPACTION_INL_H_
#undef RTCORE_SIMD_COMPACTION_INL_H_
#else
#define RTCORE_SIMD_COMPACTION_INL_H_
#endif

#include "rtcore/simd/compress_table.h"
#include "rtcore/simd/targets.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4

/// Where there is no instruction for it, hn::Compress looks up a table that GCC 12 copies to the stack at
/// each use, which takes most of the time of a stream: so a table of our own, looked up once for all columns.
class Compaction {
    using FloatTag = hn::ScalableTag<float>;

  public:
    HWY_INLINE explicit Compaction(hn::Mask<FloatTag> which) : lanes_(lanesOf(which)) {}

    /// Writes the selected lanes to `to`; a whole vector is written.
    HWY_INLINE void store(hn::Vec<FloatTag> values, float* to) const {
        hn::StoreU(hn::TableLookupLanes(values, lanes_), FloatTag(), to);
    }

  private:
    using IntTag = hn::ScalableTag<std::int32_t>;
    using Indices = decltype(hn::IndicesFromVec(FloatTag(), hn::Vec<IntTag>()));

    HWY_INLINE static Indices lanesOf(hn::Mask<FloatTag> which) {
        const hn::Rebind<std::uint8_t, FloatTag> bytes;
        std::uint8_t set[8] = {};
        hn::StoreMaskBits(FloatTag(), which, set);
        // In a set of four, lanes from 4 on are none of its own and come after them.
        const auto lanes = hn::LoadU(bytes, kCompressTable.lanes[set[0]]);
        return hn::IndicesFromVec(FloatTag(), hn::PromoteTo(IntTag(), lanes));
    }

    Indices lanes_;
};

#else

class Compaction {
    using FloatTag = hn::ScalableTag<float>;

  public:
    HWY_INLINE explicit Compaction(hn::Mask<FloatTag> which) : which_(which) {}

    /// Writes the selected lanes to `to`; a whole vector is written.
    HWY_INLINE void store(hn::Vec<FloatTag> values, float* to) const {
        hn::StoreU(hn::Compress(values, which_), FloatTag(), to);
    }

  private:
    hn::Mask<FloatTag> which_;
};

#endif

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
