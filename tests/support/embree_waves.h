/// Waves of rays through Embree's calls for packets and single rays. For tests and benchmarks only.
#pragma once

#include "support/embree_api.h"

#include <cstddef>
#include <cstdint>

namespace test {

/// The arrays of a wave, `count` long each.
struct RayArrays {
    const float *ox, *oy, *oz, *dx, *dy, *dz, *tMin, *tMax;
    std::size_t count;
};
struct HitArrays {
    float *t, *u, *v;
    std::uint32_t* triangle; ///< rtcore::kNoTriangle for a miss
};

/// `width` is 1, 4, 8 or 16: the call that is used. The copying to and from Embree's packets is vector code
/// of the instruction set that rtcore::instructionSet() names, as the project's own kernels are.
void intersectWave(RTCScene scene, bool coherent, int width, const RayArrays& rays, const HitArrays& hits);
/// Writes 1 for each ray that hits anything, else 0.
void occludedWave(RTCScene scene, bool coherent, int width, const RayArrays& rays, std::uint8_t* occluded);

} // namespace test
