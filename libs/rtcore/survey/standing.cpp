#include "rtcore/survey/standing.h"

#include "rtcore/math/constants.h"
#include "rtcore/survey/closest_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kFarthest = std::numeric_limits<float>::max();

/// Metres: of a person, and of what it stands on.
constexpr float kHeadroom = 1.9F;
constexpr float kShoulders = 0.35F;
constexpr float kBodyHeights[] = {0.4F, 1.0F, kEyeHeight};
constexpr float kKnee = 0.45F;
constexpr float kAround[] = {0.9F, 1.6F};
constexpr float kMinDrop = 0.25F, kMaxDrop = 1.3F; ///< from furniture or a stair to the floor
constexpr int kBodyDirections = 8;

/// How far one can go from `from` before the box ends.
float distanceToBorder(const Box3& box, Vec3 from, Vec3 direction) {
    float nearest = kFarthest;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(direction[axis]) < 1e-6F) continue;
        const float border = direction[axis] > 0 ? box.hi[axis] : box.lo[axis];
        nearest = std::min(nearest, (border - from[axis]) / direction[axis]);
    }
    return nearest;
}

bool hasRoomForBody(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 floor) {
    for (const float height : kBodyHeights) {
        const Vec3 from = floor + axes.up * (height * axes.metre);
        for (int i = 0; i < kBodyDirections; ++i) {
            const Vec3 direction = axes.horizontal(2 * kPi * static_cast<float>(i) / kBodyDirections);
            if (occluded(tree, mesh, {from, 0, direction, kShoulders * axes.metre})) return false;
        }
    }
    return true;
}

/// Whether the floor goes down a little in some directions and then goes on, as beside a table.
bool isRaised(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 floor) {
    const Vec3 knee = floor + axes.up * (kKnee * axes.metre);
    int lower = 0;
    for (int i = 0; i < kBodyDirections; ++i) {
        const Vec3 direction = axes.horizontal(2 * kPi * static_cast<float>(i) / kBodyDirections);
        const auto wall = closestHit(tree, mesh, knee, direction);
        for (const float around : kAround) {
            constexpr float kBefore = 0.95F;
            const float away = std::min(around * axes.metre, wall ? kBefore * wall->t : kFarthest);
            const auto below = closestHit(tree, mesh, knee + direction * away, -axes.up);
            const float drop = below ? below->t / axes.metre - kKnee : kNothing;
            if (drop < kMinDrop || drop > kMaxDrop) continue;
            ++lower;
            break;
        }
    }
    return lower >= 2;
}

} // namespace

std::vector<Space> spacesAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 place) {
    constexpr int kMax = 256;
    const Range height = rangeAlong(tree.bounds, axes.up);
    const float whole = height.high - height.low;
    const float margin = 1e-3F * whole + 1e-3F * axes.metre;
    const Vec3 top = place + axes.up * (height.high + margin - dot(place, axes.up));
    std::vector<Space> spaces;
    float above = -kNothing, from = 0;
    for (int i = 0; i < kMax; ++i) {
        Hit hit;
        if (!intersect(tree, mesh, {top, from, -axes.up, kFarthest}, hit)) break;
        spaces.push_back({top - axes.up * hit.t, hit.t - above});
        above = hit.t;
        const float next = hit.t + 1e-5F * whole;
        from = next > hit.t ? next : std::nextafter(hit.t, kFarthest);
    }
    return spaces;
}

bool Stand::covered() const { return headroom < kNothing; }

Stand lookAround(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Space& space,
                 float eyeHeight) {
    constexpr float kFraction = 1.0F / Stand::kDirections, kUpright = 0.5F;
    Stand stand;
    stand.floor = space.floor;
    stand.headroom = space.headroom;
    stand.eye = space.floor + axes.up * eyeHeight;
    stand.height =
        stand.covered() ? space.headroom : rangeAlong(tree.bounds, axes.up).high - dot(space.floor, axes.up);
    for (int i = 0; i < Stand::kDirections; ++i) {
        const Vec3 direction = axes.horizontal(2 * kPi * static_cast<float>(i) / Stand::kDirections);
        const auto wall = closestHit(tree, mesh, stand.eye, direction);
        stand.free.at(static_cast<std::size_t>(i)) = wall ? wall->t : kNothing;
        if (!wall) {
            stand.openSide += direction;
            continue;
        }
        stand.enclosed += kFraction;
        const Vec3 normal = normalize(mesh.geometricNormal(wall->triangle));
        if (dot(normal, direction) <= 0) {
            stand.walled += kFraction;
            if (std::fabs(dot(normal, axes.up)) < kUpright) stand.steep += kFraction;
        }
        stand.reach += wall->t / distanceToBorder(tree.bounds, stand.eye, direction) * kFraction;
        stand.view += wall->t * kFraction;
    }
    return stand;
}

std::optional<Stand> standIn(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Space& space) {
    if (space.headroom < kHeadroom * axes.metre) return std::nullopt;
    if (!hasRoomForBody(tree, mesh, axes, space.floor)) return std::nullopt;
    if (isRaised(tree, mesh, axes, space.floor)) return std::nullopt;
    return lookAround(tree, mesh, axes, space, kEyeHeight * axes.metre);
}

bool isIndoors(const Stand& stand) {
    constexpr float kWalled = 0.6F;       // inside a body all surfaces face away; in a room a few may
    constexpr float kWithWindows = 0.75F; // some of a room's walls are windows
    constexpr float kCourt = 0.96F;
    return stand.covered() ? stand.walled >= kWalled && stand.enclosed >= kWithWindows
                           : stand.steep >= kWalled && stand.enclosed >= kCourt;
}

bool isIndoors(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 eye) {
    for (const Space& space : spacesAt(tree, mesh, axes, eye)) {
        const float height = dot(eye - space.floor, axes.up);
        if (height > 0 && height < space.headroom)
            return isIndoors(lookAround(tree, mesh, axes, space, height));
    }
    return false;
}

bool isEnclosed(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 eye) {
    constexpr float kMax = 0.7F;
    return !tree.bounds.empty() && lookAround(tree, mesh, axes, {eye, 0}, 0).enclosed >= kMax;
}

std::vector<Vec3> placesIn(const Box3& bounds, const Axes& axes, int n) {
    constexpr float kMiddle = 0.8F;
    const float step = kMiddle / static_cast<float>(n - 1);
    std::vector<Vec3> places;
    for (int i = -n / 2; i <= n / 2; ++i) {
        for (int j = -n / 2; j <= n / 2; ++j)
            places.push_back(bounds.centre() +
                             axes.right * (step * static_cast<float>(i) * extentAlong(bounds, axes.right)) +
                             axes.front * (step * static_cast<float>(j) * extentAlong(bounds, axes.front)));
    }
    return places;
}

} // namespace rtcore
