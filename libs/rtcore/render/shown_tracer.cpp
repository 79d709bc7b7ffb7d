#include "rtcore/render/shown_tracer.h"

#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/section_tracer.h"

#include <utility>

namespace rtcore {

std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene) {
    return withGround(withSections(std::move(surfaces), scene), scene);
}

} // namespace rtcore
