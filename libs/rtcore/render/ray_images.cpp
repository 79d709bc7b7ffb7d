#include "rtcore/render/ray_images.h"

namespace rtcore {

bool RayImages::render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) {
    renderer_.collectAovs(request.aovs);
    refines_ = false;
    const bool indirect = view.settings.indirect.mode == IndirectMode::Live;
    if (indirect && !light_.learn(view, control)) return false;
    renderer_.lightIndirectlyFrom(indirect ? &light_.cache() : nullptr);
    refines_ = static_cast<bool>(request.show);
    if (!refines_) return renderer_.render(view, control, frame);
    return refinement_.render(
        renderer_, view, control, frame, [&](const RefinementPass& pass, const Frame& picture) {
            const int samples = pass.antialiasing * pass.antialiasing;
            request.show({picture, pass.block, static_cast<std::uint32_t>(samples), nullptr, nullptr});
        });
}

double RayImages::fraction(const RenderControl& control) const {
    return refines_ ? refinement_.fraction(control) : control.fraction();
}

} // namespace rtcore
