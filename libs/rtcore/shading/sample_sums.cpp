#include "rtcore/shading/sample_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/sample_sums.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/material_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void startAll(Colour background, const SurfaceWave& s, const ArraysOf3& radiance,
              std::uint8_t* HWY_RESTRICT hit) {
    const hn::Rebind<std::uint8_t, FloatTag> d8;
    const Float3 missed = broadcast(background);
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Uint point = load(s.traits + i) & traits::kPoint;
        hn::StoreU(hn::U8FromU32(point.raw), d8, hit + i);
        storeAt(selectOrZero(!hasTrait(point, traits::kPoint), missed), radiance, i);
        storeAt(broadcast(kWhite), s.share, i);
    }
}

void glowAll(const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3& glow) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Mask used = hasTrait(load(s.traits + i), traits::kPoint);
        if (none(used)) continue;
        const Float3 own = Rows(rows, s.material + i, used).get(&MaterialRow::glow);
        storeAt(select(used, loadAt(s.share, i) * own, loadAt(glow, i)), glow, i);
    }
}

void addAll(const SurfaceWave& s, const ArraysOf3& radiance) {
    for (std::size_t i = 0; i < s.size(); i += lanes())
        storeAt(loadAt(radiance, i) + loadAt(s.added, i), radiance, i);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(startAll);
HWY_EXPORT(glowAll);
HWY_EXPORT(addAll);

void startSums(Colour background, const SurfaceWave& surfaces, const ArraysOf3& radiance, std::uint8_t* hit) {
    HWY_DYNAMIC_DISPATCH(startAll)(background, surfaces, radiance, hit);
}

void glowOf(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3& glow) {
    HWY_DYNAMIC_DISPATCH(glowAll)(materials.rows(), surfaces, glow);
}

void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance) {
    HWY_DYNAMIC_DISPATCH(addAll)(surfaces, radiance);
}

} // namespace rtcore
#endif
