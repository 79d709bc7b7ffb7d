#include "rtcore/render/path_images.h"

#include <fmt/core.h>

#include <utility>

namespace rtcore {

bool PathImages::render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) {
    PathRenderer::Show show;
    if (request.show) {
        if (!findSurfaces(view, control.threads, 1)) return false;
        show = [&](std::uint32_t samples, const Frame& picture) {
            request.show({picture, 1, samples, &surfaces_.aovs});
        };
    }
    if (!paths_.render(view, control, frame, show)) return false;
    if (!request.aovs) return true;
    constexpr int kSamples = 4; // each way: edges are as smooth as those of the image
    if (!findSurfaces(view, control.threads, kSamples)) return false;
    std::swap(frame.aovs, surfaces_.aovs);
    return true;
}

/// AOVs of paths are those of rays, which see the same first.
bool PathImages::findSurfaces(const View& view, int threads, int samples) {
    RenderSettings rays = view.settings;
    rays.integrator = Integrator::Whitted;
    rays.antialiasing = samples;
    rays.adaptive = 0;
    rays.ambientOcclusion.on = rays.skyLight.on = false;
    RenderControl quietly{.threads = threads};
    rays_.collectAovs(true);
    return rays_.render({view.scene, view.tracer, view.camera, rays}, quietly, surfaces_);
}

/// Tells which samples were lost, and which lights the paths sample.
std::vector<ImageRemark> PathImages::remarks() const {
    std::vector<ImageRemark> remarks;
    const std::uint64_t dropped = paths_.sums().dropped(), clipped = paths_.sums().clipped();
    if (dropped > 0) {
        remarks.push_back({fmt::format("warning: {} samples were not finite and do not count; the scene has "
                                       "numbers that are too large",
                                       dropped),
                           false, false});
    }
    if (clipped > 0) {
        remarks.push_back({fmt::format("{} samples are brighter than {:.3g} and count as that: the image has "
                                       "less light than the scene",
                                       clipped, paths_.sums().largest()),
                           true, false});
    }
    const LightSet& lights = paths_.lights();
    remarks.push_back(
        {fmt::format("paths are lit by {} lights, {} emissive triangles{}", lights.lights().size(),
                     lights.emitters().size(), lights.surroundings().empty() ? "" : ", and the surroundings"),
         true, true});
    for (std::size_t i = 0; i < lights.emitsNoLight().size(); ++i) {
        if (lights.emitsNoLight()[i] == 0) continue;
        remarks.push_back(
            {fmt::format("material {} is seen to emit light, but lights nothing", i), true, true});
    }
    return remarks;
}

} // namespace rtcore
