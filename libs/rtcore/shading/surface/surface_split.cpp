#include "rtcore/shading/surface/surface_split.h"

#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/fresnel.h"

#include <algorithm>

namespace rtcore {

namespace {

Colour schlick(Colour normal, float cosine) {
    const Vec3 seen = HWY_NAMESPACE::fresnelSchlick<float>({normal.r, normal.g, normal.b}, cosine);
    return {seen.x, seen.y, seen.z};
}

} // namespace

Colour mirroredOf(const Material& m, float cosine) {
    const bool fresnel = m.fresnel != 0 && !isBlack(m.mirror);
    return (fresnel ? schlick(m.mirror, cosine) : m.mirror) * m.mirrorScale;
}

SurfaceSplit splitLight(const Surface& s, const RenderSettings& settings) {
    const Material& m = *s.material;
    const float cosine = std::max(dot(s.toViewer, s.shadingNormal), 0.0F);
    const float opacity = settings.refractions ? s.opacity : 1.0F;
    SurfaceSplit split;
    if (settings.reflections) {
        if (opacity < 1) {
            const float r = fresnelDielectric(cosine, s.index);
            split.mirrored = kWhite * (s.closed ? r : thinWallReflectance(r));
        } else {
            split.mirrored = mirroredOf(m, cosine) * s.specularTint;
        }
    }
    const Colour rest = kWhite - split.mirrored;
    split.scattered = rest * opacity;
    split.transmitted = rest * (1 - opacity);
    return split;
}

} // namespace rtcore
