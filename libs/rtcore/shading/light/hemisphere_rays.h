/// Rays from many points over the hemispheres before them, with the density cos / pi: vector code.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/sampling/hemisphere_pattern.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>

namespace rtcore {

/// Where the rays of some points start and go to: arrays with room for whole blocks of kWaveBlock.
struct HemisphereFrames {
    std::size_t count = 0;
    ArraysOf3 origin;
    ArraysOf3 tangent, bitangent, normal; ///< basis around the shading normal, turned as the point's pattern
    ArraysOf3 side;                       ///< geometric normal, on the side that rays leave to
    float* shift = nullptr;               ///< added to the u of each direction
};

/// Sets origins and directions of frames.count rays, from `first` on, that all go the same way in their
/// frames; those that would go below the surface are mirrored at it. `rays` has room for a block more.
void aimAlike(const HemisphereFrames& frames, HemispherePoint direction, RayWave& rays, std::size_t first);
/// The same with a direction for each ray.
void aimEach(const HemisphereFrames& frames, const HemispherePoint* directions, RayWave& rays,
             std::size_t first);

} // namespace rtcore
