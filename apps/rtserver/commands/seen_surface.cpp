#include "rtserver/commands/seen_surface.h"

#include "rtcore/render/camera_rays.h"

namespace rtserver {

std::optional<SeenSurface> surfaceAt(const Document& document, float right, float down) {
    const rtcore::RenderSettings& settings = document.settings();
    const rtcore::CameraRays view(document.camera(), settings.width, settings.height);
    const rtcore::Ray ray =
        view.at(right * static_cast<float>(settings.width), down * static_cast<float>(settings.height));
    rtcore::RayWave rays;
    rtcore::HitWave hits;
    rays.push(ray);
    document.tracer()->intersect(rtcore::RayKind::Primary, rays, hits);
    if (!hits.isHit(0)) return std::nullopt;
    const rtcore::Vec3 normal = normalize(document.scene()->mesh().geometricNormal(hits.triangle[0]));
    const bool faces = dot(normal, ray.direction) < 0;
    return SeenSurface{ray.origin + ray.direction * hits.t[0], faces ? normal : -normal, hits.t[0]};
}

} // namespace rtserver
