/// Input shared by the waves of one frame.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/indirect_taps.h"
#include "rtcore/shading/light/light_visibility.h"
#include "rtcore/shading/light/shadow_maps.h"
#include "rtcore/shading/stage_times.h"
#include "rtcore/shading/surface/material_table.h"

#include <atomic>
#include <span>
#include <vector>

namespace rtcore {

/// The context of one thread. Everything lives as long as the frame.
struct FrameContext {
    const Scene* scene = nullptr;
    const RayTracer* tracer = nullptr; ///< of the scene's mesh
    const RenderSettings* settings = nullptr;
    const MaterialTable* materials = nullptr;
    bool discs = false;                     ///< a light that is on is seen as one (isDisc())
    const ShadowMaps* shadowMaps = nullptr; ///< shadows are looked up there; null: they are traced
    /// Known visibility at the points of primary rays, by sample; results are added, unless some of many
    /// lights are chosen (light/light_choice.h), which such frames do. Empty: all is traced.
    std::span<LightVisibility> visibility;
    /// Get the points that take indirect light, which ambient light, occlusion and the light of the sky give
    /// way to. Null: those there are.
    IndirectTaps* indirectTaps = nullptr;
    PixelSize pixelSize;                     ///< for these
    std::uint32_t lobeRays = 1;              ///< the same: TapRules
    const std::atomic<bool>* stop = nullptr; ///< true: return soon, the result is not wanted; may be null
    RayStatistics* statistics = nullptr;     ///< counts all rays of the frame
    StageClock* clock = nullptr;

    bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

} // namespace rtcore
