/// From a scene and a camera to an image of unbounded linear radiance.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/adaptive_sampler.h"
#include "rtcore/render/background.h"
#include "rtcore/render/finished_tiles.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/lens.h"
#include "rtcore/render/rendered_pixels.h"
#include "rtcore/render/sample_rays.h"
#include "rtcore/render/view.h"
#include "rtcore/shading/indirect_taps.h"
#include "rtcore/shading/light/shadow_maps.h"
#include "rtcore/shading/stage_times.h"
#include "rtcore/shading/surface/material_table.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

class TileGrid;
class TileRenderer;

/// Shared with threads that show progress or stop the work. One frame at a time.
struct RenderControl {
    int threads = 0; ///< of the work; 0: all cores
    std::atomic<bool> cancel{false};
    std::atomic<std::uint64_t> tilesDone{0};
    std::atomic<std::uint64_t> tiles{0}; ///< of the whole frame; 0 before it starts
    FinishedTiles* finished = nullptr;   ///< gets each tile when its pixels are written; may be null

    double fraction() const { ///< of the frame that is done, 0..1
        const std::uint64_t all = tiles.load();
        return all == 0 ? 0.0 : static_cast<double>(tilesDone.load()) / static_cast<double>(all);
    }
};

/// Renders frames one after another and keeps the memory of its threads, so that a frame like the one before
/// it allocates nothing. Not for several threads at once: it uses all of them itself.
class FrameRenderer {
  public:
    FrameRenderer();
    ~FrameRenderer();
    FrameRenderer(const FrameRenderer&) = delete;
    FrameRenderer& operator=(const FrameRenderer&) = delete;

    /// Renders into `frame`, whose memory is reused when the size fits. The image has the same bits for
    /// every number of threads. The view may differ in every frame, but not change during one. Returns false
    /// when control.cancel was set, with `frame` undefined.
    bool render(const View& view, RenderControl& control, Frame& frame);

    /// A coarse image of those settings: one sample for each square of `block` x `block` pixels, in
    /// its middle. `frame` gets a pixel for each square, also for those that the right or lower edge cuts.
    bool renderCoarse(const View& view, int block, RenderControl& control, Frame& frame);

    /// Some pixels of the frame that render() gives: those of `pixels`, whose `sub` is 0, in
    /// their order. Neighbours should follow each other there. Mirrored light and samples may be added in
    /// another order, which rounds otherwise; it depends on `pixels` alone. Not with settings.adaptive or
    /// AOVs. Adds to `statistics`. Returns false when control.cancel was set, with `to` undefined.
    bool renderPixels(const View& view, std::span<const SampleId> pixels, RenderControl& control,
                      const RenderedPixels& to, RayStatistics& statistics);

    /// Renders the guides of an image of the view, or of renderCoarse() where `block` is not 1, into
    /// `guides`, whose memory is reused when the size fits. Returns false when control.cancel was set, with
    /// `guides` undefined.
    bool renderGuides(const View& view, int block, GuideRays rays, RenderControl& control, Guides& guides);

    /// Whether frames to come get AOVs: to be written, or for effects (effectsNeedAovs()).
    void collectAovs(bool on) { collectAovs_ = on; }
    /// Of frames to come; shown unless told. Where it is hidden, they are not sampled adaptively. Not for
    /// renderPixels().
    void treatBackground(Background how) { background_ = how; }
    /// Whether frames to come tell what each pixel sees, in Frame::seen and Frame::matter.
    void collectSeen(bool on) { collectSeen_ = on; }
    /// Whether frames to come measure stageTimes().
    void measureStages(bool on) { measureStages_ = on; }
    /// Shadow maps for the next frames, quicker and less exact than rays; null: rays.
    /// The maps are the scene's, suit the settings, and must outlive the frames.
    void takeShadowsFrom(const ShadowMaps* maps) { maps_ = maps; }
    /// Light that surfaces send to each other, and that of the surroundings, in the next frames, in place of
    /// ambient light, occlusion and the light of the sky: looked up in what this knows; null: those there
    /// are. renderPixels() leaves it out, and tells where it is to be added: taps(), lobes(). It must outlive
    /// the frames, and suit scene and settings.
    void lightIndirectlyFrom(const IndirectLight* light) { indirect_ = light; }
    /// Those of the last renderPixels(); their samples are indices of its pixels.
    std::span<const IndirectTap> taps() const { return taps_.matte; }
    std::span<const LobeTap> lobes() const { return taps_.lobes; }
    /// Times of the last frame, summed over all threads.
    const StageTimes& stageTimes() const { return stageTimes_; }

  private:
    /// Arguments of all steps of a frame.
    struct Work {
        const View& view;
        int team; ///< threads
        RenderControl& control;
        Frame& frame;
        std::vector<Vec3>* normals = nullptr; ///< Guides::normals; null: they are not wanted
    };
    bool renderAimed(const View& view, RenderControl& control, Frame& frame,
                     std::vector<Vec3>* normals = nullptr);
    void beginAovs(const View& view, Frame& frame) const;
    void prepare(const View& view);
    template <typename Render>
    void renderParts(const Work& work, int parts, Render&& render);
    void keepTaps(const TileRenderer& renderer, std::size_t ofPixel, std::size_t first, int part);
    void renderAdaptively(const Work& work, const TileGrid& grid);
    void finish(const Work& work, const PixelArea& tile);
    TileRenderer& rendererOfThread(int thread);

    SampleView samples_; ///< of the frame being rendered
    FocusFinder focus_;
    AdaptiveSampler adaptive_;
    MaterialTable materials_;
    std::vector<std::unique_ptr<TileRenderer>> renderers_; ///< by thread
    bool collectAovs_ = false;
    bool collectSeen_ = false;
    Background background_ = Background::Shown;
    bool measureStages_ = false;
    const ShadowMaps* maps_ = nullptr;
    const IndirectLight* indirect_ = nullptr;
    std::vector<IndirectTaps> tapsOfParts_;
    IndirectTaps taps_;
    StageTimes stageTimes_;
};

} // namespace rtcore
