#include "rtcore/render/shown_tracer.h"

#include "rtcore/render/ground_tracer.h"

#include <utility>

namespace rtcore {

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                             UncutSurfaces& uncut) {
    return withGround(withSections(std::move(surfaces), scene, uncut), scene);
}

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene) {
    UncutSurfaces uncut;
    return shownTracer(std::move(surfaces), scene, uncut);
}

} // namespace rtcore
