#include "rtcore/look/seen_places.h"

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

/// What arrives at the place, unless something is in the way; W/m^2 of the brightest channel.
float irradianceAt(const KdTree& tree, const Mesh& mesh, const Light& light, const SeenPlace& place) {
    const bool near = traitsOf(light).position;
    const Vec3 way = near ? light.position - place.position : -light.direction;
    const float distance = length(way);
    if (!(distance > 0)) return 0;
    const float facing = dot(place.normal, way) / distance;
    if (facing <= 0) return 0;
    float strength = maxComponent(light.intensity);
    const float cosine = near ? -dot(way, light.direction) / distance : 1;
    if (traitsOf(light).beam == Beam::Cone && cosine < light.cosOuter) return 0;
    if (traitsOf(light).beam == Beam::Cosine) strength *= std::max(cosine, 0.0F);
    if (near) strength /= std::max(distance * distance, light.radius * light.radius);
    const float last = near ? std::max(1 - light.radius / distance, 0.0F) * kShort : Box3::kHuge;
    return occluded(tree, mesh, {place.position, 0, way, last}) ? 0 : strength * facing;
}

} // namespace

std::vector<SeenPlace> seenPlaces(const KdTree& tree, const Mesh& mesh, const Camera& camera) {
    const CameraRays rays(camera, kSeenAcross, kSeenDown);
    std::vector<SeenPlace> places;
    for (int y = 0; y < kSeenDown; ++y) {
        for (int x = 0; x < kSeenAcross; ++x) {
            const Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const auto hit = closestHit(tree, mesh, ray.origin, ray.direction);
            if (!hit) continue;
            const Vec3 normal = normalize(mesh.geometricNormal(hit->triangle));
            places.push_back({ray.origin + ray.direction * (kShort * hit->t),
                              dot(normal, ray.direction) > 0 ? -normal : normal});
        }
    }
    return places;
}

bool showsModel(std::span<const SeenPlace> places, const Box3& box) {
    constexpr std::ptrdiff_t kLeast = kSeenAcross * kSeenDown / 100;
    constexpr float kAround = 0.01F; // the places lie a little before the surfaces
    const Vec3 margin = Vec3{1, 1, 1} * (kAround * box.diagonal());
    const Box3 grown{box.lo - margin, box.hi + margin};
    return std::count_if(places.begin(), places.end(),
                         [&](const SeenPlace& place) { return grown.contains(place.position); }) >= kLeast;
}

float partInImage(std::span<const SeenPlace> places, const Camera& camera) {
    const bool perspective = camera.kind == CameraKind::Perspective;
    if (places.empty() || (!perspective && camera.kind != CameraKind::Orthographic)) return 1;
    const CameraRays rays(camera, kSeenAcross, kSeenDown);
    const auto& [corner, right, down] = rays.plane();
    const Vec3 across = right / dot(right, right), downwards = down / dot(down, down);
    const auto isIn = [&](const SeenPlace& place) {
        const Vec3 way = place.position - rays.eye();
        const float depth = dot(way, rays.forward());
        if (!(depth > 0)) return false;
        const Vec3 inPlane = (perspective ? way / depth : way) - corner;
        const float x = dot(inPlane, across), y = dot(inPlane, downwards);
        return x >= 0 && x < kSeenAcross && y >= 0 && y < kSeenDown;
    };
    return static_cast<float>(std::count_if(places.begin(), places.end(), isIn)) /
           static_cast<float>(places.size());
}

std::vector<float> irradianceAt(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                                std::span<const SeenPlace> places) {
    std::vector<float> sums(places.size(), 0.0F);
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const Light& light : lights)
            if (light.on != 0) sums[i] += irradianceAt(tree, mesh, light, places[i]);
    return sums;
}

bool lightReaches(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                  std::span<const SeenPlace> places, Colour ambient) {
    constexpr float kNoticed = 0.02F; // beside what the ambient light brings
    const float least = kNoticed * kPi * maxComponent(ambient);
    const std::vector<float> sums = irradianceAt(tree, mesh, lights, places);
    const auto lit = std::ranges::count_if(sums, [&](float sum) { return sum > least; });
    return 50 * static_cast<std::size_t>(lit) >= places.size();
}

bool isOpen(const KdTree& tree, const Mesh& mesh, std::span<const SeenPlace> places) {
    constexpr float kAcross = 0.7F; // beside the normal, as directions that much light comes from
    std::size_t open = 0;
    for (const SeenPlace& place : places) {
        const Basis around = basisAround(place.normal);
        const std::array<Vec3, 5> ways{
            place.normal, place.normal + around.tangent * kAcross, place.normal - around.tangent * kAcross,
            place.normal + around.bitangent * kAcross, place.normal - around.bitangent * kAcross};
        const bool leaves = std::ranges::any_of(ways, [&](Vec3 way) {
            return !occluded(tree, mesh, {place.position, 0, way, Box3::kHuge});
        });
        open += leaves ? 1 : 0;
    }
    return 50 * open >= places.size();
}

} // namespace rtcore
