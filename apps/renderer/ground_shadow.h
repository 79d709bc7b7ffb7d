/// The shadow that a model would cast on a ground below it, for images that show neither ground nor
/// background.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/post/develop.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <memory>

namespace renderer {

/// The work of an image's shadow; all of it must live that long.
struct ShadowWork {
    const rtcore::Scene& scene;
    std::shared_ptr<const rtcore::RayTracer> surfaces; ///< as sections leave them, without any ground
    /// Of a model whose scene has none: made when it is null, and to be kept for its next image.
    std::shared_ptr<const rtcore::SkyGround>& ground;
    const rtcore::Camera& camera;
    const rtcore::RenderSettings& settings; ///< of the image
    rtcore::ImageRenderers& images;
    rtcore::PictureDeveloper& developer;
    rtcore::RenderControl& control;
};

/// What is left, per pixel and colour, of the light on the ground once the model stands there: 0..1, and 1
/// where no ground is seen. The ground is the scene's own; without one it is level, below the lowest point of
/// the model, and ends where shadows do. Images of it with and without the model are divided, with the same
/// samples, so that there is no noise where there is no shadow; the light of the surroundings always counts.
/// (Debevec 1998, differential rendering) Empty when control.cancel was set.
rtcore::HdrImage groundShadow(const ShadowWork& work);

} // namespace renderer
