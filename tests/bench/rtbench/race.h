/// All contenders on the same rays, taking turns.
#pragma once

#include "bench/rtbench/contenders.h"
#include "bench/rtbench/figures.h"
#include "bench/rtbench/ray_sets.h"

#include <functional>
#include <span>

namespace rtbench {

struct RaceOptions {
    int threads = 1;
    int rounds = 12;     ///< at most
    double spread = .01; ///< small enough to stop, after four rounds at least
    /// Called between pieces of the work with the share that is done; may throw to stop it.
    std::function<void(double)> onProgress = {};
};

/// One thread: pieces of 32768 rays, each traced by every contender in turn; the best time of each piece
/// counts. Several threads: a piece is the whole set. A first pass, not timed, compares what they hit. A
/// contender that needs half as long again as its rivals' best in the first round drops out.
/// `contenders` begins with ours; `rays` is not empty.
RayFigures race(const RaySet& rays, std::span<const Contender> contenders, const RaceOptions& options);

} // namespace rtbench
