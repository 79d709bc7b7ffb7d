/// All that rays may meet of a scene as it is shown.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/section_tracer.h"
#include "rtcore/scene/scene.h"

#include <memory>

namespace rtcore {

/// `surfaces` as the scene's sections leave them, and the scene's ground, which no section cuts: `surfaces`
/// itself where there is neither. `known`: what is kept of scenes before.
std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene,
                                             SectionSurfaces& known, GroundRole role = GroundRole::Seen);
/// The same of a scene that does not change.
std::shared_ptr<const RayTracer> shownTracer(std::shared_ptr<const RayTracer> surfaces, const Scene& scene);

} // namespace rtcore
