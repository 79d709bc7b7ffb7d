#include "rtcore/gathering/indirect_light.h"

#include "rtcore/math/constants.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

/// Coarse records that have forgotten what they knew come first until they had so many.
constexpr std::uint32_t kFewPasses = 4;

} // namespace

void IndirectLight::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings) {
    lit_.prepare(scene, tracer, settings);
    surfaces_.find(scene.model.mesh);
    cache_.clear(tracer.bounds());
    cells_.clear(tracer.bounds());
    records_.clear();
    frame_ = 0;
    guesses_ = false;
    change_.reset();
}

IndirectState IndirectLight::state() const {
    return {cache_.bounds(), cache_.state(), records_.state(), cells_.state(), frame_, guesses_};
}

void IndirectLight::restore(const IndirectState& kept) {
    cache_.restore(kept.bounds, kept.irradiance);
    cells_.restore(kept.bounds, kept.cells);
    records_.restore(kept.passes);
    frame_ = kept.frame;
    guesses_ = kept.guesses;
    change_.reset();
}

bool IndirectLight::step(std::span<const Receiver> receivers, std::span<ArrivingLight> arriving,
                         const GatherBudget& budget, int threads, const std::atomic<bool>* stop) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    ++frame_;
    const auto edited = Clock::now();
    if (change_ && !follow(budget.compared, threads, stop)) {
        --frame_;
        return false;
    }
    const Seconds following = Clock::now() - edited;
    if (!change_) forgetUnused(); // while it is, numbers of records stay
    lookUp(curve_.of(receivers, lit_.tracer().bounds()), receivers, arriving, frame_, threads);
    findLacking(receivers, arriving);
    const auto begun = Clock::now();
    const double unknown =
        receivers.empty() ? 0 : static_cast<double>(lacking_.size()) / static_cast<double>(receivers.size());
    if (!learn(receivers, arriving, budgetFor(budget, unknown), threads, stop)) return false;
    const Seconds lasted = Clock::now() - begun;
    learned_ = {chosen_.size() * kPassRays, lasted.count(), minPasses(), unknown,
                following.count(),          meanError()};
    lookUp(lacking_, receivers, arriving, 0, threads);
    return true;
}

bool IndirectLight::learn(std::span<const Receiver> receivers, std::span<const ArrivingLight> arriving,
                          const GatherBudget& budget, int threads, const std::atomic<bool>* stop) {
    const std::size_t passes = budget.rays / kPassRays;
    const std::size_t before = cache_.size();
    chosen_.clear();
    bool done = makeRecords(receivers, arriving, passes, stop);
    if (done) {
        // The light that old ones know is not judged yet, and cells know of what is compared alone.
        if (!change_) chooseRecords(passes - (cache_.size() - before), budget.enough);
        const std::uint32_t paths = change_ ? 0 : pathsFor(budget.paths);
        orderChosen();
        done = gather(paths, frame_, threads, stop);
    }
    if (done)
        enterResults();
    else
        undo(before);
    return done;
}

/// The half of the records that was not used for longest, once there are too many.
void IndirectLight::forgetUnused() {
    cells_.bound(kMaxCells);
    if (cache_.size() <= maxRecords_) return;
    std::vector<std::uint32_t> uses(cache_.size());
    for (std::uint32_t number = 0; number < uses.size(); ++number) uses[number] = cache_.lastUse(number);
    const auto middle = uses.begin() + static_cast<std::ptrdiff_t>(uses.size() / 2);
    std::ranges::nth_element(uses, middle);
    const std::uint32_t last = *middle;
    std::vector<std::uint8_t> kept(cache_.size());
    std::size_t left = cache_.size() / 2; // of those used as lately as the last ones that stay
    for (std::uint32_t number = 0; number < kept.size(); ++number) {
        const std::uint32_t used = cache_.lastUse(number);
        kept[number] = used > last || (used == last && left > 0) ? 1 : 0;
        if (kept[number] != 0 && left > 0) --left;
    }
    cache_.keep(kept);
    records_.keep(kept);
}

/// Forgets the records beyond so many, which have learned nothing yet.
void IndirectLight::undo(std::size_t records) {
    const std::size_t fresh = cache_.size() - records;
    records_.undo(fresh);
    cache_.removeLast(fresh);
    --frame_;
}

/// Receivers that fine records alone are missing for are as right as they were.
void IndirectLight::findLacking(std::span<const Receiver> receivers,
                                std::span<const ArrivingLight> arriving) {
    lacking_.clear();
    for (const std::uint32_t i : curve_.last()) {
        const bool unknown = receivers[i].pixel > 0 && !(arriving[i].weight > 0);
        if (arriving[i].lacking > 0 || unknown) lacking_.push_back(i);
    }
}

/// More where little is known of what is seen.
GatherBudget IndirectLight::budgetFor(const GatherBudget& budget, double unknown) {
    const double times = 1 + (budget.maxTimes - 1) * unknown;
    return {static_cast<std::uint32_t>(budget.rays * times), static_cast<std::uint32_t>(budget.paths * times),
            budget.enough};
}

/// More where what is seen was forgotten: what cells learn now is what is shown for long, since each record
/// has its next pass long after.
std::uint32_t IndirectLight::pathsFor(std::uint32_t paths) const {
    constexpr double kMaxTimes = 4;
    if (chosen_.empty()) return paths;
    std::size_t forgotten = 0;
    for (const std::uint32_t number : chosen_)
        forgotten += records_.density(number) > 0 && records_.passes(number) < kFewPasses &&
                             records_.hasForgotten(number)
                         ? 1
                         : 0;
    const double part = static_cast<double>(forgotten) / static_cast<double>(chosen_.size());
    return static_cast<std::uint32_t>(paths * (1 + (kMaxTimes - 1) * part));
}

/// For the receivers of these numbers: groups of those that follow each other are looked up together.
void IndirectLight::lookUp(std::span<const std::uint32_t> numbers, std::span<const Receiver> receivers,
                           std::span<ArrivingLight> arriving, std::uint32_t frame, int threads) const {
    constexpr std::size_t kPart = 512;
    forEachPart((numbers.size() + kPart - 1) / kPart, threadsFor(threads), [&](std::size_t part) {
        const auto some = numbers.subspan(part * kPart, std::min(kPart, numbers.size() - part * kPart));
        std::array<Receiver, kPart> asking;
        std::array<ArrivingLight, kPart> found;
        for (std::size_t i = 0; i < some.size(); ++i) asking[i] = receivers[some[i]];
        cache_.lookUp({asking.data(), some.size()}, {found.data(), some.size()}, frame);
        for (std::size_t i = 0; i < some.size(); ++i) arriving[some[i]] = found[i];
    });
}

/// Where records lack, coarse ones first; fine ones leave half of the passes to records that know something.
/// A receiver is looked up again only where records that were made since reach it.
bool IndirectLight::makeRecords(std::span<const Receiver> receivers, std::span<const ArrivingLight> arriving,
                                std::size_t max, const std::atomic<bool>* stop) {
    fresh_.begin(cache_, lit_.tracer().bounds());
    latest_.assign(arriving.begin(), arriving.end());
    asOf_.assign(arriving.size(), static_cast<std::uint32_t>(cache_.size()));
    for (int density = kDensities - 1; density >= 0; --density) {
        const std::size_t limit = density > 0 ? max : std::max(chosen_.size(), (max + 1) / 2);
        for (std::size_t i = 0; i < receivers.size() && chosen_.size() < limit; ++i) {
            if (arriving[i].lacking < density) continue;
            if (stop != nullptr && stop->load(std::memory_order_relaxed)) return false;
            ArrivingLight& now = latest_[i];
            if (fresh_.change(receivers[i].position, asOf_[i])) {
                cache_.lookUp({&receivers[i], 1}, {&now, 1}, 0);
                asOf_[i] = static_cast<std::uint32_t>(cache_.size());
            }
            if (now.lacking != density) continue;
            chosen_.push_back(records_.add(cache_, receivers[i], now, density));
            fresh_.add(cache_);
            cache_.use(chosen_.back(), frame_);
        }
    }
    return true;
}

/// Records with a lower one have their pass first: those with the fewest passes. Coarse ones count less: fine
/// ones take their part; but before the first pass they come first, since few of them tell of all that is
/// seen, and where they have forgotten what they knew until a few passes.
std::uint64_t IndirectLight::turnOf(std::uint32_t number) const {
    const std::uint32_t passes = records_.passes(number);
    const int density = records_.density(number);
    const bool coarse = density > 0, few = passes < kFewPasses && records_.hasForgotten(number);
    if (passes == 0 && coarse) return static_cast<std::uint64_t>(kDensities - 1 - density);
    if (coarse && few) return kDensities + passes;
    if (passes == 0) return kDensities + kFewPasses;
    return kDensities + kFewPasses + std::uint64_t{countedPasses(number)};
}

/// Of the records that were used lately.
void IndirectLight::chooseRecords(std::size_t max, std::uint32_t enough) {
    const auto old = static_cast<std::uint32_t>(cache_.size() - chosen_.size());
    order_.clear();
    for (std::uint32_t number = 0; number < old; ++number) {
        const std::uint32_t used = cache_.lastUse(number);
        if (used == 0 || used + kRecentSteps < frame_) continue;
        if (countedPasses(number) < enough) order_.push_back(turnOf(number) << 32 | number);
    }
    const std::size_t taken = std::min(max, order_.size());
    std::ranges::nth_element(order_, order_.begin() + static_cast<std::ptrdiff_t>(taken));
    for (std::size_t i = 0; i < taken; ++i) chosen_.push_back(static_cast<std::uint32_t>(order_[i]));
}

/// Records with the fewest have just had one more.
std::uint32_t IndirectLight::minPasses() const {
    std::uint32_t fewest = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t number : chosen_) fewest = std::min(fewest, countedPasses(number));
    return fewest;
}

/// Records that lie together follow each other: their rays meet the same nodes.
void IndirectLight::orderChosen() {
    order_.clear();
    for (const std::uint32_t number : chosen_)
        order_.push_back(
            std::uint64_t{alongCurve(cache_.record(number).position, lit_.tracer().bounds())} << 32 | number);
    std::ranges::sort(order_);
    for (std::size_t i = 0; i < order_.size(); ++i) chosen_[i] = static_cast<std::uint32_t>(order_[i]);
}

bool IndirectLight::gather(std::size_t paths, std::uint32_t frame, int threads,
                           const std::atomic<bool>* stop) {
    passes_.clear();
    for (const std::uint32_t number : chosen_) passes_.push_back(records_.next(cache_, number));
    return gatherer_.gather({lit_, surfaces_, frame, threads, stop}, passes_, paths, cells_);
}

/// In the order of the passes. The guess follows what new records find.
void IndirectLight::enterResults() {
    Colour sum;
    float count = 0;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        if (records_.passes(chosen_[i]) == 0) {
            sum += gatherer_.results()[i].light.irradiance;
            ++count;
        }
        records_.enter(cache_, chosen_[i], gatherer_.results()[i]);
    }
    if (count == 0) return;
    const float weight = guesses_ ? std::min(0.1F, count * 1e-4F) : 1;
    cache_.setGuess(cache_.guess() * (1 - weight) + sum * (weight / count));
    guesses_ = true;
}

/// By the spread of the rays of the last pass.
double IndirectLight::meanError() const {
    double sum = 0;
    for (std::size_t i = 0; i < chosen_.size(); ++i)
        sum += gatherer_.results()[i].deviation /
               std::sqrt(static_cast<double>(records_.passes(chosen_[i]) * kPassRays));
    return chosen_.empty() ? 0 : sum / static_cast<double>(chosen_.size());
}

std::size_t IndirectLight::memory() const { return cache_.memory() + cells_.memory() + records_.memory(); }

/// Where no cell knows anything, as if the light that arrives came from all sides.
void IndirectLight::addFromCells(std::span<const OutgoingCells::Site> sites,
                                 std::span<Colour> radiance) const {
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i].level != OutgoingCells::kNowhere)
            radiance[i] += cells_.smoothRadiance(sites[i]).value_or(cache_.guess() / kPi);
}

void IndirectLight::lookUp(std::span<const LobeTap> lobes, std::span<Colour> radiance,
                           LobeScratch& scratch) const {
    scratch.sites.resize(lobes.size());
    scratch.rays.trace(gatherScene(), lit_, lobes, scratch.sites, radiance);
    addFromCells(scratch.sites, radiance);
}

void IndirectLight::learnLobes(std::span<const LobeTap> lobes, std::span<Colour> radiance,
                               std::uint32_t paths, int threads) {
    constexpr std::size_t kPart = 1024;
    if (lobes.empty()) return;
    lobeSites_.resize(lobes.size());
    const auto forEachLobes = [&](auto&& work) {
        forEachPart((lobes.size() + kPart - 1) / kPart, threadsFor(threads), [&](std::size_t part) {
            const std::size_t first = part * kPart;
            work(first, std::min(kPart, lobes.size() - first));
        });
    };
    forEachLobes([&](std::size_t first, std::size_t count) {
        thread_local LobeRays rays;
        rays.trace(gatherScene(), lit_, lobes.subspan(first, count),
                   std::span(lobeSites_).subspan(first, count), radiance.subspan(first, count));
    });
    const RaysToCells rays{
        lobeSites_, [this, taps = lobes.data()](std::size_t i) -> RaysToCells::Named {
            const std::uint32_t name = mixBits(taps[i].name);
            return {{taps[i].origin, 0, taps[i].direction, std::numeric_limits<float>::max()},
                    {static_cast<std::uint16_t>(name), static_cast<std::uint16_t>(name >> 16), frame_}};
        }};
    // While states are compared, cells know of what paths of both found alone.
    lobePaths_.fill(lit_.paths(), rays, change_ ? 0 : paths, frame_, threads, nullptr, cells_);
    forEachLobes([&](std::size_t first, std::size_t count) {
        addFromCells(std::span(lobeSites_).subspan(first, count), radiance.subspan(first, count));
    });
}

} // namespace rtcore
