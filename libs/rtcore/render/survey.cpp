#include "rtcore/render/survey.h"

#include "rtcore/kernels/single_ray.h"
#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr int kDirections = 32;
constexpr float kWalled = 0.6F; // inside a body all surfaces face away; in a room a few may

/// How far one can go from `from` before the box ends.
float distanceToBorder(const Box3& box, Vec3 from, Vec3 direction) {
    float nearest = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(direction[axis]) < 1e-6F) continue;
        const float border = direction[axis] > 0 ? box.hi[axis] : box.lo[axis];
        nearest = std::min(nearest, (border - from[axis]) / direction[axis]);
    }
    return nearest;
}

std::optional<Hit> hitFrom(const KdTree& tree, const Mesh& mesh, Vec3 from, Vec3 direction) {
    Hit hit;
    if (!intersect(tree, mesh, {from, 0, direction, std::numeric_limits<float>::max()}, hit))
        return std::nullopt;
    return hit;
}

} // namespace

Axes::Axes(Vec3 upwards) : up(upwards) {
    // What a viewer of the usual +Y models calls front is +Z; other up axes follow by turning the model.
    right = std::fabs(up.x) < 0.5F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    front = cross(right, up);
}

Vec3 Axes::horizontal(float angle) const { return right * portableCos(angle) + front * portableSin(angle); }

float extentAlong(const Box3& box, Vec3 axis) { return std::fabs(dot(box.size(), axis)); }

std::optional<Stand> standAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 place) {
    const auto floor = hitFrom(tree, mesh, place, -axes.up);
    if (!floor) return std::nullopt;
    Stand stand;
    const float height = extentAlong(tree.bounds, axes.up);
    stand.eye = place - axes.up * (floor->t - std::min(0.12F * height, 0.5F * floor->t));
    constexpr float kShare = 1.0F / kDirections;
    float longest = 0;
    for (int i = 0; i < kDirections; ++i) {
        const Vec3 direction = axes.horizontal(2 * kPi * static_cast<float>(i) / kDirections);
        const auto wall = hitFrom(tree, mesh, stand.eye, direction);
        if (!wall) {
            stand.openSide += direction;
            continue;
        }
        stand.enclosed += kShare;
        if (dot(mesh.geometricNormal(wall->triangle), direction) <= 0) stand.walled += kShare;
        stand.reach += wall->t / distanceToBorder(tree.bounds, stand.eye, direction) * kShare;
        stand.view += wall->t * kShare;
        if (wall->t > longest) {
            longest = wall->t;
            stand.longestView = direction;
        }
    }
    return stand;
}

bool isIndoors(const Stand& stand) {
    constexpr float kEnclosed = 0.96F;
    return stand.walled >= kWalled && stand.enclosed >= kEnclosed;
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

Survey survey(const KdTree& tree, const Mesh& mesh, const Axes& axes) {
    constexpr float kReach = 0.5F; // between the legs of a figure is no stage
    std::optional<Stand> widest;
    int indoors = 0;
    int stages = 0;
    Vec3 open;
    for (const Vec3 place : placesIn(tree.bounds, axes, 5)) {
        const auto stand = standAt(tree, mesh, axes, place);
        if (!stand || stand->walled < kWalled) continue;
        if (isIndoors(*stand)) {
            ++indoors;
            if (!widest || stand->view > widest->view) widest = stand;
        } else if (stand->reach >= kReach) {
            ++stages;
            open += stand->openSide;
        }
    }
    constexpr int kEnough = 5;
    Survey result;
    // What stands on a stage hides its open side from some places; a room's door is seen from few.
    const bool stage = stages >= kEnough && 2 * stages >= indoors;
    if (indoors >= kEnough && !stage) result.indoors = widest;
    if (stage) {
        // The nearest of the four sides.
        const float right = dot(open, axes.right);
        const float front = dot(open, axes.front);
        result.openSide = std::fabs(right) > std::fabs(front) ? axes.right * std::copysign(1.0F, right)
                                                              : axes.front * std::copysign(1.0F, front);
    }
    return result;
}

} // namespace rtcore
