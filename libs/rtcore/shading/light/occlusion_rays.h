/// The vector code of ambient occlusion: rays of many points, and what they found.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/sampling/hemisphere_pattern.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>

namespace rtcore {

/// Where the rays of some points start and go to: arrays with room for whole blocks of kWaveBlock.
struct OcclusionFrames {
    std::size_t count = 0;
    ArraysOf3 origin;
    ArraysOf3 tangent, bitangent, normal; ///< basis around the shading normal, turned as the point's pattern
    ArraysOf3 side;                       ///< geometric normal, on the side that rays leave to
    float* shift = nullptr;               ///< added to the u of each direction
    float* visible = nullptr;             ///< sum of what the rays let pass
};

/// Sets origins and directions of frames.count rays, from `first` on, that all go the same way in their
/// frames; those that would go below the surface are mirrored at it. `rays` has room for a block more.
void aimAlike(const OcclusionFrames& frames, HemispherePoint direction, RayWave& rays, std::size_t first);
/// The same with a direction for each ray.
void aimEach(const OcclusionFrames& frames, const HemispherePoint* directions, RayWave& rays,
             std::size_t first);

/// Adds to frames.visible what passes: t / distance of a ray that hit, else 1. `hits`, from `first` on, has
/// one for each frame.
void addVisible(const OcclusionFrames& frames, const HitWave& hits, std::size_t first, float distance);

} // namespace rtcore
