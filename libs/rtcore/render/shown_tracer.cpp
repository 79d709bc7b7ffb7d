#include "rtcore/render/shown_tracer.h"

#include "rtcore/render/ground_tracer.h"

#include <utility>

namespace rtcore {

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                             SectionSurfaces& known) {
    return withGround(withSections(std::move(surfaces), scene, known), scene);
}

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene) {
    SectionSurfaces known;
    return shownTracer(std::move(surfaces), scene, known);
}

} // namespace rtcore
