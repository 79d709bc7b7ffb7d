#include "rtserver/document/light_grid.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/sections/closed_pieces.h"
#include "rtcore/settings/number_text.h"
#include "rtcore/survey/axes.h"
#include "rtcore/survey/subject.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rtserver {

namespace {

using rtcore::Axes;
using rtcore::Vec3;
using rtcore::WhitePoint;

constexpr float kFloorStep = 0.3F; ///< metres by which floors of one storey differ
constexpr double kMaxPlaces = 250'000;
constexpr std::size_t kMaxPoints = 20'000;
constexpr std::size_t kAtOnce = 32; ///< points between two words of progress
constexpr rtcore::ProbeEffort kEffort{.relativeError = 0.02, .paths = 1U << 15};

/// What a ray from a place meets.
struct Met {
    bool any = false;
    float distance = 0;
    bool behind = false;     ///< the surface is seen from its back
    bool fromInside = false; ///< it bounds a solid that the place is in
};

/// The pieces of the model that are closed, so that they have an inside.
class Solids {
  public:
    explicit Solids(const rtcore::Model& model) : triangles_(model.mesh.triangles.size()), pieces_(model) {}

    bool bounds(std::uint32_t triangle) {
        if (triangle >= triangles_) return false; // of the sky's ground
        const auto& ranges = pieces_.ranges();
        const auto behind = std::ranges::upper_bound(ranges, triangle, {}, &rtcore::PartRange::firstTriangle);
        const auto range = static_cast<std::size_t>(behind - ranges.begin()) - 1;
        return pieces_.of(range)[triangle - ranges[range].firstTriangle] != 0;
    }

  private:
    std::size_t triangles_;
    rtcore::ClosedPieces pieces_;
};

/// Sections take no floor away where light does not know of them.
std::vector<Met> lookAlong(const MeasuredScene& in, std::span<const Vec3> places, Vec3 direction,
                           Solids& solids) {
    rtcore::RayWave rays;
    rtcore::HitWave hits;
    for (const Vec3 place : places) rays.push({place, 0, direction, std::numeric_limits<float>::max()});
    in.tracer->intersect(rtcore::RayKind::Scattered, rays, hits);
    std::vector<Met> met(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!hits.isHit(i)) continue;
        const std::uint32_t triangle = hits.triangle[i];
        const bool behind = dot(in.scene->mesh().geometricNormal(triangle), direction) > 0;
        met[i] = {true, hits.t[i], behind, behind && solids.bounds(triangle)};
    }
    return met;
}

/// What lies around places. A wall that stands between two floors shares planes with them, so that rays
/// upwards and downwards may meet these in its place. In walls that are not closed all level rays meet backs.
struct Around {
    std::vector<Met> below, above;
    std::vector<int> insides; ///< of six directions: in how many a solid is left
    std::vector<int> backs;   ///< of the four level ones: in how many a back is seen

    Around(const MeasuredScene& in, std::span<const Vec3> places, const Axes& axes, Solids& solids)
        : below(lookAlong(in, places, -axes.up, solids)), above(lookAlong(in, places, axes.up, solids)),
          insides(places.size()), backs(places.size()) {
        count(below);
        count(above);
        for (const Vec3 level : {axes.right, -axes.right, axes.front, -axes.front}) {
            const std::vector<Met> met = lookAlong(in, places, level, solids);
            count(met);
            for (std::size_t i = 0; i < met.size(); ++i) backs[i] += met[i].behind ? 1 : 0;
        }
    }
    bool inSolid(std::size_t i) const { return insides[i] >= 2 || backs[i] == 4; }

  private:
    void count(const std::vector<Met>& met) {
        for (std::size_t i = 0; i < met.size(); ++i) insides[i] += met[i].fromInside ? 1 : 0;
    }
};

std::size_t countAlong(float extent, float spacing) {
    return std::max(std::size_t{1}, static_cast<std::size_t>(extent / spacing));
}

/// All places of the grid.
std::vector<Vec3> placesOf(const rtcore::Box3& bounds, const Axes& axes, float height, double spacing) {
    const auto step = static_cast<float>(spacing) * axes.metre;
    const float across = extentAlong(bounds, axes.right), along = extentAlong(bounds, axes.front);
    if (double{across / step} * double{along / step} > kMaxPlaces)
        throw rtcore::Refusal(
            rtcore::say("the grid would have more than {0} points; give a larger SPACING", kMaxPoints));
    const std::size_t columns = countAlong(across, step), rows = countAlong(along, step);
    const Vec3 centre = bounds.centre();
    const Vec3 middle = centre + axes.up * (height - dot(centre, axes.up));
    const auto offset = [&](std::size_t i, std::size_t count) {
        return (static_cast<float>(i) - 0.5F * static_cast<float>(count - 1)) * step;
    };
    std::vector<Vec3> places;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            places.push_back(middle + axes.right * offset(column, columns) + axes.front * offset(row, rows));
    }
    return places;
}

} // namespace

std::vector<WhitePoint> gridPoints(const MeasuredScene& measured, const GridRequest& request) {
    const rtcore::Scene& scene = *measured.scene;
    const Axes axes = axesOf(scene);
    Solids solids(scene.model);
    const Around eye(measured, {&request.eye, 1}, axes, solids);
    if (!eye.below[0].any) throw rtcore::Refusal("there is no floor below the viewpoint");
    const float over = static_cast<float>(request.height) * axes.metre;
    const float height = dot(request.eye, axes.up) - eye.below[0].distance + over;
    const rtcore::Box3 bounds = subjectOf(scene.model.mesh, axes).standing;
    const std::vector<Vec3> places = placesOf(bounds, axes, height, request.spacing);
    const Around around(measured, places, axes, solids);
    std::vector<WhitePoint> points;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Met &below = around.below[i], &above = around.above[i];
        const bool floor = below.any && below.distance <= over + kFloorStep * axes.metre;
        const bool outside = eye.above[0].any && !above.any;
        const bool solid = around.inSolid(i) && !eye.inSolid(0);
        if (floor && !outside && !solid) points.push_back({places[i], axes.up});
    }
    if (points.empty()) throw rtcore::Refusal("no point of the grid lies over the floor below the viewpoint");
    if (points.size() > kMaxPoints)
        throw rtcore::Refusal(
            rtcore::say("the grid would have more than {0} points; give a larger SPACING", kMaxPoints));
    return points;
}

std::vector<rtcore::MeasuredLight> measureGrid(Photometer& photometer, std::span<const WhitePoint> points,
                                               Measuring& measuring) {
    std::vector<rtcore::MeasuredLight> all;
    while (all.size() < points.size()) {
        const std::size_t count = std::min(kAtOnce, points.size() - all.size());
        const auto some =
            photometer.illuminance(points.subspan(all.size(), count), kEffort, measuring.control);
        all.insert(all.end(), some.begin(), some.end());
        measuring.fraction = static_cast<double>(all.size()) / static_cast<double>(points.size());
    }
    return all;
}

std::string gridTable(std::span<const WhitePoint> points, std::span<const rtcore::MeasuredLight> light,
                      const rtcore::Scene& scene) {
    std::string text = "x,y,z,lux,standard_error\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i].position;
        for (int axis = 0; axis < 3; ++axis)
            text += (scene.origin.isZero()
                         ? rtcore::shortestText(p[axis])
                         : rtcore::shortestText(scene.origin.inFile(p)[static_cast<std::size_t>(axis)])) +
                    ',';
        text += rtcore::shortestText(static_cast<float>(light[i].luminance)) + ',' +
                rtcore::shortestText(static_cast<float>(light[i].error)) + '\n';
    }
    return text;
}

std::string gridText(std::span<const rtcore::MeasuredLight> light) {
    double sum = 0, min = std::numeric_limits<double>::max(), max = 0;
    for (const rtcore::MeasuredLight& each : light) {
        sum += each.luminance;
        min = std::min(min, each.luminance);
        max = std::max(max, each.luminance);
    }
    const double mean = sum / static_cast<double>(light.size());
    const auto lux = [](double value) { return fmt::format("{:.{}f} lx", value, value < 10 ? 2 : 0); };
    return fmt::format("{} points, mean {}, min {}, max {}, uniformity {:.2f}", light.size(), lux(mean),
                       lux(min), lux(max), mean > 0 ? min / mean : 0);
}

} // namespace rtserver
