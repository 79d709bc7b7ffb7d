// The power heuristic (Veach 1995). Included once for each instruction set, inside the loop of
// foreach_target.h, or alone.
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_PATHTRACING_PATH_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_PATH_WEIGHTS_INL_H_
#undef RTCORE_PATHTRACING_PATH_WEIGHTS_INL_H_
#else
#define RTCORE_PATHTRACING_PATH_WEIGHTS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// p^2 / (p^2 + q^2), of densities that are not negative, and not both 0; the weights of both sum to 1. The
/// larger one divides, since squares of large densities leave the range of floats.
template <typename F>
HWY_INLINE F powerHeuristic(F p, F q) {
    const F larger = max(p, q), a = p / larger, b = q / larger;
    return a * a / (a * a + b * b);
}

/// MIS weight of light that next event samples with the density p, and scattered rays with q > 0.
template <typename F>
HWY_INLINE F misWeightOfNextEvent(SamplingStrategy strategy, F p, F q) {
    if (strategy == SamplingStrategy::Both) return powerHeuristic<F>(p, q);
    return F(strategy == SamplingStrategy::NextEvent ? 1 : 0);
}
/// MIS weight of light that scattered rays sample with the density p > 0, and next event with q.
template <typename F>
HWY_INLINE F misWeightOfScatteredRay(SamplingStrategy strategy, F p, F q) {
    if (strategy == SamplingStrategy::Both) return powerHeuristic<F>(p, q);
    return select(q > 0.0F, F(strategy == SamplingStrategy::NextEvent ? 0 : 1), F(1));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
