/// From a scene and a camera to a picture of unbounded linear radiance.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/finished_tiles.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/lens.h"
#include "rtcore/render/sample_choice.h"
#include "rtcore/render/sample_rays.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/material_table.h"
#include "rtcore/shading/shadow_maps.h"
#include "rtcore/shading/stage_times.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

class TileGrid;
class TileRenderer;

/// Shared with threads that show progress or stop the work. One frame at a time.
struct RenderControl {
    std::atomic<bool> cancel{false};
    std::atomic<std::uint64_t> tilesDone{0};
    std::atomic<std::uint64_t> tiles{0}; ///< of the whole frame; 0 before it starts
    FinishedTiles* finished = nullptr;   ///< gets each tile when its pixels are written; may be null
};

/// Renders frames one after another and keeps the memory of its threads, so that a frame like the one before
/// it allocates nothing. Not for several threads at once: it uses all of them itself.
class FrameRenderer {
  public:
    FrameRenderer();
    ~FrameRenderer();
    FrameRenderer(const FrameRenderer&) = delete;
    FrameRenderer& operator=(const FrameRenderer&) = delete;

    /// Renders into `frame`, whose memory is reused when the size fits. `threads` = 0: all cores; the picture
    /// has the same bits for every number. Scene, camera and settings may differ in every frame, but not
    /// change during one. Returns false when control.cancel was set, with `frame` undefined.
    bool render(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                const RenderSettings& settings, int threads, RenderControl& control, Frame& frame);

    /// The picture of those settings from afar: one sample for each square of `block` x `block` pixels, in
    /// its middle. `frame` gets a pixel for each square, also for those that the right or lower edge cuts.
    bool renderCoarse(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                      const RenderSettings& settings, int block, int threads, RenderControl& control,
                      Frame& frame);

    /// Whether frames to come get layers: for who writes them, or for effects (effectsNeedLayers()).
    void collectLayers(bool on) { collectLayers_ = on; }
    /// Whether frames to come measure stageTimes().
    void measureStages(bool on) { measureStages_ = on; }
    /// Where the shadows of frames to come are looked up, quicker and less exact than by rays; null: by rays.
    /// The maps are the scene's, suit the settings, and must outlive the frames.
    void takeShadowsFrom(const ShadowMaps* maps) { maps_ = maps; }
    /// Of the last frame, all threads together.
    const StageTimes& stageTimes() const { return stageTimes_; }

  private:
    /// What goes through all steps of a frame.
    struct Work {
        const Scene& scene;
        const RayTracer& tracer;
        const RenderSettings& settings;
        int team;
        RenderControl& control;
        Frame& frame;
    };
    void aim(const Scene& scene, const RayTracer& tracer, const Camera& camera,
             const RenderSettings& settings);
    void beginLayers(const Camera& camera, const RenderSettings& settings, Frame& frame) const;
    bool renderView(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings, int threads,
                    RenderControl& control, Frame& frame);
    template <typename Render>
    void renderTiles(const Work& work, const TileGrid& grid, Render&& render);
    void renderChosen(const Work& work, const TileGrid& grid);
    void finish(const Work& work, const PixelArea& tile);
    TileRenderer& rendererOfThread(int thread);

    SampleView view_; ///< of the frame being rendered
    FocusFinder focus_;
    SampleChoice choice_;
    MaterialTable materials_;
    std::vector<std::unique_ptr<TileRenderer>> renderers_; ///< by thread
    bool collectLayers_ = false;
    bool measureStages_ = false;
    const ShadowMaps* maps_ = nullptr;
    StageTimes stageTimes_;
};

/// A single frame: FrameRenderer::render() with memory of its own.
bool renderFrame(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                 const RenderSettings& settings, int threads, RenderControl& control, Frame& frame);

} // namespace rtcore
