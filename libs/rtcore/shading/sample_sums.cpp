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

void startAll(Colour background, const SurfaceWave& s, const ArraysOf3& radiance) {
    const FloatTag d;
    const BitsTag du;
    const Vectors missed = constant(background.r, background.g, background.b);
    const Vectors one = constant(1, 1, 1);
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const auto missing = hn::Eq(hn::LoadU(du, s.traits + i), hn::Zero(du));
        const Lanes lanes = hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(du, missing)));
        storeVectors(selectOrZero(lanes, missed), radiance.x + i, radiance.y + i, radiance.z + i);
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

void startSums(Colour background, SurfaceWave& surfaces, const ArraysOf3& radiance) {
    HWY_DYNAMIC_DISPATCH(startAll)(background, surfaces, radiance);
}

void addToSums(const SurfaceWave& surfaces, const ArraysOf3& radiance) {
    HWY_DYNAMIC_DISPATCH(addAll)(surfaces, radiance);
}

} // namespace rtcore
#endif
