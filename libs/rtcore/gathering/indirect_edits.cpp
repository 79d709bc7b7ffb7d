#include "rtcore/gathering/changed_surfaces.h"
#include "rtcore/gathering/indirect_light.h"
#include "rtcore/gathering/light_difference.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"
#include "rtcore/scene/part_list.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr float kAnotherLight = 0.1F; ///< by such a difference what was known of it is of no use

/// Calls `use` with each number below `count`, in several threads.
template <typename Use>
void forEachNumber(std::size_t count, int threads, Use&& use) {
    constexpr std::size_t kPart = 512;
    forEachPart((count + kPart - 1) / kPart, threadsFor(threads), [&](std::size_t part) {
        for (std::size_t i = part * kPart; i < std::min((part + 1) * kPart, count); ++i) use(i);
    });
}

} // namespace

void IndirectLight::changeLight(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings) {
    lit_.prepare(scene, tracer, settings);
    cells_.clear(tracer.bounds());
    forgetValues();
}

void IndirectLight::changeParts(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                                int threads) {
    constexpr std::uint32_t kPathsOfForgotten = 6144;
    ChangedSurfaces changed;
    changed.find(scene.model.mesh, hiddenTriangles(scene.model, lit_.scene().hiddenParts),
                 hiddenTriangles(scene.model, scene.hiddenParts));
    const LitScene before = std::exchange(lit_, {});
    lit_.prepare(scene, tracer, settings);
    if (changed.empty()) return;
    ++frame_;
    forgetNear(changed, threads);
    chooseCompared();
    passes_.clear();
    for (const std::uint32_t number : chosen_) passes_.push_back(records_.next(cache_, number));
    OutgoingCells old = std::exchange(cells_, {});
    cells_.clear(tracer.bounds());
    LightDifference difference;
    difference.find({before, surfaces_, frame_, threads}, {lit_, surfaces_, frame_, threads}, cache_, passes_,
                    gatherer_, cells_);
    takeCells(old, difference, threads);
    takeDifference(difference, threads);
    std::erase_if(chosen_, [&](std::uint32_t number) { return records_.passes(number) > 0; });
    if (gather({0, kPathsOfForgotten}, threads, nullptr)) enterResults();
}

/// Cells that rays have met stay known as far as their light is the same.
void IndirectLight::takeCells(OutgoingCells& old, const LightDifference& difference, int threads) {
    constexpr float kMaxSamples = 128, kOfFaded = 2, kMin = 1e-6F;
    const std::span<const OutgoingCells::Site> sites = gatherer_.hits().sites();
    std::vector<std::uint32_t> kept(sites.size());
    forEachNumber(kept.size(), threads, [&](std::size_t i) {
        if (sites[i].level == OutgoingCells::kNowhere) return;
        const float differs = difference.leaving(sites[i]);
        if (differs < kAnotherLight)
            kept[i] = static_cast<std::uint32_t>(std::min(kMaxSamples, kOfFaded / std::max(differs, kMin)));
    });
    cells_.takeOver(old, sites, kept);
}

/// They are made anew where they lack.
void IndirectLight::forgetNear(const ChangedSurfaces& changed, int threads) {
    std::vector<std::uint8_t> kept(cache_.size());
    forEachNumber(kept.size(), threads, [&](std::size_t i) {
        kept[i] = changed.areNear(cache_.record(static_cast<std::uint32_t>(i))) ? 0 : 1;
    });
    cache_.keep(kept);
    records_.keep(kept);
}

/// Records by which all are judged: coarse and fine ones of what was seen lately, and some of all others.
void IndirectLight::chooseCompared() {
    constexpr std::size_t kCoarse = 512, kFine = 256, kOthers = 256;
    chosen_.clear();
    const auto choose = [&](std::size_t max, auto&& wanted) {
        order_.clear();
        for (std::uint32_t number = 0; number < cache_.size(); ++number) {
            const std::uint32_t used = cache_.lastUse(number);
            const bool lately = used != 0 && used + kRecentSteps >= frame_;
            if (wanted(lately, records_.density(number)))
                order_.push_back(
                    std::uint64_t{alongCurve(cache_.record(number).position, lit_.tracer().bounds())} << 32 |
                    number);
        }
        chooseEvenly(max);
    };
    choose(kCoarse, [](bool lately, int density) { return lately && density > 0; });
    choose(kFine, [](bool lately, int density) { return lately && density == 0; });
    choose(kOthers, [](bool lately, int) { return !lately; });
    orderChosen();
}

/// So many of those in the order, along it.
void IndirectLight::chooseEvenly(std::size_t max) {
    std::ranges::sort(order_);
    const std::size_t count = std::min(max, order_.size());
    for (std::size_t i = 0; i < count; ++i)
        chosen_.push_back(static_cast<std::uint32_t>(order_[i * order_.size() / count]));
}

/// Each record forgets as much as its light differs.
void IndirectLight::takeDifference(const LightDifference& difference, int threads) {
    constexpr float kSame = 1e-4F;
    std::vector<LightDifference::Arriving> found(cache_.size());
    forEachNumber(found.size(), threads, [&](std::size_t i) {
        found[i] = difference.arrivingAt(cache_.record(static_cast<std::uint32_t>(i)));
    });
    for (std::uint32_t number = 0; number < found.size(); ++number) {
        const LightDifference::Arriving& arriving = found[number];
        if (arriving.difference >= kAnotherLight) {
            records_.forgetLight(number);
            cache_.values(number).confidence = 0;
        } else if (arriving.difference > kSame) {
            records_.fade(cache_, number, static_cast<std::uint32_t>(kAnotherLight / arriving.difference),
                          arriving.ratio);
        }
    }
    guesses_ = false;
}

/// Positions and radii of records stay.
void IndirectLight::forgetValues() {
    records_.forgetLight();
    for (std::uint32_t number = 0; number < cache_.size(); ++number) cache_.values(number).confidence = 0;
    guesses_ = false;
}

} // namespace rtcore
