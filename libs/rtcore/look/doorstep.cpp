#include "rtcore/look/doorstep.h"

#include "rtcore/survey/closest_hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace rtcore {

namespace {

// Metres.
constexpr float kDoorHeight = 1.9F, kNarrowDoor = 0.6F, kWideDoor = 4;
constexpr float kSills[] = {0.3F, 1.0F, 1.6F}; ///< heights at which an open door has nothing in it
constexpr float kStep = 0.15F;                 ///< between looks along a side
constexpr float kDeep = 0.8F;                  ///< that one can go into a door at least
constexpr float kNearest = 3, kFarthestStand = 15;
constexpr int kMaxLooks = 400;

/// One of the four sides of the box.
struct Side {
    Vec3 outwards, along;
    Vec3 middle; ///< at the box's lowest height
    float half;  ///< of its length
};

std::array<Side, 4> sidesOf(const Box3& box, const Axes& axes) {
    const Vec3 centre = box.centre();
    const Vec3 bottom = centre + axes.up * (rangeAlong(box, axes.up).low - dot(centre, axes.up));
    std::array<Side, 4> sides;
    std::size_t i = 0;
    for (const Vec3 out : {axes.front, axes.right, -axes.front, -axes.right}) {
        const Vec3 along = cross(axes.up, out);
        sides.at(i++) = {out, along, bottom + out * (0.5F * extentAlong(box, out)),
                         0.5F * extentAlong(box, along)};
    }
    return sides;
}

/// Looks at the model from a few steps before it.
class Approach {
  public:
    Approach(const KdTree& tree, const Mesh& mesh, const Survey& survey)
        : tree_(tree), mesh_(mesh), axes_(survey.axes), box_(survey.subject.standing),
          lowest_(rangeAlong(tree.bounds, axes_.up).low) {}

    /// Standing `away` before `target`, a point of that side; facing it.
    Camera standBefore(const Side& side, Vec3 target, float away) const {
        const Vec3 position = target + side.outwards * away;
        Camera camera;
        camera.up = axes_.up;
        camera.horizontalFov = 75;
        camera.forward = -side.outwards;
        camera.eye =
            position + axes_.up * (floorAt(position) + kEyeHeight * axes_.metre - dot(position, axes_.up));
        return camera;
    }

    bool hasFloor(const Camera& camera) const { return foundFloor(camera.eye).has_value(); }

    /// The middle of the widest open door of the side.
    std::optional<Vec3> doorOf(const Side& side) const {
        const int looks = std::min(static_cast<int>(2 * side.half / (kStep * axes_.metre)), kMaxLooks);
        if (looks < 4) return std::nullopt;
        const float step = 2 * side.half / static_cast<float>(looks);
        int begun = -1;
        float widest = 0;
        std::optional<Vec3> door;
        for (int i = 0; i <= looks; ++i) {
            const float at = (static_cast<float>(i) + 0.5F) * step - side.half;
            if (i < looks && isOpen(side, side.middle + side.along * at)) {
                if (begun < 0) begun = i;
                continue;
            }
            const float width = begun < 0 ? 0 : static_cast<float>(i - begun) * step;
            if (width >= kNarrowDoor * axes_.metre && width <= kWideDoor * axes_.metre && width > widest) {
                widest = width;
                const float middle = 0.5F * static_cast<float>(begun + i) * step - side.half;
                door = side.middle + side.along * middle;
            }
            begun = -1;
        }
        return door;
    }

  private:
    std::optional<float> foundFloor(Vec3 position) const {
        const float above = rangeAlong(box_, axes_.up).high - dot(position, axes_.up) + axes_.metre;
        const auto floor = closestHit(tree_, mesh_, position + axes_.up * above, -axes_.up);
        if (!floor) return std::nullopt;
        return dot(position, axes_.up) + above - floor->t;
    }
    float floorAt(Vec3 position) const { return foundFloor(position).value_or(lowest_); }

    /// Whether one could walk in there, below a lintel.
    bool isOpen(const Side& side, Vec3 at) const {
        const Vec3 outside = at + side.outwards * axes_.metre;
        const float ground = floorAt(outside) - dot(at, axes_.up);
        const auto look = [&](float height) {
            return closestHit(tree_, mesh_, outside + axes_.up * (ground + height * axes_.metre),
                              -side.outwards);
        };
        const auto lintel = look(lintelHeight(side, outside, ground));
        if (!lintel) return false;
        for (const float height : kSills) {
            const auto hit = look(height);
            if (hit && hit->t < lintel->t + kDeep * axes_.metre) return false;
        }
        return true;
    }

    /// In metres: the lowest height above a door at which there is a wall.
    float lintelHeight(const Side& side, Vec3 outside, float ground) const {
        constexpr float kMax = 3.5F, kBetween = 0.2F;
        float best = kDoorHeight, nearest = Box3::kHuge;
        for (float height = kDoorHeight; height <= kMax; height += kBetween) {
            const auto hit = closestHit(tree_, mesh_, outside + axes_.up * (ground + height * axes_.metre),
                                        -side.outwards);
            if (!hit || hit->t >= nearest - 0.1F * axes_.metre) continue;
            nearest = hit->t;
            best = height;
        }
        return best;
    }

    const KdTree& tree_;
    const Mesh& mesh_;
    const Axes& axes_;
    const Box3& box_;
    float lowest_;
};

/// Ground with nothing on it.
bool isLand(const Box3& box, const Axes& axes) {
    constexpr float kFlatLand = 0.2F, kWide = 40;
    const float width = std::max(extentAlong(box, axes.right), extentAlong(box, axes.front));
    return width > kWide * axes.metre && extentAlong(box, axes.up) < kFlatLand * width;
}

/// On the floor below `position`, looking into the direction of `from`, level.
Camera standBelow(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Camera& from, Vec3 position) {
    const auto floor = closestHit(tree, mesh, position, -axes.up);
    Camera camera = from;
    camera.kind = CameraKind::Perspective;
    camera.up = axes.up;
    const Vec3 forward = normalize(from.forward), level = forward - axes.up * dot(forward, axes.up);
    camera.forward = length(level) > 1e-3F ? normalize(level) : axes.front;
    camera.eye = position + axes.up * (kEyeHeight * axes.metre - (floor ? floor->t : 0));
    return camera;
}

/// Where `from` looks, on the land.
Camera standOnLand(const KdTree& tree, const Mesh& mesh, const Survey& survey, const Camera& from) {
    const Vec3 forward = normalize(from.forward);
    const auto seen = closestHit(tree, mesh, from.eye, forward);
    const Vec3 position = seen ? from.eye + forward * seen->t : survey.subject.bounds.centre();
    return standBelow(tree, mesh, survey.axes, from,
                      position + survey.axes.up * survey.subject.bounds.diagonal());
}

} // namespace

bool hoversOutside(const KdTree& tree, const Mesh& mesh, const Survey& survey, Vec3 eye) {
    if (survey.inside() && survey.subject.bounds.contains(eye)) return false;
    constexpr float kHigh = 2.5F; // metres
    const auto floor = closestHit(tree, mesh, eye, -survey.axes.up);
    const float above = dot(eye, survey.axes.up) - rangeAlong(tree.bounds, survey.axes.up).low;
    return (floor ? floor->t : above) > kHigh * survey.axes.metre;
}

bool isTooSmallToWalk(const Survey& survey) {
    constexpr float kLow = 1, kWide = 4; // metres
    const Box3& box = survey.subject.bounds;
    const Axes& axes = survey.axes;
    return extentAlong(box, axes.up) < kLow * axes.metre &&
           std::max(extentAlong(box, axes.right), extentAlong(box, axes.front)) < kWide * axes.metre;
}

std::vector<Camera> doorsteps(const KdTree& tree, const Mesh& mesh, const Survey& survey,
                              const Camera& from) {
    const Box3& box = survey.subject.standing;
    const Axes& axes = survey.axes;
    if (box.empty()) return {};
    if (isLand(box, axes)) return {standOnLand(tree, mesh, survey, from)};
    std::array<Side, 4> sides = sidesOf(box, axes);
    const Vec3 viewer = from.eye - box.centre();
    std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return dot(viewer, a.outwards) > dot(viewer, b.outwards);
    });
    const Approach approach(tree, mesh, survey);
    const float away =
        std::clamp(1.2F * extentAlong(box, axes.up), kNearest * axes.metre, kFarthestStand * axes.metre);
    std::vector<Camera> steps;
    for (const Side& side : sides)
        if (const auto door = approach.doorOf(side)) steps.push_back(approach.standBefore(side, *door, away));
    for (const Side& side : sides) steps.push_back(approach.standBefore(side, side.middle, away));
    // On a floor, if there is one: there, or else below the eye.
    const auto rest = std::stable_partition(steps.begin(), steps.end(),
                                            [&](const Camera& step) { return approach.hasFloor(step); });
    if (rest == steps.begin() && closestHit(tree, mesh, from.eye, -axes.up))
        steps.insert(steps.begin(), standBelow(tree, mesh, axes, from, from.eye));
    return steps;
}

} // namespace rtcore
