/// Learning indirect light of many views, with progress shown and Ctrl-C heeded.
#pragma once

#include "renderer/light_bounds.h"

#include "common/progress/progress.h"

#include "rtcore/render/learned_light.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <functional>
#include <span>

namespace renderer {

/// A view, and the pixels of its images.
struct LightView {
    rtcore::Camera camera;
    int width = 0, height = 0;
};

/// What light is learned of. Must outlive it.
struct LitScene {
    const rtcore::Scene& scene;
    const rtcore::RayTracer& tracer;
    const rtcore::RenderSettings& settings; ///< of any size
};

struct LearnedViews {
    std::size_t views = 0; ///< those that were learned of; fewer than all where a bound was reached
    bool stopped = false;  ///< by Ctrl-C
};

/// Learns view after view; `keep` is called now and then, where what was learned so far may be kept. What is
/// learned within the bounds has the same bits for any number of `threads`.
LearnedViews learnViews(rtcore::LearnedLight& light, const LitScene& lit, std::span<const LightView> views,
                        const LightBounds& bounds, int threads, app::Progress& progress,
                        const std::function<void()>& keep = {});

} // namespace renderer
