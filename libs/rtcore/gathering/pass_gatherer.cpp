#include "rtcore/gathering/pass_gatherer.h"

#include "rtcore/math/constants.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace rtcore {

bool PassGatherer::gather(const GatherTask& task, std::span<const GatherPass> passes, std::size_t paths,
                          OutgoingCells& cells) {
    if (!trace(task, passes, cells) ||
        !cellPaths_.fill(task.lit.paths(), hits_, passes, paths, task.frame, task.threads, task.stop, cells))
        return false;
    sumUp(task, passes, cells);
    return true;
}

bool PassGatherer::gatherEvenly(const GatherTask& task, std::span<const GatherPass> passes, std::size_t step,
                                OutgoingCells& cells) {
    return trace(task, passes, cells) && cellPaths_.fillEvenly(task.lit.paths(), hits_, passes, step,
                                                               task.frame, task.threads, task.stop, cells);
}

void PassGatherer::sumUp(const GatherTask& task, std::span<const GatherPass> passes, GatherHits&& hits,
                         const OutgoingCells& cells) {
    hits_ = std::move(hits);
    sumUp(task, passes, cells);
}

bool PassGatherer::trace(const GatherTask& task, std::span<const GatherPass> passes,
                         const OutgoingCells& cells) {
    return hits_.trace({task.lit.scene(), task.lit.tracer(), task.surfaces, cells}, passes, task.threads,
                       task.stop);
}

void PassGatherer::sumUp(const GatherTask& task, std::span<const GatherPass> passes,
                         const OutgoingCells& cells) {
    emitted_.assign(passes.size(), {});
    emitterRays_.add(task.lit.paths(), passes, task.threads, emitted_);
    results_.resize(passes.size());
    constexpr std::size_t kPart = 16;
    forEachPart((passes.size() + kPart - 1) / kPart, threadsFor(task.threads), [&](std::size_t part) {
        const std::size_t last = std::min((part + 1) * kPart, passes.size());
        for (std::size_t pass = part * kPart; pass < last; ++pass)
            results_[pass] = resultOf(task.lit, passes, pass, cells);
    });
}

PassResult PassGatherer::resultOf(const LitScene& lit, std::span<const GatherPass> passes, std::size_t pass,
                                  const OutgoingCells& cells) const {
    constexpr float kSlack = 0.02F; // of its distance: what lies in the surface itself is no wall
    const GatherPass& of = passes[pass];
    PassResult result;
    PassLight gathered;
    std::size_t known = 0;
    float squares = 0;                                     // of luminances
    std::array<std::optional<Colour>, kPassRays> arriving; // but emission; nothing where it is not known yet
    cells.radiance(hits_.sites().subspan(pass * kPassRays, kPassRays), arriving);
    for (std::size_t i = 0; i < kPassRays; ++i) {
        const std::size_t ray = pass * kPassRays + i;
        const OutgoingCells::Site& site = hits_.site(ray);
        const Vec3 direction = hits_.direction(ray);
        if (!hits_.isHit(ray)) arriving[i] = lit.fromSurroundings(of.origin, direction, of.normal);
        if (const std::optional<Colour>& radiance = arriving[i]) {
            gathered.add(*radiance, direction, dot(direction, of.normal), kPi);
            squares += luminance(*radiance) * luminance(*radiance);
            ++known;
        }
        result.inverseLengths += 1 / std::max(site.length, 1e-12F);
        if (hits_.isHit(ray))
            result.walls.meet({site.normal, dot(site.normal, site.point) - kSlack * site.length},
                              site.length);
    }
    result.light = emitted_[pass];
    const float weight = 1 / static_cast<float>(std::max<std::size_t>(known, 1));
    result.light.irradiance += gathered.irradiance * weight;
    result.light.vector += gathered.vector * weight;
    const float mean = luminance(gathered.irradiance) * weight,
                variance = std::max(squares * weight * (kPi * kPi) - mean * mean, 0.0F),
                all = luminance(result.light.irradiance);
    result.deviation = all > 0 ? std::sqrt(variance) / all : 0;
    return result;
}

} // namespace rtcore
