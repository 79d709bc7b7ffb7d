#include "rtcore/render/image_renderer.h"

#include "rtcore/render/path_images.h"
#include "rtcore/render/ray_images.h"

namespace rtcore {

std::unique_ptr<ImageRenderer> makeImageRenderer(Integrator integrator) {
    switch (integrator) {
    case Integrator::Path:
        return std::make_unique<PathImages>();
    case Integrator::Whitted:
        break;
    }
    return std::make_unique<RayImages>();
}

ImageRenderer& ImageRenderers::of(Integrator integrator) {
    const auto index = static_cast<std::size_t>(integrator);
    if (index >= renderers_.size()) renderers_.resize(index + 1);
    std::unique_ptr<ImageRenderer>& renderer = renderers_[index];
    if (renderer == nullptr) renderer = makeImageRenderer(integrator);
    return *renderer;
}

} // namespace rtcore
