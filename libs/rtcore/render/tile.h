/// One tile of the image: its rays are traced as one wave.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/adaptive_sampler.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/render/rendered_pixels.h"
#include "rtcore/render/sample_rays.h"
#include "rtcore/render/view.h"
#include "rtcore/shading/whitted.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// How an image is cut into square tiles, in pixels. Depends on the image alone, never on threads.
class TileGrid {
  public:
    /// `secondaryRays`: mirrors or transparent surfaces may send rays on.
    TileGrid(const RenderSettings& settings, bool secondaryRays);

    int count() const { return columns_ * rows_; }
    /// At the right and lower edge of the image smaller than elsewhere.
    PixelArea area(int tile) const;

  private:
    int width_, height_, side_, columns_, rows_;
};

/// Renders tiles one after another; one for each thread, reuses its memory from tile to tile and from frame
/// to frame.
class TileRenderer {
  public:
    /// Input shared by the tiles of a frame; must outlive it.
    struct FrameTask {
        const View& view;
        const SampleView& samples;
        const MaterialTable& materials; ///< of the view's scene and settings
        const ShadowMaps* shadowMaps;   ///< as WhittedIntegrator takes them; may be null
        const IndirectLight* indirect;  ///< indirect light is looked up there; may be null
        const std::atomic<bool>& cancel;
        bool measureStages;
        Aovs* aovs;                      ///< gets what samples see first; may be null
        std::vector<SeenPoint>* seen;    ///< the same of each pixel of the frame; may be null
        std::vector<SeenMatter>* matter; ///< of the same points, with `indirect`; may be null
        bool hidesBackground;            ///< tiles get Frame::transmitted
        std::vector<Vec3>*
            normals; ///< gets means of WhittedIntegrator::normals(), begins with 0; may be null
    };
    /// Starts a frame, or a pass of it.
    void begin(const FrameTask& task);

    /// Writes the pixels of one tile into `frame`; soon returns, with them undefined, when `cancel` is set.
    void render(const PixelArea& area, Frame& frame);
    /// The same in two steps. The first leaves sums in frame.radiance and numbers of hits in frame.covered.
    void renderFirst(const PixelArea& area, AdaptiveSampler& sampler, Frame& frame);
    void renderRest(const PixelArea& area, const AdaptiveSampler& sampler, Frame& frame);
    /// Pixels anywhere, in their order; their `sub` is 0.
    void renderPixels(std::span<const SampleId> pixels, const RenderedPixels& to);
    /// Points of the last renderPixels() that take indirect light, which it leaves out; one sample for each
    /// pixel.
    std::span<const IndirectTap> taps() const { return integrator_.taps(); }
    std::span<const LobeTap> lobes() const { return integrator_.lobes(); }
    const RayStatistics& statistics() const { return integrator_.statistics(); }
    const StageTimes& stageTimes() { return integrator_.clock().times(); }

  private:
    void collectRays(const PixelArea& area);
    void collectDirections(const PixelArea& area);
    template <typename Wanted>
    void nameSamples(const PixelArea& area, Wanted&& wanted);
    void traceSamples();
    void traceRays();
    void addIndirect();
    void findTaps();
    SeenMatter matterOf(std::size_t sample, const SeenPoint& seen) const;
    void clearSums(const PixelArea& area);
    void addToSums(const PixelArea& area);
    template <typename Count>
    void storeMeans(const PixelArea& area, Frame& frame, Count&& count);
    void keepHits();
    void addNormals();
    void forgetHits(const PixelArea& area);
    void storePixels(const PixelArea& area, Frame& frame);
    void averageSamples(const PixelArea& area, Frame& frame);

    const RenderSettings* settings_ = nullptr;
    const SampleView* view_ = nullptr; ///< of samples
    WhittedIntegrator integrator_;
    RayWave rays_;
    bool needsSampleIds_ = false;
    bool hidesBackground_ = false;
    const IndirectLight* indirect_ = nullptr; ///< null: there is none
    std::vector<Receiver> receivers_;         ///< of a wave's taps
    std::vector<ArrivingLight> arriving_;     ///< the same
    std::vector<Colour> alongLobes_;
    LobeScratch lobeScratch_;
    Aovs* aovs_ = nullptr;                      ///< that samples are added to; null: not asked for
    std::vector<SeenPoint>* seen_ = nullptr;    ///< the same
    std::vector<SeenMatter>* matter_ = nullptr; ///< the same
    std::vector<std::uint32_t> tapOf_;          ///< by sample of a wave: that of its primary hit, or kNoTap
    std::vector<Vec3>* normals_ = nullptr;      ///< the same
    std::vector<SampleId> samples_;             ///< of rays_, where sample ids are needed
    bool sameOrigin_ = false;                   ///< all of rays_ begin at the eye already
    /// Sums over the samples of one pixel.
    struct PixelSum {
        Colour radiance;
        int hits = 0;
        Colour transmitted = {};
    };
    std::vector<PixelSum> sums_;      ///< of the tile, row by row
    std::vector<std::uint32_t> slot_; ///< of each sample of the tile, by row * width + column: its ray
};

} // namespace rtcore
