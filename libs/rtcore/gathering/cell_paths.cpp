#include "rtcore/gathering/cell_paths.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace rtcore {

namespace {

constexpr std::size_t kDigits = 33;    ///< so many numbers of digits there are
constexpr std::uint8_t kNoCell = 0xFF; ///< the ray has hit nothing
/// Long waves are quicker, but all threads have some of the few paths of a live frame.
constexpr std::size_t kMinPathsOfWave = 256, kMaxPathsOfWave = 2048;
constexpr float kMaxRadiance = 1e6F; ///< beyond, or where it is no number, a path counts as dark

/// What the function captures is so small that it needs no memory.
RaysToCells raysOf(const GatherHits& hits, std::span<const GatherPass> passes) {
    return {hits.sites(), [&hits, of = passes.data()](std::size_t ray) -> RaysToCells::Named {
                const GatherPass& pass = of[ray / kPassRays];
                const std::uint32_t name = mixBits(pass.name + static_cast<std::uint32_t>(ray % kPassRays));
                return {
                    {pass.origin, 0, hits.direction(ray), std::numeric_limits<float>::max()},
                    {static_cast<std::uint16_t>(name), static_cast<std::uint16_t>(name >> 16), pass.number}};
            }};
}

} // namespace

bool CellPaths::fill(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
                     std::size_t budget, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
                     OutgoingCells& cells) {
    return fill(paths, raysOf(hits, passes), budget, frame, threads, stop, cells);
}

bool CellPaths::fill(const PathFrame& paths, const RaysToCells& rays, std::size_t budget, std::uint32_t frame,
                     int threads, const std::atomic<bool>* stop, OutgoingCells& cells) {
    choose(rays.sites, cells, budget, frame, threads);
    if (!trace(paths, rays, threads, stop)) return false;
    addTo(cells, rays.sites, frame);
    return true;
}

bool CellPaths::fillEvenly(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
                           std::size_t step, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
                           OutgoingCells& cells) {
    chosen_.clear();
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        for (std::size_t i = pass % step; i < kPassRays; i += step) {
            const std::size_t ray = pass * kPassRays + i;
            if (hits.isHit(ray)) chosen_.push_back(static_cast<std::uint32_t>(ray));
        }
    }
    if (!trace(paths, raysOf(hits, passes), threads, stop)) return false;
    addTo(cells, hits.sites(), frame);
    return true;
}

void CellPaths::addTo(OutgoingCells& cells, std::span<const OutgoingCells::Site> sites,
                      std::uint32_t frame) const {
    constexpr std::size_t kAhead = 4; // adding waits for memory most of all
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        if (i + kAhead < chosen_.size()) cells.prefetch(sites[chosen_[i + kAhead]]);
        cells.add(sites[chosen_[i]], radiance_[i], frame);
    }
}

/// Half of what is left of the budget goes to each group of rays whose cells know about as much, evenly among
/// them.
void CellPaths::choose(std::span<const OutgoingCells::Site> sites, const OutgoingCells& cells,
                       std::size_t budget, std::uint32_t frame, int threads) {
    constexpr std::size_t kPart = 2048, kMinOfGroup = 64;
    knowledge_.resize(sites.size());
    forEachPart((sites.size() + kPart - 1) / kPart, threadsFor(threads), [&](std::size_t part) {
        const std::size_t first = part * kPart, count = std::min(kPart, sites.size() - first);
        std::array<std::uint32_t, kPart> samples;
        cells.samples(sites.subspan(first, count), samples);
        for (std::size_t i = 0; i < count; ++i)
            knowledge_[first + i] = sites[first + i].level != OutgoingCells::kNowhere
                                        ? static_cast<std::uint8_t>(std::bit_width(samples[i]))
                                        : kNoCell;
    });
    std::array<std::size_t, kDigits> sizes{};
    for (const std::uint8_t digits : knowledge_)
        if (digits != kNoCell) ++sizes[digits];
    /// Of each group, every `step`-th ray from the `next`-th on.
    std::array<double, kDigits> step{}, next{};
    std::size_t left = budget;
    for (std::size_t group = 0; group < kDigits; ++group) {
        const std::size_t taken = std::min({left, sizes[group], std::max(left / 2, kMinOfGroup)});
        left -= taken;
        if (taken == 0) continue;
        step[group] = static_cast<double>(sizes[group]) / static_cast<double>(taken);
        const auto name = frame * static_cast<std::uint32_t>(kDigits) + static_cast<std::uint32_t>(group);
        next[group] = step[group] * static_cast<double>(unitFloat(mixBits(name)));
    }
    chosen_.clear();
    std::array<std::size_t, kDigits> seen{};
    for (std::size_t i = 0; i < knowledge_.size(); ++i) {
        const std::uint8_t group = knowledge_[i];
        if (group == kNoCell || step[group] == 0) continue;
        if (static_cast<double>(seen[group]++) < next[group]) continue;
        next[group] += step[group];
        chosen_.push_back(static_cast<std::uint32_t>(i));
    }
}

bool CellPaths::trace(const PathFrame& paths, const RaysToCells& from, int threads,
                      const std::atomic<bool>* stop) {
    const int team = threadsFor(threads);
    while (integrators_.size() < static_cast<std::size_t>(team))
        integrators_.push_back(std::make_unique<PathIntegrator>());
    radiance_.resize(chosen_.size());
    const std::size_t all = chosen_.size(), ofWave = std::clamp((all + static_cast<std::size_t>(team) - 1) /
                                                                    static_cast<std::size_t>(team),
                                                                kMinPathsOfWave, kMaxPathsOfWave);
    const auto waves = static_cast<std::int64_t>((all + ofWave - 1) / ofWave);
    const auto stopped = [&] { return stop != nullptr && stop->load(std::memory_order_relaxed); };
    TaskErrors errors;
#pragma omp parallel num_threads(team)
    errors.guard([&] {
        PathIntegrator& integrator = *integrators_[static_cast<std::size_t>(threadNumber())];
        integrator.begin(paths);
        integrator.stopWhen(stop);
        RayWave rays;
        std::vector<SampleId> names;
#pragma omp for schedule(dynamic, 1) nowait
        for (std::int64_t wave = 0; wave < waves; ++wave) {
            if (stopped() || errors.any()) continue;
            errors.guard([&] {
                const std::size_t first = static_cast<std::size_t>(wave) * ofWave,
                                  last = std::min(first + ofWave, all);
                rays.clear();
                names.clear();
                for (std::size_t i = first; i < last; ++i) {
                    const RaysToCells::Named named = from.ray(chosen_[i]);
                    rays.push(named.ray);
                    names.push_back(named.name);
                }
                integrator.traceGathering(rays, names);
                for (std::size_t i = first; i < last; ++i) {
                    const Colour found = integrator.radiance().colourAt(i - first);
                    radiance_[i] = maxComponent(found) < kMaxRadiance && isFinite(found) ? found : Colour{};
                }
            });
        }
    });
    errors.rethrow();
    return !stopped();
}

} // namespace rtcore
