#include "rtcore/gathering/light_difference.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

/// Of the channel that differs most, as a part of the larger light.
float differenceOf(Colour before, Colour now) {
    const float light = std::max(maxComponent(before), maxComponent(now));
    const float largest =
        std::max({std::fabs(now.r - before.r), std::fabs(now.g - before.g), std::fabs(now.b - before.b)});
    return light > 0 ? std::min(largest / light, 1.0F) : 0.0F;
}

float ratioOf(float before, float now) { return before > 0 && now > 0 ? now / before : 1; }

/// Nothing is told of what lies behind walls.
bool isBeforeWalls(const IrradianceRecord& record, Vec3 point) {
    return std::ranges::all_of(record.walls, [&](const RecordWall& wall) { return wall.isBefore(point); });
}

constexpr float kMinCosine = 0.7F; ///< of surfaces that face the same way

/// Whether what is told of a record holds for another one, too.
struct AlikeTo {
    const IrradianceRecord& record;

    bool operator()(const IrradianceRecord& other) const {
        return dot(other.normal, record.normal) > kMinCosine && isBeforeWalls(other, record.position) &&
               isBeforeWalls(record, other.position);
    }
};

} // namespace

void LightDifference::Sum::add(const Passed& passed) {
    difference += passed.difference;
    count += 1;
    if (passed.record.confidence > 0) known += passed.record.irradiance;
    before += passed.before;
    now += passed.now;
    pathsBefore += passed.pathsBefore;
    pathsNow += passed.pathsNow;
}

/// Whether rays met the light that is known to be there, or any.
bool LightDifference::Sum::tellsEnough() const {
    constexpr float kPart = 0.5F, kForDarkness = 64;
    const float found = luminance(before) + luminance(now);
    return found >= kPart * luminance(known) && (found > 0 || count >= kForDarkness);
}

/// Cells that know little leak, and paths are few: the one may miss what the other tells.
float LightDifference::Sum::mean() const {
    return std::max(difference / count, differenceOf(pathsBefore, pathsNow));
}

void LightDifference::begin(const Box3& bounds) {
    before_.clear(bounds);
    now_.clear(bounds);
    passed_.clear();
    parts_.clear();
}

bool LightDifference::passBefore(const GatherTask& task, std::span<const GatherPass> passes,
                                 PassGatherer& gatherer) {
    return gather(task, passes, gatherer, before_, were_);
}

bool LightDifference::passNow(const GatherTask& task, std::span<const GatherPass> passes,
                              PassGatherer& gatherer, OutgoingCells& cells) {
    Rays are;
    if (!gather(task, passes, gatherer, cells, are)) return false;
    parts_.push_back({{passes.begin(), passes.end()}, std::move(were_), std::move(are)});
    return true;
}

/// Only now, since cells know little at first.
void LightDifference::finish(const GatherTask& before, const GatherTask& now, const IrradianceCache& cache,
                             PassGatherer& gatherer, const OutgoingCells& cells) {
    now_ = cells;
    for (Part& part : parts_) {
        gatherer.sumUp(before, part.passes, std::move(part.before.hits), before_);
        std::vector<Colour> were;
        for (const PassResult& result : gatherer.results()) were.push_back(result.light.irradiance);
        gatherer.sumUp(now, part.passes, std::move(part.now.hits), now_);
        for (std::size_t i = 0; i < part.passes.size(); ++i) {
            const Colour is = gatherer.results()[i].light.irradiance;
            passed_.push_back({cache.record(part.passes[i].record), were[i], is, part.before.byPaths[i],
                               part.now.byPaths[i], differenceOf(were[i], is)});
        }
    }
    parts_.clear();
    order(0, passed_.size(), 0);
    forEachPart(passed_.size(), threadsFor(now.threads),
                [&](std::size_t i) { passed_[i].around = differenceAround(passed_[i].record); });
}

bool LightDifference::gather(const GatherTask& task, std::span<const GatherPass> passes,
                             PassGatherer& gatherer, OutgoingCells& cells, Rays& found) {
    constexpr std::size_t kStep = 4; // of the rays
    if (!gatherer.gatherEvenly(task, passes, kStep, cells)) return false;
    found.hits = gatherer.hits();
    found.byPaths.assign(passes.size(), {});
    const std::span<const std::uint32_t> rays = gatherer.paths().chosen();
    for (std::size_t i = 0; i < rays.size(); ++i)
        found.byPaths[rays[i] / kPassRays] += gatherer.paths().radiance()[i];
    return true;
}

void LightDifference::order(std::size_t first, std::size_t last, int axis) {
    if (last - first < 2) return;
    const auto at = [&](std::size_t i) { return passed_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(at(first), at(middle), at(last), [&](const Passed& a, const Passed& b) {
        return a.record.position[axis] < b.record.position[axis];
    });
    order(first, middle, (axis + 1) % 3);
    order(middle + 1, last, (axis + 1) % 3);
}

/// Keeps those of the range that suit and are nearer than those that are known, ascending.
template <typename Suits>
void LightDifference::findNearest(Vec3 point, std::size_t first, std::size_t last, int axis,
                                  const Suits& suits, std::vector<std::pair<float, std::uint32_t>>& nearest,
                                  std::size_t wanted) const {
    if (first == last) return;
    const std::size_t middle = first + (last - first) / 2;
    const IrradianceRecord& record = passed_[middle].record;
    const Vec3 apart = point - record.position;
    const std::pair entry{dot(apart, apart), static_cast<std::uint32_t>(middle)};
    if ((nearest.size() < wanted || entry < nearest.back()) && suits(record)) {
        if (nearest.size() == wanted) nearest.pop_back();
        nearest.insert(std::ranges::upper_bound(nearest, entry), entry);
    }
    const float across = apart[axis];
    const bool lower = across < 0;
    const int next = (axis + 1) % 3;
    findNearest(point, lower ? first : middle + 1, lower ? middle : last, next, suits, nearest, wanted);
    if (nearest.size() == wanted && across * across > nearest.back().first) return;
    findNearest(point, lower ? middle + 1 : first, lower ? last : middle, next, suits, nearest, wanted);
}

template <typename Suits, typename Use>
void LightDifference::forNearest(Vec3 point, std::size_t wanted, const Suits& suits, Use&& use) const {
    thread_local std::vector<std::pair<float, std::uint32_t>> nearest;
    nearest.clear();
    findNearest(point, 0, passed_.size(), 0, suits, nearest, wanted);
    for (const auto& [square, number] : nearest) use(passed_[number]);
}

/// By as few records as tell enough: light that comes from far, or by a small bright spot, is met by few
/// rays.
float LightDifference::differenceAround(const IrradianceRecord& record) const {
    for (const std::size_t wanted : {4U, 16U, 64U, 256U}) {
        Sum sum;
        forNearest(record.position, wanted, AlikeTo{record}, [&](const Passed& passed) { sum.add(passed); });
        if (sum.tellsEnough()) return sum.mean();
        if (sum.count < static_cast<float>(wanted)) break;
    }
    return 1;
}

template <typename Suits>
float LightDifference::meanOfNearest(Vec3 point, const Suits& suits) const {
    constexpr std::size_t kNear = 4;
    float sum = 0, count = 0;
    forNearest(point, kNear, suits, [&](const Passed& passed) {
        sum += passed.around;
        ++count;
    });
    return count > 0 ? sum / count : 1;
}

LightDifference::Arriving LightDifference::arrivingAt(const IrradianceRecord& record) const {
    constexpr std::size_t kForRatio = 16;
    const AlikeTo suits{record};
    Sum sum;
    forNearest(record.position, kForRatio, suits, [&](const Passed& passed) { sum.add(passed); });
    return {meanOfNearest(record.position, suits),
            {ratioOf(sum.before.r, sum.now.r), ratioOf(sum.before.g, sum.now.g),
             ratioOf(sum.before.b, sum.now.b)}};
}

float LightDifference::leaving(const OutgoingCells::Site& site) const {
    constexpr std::uint32_t kEnough = 64; // samples
    const OutgoingCells::Cell *const before = before_.cellOf(site, kEnough), *const now =
                                                                                 now_.cellOf(site, kEnough);
    if (before == nullptr || now == nullptr) return 1;
    const float ofPaths = differenceOf(before->sum / static_cast<float>(before->count),
                                       now->sum / static_cast<float>(now->count));
    const auto suits = [&](const IrradianceRecord& other) {
        return dot(other.normal, site.normal) > kMinCosine && isBeforeWalls(other, site.point);
    };
    return std::max(ofPaths, meanOfNearest(site.point, suits));
}

} // namespace rtcore
