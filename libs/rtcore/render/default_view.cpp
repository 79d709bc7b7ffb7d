#include "rtcore/render/default_view.h"

#include "rtcore/kernels/single_ray.h"
#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace rtcore {

namespace {

constexpr float kTwoPi = 6.28318530718F;
constexpr float kInteriorFov = 75;
constexpr float kExteriorFov = 45;
constexpr int kDirections = 32;

/// The horizontal axes of a model and the one that goes up.
struct Axes {
    explicit Axes(Vec3 upwards) : up(upwards) {
        // What a viewer of the usual +Y models calls front is +Z; other up axes follow by turning the model.
        right = std::fabs(up.x) < 0.5F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        front = cross(right, up);
    }
    Vec3 up, right, front;

    Vec3 horizontal(int i) const {
        const float angle = kTwoPi * static_cast<float>(i) / kDirections;
        return right * portableCos(angle) + front * portableSin(angle);
    }
};

float extentAlong(const Box3& box, Vec3 axis) { return std::fabs(dot(box.size(), axis)); }

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

/// A place to stand on, and what can be seen from it.
struct Stand {
    Vec3 eye;
    float enclosed = 0; ///< fraction of horizontal directions that end at a surface
    float walled = 0;   ///< fraction of horizontal directions that end at the front of one
    float reach = 0;    ///< mean fraction of the distance to the border of the model that is free
    float view = 0;     ///< mean distance to what is seen
    Vec3 longestView;
    Vec3 openSide; ///< sum of the directions that end nowhere
};

std::optional<Hit> look(const KdTree& tree, const Mesh& mesh, Vec3 from, Vec3 direction) {
    Hit hit;
    if (!intersect(tree, mesh, {from, 0, direction, std::numeric_limits<float>::max()}, hit))
        return std::nullopt;
    return hit;
}

std::optional<Stand> standAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 middle) {
    const auto floor = look(tree, mesh, middle, -axes.up);
    if (!floor) return std::nullopt;
    Stand stand;
    const float height = extentAlong(tree.bounds, axes.up);
    stand.eye = middle - axes.up * (floor->t - std::min(0.12F * height, 0.5F * floor->t));
    constexpr float kShare = 1.0F / kDirections;
    float longest = 0;
    for (int i = 0; i < kDirections; ++i) {
        const Vec3 direction = axes.horizontal(i);
        const auto wall = look(tree, mesh, stand.eye, direction);
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

/// What 5 x 5 places in the middle of the model tell of it.
struct Survey {
    std::optional<Stand> indoors; ///< the widest place with walls all around, when there are several such
    Vec3 openSide;                ///< the one side on which a stage is open, else zero
};

Survey survey(const KdTree& tree, const Mesh& mesh, const Axes& axes) {
    constexpr float kEnclosed = 0.96F;
    constexpr float kWalled = 0.6F; // inside a body all surfaces face away; in a room a few may
    constexpr float kReach = 0.5F;  // between the legs of a figure is no stage
    std::optional<Stand> widest;
    int indoors = 0;
    int stages = 0;
    Vec3 open;
    const Vec3 centre = tree.bounds.centre();
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            const Vec3 place =
                centre + axes.right * (0.2F * static_cast<float>(i) * extentAlong(tree.bounds, axes.right)) +
                axes.front * (0.2F * static_cast<float>(j) * extentAlong(tree.bounds, axes.front));
            const auto stand = standAt(tree, mesh, axes, place);
            if (!stand || stand->walled < kWalled) continue;
            if (stand->enclosed < kEnclosed) {
                if (stand->reach < kReach) continue;
                ++stages;
                open += stand->openSide;
                continue;
            }
            ++indoors;
            if (!widest || stand->view > widest->view) widest = stand;
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

/// Looks along `forward` from so far that everything is in the image, also in one of 16:9.
Camera frameAll(const Mesh& mesh, const Box3& bounds, Vec3 forward, Vec3 upwards) {
    Camera camera;
    camera.horizontalFov = kExteriorFov;
    camera.up = upwards;
    camera.forward = forward;
    const Vec3 right = normalize(cross(forward, upwards));
    const Vec3 up = cross(right, forward);
    const float half = kExteriorFov * 0.5F * kTwoPi / 360;
    const float across = portableSin(half) / portableCos(half) * 0.95F;
    const float vertical = across * 9 / 16;

    // The middle of what is seen, then the distance at which its farthest corner still fits.
    Box3 seen;
    const auto project = [&](const Vertex& v) {
        const Vec3 p = v.position() - bounds.centre();
        return Vec3{dot(p, right), dot(p, up), dot(p, forward)};
    };
    constexpr std::size_t kSamples = 50'000;
    const std::size_t step = std::max<std::size_t>(1, mesh.vertices.size() / kSamples);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) seen.extend(project(mesh.vertices[i]));
    const Vec3 middle = seen.centre();
    float distance = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) {
        const Vec3 p = project(mesh.vertices[i]) - middle;
        distance = std::max({distance, std::fabs(p.x) / across - p.z, std::fabs(p.y) / vertical - p.z});
    }
    const Vec3 target = bounds.centre() + right * middle.x + up * middle.y + forward * middle.z;
    camera.eye = target - forward * (distance > 0 ? distance : 1.0F);
    return camera;
}

} // namespace

Camera defaultCamera(const KdTree& tree, const Mesh& mesh, Vec3 up) {
    const Axes axes(up);
    if (tree.bounds.empty()) return {};
    const Survey found = survey(tree, mesh, axes);
    if (found.indoors) {
        Camera camera;
        camera.eye = found.indoors->eye;
        camera.forward = found.indoors->longestView;
        camera.up = up;
        camera.horizontalFov = kInteriorFov;
        return camera;
    }
    const Vec3 from =
        found.openSide == Vec3{} ? axes.front + axes.right * 0.45F + axes.up * 0.35F : found.openSide;
    return frameAll(mesh, tree.bounds, -normalize(from), up);
}

bool isInterior(const KdTree& tree, const Mesh& mesh, Vec3 up) {
    return !tree.bounds.empty() && survey(tree, mesh, Axes(up)).indoors.has_value();
}

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
