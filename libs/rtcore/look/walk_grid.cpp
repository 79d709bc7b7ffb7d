#include "rtcore/look/walk_grid.h"

#include "rtcore/math/constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kDirections = 4;

Camera viewTo(Vec3 eye, Vec3 forward, Vec3 up) {
    Camera camera;
    camera.eye = eye;
    camera.forward = forward;
    camera.up = up;
    camera.horizontalFov = 90;
    return camera;
}

/// But roofs, which lie under the sky and above other floors.
std::vector<Space> floorsAt(const KdTree& tree, const Mesh& mesh, const Axes& axes, Vec3 position) {
    std::vector<Space> spaces = spacesAt(tree, mesh, axes, position);
    if (spaces.size() > 1 && std::isinf(spaces.front().headroom)) spaces.erase(spaces.begin());
    return spaces;
}

/// Eyes of people on all floors. Every other row goes back, so that neighbours follow each other.
std::vector<Vec3> standingEyes(const KdTree& tree, const Mesh& mesh, const Survey& survey) {
    constexpr float kApart = 1.2F;                 ///< metres at least
    constexpr int kMaxSide = 48, kPartsOfSide = 8; ///< of the grid; so many at least
    const Axes& axes = survey.axes;
    const Box3& bounds = survey.subject.bounds;
    const float length = std::max(extentAlong(bounds, axes.right), extentAlong(bounds, axes.front));
    const float apart = std::clamp(kApart * axes.metre, length / kMaxSide, length / kPartsOfSide);
    const Range across = rangeAlong(bounds, axes.right), along = rangeAlong(bounds, axes.front);
    const auto count = [apart](const Range& range) {
        return std::max(1, static_cast<int>(std::ceil((range.high - range.low) / apart)));
    };
    const int columns = count(across), rows = count(along);
    std::vector<Vec3> eyes;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < columns; ++i) {
            const int column = row % 2 == 0 ? i : columns - 1 - i;
            const Vec3 position = axes.right * (across.low + (static_cast<float>(column) + 0.5F) * apart) +
                                  axes.front * (along.low + (static_cast<float>(row) + 0.5F) * apart);
            for (const Space& space : floorsAt(tree, mesh, axes, position))
                if (const auto stand = standIn(tree, mesh, axes, space)) eyes.push_back(stand->eye);
        }
    }
    return eyes;
}

/// As of one who walks around it at some distance.
std::vector<Camera> viewsAround(const Survey& survey) {
    constexpr int kViews = 12;
    constexpr float kDistance = 1.2F, kHeight = 0.4F; ///< diagonals
    const Axes& axes = survey.axes;
    const Vec3 centre = survey.subject.bounds.centre();
    const float diagonal = survey.subject.bounds.diagonal();
    std::vector<Camera> views;
    for (int i = 0; i < kViews; ++i) {
        const Vec3 to =
            axes.horizontal(2 * kPi * static_cast<float>(i) / kViews) * kDistance + axes.up * kHeight;
        views.push_back(viewTo(centre + to * diagonal, -to, axes.up));
    }
    return views;
}

} // namespace

std::vector<Camera> walkGrid(const KdTree& tree, const Mesh& mesh, const Survey& survey, int maxStands) {
    if (survey.subject.bounds.empty()) return {};
    const std::vector<Vec3> eyes = standingEyes(tree, mesh, survey);
    std::vector<Camera> views;
    if (eyes.empty() || !survey.inside()) views = viewsAround(survey);
    const auto max = static_cast<std::size_t>(std::max(maxStands, 1));
    const std::size_t taken = std::min(eyes.size(), max);
    for (std::size_t i = 0; i < taken; ++i) {
        const Vec3 eye = eyes[i * eyes.size() / taken];
        for (int side = 0; side < kDirections; ++side) {
            const Vec3 forward = survey.axes.horizontal(2 * kPi * static_cast<float>(side) / kDirections);
            views.push_back(viewTo(eye, forward, survey.axes.up));
        }
    }
    return views;
}

} // namespace rtcore
