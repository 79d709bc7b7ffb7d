#include "rtcore/render/shown_tracer.h"

#include <utility>

namespace rtcore {

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                             SectionSurfaces& known, GroundRole role) {
    return withGround(withSections(std::move(surfaces), scene, known), scene, role);
}

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene) {
    SectionSurfaces known;
    return shownTracer(std::move(surfaces), scene, known);
}

} // namespace rtcore
