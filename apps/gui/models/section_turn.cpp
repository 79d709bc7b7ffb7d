#include "gui/models/section_turn.h"

#include "rtcore/scene/up_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gui {

namespace {

using rtcore::Vec3d;

constexpr double kTurnStep = std::numbers::pi / 12;
constexpr double kFromItsSide = 0.25; ///< cosine between the axis and the view

double angleBetween(const Vec3d& from, const Vec3d& to, const Vec3d& axis) {
    return std::atan2(dot(cross(from, to), axis), dot(from, to));
}

/// Nothing where the hand is not over the circle's plane.
std::optional<double> turnAround(const SceneImage& image, const TurnCircle& circle, const QPointF& from,
                                 const QPointF& to) {
    const auto start = image.onPlane(circle.middle, circle.axis, from);
    const auto end = image.onPlane(circle.middle, circle.axis, to);
    if (!start || !end) return std::nullopt;
    return angleBetween(*start - circle.middle, *end - circle.middle, circle.axis);
}

double turnAlong(const SceneImage& image, const TurnCircle& circle, const QPointF& from, const QPointF& to) {
    const Vec3d eye = image.towardsEye(circle.middle);
    const Vec3d along = normalize(cross(circle.axis, eye));
    const Vec3d off = image.movedInPlane(circle.middle, from, to) - circle.middle;
    return (dot(circle.held, eye) < 0 ? -1 : 1) * dot(off, along) / circle.radius;
}

} // namespace

TurnAxes turnAxesOf(const Vec3d& normal, const Vec3d& up) {
    constexpr double kLevel = 1e-4;
    Vec3d level = cross(up, normal);
    if (length(level) < kLevel) {
        const rtcore::Vec3 axis{static_cast<float>(up.x), static_cast<float>(up.y), static_cast<float>(up.z)};
        level = exactOf(rtcore::rightOf(axis));
        level = level - normal * dot(level, normal);
    }
    level = normalize(level);
    return {level, cross(normal, level)};
}

Vec3d turned(const Vec3d& direction, const Vec3d& axis, double radians) {
    const double along = dot(axis, direction), cosine = std::cos(radians);
    return direction * cosine + cross(axis, direction) * std::sin(radians) + axis * (along * (1 - cosine));
}

double inTurnSteps(const Vec3d& normal, const Vec3d& axis, double radians) {
    int across = 0; // the axis of the scene that is most across
    for (int i = 1; i < 3; ++i)
        if (std::fabs(axis[i]) < std::fabs(axis[across])) across = i;
    Vec3d zero{};
    zero[across] = 1;
    const double start = angleBetween(zero - axis * axis[across], normal, axis);
    return std::round((start + radians) / kTurnStep) * kTurnStep - start;
}

bool isBox(const rtcore::SectionPlanes& sections) {
    if (sections.planes.size() != 6) return false;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const auto faces = [&](const rtcore::SectionPlane& plane) {
                return normalize(exactOf(plane.normal))[axis] * sign == 1;
            };
            if (std::ranges::none_of(sections.planes, faces)) return false;
        }
    return true;
}

double turnLed(const SceneImage& image, const TurnCircle& circle, const QPointF& from, const QPointF& to,
               double before) {
    const Vec3d eye = image.towardsEye(circle.middle);
    if (std::fabs(dot(circle.axis, eye)) < kFromItsSide) return turnAlong(image, circle, from, to);
    const auto around = turnAround(image, circle, from, to);
    return around ? before + std::remainder(*around - before, 2 * std::numbers::pi) : before;
}

} // namespace gui
