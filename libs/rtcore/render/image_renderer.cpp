#include "rtcore/render/image_renderer.h"

#include "rtcore/render/path_images.h"
#include "rtcore/render/ray_images.h"

#include <utility>

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
    if (renderer == nullptr) {
        renderer = makeImageRenderer(integrator);
        renderer->beginWith(kept_);
    }
    return *renderer;
}

void ImageRenderers::beginWith(std::shared_ptr<const IndirectState> kept) {
    kept_ = std::move(kept);
    for (const auto& each : renderers_)
        if (each != nullptr) each->beginWith(kept_);
}

} // namespace rtcore
