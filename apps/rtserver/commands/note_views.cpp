#include "rtserver/commands/note_views.h"

#include "rtcore/measures/extents.h"
#include "rtcore/render/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtserver {

namespace {

using rtcore::Vec3;

constexpr float kOfDiagonal = 0.1F;
constexpr float kKeptFree = 0.9F; ///< of the way to what stands there

Vec3 nearest(const rtcore::Vec3d& point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

/// Unit directions from the point in which an eye may be: where it is, that of the view, eight around and a
/// little above, straight above.
std::vector<Vec3> directionsOfEyes(const rtcore::Camera& camera, Vec3 at, Vec3 up) {
    std::vector<Vec3> all{-normalize(camera.forward)};
    const Vec3 here = normalize(camera.eye - at);
    if (here != Vec3{}) all.insert(all.begin(), here);
    const Vec3 ahead = rtcore::basisAround(up).tangent, side = cross(up, ahead);
    constexpr int kAround = 8;
    constexpr float kRise = 0.35F, kQuarter = 1.57079633F;
    for (int i = 0; i < kAround; ++i) {
        const float angle = kQuarter * static_cast<float>(i) * 4 / kAround;
        all.push_back(normalize(ahead * std::cos(angle) + side * std::sin(angle) + up * kRise));
    }
    all.push_back(up);
    return all;
}

} // namespace

std::optional<rtcore::Camera> viewOnto(const Document& document, const rtcore::Vec3d& point) {
    const rtcore::RenderSettings& settings = document.settings();
    const rtcore::CameraRays rays(document.camera(), settings.width, settings.height);
    const Vec3 off = nearest(point) - rays.eye();
    const float depth = dot(off, rays.forward());
    if (!(depth > 0)) return std::nullopt;
    const Vec3 across = rays.parallel() ? off - rays.forward() * depth : off / depth;
    const Vec3 inImage = across - rays.plane().corner;
    const auto pixels = [&](Vec3 pixel) { return dot(inImage, pixel) / dot(pixel, pixel); };
    const float x = pixels(rays.plane().right), y = pixels(rays.plane().down);
    const bool within = x >= 0 && x <= static_cast<float>(settings.width) && y >= 0 &&
                        y <= static_cast<float>(settings.height);
    if (!within) return std::nullopt;
    rtcore::Camera camera = document.camera();
    camera.nameOffset = 0;
    return camera;
}

rtcore::Camera viewTowards(const Document& document, const rtcore::Vec3d& point) {
    rtcore::Camera camera = document.camera();
    const Vec3 at = nearest(point), up = document.scene()->up;
    const rtcore::Box3& bounds = document.world().loaded.tree.bounds;
    const float away = bounds.empty() ? 1 : std::max(kOfDiagonal * bounds.diagonal(), 1e-6F);
    Vec3 best{};
    float room = -1;
    for (const Vec3 direction : directionsOfEyes(camera, at, up)) {
        const auto free = rtcore::clearanceFrom(*document.tracer(), at, direction);
        const float own = free ? std::min(away, kKeptFree * static_cast<float>(*free)) : away;
        if (!(own > room)) continue;
        room = own;
        best = direction;
        if (room > away / 2) break;
    }
    camera.eye = at + best * std::max(room, away / 100);
    camera.forward = -best;
    if (rtcore::areParallel(camera.forward, camera.up)) camera.up = rtcore::upwardsOf(camera.forward, up);
    camera.nameOffset = 0;
    return camera;
}

} // namespace rtserver
