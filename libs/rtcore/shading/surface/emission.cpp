#include "rtcore/shading/surface/emission.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/emission.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/surface/material_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void emissionAll(const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3& emitted) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Mask used = hasTrait(load(s.traits + i), traits::kPoint);
        if (none(used)) continue;
        const Float3 own = Rows(rows, s.material + i, used).get(&MaterialRow::emitted);
        storeAt(select(used, loadAt(s.weight, i) * own, loadAt(emitted, i)), emitted, i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(emissionAll);

void emissionOf(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3& emitted) {
    HWY_DYNAMIC_DISPATCH(emissionAll)(materials.rows(), surfaces, emitted);
}

} // namespace rtcore
#endif
