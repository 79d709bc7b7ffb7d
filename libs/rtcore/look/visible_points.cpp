#include "rtcore/look/visible_points.h"

#include "rtcore/lights/photometry-inl.h"
#include "rtcore/math/constants.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/survey/closest_hit.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rtcore {

namespace {

/// A little before a surface, as a part of the way to it.
constexpr float kShort = 0.999F;

/// Irradiance at the point, 0 where it is occluded; W/m^2 of the brightest channel.
float irradianceAt(const KdTree& tree, const Mesh& mesh, const Light& light, const VisiblePoint& point) {
    const bool near = traitsOf(light).position;
    const Vec3 direction = near ? light.position - point.position : -light.direction;
    const float distance = length(direction);
    if (!(distance > 0)) return 0;
    const float facing = dot(point.normal, direction) / distance;
    if (facing <= 0) return 0;
    float strength = maxComponent(light.intensity);
    const float cosine = near ? -dot(direction, light.direction) / distance : 1;
    if (traitsOf(light).beam == Beam::Cone && cosine < light.cosOuter) return 0;
    if (traitsOf(light).beam == Beam::Cosine) strength *= std::max(cosine, 0.0F);
    if (traitsOf(light).beam == Beam::Measured)
        strength *= HWY_NAMESPACE::measuredFactor<float>(light, -direction);
    if (near) strength /= std::max(distance * distance, light.radius * light.radius);
    const float last = near ? std::max(1 - light.radius / distance, 0.0F) * kShort : Box3::kHuge;
    return occluded(tree, mesh, {point.position, 0, direction, last}) ? 0 : strength * facing;
}

} // namespace

std::vector<VisiblePoint> visiblePoints(const KdTree& tree, const Mesh& mesh, const Camera& camera) {
    const CameraRays rays(camera, kSeenAcross, kSeenDown);
    std::vector<VisiblePoint> points;
    for (int y = 0; y < kSeenDown; ++y) {
        for (int x = 0; x < kSeenAcross; ++x) {
            const Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const auto hit = closestHit(tree, mesh, ray.origin, ray.direction);
            if (!hit) continue;
            const Vec3 normal = normalize(mesh.geometricNormal(hit->triangle));
            points.push_back({ray.origin + ray.direction * (kShort * hit->t),
                              dot(normal, ray.direction) > 0 ? -normal : normal});
        }
    }
    return points;
}

bool showsModel(std::span<const VisiblePoint> points, const Box3& box) {
    constexpr std::ptrdiff_t kMin = kSeenAcross * kSeenDown / 100;
    constexpr float kAround = 0.01F; // the places lie a little before the surfaces
    const Vec3 margin = Vec3{1, 1, 1} * (kAround * box.diagonal());
    const Box3 grown{box.lo - margin, box.hi + margin};
    return std::count_if(points.begin(), points.end(),
                         [&](const VisiblePoint& point) { return grown.contains(point.position); }) >= kMin;
}

float partInImage(std::span<const VisiblePoint> points, const Camera& camera) {
    const bool perspective = camera.kind == CameraKind::Perspective;
    if (points.empty() || (!perspective && camera.kind != CameraKind::Orthographic)) return 1;
    const CameraRays rays(camera, kSeenAcross, kSeenDown);
    const auto& [corner, right, down] = rays.plane();
    const Vec3 across = right / dot(right, right), downwards = down / dot(down, down);
    const auto isIn = [&](const VisiblePoint& point) {
        const Vec3 direction = point.position - rays.eye();
        const float depth = dot(direction, rays.forward());
        if (!(depth > 0)) return false;
        const Vec3 inPlane = (perspective ? direction / depth : direction) - corner;
        const float x = dot(inPlane, across), y = dot(inPlane, downwards);
        return x >= 0 && x < kSeenAcross && y >= 0 && y < kSeenDown;
    };
    return static_cast<float>(std::count_if(points.begin(), points.end(), isIn)) /
           static_cast<float>(points.size());
}

std::vector<float> irradianceAt(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                                std::span<const VisiblePoint> points) {
    std::vector<float> sums(points.size(), 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const Light& light : lights)
            if (light.on != 0) sums[i] += irradianceAt(tree, mesh, light, points[i]);
    return sums;
}

bool lightReaches(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                  std::span<const VisiblePoint> points, Colour ambient) {
    constexpr float kNoticed = 0.02F; // beside what the ambient light brings
    const float min = kNoticed * kPi * maxComponent(ambient);
    const std::vector<float> sums = irradianceAt(tree, mesh, lights, points);
    const auto lit = std::ranges::count_if(sums, [&](float sum) { return sum > min; });
    return 50 * static_cast<std::size_t>(lit) >= points.size();
}

bool isOpen(const KdTree& tree, const Mesh& mesh, std::span<const VisiblePoint> points) {
    constexpr float kAcross = 0.7F; // beside the normal, as directions that much light comes from
    std::size_t open = 0;
    for (const VisiblePoint& point : points) {
        const Basis around = basisAround(point.normal);
        const std::array<Vec3, 5> directions{
            point.normal, point.normal + around.tangent * kAcross, point.normal - around.tangent * kAcross,
            point.normal + around.bitangent * kAcross, point.normal - around.bitangent * kAcross};
        const bool leaves = std::ranges::any_of(directions, [&](Vec3 direction) {
            return !occluded(tree, mesh, {point.position, 0, direction, Box3::kHuge});
        });
        open += leaves ? 1 : 0;
    }
    return 50 * open >= points.size();
}

} // namespace rtcore
