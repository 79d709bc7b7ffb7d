#include "rtserver/document/storey_outlines.h"

#include "common/commands/outline_text.h"

#include "rtcore/plans/level_outline.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/survey/standing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rtserver {

namespace {

using app::ToldOutline;
using rtcore::FlatLoop;
using rtcore::LevelOutline;

constexpr double kSteps = 2000; ///< of the larger side: more than a small plan has pixels

/// Of a line, simplified to so many steps.
ToldOutline::Line toldLine(const FlatLoop& line, const LevelOutline& of, double step, double tolerance) {
    ToldOutline::Line told;
    for (const rtcore::FlatPoint& p : rtcore::simplified(line, tolerance * step)) {
        const std::array<int, 2> at{static_cast<int>(std::lround((p[0] - of.low[0]) / step)),
                                    static_cast<int>(std::lround((p[1] - of.low[1]) / step))};
        if (told.empty() || told.back() != at) told.push_back(at);
    }
    return told;
}

std::vector<ToldOutline::Line> toldLines(const std::vector<FlatLoop>& lines, const LevelOutline& of,
                                         double step, double tolerance) {
    std::vector<ToldOutline::Line> told;
    for (const FlatLoop& line : lines) {
        ToldOutline::Line each = toldLine(line, of, step, tolerance);
        if (each.size() > 1) told.push_back(std::move(each));
    }
    return told;
}

double heightOf(const rtcore::Scene& scene, double height) {
    const rtcore::FilePoint& zero = scene.origin.at;
    const rtcore::Vec3 up = scene.up;
    return height + zero[0] * double{up.x} + zero[1] * double{up.y} + zero[2] * double{up.z};
}

std::array<float, 3> numbersOf(const rtcore::Vec3d& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// All but the lines.
ToldOutline frameOf(const rtcore::Scene& scene, const std::vector<rtcore::Storey>& storeys, int storey,
                    const LevelOutline& outline, const rtcore::Box3& bounds) {
    ToldOutline told{.storey = storey};
    for (const rtcore::Storey& each : storeys) told.floors.push_back(heightOf(scene, each.height));
    const double low = double{dot(bounds.lo, scene.up)}, high = double{dot(bounds.hi, scene.up)};
    told.top = heightOf(scene, std::max(low, high));
    if (storey > 0) told.eyeHeight = double{rtcore::kEyeHeight} / double{scene.metresPerUnit};
    const double floor =
        storey > 0 ? storeys[static_cast<std::size_t>(storey - 1)].height : std::min(low, high);
    const rtcore::Vec3d corner = outline.plane.point(outline.low);
    const rtcore::Vec3d up = rtcore::exact(scene.up), at = corner + up * (floor - dot(corner, up));
    told.corner = {at.x + scene.origin.at[0], at.y + scene.origin.at[1], at.z + scene.origin.at[2]};
    told.right = numbersOf(outline.plane.right);
    told.ahead = numbersOf(outline.plane.up);
    told.up = numbersOf(up);
    const double width = outline.high[0] - outline.low[0], height = outline.high[1] - outline.low[1];
    if (const double larger = std::max(width, height); larger > 0) told.step = larger / kSteps;
    told.size = {static_cast<int>(std::lround(width / told.step)),
                 static_cast<int>(std::lround(height / told.step))};
    return told;
}

std::string textOf(ToldOutline told, const LevelOutline& outline, std::size_t maxBytes) {
    constexpr double kFinest = 0.5; // steps
    for (double tolerance = kFinest;; tolerance *= 2) {
        told.solids = toldLines(outline.solids, outline, told.step, tolerance);
        told.lines = toldLines(outline.lines, outline, told.step, tolerance);
        told.light = toldLines(outline.light, outline, told.step, tolerance);
        std::string text = formatOutline(told);
        if (text.size() <= maxBytes || tolerance > kSteps) return text;
    }
}

} // namespace

void StoreyOutlines::begin(const Order& order) {
    const rtcore::Scene& scene = *order.scene;
    const bool same = storage_.lock() == scene.model.storage && hidden_ == scene.hiddenParts &&
                      up_ == scene.up && metresPerUnit_ == scene.metresPerUnit;
    if (same) return;
    texts_.clear();
    storeys_ = rtcore::storeysOf(scene);
    storage_ = scene.model.storage;
    hidden_ = scene.hiddenParts;
    up_ = scene.up;
    metresPerUnit_ = scene.metresPerUnit;
}

std::string StoreyOutlines::make(const Order& order, int storey, const std::atomic<bool>& cancel) {
    const rtcore::Scene& scene = *order.scene;
    rtcore::ClosedPieces pieces(scene.model);
    const LevelOutline outline =
        storey > 0
            ? rtcore::outlineOfStorey(scene, order.bounds,
                                      storeys_[static_cast<std::size_t>(storey - 1)].height, pieces, cancel)
            : rtcore::contourLines(scene, order.bounds, pieces, cancel);
    return textOf(frameOf(scene, storeys_, storey, outline, order.bounds), outline, order.maxBytes);
}

std::string StoreyOutlines::text(const Order& order, const std::atomic<bool>& cancel) {
    const std::scoped_lock lock(mutex_);
    begin(order);
    if (order.storey && static_cast<std::size_t>(*order.storey) > storeys_.size())
        throw rtcore::Refusal(rtcore::say("there is no storey {0}; {1} were found, of which 1 is the lowest",
                                          *order.storey, storeys_.size()));
    std::vector<double> floors;
    for (const rtcore::Storey& storey : storeys_) floors.push_back(storey.height);
    const rtcore::Vec3 up = order.scene->up;
    const double top = double{std::max(dot(order.bounds.lo, up), dot(order.bounds.hi, up))};
    const int storey = order.storey.value_or(app::storeyAt(floors, top, double{dot(order.eye, up)}));
    if (!texts_.contains(storey)) {
        std::string made = make(order, storey, cancel);
        if (cancel.load()) throw rtcore::Refusal("the outline was given up");
        texts_[storey] = std::move(made);
    }
    return texts_[storey];
}

} // namespace rtserver
