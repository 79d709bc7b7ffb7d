/// Whole frames by the project's renderer, over each of the tracers.
#pragma once

#include "bench/rtbench/bench_view.h"
#include "bench/rtbench/contenders.h"
#include "bench/rtbench/figures.h"

#include "rtcore/scene/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace rtbench {

struct FrameOptions {
    int width = 1280, height = 720; ///< pixels
    int threads = 1;                ///< raced with one, and with so many
    int rounds = 7;
    std::function<void(double)> onProgress = {}; ///< as RaceOptions::onProgress
};

/// Each of the makeFrameContenders() in turn renders the view with one light: "phong" with Phong and shadows
/// alone, "mirrors" with half of the light reflected by every surface, up to depth 5. From the scene to
/// radiance; what a display needs after that is the same for all.
std::vector<FrameFigures> raceFrames(const rtcore::Scene& scene, const BenchView& view,
                                     std::span<const Contender> contenders, const FrameOptions& options);

} // namespace rtbench
