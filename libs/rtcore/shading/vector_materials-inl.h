// Values of the materials of consecutive points. Included once for each instruction set, inside
// foreach_target.h's loop.
#include "rtcore/shading/material_table.h"
#include "rtcore/shading/vector_math-inl.h"

#if defined(RTCORE_SHADING_VECTOR_MATERIALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_VECTOR_MATERIALS_INL_H_
#undef RTCORE_SHADING_VECTOR_MATERIALS_INL_H_
#else
#define RTCORE_SHADING_VECTOR_MATERIALS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Lanes hasTrait(Bits traits, std::uint32_t trait) {
    const FloatTag d;
    const BitsTag du;
    return hn::MaskFromVec(
        hn::BitCast(d, hn::VecFromMask(du, hn::Ne(hn::And(traits, hn::Set(du, trait)), hn::Zero(du)))));
}

/// The rows of consecutive points; often they are one and the same.
class Rows {
  public:
    /// Points that are not `used` may have any material; at least one is used.
    HWY_INLINE Rows(const MaterialRow* rows, const std::uint32_t* HWY_RESTRICT material, Lanes used) {
        const FloatTag d;
        const BitsTag du;
        const hn::RebindToSigned<FloatTag> di;
        const Bits indices = hn::LoadU(du, material);
        row_ = rows + material[0];
        one_ = hn::AllTrue(d, used) && hn::AllTrue(du, hn::Eq(indices, hn::Set(du, material[0])));
        if (one_) return;
        const Bits safe = hn::BitCast(du, hn::IfThenElseZero(used, hn::BitCast(d, indices)));
        hn::Store(hn::ShiftLeft<kRowShift>(hn::BitCast(di, safe)), di, first_);
        row_ = rows;
    }

    HWY_INLINE Floats get(float MaterialRow::*member) const { return column(&(row_->*member)); }
    HWY_INLINE Vectors get(float (MaterialRow::*member)[3]) const {
        const float* const values = row_->*member;
        return {column(values), column(values + 1), column(values + 2)};
    }

  private:
    HWY_INLINE Floats column(const float* value) const {
        if (one_) return constant(*value);
        const hn::RebindToSigned<FloatTag> di;
        return hn::GatherIndex(FloatTag(), value, hn::Load(di, first_));
    }

    const MaterialRow* row_;
    bool one_;
    HWY_ALIGN std::int32_t first_[hn::MaxLanes(FloatTag())];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
