#include "bench/rtbench/agreement.h"

#include <algorithm>
#include <cmath>

namespace rtbench {

namespace {

constexpr float kTolerance = 1e-4F;

bool differ(const rtcore::HitWave& a, const rtcore::HitWave& b, std::size_t i) {
    if (a.isHit(i) != b.isHit(i)) return true;
    return a.isHit(i) && std::fabs(a.t[i] - b.t[i]) > kTolerance * std::max(a.t[i], b.t[i]);
}

} // namespace

std::size_t countDifferences(const RayTest& test, const std::vector<WaveAnswer>& a,
                             const std::vector<WaveAnswer>& b) {
    std::size_t count = 0;
    for (std::size_t wave = 0; wave < a.size(); ++wave) {
        const std::size_t rays = test.anyHit ? a[wave].occluded.size() : a[wave].hits.size();
        for (std::size_t i = 0; i < rays; ++i) {
            const bool other = test.anyHit ? a[wave].occluded[i] != b[wave].occluded[i]
                                           : differ(a[wave].hits, b[wave].hits, i);
            count += other ? 1 : 0;
        }
    }
    return count;
}

} // namespace rtbench
