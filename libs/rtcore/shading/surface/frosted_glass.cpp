#include "rtcore/shading/surface/frosted_glass.h"

#include "rtcore/scattering/ggx-inl.h"

namespace rtcore {

bool isFrosted(const Material& m) {
    return hasRoughness(m) && m.opacity < 1 && m.indexOfRefraction != 1 &&
           m.roughness * m.roughness >= kMinAlpha;
}

float facetAlpha(const Scene& scene, bool textures, const Hit& hit) {
    const Material& m = scene.material(scene.mesh().shading[hit.triangle].material);
    const bool varies = textures && m.metallicRoughnessTexture != kNoTexture;
    const float roughness = m.roughness * (varies ? roughnessAt(scene, hit).roughness : 1.0F);
    return roughness * roughness;
}

void takeFacet(float alpha, SquarePoint point, Surface& s) {
    if (alpha < kMinAlpha) return;
    namespace plain = HWY_NAMESPACE;
    const Vec3 viewer = plain::liftedViewer<float>(s.toViewer, s.shadingNormal);
    const Vec3 facet = plain::sampleFacet<float>(s.shadingNormal, viewer, alpha, {point.u, point.v});
    if (!(dot(facet, s.toViewer) > 0)) return;
    s.shadingNormal = facet;
    s.facet = true;
}

} // namespace rtcore
