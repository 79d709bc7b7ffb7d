/// The part of the model that is seen at a point of the image: for selecting by clicks, and for marking the
/// selection.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// The first surface, a transparent one too, and whether a texture has a hole there or not.
struct SeenObject {
    std::uint32_t material = 0;         ///< index into Scene::materials
    std::optional<std::uint32_t> piece; ///< index into Model::parts; none: it belongs to no part
};

/// At (x, y) pixels from the upper left corner of `view`; nothing where the background is seen. `tracer`: of
/// what is visible of the scene.
std::optional<SeenObject> seenObject(const Scene& scene, const RayTracer& tracer, const CameraRays& view,
                                     float x, float y);

/// The middles of all pixels of an image of that size, rows from the top. By the threads of OpenMP.
std::vector<std::optional<SeenObject>> seenObjects(const Scene& scene, const RayTracer& tracer,
                                                   const CameraRays& view, int width, int height);

} // namespace rtcore
