#include "rtcore/shading/surface/emission.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/emission.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/surface/mirrors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Mirrors reflect the ambient light only as far as they scatter.
HWY_INLINE Float3 emittedByMirrors(const Rows& row, const SurfaceWave& s, std::size_t i, Mask mirrors) {
    const Float3 ambient = row.get(&MaterialRow::ambient), emission = row.get(&MaterialRow::emission);
    if (none(mirrors & (maxComponent(ambient) > 0.0F))) return emission;
    return emission + ambient * (broadcast(kWhite) - mirroredFraction(row, s, i, mirrors));
}

void emissionAll(const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3& emitted) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Mask used = hasTrait(load(s.traits + i), traits::kPoint);
        if (none(used)) continue;
        const Rows row(rows, s.material + i, used);
        Float3 own = row.get(&MaterialRow::emitted);
        const Mask mirrors = used & hasTrait(load(s.traits + i), traits::kMirror);
        if (any(mirrors)) own = select(mirrors, emittedByMirrors(row, s, i, mirrors), own);
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
