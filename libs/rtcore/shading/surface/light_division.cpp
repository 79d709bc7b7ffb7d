#include "rtcore/shading/surface/light_division.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/surface/light_division.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/surface/mirrors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void divideAtMirrors(const MaterialRow* rows, const SurfaceWave& s) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Uint traits = load(s.traits + i);
        const Mask mirrors = hasTrait(traits, traits::kMirror);
        if (none(mirrors)) continue;
        const Rows row(rows, s.material + i, mirrors);
        const Float3 mirrored = mirroredFraction(row, s, i, mirrors), weight = loadAt(s.weight, i);
        storeAt(select(mirrors, weight * mirrored, loadAt(s.specular, i)), s.specular, i);
        storeAt(select(mirrors, weight * (broadcast(kWhite) - mirrored), weight), s.weight, i);
        store(select(mirrors, traits | traits::kSpecular, traits), s.traits + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(divideAtMirrors);

void LightDivision::divide(const LobeTask& task, const SurfaceWave& surfaces) {
    if (task.materials.anyMirror()) HWY_DYNAMIC_DISPATCH(divideAtMirrors)(task.materials.rows(), surfaces);
    if (task.materials.anyMetallic()) metallic_.complete(task, surfaces);
}

} // namespace rtcore
#endif
