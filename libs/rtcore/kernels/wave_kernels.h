/// The vector kernels: whole waves, by packets of coherent rays and streams of the others. Data only, so that
/// the code behind it can be compiled once for each instruction set; ray_tracer.h is the interface for
/// others.
#pragma once

#include "rtcore/kernels/kernel_scene.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/stream_scratch.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// One array for each component, all of the same length.
struct RaySpan {
    const float* origin[3];
    const float* direction[3];
    const float* tMin;
    const float* tMax;
    std::size_t count;

    Ray ray(std::size_t i) const {
        return {{origin[0][i], origin[1][i], origin[2][i]},
                tMin[i],
                {direction[0][i], direction[1][i], direction[2][i]},
                tMax[i]};
    }
};

struct HitSpan {
    float* t;
    std::uint32_t* triangle;
    float *u, *v;
};

/// Finds the closest hits of all rays as findNearest() of single_ray.h does, kTiedHit included. The same
/// distances by every instruction set, and where there are no ties the same bits.
void traceClosest(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch, const HitSpan& hits);

/// Any hit: 1 where there is one, else 0. With scene.clear, triangles that let light through do not count,
/// and 2 stands where a ray passes one of them, or may do so.
void traceAny(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch, std::uint8_t* occluded);

/// Writes the indices of those hits that have kTiedHit, ascending; returns their number. `indices` has room
/// for all.
std::size_t findTied(const HitSpan& hits, std::size_t count, std::uint32_t* indices);

/// Writes the indices of those hits that are nearer than `limit` scene units, ascending; returns their
/// number. `indices` has room for all.
std::size_t findNear(const RaySpan& rays, const HitSpan& hits, float limit, std::uint32_t* indices);

} // namespace rtcore
