#include "rtcore/survey/survey.h"

#include "rtcore/math/constants.h"
#include "rtcore/survey/closest_hit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace rtcore {

namespace {

constexpr int kAcross = 9; ///< places each way

/// Those of a model that is one room, or few: a building of several storeys, or with a roof above its rooms,
/// is looked at from outside.
std::vector<Stand> roomsIn(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Box3& bounds) {
    constexpr std::size_t kFewestPlaces = 4;
    const float high = 0.5F * extentAlong(bounds, axes.up);
    std::vector<Stand> rooms;
    std::size_t filled = 0, roomy = 0, tall = 0; // places with anything below, with a room, with a high one
    for (const Vec3 place : placesIn(bounds, axes, kAcross)) {
        const std::vector<Space> spaces = spacesAt(tree, mesh, axes, place);
        const std::size_t before = rooms.size();
        bool isTall = false;
        for (const Space& space : spaces) {
            const auto stand = standIn(tree, mesh, axes, space);
            if (!stand || !isIndoors(*stand)) continue;
            rooms.push_back(*stand);
            isTall = isTall || stand->height >= high;
        }
        filled += spaces.empty() ? 0 : 1;
        roomy += rooms.size() > before ? 1 : 0;
        tall += isTall ? 1 : 0;
    }
    if (roomy < kFewestPlaces || 4 * tall < roomy) rooms.clear();
    return rooms;
}

/// The side of the four on which places in the middle are open, if one is.
Vec3 openSideOf(const KdTree& tree, const Mesh& mesh, const Axes& axes, const Box3& bounds) {
    constexpr float kReach = 0.5F; // between the legs of a figure is no stage
    constexpr float kWalled = 0.6F, kEnclosed = 0.96F;
    constexpr int kPlaces = 5, kEnough = 5;
    int indoors = 0, stages = 0;
    Vec3 open;
    const float height = extentAlong(bounds, axes.up);
    for (const Vec3 place : placesIn(bounds, axes, kPlaces)) {
        const auto floor = closestHit(tree, mesh, place, -axes.up);
        if (!floor) continue;
        const Space space{place - axes.up * floor->t, floor->t};
        const Stand stand = lookAround(tree, mesh, axes, space, std::min(0.12F * height, 0.5F * floor->t));
        if (stand.walled < kWalled) continue;
        if (stand.enclosed >= kEnclosed) {
            ++indoors;
        } else if (stand.reach >= kReach) {
            ++stages;
            open += stand.openSide;
        }
    }
    // Things on a stage hide its open side from some positions; a room's door is seen from few.
    if (stages < kEnough || 2 * stages < indoors) return {};
    const float right = dot(open, axes.right), front = dot(open, axes.front);
    return std::fabs(right) > std::fabs(front) ? axes.right * std::copysign(1.0F, right)
                                               : axes.front * std::copysign(1.0F, front);
}

} // namespace

Survey survey(const KdTree& tree, const Mesh& mesh, const Axes& axes) {
    Survey result{axes, {}, {}, {}};
    if (tree.bounds.empty()) return result;
    result.subject = subjectOf(mesh, axes);
    const Box3& bounds = result.subject.bounds;
    if (bounds.empty() || result.subject.ground || !result.subject.domes.empty()) return result;
    result.openSide = openSideOf(tree, mesh, axes, bounds);
    if (result.isStage()) return result;
    result.rooms = roomsIn(tree, mesh, axes, bounds);
    return result;
}

float roomHeight(const KdTree& tree, const Mesh& mesh, Vec3 up) {
    constexpr float kLow = 0.08F; // of the model: no room
    const Axes axes(up);
    std::vector<float> heights;
    std::size_t filled = 0;
    for (const Vec3 place : placesIn(tree.bounds, axes, kAcross)) {
        const std::vector<Space> spaces = spacesAt(tree, mesh, axes, place);
        filled += spaces.empty() ? 0 : 1;
        for (const Space& space : spaces) {
            if (!(space.headroom >= kLow * extentAlong(tree.bounds, up))) continue;
            const bool covered = space.headroom < std::numeric_limits<float>::infinity();
            // A court is as high as its walls.
            const float top = rangeAlong(tree.bounds, up).high - dot(space.floor, up);
            const float height = covered ? space.headroom : top;
            if (!(height > 0)) continue;
            constexpr float kEyes = 0.6F, kWalled = 0.6F, kEnclosed = 0.96F;
            const Stand stand = lookAround(tree, mesh, axes, space, kEyes * height);
            if (stand.walled >= kWalled && stand.enclosed >= kEnclosed) heights.push_back(height);
        }
    }
    if (heights.empty() || 10 * heights.size() < filled) return 0;
    // Half of the space is in higher ones: what is below tables counts little.
    std::sort(heights.begin(), heights.end());
    const double half = std::accumulate(heights.begin(), heights.end(), 0.0) / 2;
    double below = 0;
    for (const float height : heights) {
        below += double{height};
        if (below >= half) return height;
    }
    return heights.back();
}

} // namespace rtcore
