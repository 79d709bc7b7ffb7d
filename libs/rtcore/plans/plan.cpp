#include "rtcore/plans/plan.h"

#include "rtcore/plans/file_metres.h"
#include "rtcore/plans/flat_areas.h"
#include "rtcore/plans/flat_region.h"
#include "rtcore/plans/seen_edges.h"
#include "rtcore/plans/storeys.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/sections/cut_outlines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace rtcore {

namespace {

/// Upwards, whatever side one looks at.
constexpr float kUpright = 0.999F;

/// From scene units in the plane to metres of the model's file.
class ToMetres {
  public:
    ToMetres(const Scene& scene, const CutPlane& plane) : scale_(exactMetresPerUnit(scene)) {
        const FilePoint& at = scene.origin.at;
        const Vec3d zero = plane.origin + Vec3d{at[0], at[1], at[2]};
        zero_ = {dot(plane.right, zero), dot(plane.up, zero)};
    }
    void operator()(FlatPoint& p) const {
        for (int axis = 0; axis < 2; ++axis) p[axis] = (p[axis] + zero_[axis]) * scale_;
    }
    FlatPoint inPlane(const FlatPoint& p) const {
        return {p[0] / scale_ - zero_[0], p[1] / scale_ - zero_[1]};
    }
    void operator()(FlatLoop& loop) const { std::ranges::for_each(loop, *this); }
    void operator()(FlatLine& line) const {
        (*this)(line.a);
        (*this)(line.b);
    }
    void operator()(RoomArea& room) const {
        (*this)(room.outline);
        std::ranges::for_each(room.islands, *this);
        (*this)(room.label);
        room.area *= scale_ * scale_;
    }

  private:
    double scale_;
    FlatPoint zero_{};
};

void findBounds(Drawing& drawing) {
    bool any = false;
    const auto add = [&](const FlatPoint& p) {
        if (!any) drawing.low = drawing.high = p;
        any = true;
        for (int axis = 0; axis < 2; ++axis) {
            drawing.low[axis] = std::min(drawing.low[axis], p[axis]);
            drawing.high[axis] = std::max(drawing.high[axis], p[axis]);
        }
    };
    for (const auto* loops : {&drawing.solids, &drawing.loops, &drawing.chains})
        for (const FlatLoop& loop : *loops) std::ranges::for_each(loop, add);
    for (const FlatLine& line : drawing.seen) {
        add(line.a);
        add(line.b);
    }
}

SectionPlane onlySection(const Scene& scene) {
    const std::vector<SectionPlane>& planes = scene.sections.planes;
    if (planes.size() != 1)
        throw Refusal(
            say("a drawing of a section needs a scene with just one; this one has {0}", planes.size()));
    return planes[0];
}

SectionPlane inFrontOf(PlanSide side, const Scene& scene, const Box3& bounds) {
    const Vec3 up = scene.up, ahead = std::fabs(up.z) > std::fabs(up.y) ? Vec3{0, 1, 0} : Vec3{0, 0, -1};
    const Vec3 right = cross(ahead, up);
    const Vec3 normal = side == PlanSide::Front  ? -ahead
                        : side == PlanSide::Back ? ahead
                        : side == PlanSide::Left ? -right
                                                 : right;
    return {0.5F * (bounds.lo + bounds.hi) + length(bounds.hi - bounds.lo) * normal, normal};
}

double lowest(const Box3& bounds, Vec3 up) {
    return std::min(double{dot(bounds.lo, up)}, double{dot(bounds.hi, up)});
}

/// From 1; 0 where there are none.
std::size_t storeyOf(const PlanChoice& choice, const std::vector<Storey>& storeys,
                     std::optional<double> eye) {
    if (choice.storey) {
        if (*choice.storey < 1 || static_cast<std::size_t>(*choice.storey) > storeys.size())
            throw Refusal(say("there is no storey {0}; {1} were found, of which 1 is the lowest",
                              *choice.storey, storeys.size()));
        return static_cast<std::size_t>(*choice.storey);
    }
    std::size_t below = 0;
    while (eye && below < storeys.size() && storeys[below].height < *eye) ++below;
    return std::max(below, std::min<std::size_t>(storeys.size(), 1));
}

std::vector<FlatLoop> linesOf(const Drawing& drawing) {
    std::vector<FlatLoop> lines = drawing.chains;
    for (const FlatLoop& loop : drawing.loops) {
        lines.push_back(loop);
        lines.back().push_back(loop.front());
    }
    return lines;
}

} // namespace

ChosenPlan choosePlan(const PlanChoice& choice, const Scene& scene, const Box3& bounds,
                      std::optional<Vec3> eye) {
    if (choice.side == PlanSide::Section) return {.plane = onlySection(scene), .floor = {}};
    if (choice.side != PlanSide::Above) return {.plane = inFrontOf(choice.side, scene, bounds), .floor = {}};
    const std::vector<Storey> storeys = storeysOf(scene);
    ChosenPlan chosen{.plane = {}, .floor = choice.floor, .storeys = storeys.size()};
    if (!chosen.floor) {
        chosen.storey =
            storeyOf(choice, storeys, eye ? std::optional<double>(dot(*eye, scene.up)) : std::nullopt);
        chosen.floor = heightInFile(scene, chosen.storey > 0 ? storeys[chosen.storey - 1].height
                                                             : lowest(bounds, scene.up));
    }
    const double height = heightInScene(scene, *chosen.floor + choice.height);
    const Vec3 middle = 0.5F * (bounds.lo + bounds.hi);
    chosen.plane = {middle + (static_cast<float>(height) - dot(middle, scene.up)) * scene.up, scene.up};
    return chosen;
}

Drawing drawingOf(const Scene& scene, const RayTracer& tracer, ClosedPieces& pieces,
                  const SectionPlane& plane, const PlanOptions& options, const std::atomic<bool>& cancel) {
    const CutPlane cut = cutPlaneOf(plane, tracer.bounds(), scene.up);
    const double metre = 1 / exactMetresPerUnit(scene);
    Drawing drawing;
    std::vector<CutOutline> outlines = cutOutlines(scene.model, scene.hiddenParts, cut, pieces);
    drawing.solids = coveredBy(outlines);
    for (CutOutline& outline : outlines) {
        if (outline.closed) continue;
        std::ranges::move(outline.loops, std::back_inserter(drawing.loops));
        std::ranges::move(outline.chains, std::back_inserter(drawing.chains));
    }
    drawing.seen = seenEdges(scene, tracer, cut, FlatRegion(drawing.solids), options.step * metre, cancel);
    const bool fromAbove = dot(normalize(plane.normal), scene.up) > kUpright;
    if (cancel.load()) return {};
    if (options.rooms && fromAbove)
        drawing.rooms =
            roomsBetween(drawing.solids, linesOf(drawing),
                         {.door = options.door * metre, .window = options.window * metre},
                         {.area = options.smallest * metre * metre, .width = options.narrowest * metre});
    if (fromAbove && scene.sky) drawing.north = double{scene.sky->north} * std::numbers::pi / 180;
    const ToMetres toMetres(scene, cut);
    for (auto* loops : {&drawing.solids, &drawing.loops, &drawing.chains})
        std::ranges::for_each(*loops, toMetres);
    std::ranges::for_each(drawing.seen, toMetres);
    std::ranges::for_each(drawing.rooms, toMetres);
    findBounds(drawing);
    return drawing;
}

Camera planCamera(const Scene& scene, const Box3& bounds, const SectionPlane& plane, const FlatPoint& low,
                  const FlatPoint& high) {
    const CutPlane cut = cutPlaneOf(plane, bounds, scene.up);
    const ToMetres toMetres(scene, cut);
    const FlatPoint from = toMetres.inPlane(low), to = toMetres.inPlane(high);
    constexpr double kAbove = 0.01; // of the model's size: no position of the plane is behind the eye
    const double above = kAbove * double{length(bounds.hi - bounds.lo)};
    const Vec3d eye = cut.point({(from[0] + to[0]) / 2, (from[1] + to[1]) / 2}) + cut.normal * above;
    const auto rounded = [](const Vec3d& v) {
        return Vec3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    Camera camera;
    camera.eye = rounded(eye);
    camera.forward = -rounded(cut.normal);
    camera.up = rounded(cut.up);
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = static_cast<float>(to[0] - from[0]);
    return camera;
}

} // namespace rtcore
