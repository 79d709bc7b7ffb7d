#include "rtcore/shading/sample_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/sample_sums.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Vectors glowOf(const MaterialRow& row) { return constant(row.glow[0], row.glow[1], row.glow[2]); }

/// Of consecutive points; those that are not `used` may have any material.
HWY_INLINE Vectors glowOf(const MaterialRow* rows, const std::uint32_t* material, Lanes used) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Bits indices = hn::LoadU(du, material);
    if (hn::AllTrue(du, hn::Eq(indices, hn::Set(du, material[0]))) && hn::AllTrue(d, used)) return glowOf(rows[material[0]]);
    const Bits safe = hn::BitCast(du, hn::IfThenElseZero(used, hn::BitCast(d, indices)));
    const auto row = hn::ShiftLeft<4>(hn::BitCast(di, safe));
    const float* const glow = rows->glow;
    return {hn::GatherIndex(d, glow, row), hn::GatherIndex(d, glow + 1, row), hn::GatherIndex(d, glow + 2, row)};
}

void startAll(Colour background, const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3& radiance,
              std::uint8_t* HWY_RESTRICT hit) {
    const FloatTag d;
    const BitsTag du;
    const hn::Rebind<std::uint8_t, FloatTag> d8;
    const Vectors missed = constant(background.r, background.g, background.b);
    const Vectors one = constant(1, 1, 1);
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Bits point = hn::And(hn::LoadU(du, s.traits + i), hn::Set(du, traits::kPoint));
        hn::StoreU(hn::U8FromU32(point), d8, hit + i);
        const Lanes used = hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(du, hn::Ne(point, hn::Zero(du)))));
        Vectors first = selectOrZero(hn::Not(used), missed);
        if (rows != nullptr && !hn::AllFalse(d, used)) first = select(used, glowOf(rows, s.material + i, used), missed);
        storeVectors(first, radiance.x + i, radiance.y + i, radiance.z + i);
        storeVectors(one, s.share.x + i, s.share.y + i, s.share.z + i);
    }
}

void addAll(const SurfaceWave& s, const ArraysOf3& radiance) {
    const FloatTag d;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Vectors sum = loadVectors(radiance.x + i, radiance.y + i, radiance.z + i) +
                            loadVectors(s.added.x + i, s.added.y + i, s.added.z + i);
        storeVectors(sum, radiance.x + i, radiance.y + i, radiance.z + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(startAll);
HWY_EXPORT(addAll);

void startSums(Colour background, const MaterialTable& materials, const SurfaceWave& surfaces,
               const ArraysOf3& radiance, std::uint8_t* hit) {
    const MaterialRow* const rows = materials.anyGlow() ? materials.rows() : nullptr;
    HWY_DYNAMIC_DISPATCH(startAll)(background, rows, surfaces, radiance, hit);
}

void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance) {
    HWY_DYNAMIC_DISPATCH(addAll)(surfaces, radiance);
}

} // namespace rtcore
#endif
