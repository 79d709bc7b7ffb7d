#include "rtserver/commands/hidden_points.h"

#include "rtcore/render/camera_rays.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace rtserver {

namespace {

using rtcore::Vec3;

constexpr float kShortOfDistance = 1e-3F, kShortOfDiagonal = 2e-4F;

/// To a little before the point; nothing: it is not in front of the camera, or at it.
std::optional<rtcore::Ray> rayTo(const rtcore::CameraRays& view, const rtcore::Vec3d& exactPoint,
                                 float diagonal) {
    const Vec3 point{static_cast<float>(exactPoint.x), static_cast<float>(exactPoint.y),
                     static_cast<float>(exactPoint.z)};
    const float depth = dot(point - view.eye(), view.forward());
    if (!(depth > 0)) return std::nullopt;
    const Vec3 from = view.parallel() ? point - view.forward() * depth : view.eye();
    const float distance = length(point - from);
    const float end = distance - std::max(kShortOfDistance * distance, kShortOfDiagonal * diagonal);
    if (!(end > 0)) return std::nullopt;
    return rtcore::Ray{from, 0, normalize(point - from), end};
}

} // namespace

std::vector<bool> hiddenFromCamera(const Document& document, std::span<const rtcore::Vec3d> points) {
    const rtcore::RenderSettings& settings = document.settings();
    const rtcore::CameraRays view(document.camera(), settings.width, settings.height);
    const rtcore::Box3& bounds = document.world().loaded.tree.bounds;
    const float diagonal = bounds.empty() ? 0 : bounds.diagonal();
    rtcore::RayWave rays;
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto ray = rayTo(view, points[i], diagonal);
        if (!ray) continue;
        rays.push(*ray);
        asked.push_back(i);
    }
    std::vector<std::uint8_t> occluded;
    document.tracer()->occluded(rtcore::RayKind::Primary, rays, occluded);
    std::vector<bool> hidden(points.size());
    for (std::size_t k = 0; k < asked.size(); ++k) hidden[asked[k]] = occluded[k] != 0;
    return hidden;
}

} // namespace rtserver
