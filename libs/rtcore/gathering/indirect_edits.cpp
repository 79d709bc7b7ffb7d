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

/// Passes by which states are compared have numbers from there on, by which their rays are others than those
/// of passes that records learn of.
constexpr std::uint32_t kFirstCompared = 1U << 24U;
constexpr float kAnotherLight = 0.1F; ///< by such a difference what was known of it is of no use

/// Whether emissive triangles are hidden in the scene or there alone.
bool emittersDiffer(const Scene& scene, const HiddenParts& hidden) {
    const std::vector<std::uint8_t> here = partTriangles(scene.model, scene.hiddenParts),
                                    there = partTriangles(scene.model, hidden);
    for (std::size_t i = 0; i < here.size(); ++i) {
        const bool differs = (here[i] != 0) != (there[i] != 0);
        if (differs && !isBlack(scene.material(scene.mesh().shading[i].material).emission)) return true;
    }
    return false;
}

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
    change_.reset(); // nothing of it is of use any more
    lit_.prepare(scene, tracer, settings);
    cells_.clear(tracer.bounds());
    forgetValues();
}

void IndirectLight::changeParts(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                                int threads) {
    ChangedSurfaces changed;
    changed.find(scene.model.mesh, partTriangles(scene.model, lit_.scene().hiddenParts),
                 partTriangles(scene.model, scene.hiddenParts));
    if (changed.empty()) {
        rebind(scene, tracer, settings);
        return;
    }
    ++frame_;
    if (change_ && change_->taken()) change_.reset(); // what is known is of the state that it led to
    if (!change_) {
        change_.emplace(std::exchange(lit_, {}), std::exchange(cells_, {}));
    } else { // records that were made since know of a state that is no more
        for (auto i = static_cast<std::uint32_t>(change_->records()); i < cache_.size(); ++i) forget(i);
    }
    forgetNear(changed, threads);
    if (sameParts(change_->before().scene().hiddenParts, scene.hiddenParts)) {
        cells_ = std::move(change_->cells());
        change_.reset();
        lit_.prepare(scene, tracer, settings);
        return;
    }
    prepareCompared(scene, tracer, settings);
    cells_.clear(tracer.bounds());
    chooseCompared();
    passes_.clear();
    for (const std::uint32_t number : chosen_) {
        passes_.push_back(records_.next(cache_, number));
        passes_.back().number = kFirstCompared + frame_;
    }
    change_->begin(passes_, cache_.size(), tracer.bounds(), frame_);
}

void IndirectLight::rebind(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings) {
    if (change_)
        prepareCompared(scene, tracer, settings);
    else
        lit_.prepare(scene, tracer, settings);
}

/// Where emitters are hidden or shown, too, random numbers mean the same in both states.
void IndirectLight::prepareCompared(const Scene& scene, const RayTracer& tracer,
                                    const RenderSettings& settings) {
    LitScene& before = change_->before();
    const HiddenParts& hidden = before.scene().hiddenParts;
    if (!emittersDiffer(scene, hidden)) {
        if (before.isBeside()) before.prepare(before.scene(), before.tracer(), before.settings());
        lit_.prepare(scene, tracer, settings);
        return;
    }
    before.prepareBeside(before.scene(), before.tracer(), before.settings(), scene.hiddenParts);
    lit_.prepareBeside(scene, tracer, settings, hidden);
}

/// Compares some more records; once all are, takes what was found. Returns false when stopped.
bool IndirectLight::follow(std::size_t compared, int threads, const std::atomic<bool>* stop) {
    PartsChange& change = *change_;
    if (!change.taken()) {
        const GatherTask now{lit_, surfaces_, change.frame(), threads, stop};
        if (!change.compare(now, frame_, compared, gatherer_, cells_)) return false;
        if (!change.compared()) return true;
        const LightDifference& difference = change.difference(now, cache_, gatherer_, cells_);
        takeCells(difference, threads);
        takeDifference(difference, threads);
        // Cells knew little when those that were made since had their first pass: the next one counts alone.
        for (auto i = static_cast<std::uint32_t>(change.records()); i < cache_.size(); ++i)
            records_.forgetLight(i);
        if (lit_.isBeside()) lit_.prepare(lit_.scene(), lit_.tracer(), lit_.settings());
        change.take();
    }
    if (!gatherForgotten(threads, stop)) return false;
    change_.reset();
    return true;
}

/// Compared records that have forgotten their light pass first, with more paths than others.
bool IndirectLight::gatherForgotten(int threads, const std::atomic<bool>* stop) {
    constexpr std::size_t kPaths = 16384;
    chosen_.clear();
    for (const GatherPass& pass : change_->passes())
        if (records_.passes(pass.record) == 0) chosen_.push_back(pass.record);
    orderChosen();
    if (!gather(kPaths, change_->frame(), threads, stop)) return false;
    enterResults();
    return true;
}

/// Cells that rays have met stay known as far as their light is the same.
void IndirectLight::takeCells(const LightDifference& difference, int threads) {
    constexpr float kMaxSamples = 128, kOfFaded = 2, kMin = 1e-6F;
    const std::span<const OutgoingCells::Site> sites = change_->sites();
    std::vector<std::uint32_t> kept(sites.size());
    forEachNumber(kept.size(), threads, [&](std::size_t i) {
        if (sites[i].level == OutgoingCells::kNowhere) return;
        const float differs = difference.leaving(sites[i]);
        if (differs < kAnotherLight)
            kept[i] = static_cast<std::uint32_t>(std::min(kMaxSamples, kOfFaded / std::max(differs, kMin)));
    });
    cells_.takeOver(change_->cells(), sites, kept);
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

/// Each record that was there before forgets as much as its light differs.
void IndirectLight::takeDifference(const LightDifference& difference, int threads) {
    constexpr float kSame = 1e-4F;
    std::vector<LightDifference::Arriving> found(change_->records());
    forEachNumber(found.size(), threads, [&](std::size_t i) {
        found[i] = difference.arrivingAt(cache_.record(static_cast<std::uint32_t>(i)));
    });
    for (std::uint32_t number = 0; number < found.size(); ++number) {
        const LightDifference::Arriving& arriving = found[number];
        if (arriving.difference >= kAnotherLight) {
            forget(number);
        } else if (arriving.difference > kSame) {
            records_.fade(cache_, number, static_cast<std::uint32_t>(kAnotherLight / arriving.difference),
                          arriving.ratio);
        }
    }
    guesses_ = false;
}

/// Its position and its radius stay.
void IndirectLight::forget(std::uint32_t number) {
    records_.forgetLight(number);
    cache_.values(number).confidence = 0;
}

/// Those of all.
void IndirectLight::forgetValues() {
    records_.forgetLight();
    for (std::uint32_t number = 0; number < cache_.size(); ++number) cache_.values(number).confidence = 0;
    guesses_ = false;
}

} // namespace rtcore
