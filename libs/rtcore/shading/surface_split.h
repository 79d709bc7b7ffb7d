/// How the light at a surface divides: mirrored, let through, or scattered by the Phong lobes.
#pragma once

#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/fresnel.h"
#include "rtcore/shading/surface.h"

namespace rtcore {

struct SurfaceSplit {
    Colour mirrored;    ///< weight of the mirror ray
    Colour transmitted; ///< weight of the ray that goes on behind the surface
    Colour scattered;   ///< factor on diffuse and glossy reflection
};

inline SurfaceSplit splitLight(const Surface& s, const RenderSettings& settings) {
    const Material& m = *s.material;
    const float cosine = std::max(dot(s.toViewer, s.shadingNormal), 0.0F);
    const float opacity = settings.refractions ? m.opacity : 1.0F;
    SurfaceSplit split;
    if (settings.reflections) {
        if (opacity < 1) {
            const float eta = s.closed && s.fromInside ? 1 / m.indexOfRefraction : m.indexOfRefraction;
            const float r = fresnelDielectric(cosine, eta);
            split.mirrored = kWhite * (s.closed ? r : thinWallReflectance(r));
        } else {
            split.mirrored =
                (m.fresnel != 0 && !isBlack(m.mirror) ? fresnelSchlick(m.mirror, cosine) : m.mirror);
            split.mirrored = split.mirrored * m.mirrorScale;
        }
    }
    const Colour rest = kWhite - split.mirrored;
    split.scattered = rest * opacity;
    split.transmitted = rest * (1 - opacity);
    return split;
}

} // namespace rtcore
