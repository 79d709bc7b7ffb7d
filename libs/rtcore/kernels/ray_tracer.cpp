#include "rtcore/kernels/ray_tracer.h"

#include "rtcore/kernels/single_ray.h"

namespace rtcore {

void KdRayTracer::intersect(RayKind /*kind*/, const RayWave& rays, HitWave& hits) const {
    hits.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hit hit;
        rtcore::intersect(tree_, mesh_, rays.ray(i), hit);
        hits.t[i] = hit.t;
        hits.u[i] = hit.u;
        hits.v[i] = hit.v;
        hits.triangle[i] = hit.triangle;
    }
}

void KdRayTracer::occluded(RayKind /*kind*/, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    occluded.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        occluded[i] = rtcore::occluded(tree_, mesh_, rays.ray(i)) ? 1 : 0;
    }
}

} // namespace rtcore
