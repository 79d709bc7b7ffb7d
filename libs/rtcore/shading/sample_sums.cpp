#include "rtcore/shading/sample_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/sample_sums.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_materials-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void startAll(Colour background, const SurfaceWave& s, const ArraysOf3& radiance,
              std::uint8_t* HWY_RESTRICT hit) {
    const FloatTag d;
    const BitsTag du;
    const hn::Rebind<std::uint8_t, FloatTag> d8;
    const Vectors missed = constant(background.r, background.g, background.b);
    const Vectors one = constant(1, 1, 1);
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Bits point = hn::And(hn::LoadU(du, s.traits + i), hn::Set(du, traits::kPoint));
        hn::StoreU(hn::U8FromU32(point), d8, hit + i);
        const Vectors first = selectOrZero(hn::Not(hasTrait(point, traits::kPoint)), missed);
        storeVectors(first, radiance.x + i, radiance.y + i, radiance.z + i);
        storeVectors(one, s.share.x + i, s.share.y + i, s.share.z + i);
    }
}

void glowAll(const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3& glow) {
    const FloatTag d;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Lanes used = hasTrait(hn::LoadU(BitsTag(), s.traits + i), traits::kPoint);
        if (hn::AllFalse(d, used)) continue;
        const Vectors own = Rows(rows, s.material + i, used).get(&MaterialRow::glow);
        const Vectors share = loadVectors(s.share.x + i, s.share.y + i, s.share.z + i);
        const Vectors old = loadVectors(glow.x + i, glow.y + i, glow.z + i);
        storeVectors(select(used, share * own, old), glow.x + i, glow.y + i, glow.z + i);
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
