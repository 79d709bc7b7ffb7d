#include "rtcore/survey/default_view.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"
#include "rtcore/survey/closest_hit.h"
#include "rtcore/survey/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

namespace {

constexpr float kTwoPi = 6.28318530718F;
constexpr float kInteriorFov = 75;
constexpr float kExteriorFov = 45;
constexpr float kAside = 0.45F, kAbove = 0.35F; ///< of where an object is looked at from

/// Looks along `forward` at what is in the box, in an image of 16:9.
Camera frameAll(const Mesh& mesh, const Box3& bounds, Vec3 forward, Vec3 upwards) {
    Camera camera;
    camera.horizontalFov = kExteriorFov;
    camera.up = upwards;
    camera.forward = forward;
    return framed(mesh, bounds, camera, 16.0F / 9);
}

/// How much of the box is seen from the eye: the share of 27 points in it that nothing outside of it hides.
float openTo(const KdTree& tree, const Mesh& mesh, const Box3& bounds, Vec3 eye) {
    int open = 0, all = 0;
    for (int i = 0; i < 27; ++i) {
        const Vec3 part{0.2F + 0.3F * static_cast<float>(i % 3), 0.2F + 0.3F * static_cast<float>(i / 3 % 3),
                        0.2F + 0.3F * static_cast<float>(i / 9)};
        const Vec3 size = bounds.size();
        const Vec3 way = bounds.lo + Vec3{size.x * part.x, size.y * part.y, size.z * part.z} - eye;
        Hit hit;
        ++all;
        if (!intersect(tree, mesh, {eye, 0, way, 1}, hit) || bounds.contains(eye + way * (1.001F * hit.t)))
            ++open;
    }
    return static_cast<float>(open) / static_cast<float>(all);
}

/// From the front and a little above; from higher, or from another side, where a hill is in the way.
Camera viewOfObject(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Box3& bounds) {
    Camera best;
    float max = -1;
    for (const float height : {kAbove, 2 * kAbove, 4 * kAbove}) {
        for (const Vec3 side : {axes.front + axes.right * kAside, axes.front - axes.right * kAside,
                                axes.right + axes.front * kAside, -axes.front - axes.right * kAside}) {
            const Camera camera = frameAll(mesh, bounds, -normalize(side + axes.up * height), axes.up);
            const float open = openTo(tree, mesh, bounds, camera.eye);
            constexpr float kEnough = 0.9F;
            if (open >= kEnough) return camera;
            if (open <= max) continue;
            max = open;
            best = camera;
        }
    }
    return best;
}

/// Where one sees far, and much, with nothing close in the middle.
class RoomView {
  public:
    RoomView(const KdTree& tree, const Mesh& mesh, const Axes& axes)
        : tree_(tree), mesh_(mesh), axes_(axes) {}

    Camera best(const std::vector<Stand>& rooms) {
        Camera camera;
        camera.up = axes_.up;
        camera.horizontalFov = kInteriorFov;
        float max = -1;
        for (const Stand& stand : rooms) {
            for (int i = 0; i < Stand::kDirections; ++i) {
                const float worth = worthOf(stand, i);
                if (worth <= max) continue;
                max = worth;
                camera.eye = stand.eye;
                camera.forward = directionOf(i);
            }
        }
        return camera;
    }

  private:
    static constexpr int kHalfView = 3; ///< directions to each side that are in the image
    Vec3 directionOf(int i) const {
        return axes_.horizontal(kTwoPi * static_cast<float>(i) / Stand::kDirections);
    }

    /// How far one sees in the mean, times the root of how far at least, of how high the room is, and of how
    /// many triangles a few rays find.
    float worthOf(const Stand& stand, int direction) const {
        constexpr float kClose = 1; // metre, in the middle of the image
        float sum = 0, min = Box3::kHuge;
        for (int i = -kHalfView; i <= kHalfView; ++i) {
            const float free = countedFree(stand, (direction + i + Stand::kDirections) % Stand::kDirections);
            if (std::abs(i) <= 1 && free < kClose * axes_.metre) return -1;
            sum += free;
            min = std::min(min, free);
        }
        const auto seen = static_cast<float>(detail(stand.eye, directionOf(direction)));
        return sum * std::sqrt(min * stand.height * seen);
    }

    /// Space behind a window does not count as the room's.
    static float countedFree(const Stand& stand, int direction) {
        constexpr float kFarthest = 3, kOutside = 0.5F; // of the mean
        const float free = stand.free.at(static_cast<std::size_t>(direction));
        return stand.view * (std::isinf(free) ? kOutside : std::min(free / stand.view, kFarthest));
    }

    std::size_t detail(Vec3 eye, Vec3 forward) const {
        const Vec3 right = normalize(cross(forward, axes_.up));
        std::array<std::uint32_t, 35> seen{};
        std::size_t count = 0;
        for (int y = -2; y <= 2; ++y) {
            for (int x = -3; x <= 3; ++x) {
                constexpr float kStep = 0.2F;
                const Vec3 way = forward + right * (kStep * static_cast<float>(x)) +
                                 axes_.up * (kStep * static_cast<float>(y));
                const auto hit = closestHit(tree_, mesh_, eye, way);
                if (!hit) continue;
                const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
                if (std::find(seen.begin(), end, hit->triangle) == end) seen.at(count++) = hit->triangle;
            }
        }
        return count;
    }

    const KdTree& tree_;
    const Mesh& mesh_;
    const Axes& axes_;
};

} // namespace

Camera defaultCamera(const KdTree& tree, const Mesh& mesh, const Survey& survey) {
    const Axes& axes = survey.axes;
    const Box3& bounds = survey.subject.bounds;
    if (bounds.empty()) return {};
    if (survey.inside()) return RoomView(tree, mesh, axes).best(survey.rooms);
    return survey.isStage() ? frameAll(mesh, bounds, -survey.openSide, axes.up)
                            : viewOfObject(tree, mesh, axes, bounds);
}

Vec3 threeQuarters(const Axes& axes) { return axes.front + axes.right * kAside + axes.up * kAbove; }

Light defaultLight(const Camera& camera, const Box3& bounds) {
    const Vec3 forward = normalize(camera.forward);
    const Vec3 right = normalize(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    const float diagonal = bounds.diagonal();
    const float away = length(bounds.centre() - camera.eye);
    const bool inside = away < 0.5F * diagonal;
    const float side = inside ? 0.03F * diagonal : 0.35F * away;
    Light light;
    light.position = camera.eye + right * side + up * (inside ? side : 1.4F * side);
    // Indoors the light is as far from most walls as the room is wide.
    const float distance = inside ? 0.2F * diagonal : length(bounds.centre() - light.position);
    const float strength = kPi * std::max(distance * distance, 1e-30F);
    light.intensity = kWhite * strength;
    light.radius = 0.01F * diagonal;
    return light;
}

} // namespace rtcore
