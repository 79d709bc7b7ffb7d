#include "rtcore/gathering/lobe_rays.h"

#include "rtcore/shading/surface/surface.h"

#include <limits>

namespace rtcore {

namespace {

/// That of the triangle, but where a light stands for it.
Colour emissionOf(const LitScene& lit, const Hit& hit) {
    const Scene& scene = lit.scene();
    const std::uint32_t material = scene.mesh().shading[hit.triangle].material;
    const std::span<const std::uint8_t> emitsNoLight = lit.paths().lights.emitsNoLight();
    if (isBlack(scene.material(material).emission)) return {};
    if (material < emitsNoLight.size() && emitsNoLight[material] != 0) return {};
    return emissionAt(scene, lit.paths().settings.textures, hit);
}

} // namespace

void LobeRays::trace(const GatherScene& in, const LitScene& lit, std::span<const LobeTap> taps,
                     std::span<OutgoingCells::Site> sites, std::span<Colour> direct) {
    rays_.clear();
    for (const LobeTap& tap : taps)
        rays_.push({tap.origin, 0, tap.direction, std::numeric_limits<float>::max()});
    in.tracer.intersect(RayKind::Scattered, rays_, hits_);
    for (std::size_t i = 0; i < taps.size(); ++i) {
        if (!hits_.isHit(i)) {
            sites[i] = {};
            direct[i] = lit.fromSurroundings(taps[i].origin, taps[i].direction);
            continue;
        }
        const Hit hit = hits_.hit(i);
        sites[i] = siteOf(in, rays_.ray(i), hit);
        sites[i].level = in.cells.levelOfSide(taps[i].width * sites[i].length);
        direct[i] = emissionOf(lit, hit);
    }
}

} // namespace rtcore
