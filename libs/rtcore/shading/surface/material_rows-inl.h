// Values of the materials of consecutive points. Included once for each instruction set, inside
// foreach_target.h's loop.
#include "rtcore/math/float3-inl.h"
#include "rtcore/shading/surface/material_row.h"

#if defined(RTCORE_SHADING_SURFACE_MATERIAL_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_SURFACE_MATERIAL_ROWS_INL_H_
#undef RTCORE_SHADING_SURFACE_MATERIAL_ROWS_INL_H_
#else
#define RTCORE_SHADING_SURFACE_MATERIAL_ROWS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Mask hasTrait(Uint traits, std::uint32_t trait) { return (traits & trait) != 0U; }

/// The rows of consecutive points; often those of the used ones are one and the same.
class Rows {
  public:
    /// Points that are not `used` may have any material, and get any values; at least one is used.
    HWY_INLINE Rows(const MaterialRow* rows, const std::uint32_t* material, Mask used) {
        const Uint indices = load(material);
        const std::uint32_t first = material[used.first()];
        row_ = rows + first;
        one_ = none(without(used, indices == first));
        if (one_) return;
        store(shiftLeft<kRowShift>(selectOrZero(used, indices)), first_);
        row_ = rows;
    }

    HWY_INLINE Float get(float MaterialRow::*member) const { return column(&(row_->*member)); }
    HWY_INLINE Float3 get(float (MaterialRow::*member)[3]) const {
        const float* const values = row_->*member;
        return {column(values), column(values + 1), column(values + 2)};
    }

  private:
    HWY_INLINE Float column(const float* value) const {
        if (one_) return *value;
        return hn::GatherIndex(FloatTag(), value, toInt(load(first_)).raw);
    }

    const MaterialRow* row_;
    bool one_;
    HWY_ALIGN std::uint32_t first_[kLanes] = {};
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
