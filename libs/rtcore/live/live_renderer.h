/// Frames of a moving camera: the samples of the frame before are reprojected into the new view, and traced
/// anew where they are stale or missing. (docs/live.md)
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/live/entering_surfaces.h"
#include "rtcore/live/light_change.h"
#include "rtcore/live/live_samples.h"
#include "rtcore/live/pixel_selector.h"
#include "rtcore/live/reconstruction.h"
#include "rtcore/live/reprojection.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/render/view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Renders a sequence of frames, each from samples of the one before. Not for several threads at once: it
/// uses all of them itself. Throws std::bad_alloc; the samples are undefined then.
class LiveRenderer {
  public:
    /// Memory beside the frame, without some megabytes for each thread: where nothing mirrors and few pixels
    /// are traced; and at most, where something mirrors and all are traced.
    static constexpr std::size_t kBytesPerPixel = 103, kMaxBytesPerPixel = 369;
    /// The same in addition, with lightIndirectly().
    static constexpr std::size_t kMatterBytesPerPixel = 2 * sizeof(LiveSamples::Matter);

    /// Whether such a view can be rendered: one sample per pixel in its middle, fewer than
    /// Reprojection::kMaxPixels.
    static bool supports(const View& view);
    static ImagePlane planeOf(const View& view);

    /// Renders the next frame, with about `newSamples` (0..1) of its pixels traced. The image depends on
    /// these numbers and on the frames before; it has the same bits for every number of threads. Returns
    /// false when control.cancel was set: the frame is undefined then, and the samples are as they were.
    bool render(const View& view, double newSamples, RenderControl& control, Frame& frame);

    /// Frames to come are lit by what this learns: each gives it the work of a step. Samples follow what is
    /// learned later in so many turns of frames, at least 1. Null: not any more, and samples stay as they
    /// are.
    void lightIndirectly(IndirectLight* light, const GatherBudget& budget, int turns);

    /// Takes the samples of a whole frame, which has Frame::seen, and with indirect light Frame::matter, of a
    /// view on that plane. It may have any number of samples per pixel. `age`: its samples count as so many
    /// frames old; those of a rough preview are replaced soon.
    void seed(const ImagePlane& plane, const Frame& frame, int threads, std::uint8_t age = 0);

    /// Takes the samples of the finished parts of a frame of that view, in place of those that are known
    /// there.
    void seedParts(const View& view, const Frame& frame, std::span<const PixelArea> parts, int threads);

    /// Drops the samples of surfaces that a change of lights reaches, and the whole specular layer, whose
    /// true positions are not known. Returns the fraction of pixels without a complete sample.
    double invalidate(const LightChange& change, int threads);

    /// Drops all samples, after a change of lights, materials or settings. The next frames are those of a new
    /// LiveRenderer.
    void forget() {
        past_.clear();
        number_ = 0;
        forgetChecks();
    }
    /// Whether the samples can be reused for this view, which has the same projection. Perspective: the
    /// distance to what was seen before is about the same, else things behind would be seen through gaps
    /// between samples; and no surface lies between the old eye and the new one. Parallel: it has about the
    /// same direction and width, and shows half of the surfaces that were seen before.
    bool canReuse(const View& view);
    bool empty() const { return past_.surface.size() == 0; } ///< nothing is kept

    /// Seconds that the traced pixels of the last frame took, but what indirect light learned of them.
    double sampleSeconds() const { return sampleSeconds_; }
    /// Fractions of the last frame's pixels: those that were traced, and those without a sample.
    double newSamples() const { return newSamples_; }
    double unknown() const { return selector_.unknown(); }

  private:
    void forgetOtherProjection(const ImagePlane& plane);
    void reproject(const RayTracer& tracer, int threads, const Reprojection::RowsDone& done);
    void updateBackground(const View& view, int threads);
    bool isFar(Vec3 eye) const;
    bool crossesSurface(Vec3 eye, const RayTracer& tracer);
    void check();
    void forgetChecks();
    void meter(int threads, Frame& frame) const;
    void beginMirroring();
    bool lightSamples(const View& view, RenderControl& control, Frame& frame);
    LightVisibility surelyKnown(int x, int y) const;
    bool addIndirect(const View& view, RenderControl& control);
    void collectReceivers(const View& view);
    void addToChosen();
    void addAlongLobes();
    void findFractions();
    void updateLight(int threads);

    FrameRenderer renderer_;
    Reprojection reprojection_;
    EnteringSurfaces entering_;
    PixelSelector selector_;
    Reconstruction reconstruction_;
    std::vector<Colour> light_;               ///< of the chosen pixels
    std::vector<LightVisibility> visibility_; ///< the same
    std::vector<SeenPoint> seen_;             ///< the same
    IndirectLight* indirect_ = nullptr;
    GatherBudget budget_;
    int turns_ = 1;
    std::vector<Receiver> receivers_;         ///< of the renderer's taps, then of samples that are updated
    std::vector<ArrivingLight> arriving_;     ///< the same
    std::vector<Colour> alongLobes_;          ///< radiance of the renderer's lobes
    std::vector<std::uint32_t> updated_;      ///< the pixels of these
    std::vector<LiveSamples::Matter> matter_; ///< of the chosen pixels
    std::vector<Colour> surfaceLight_;        ///< the same
    LiveLayers past_, present_;
    static constexpr std::size_t kCheckedFrames = 24;
    std::array<std::vector<CheckedPixel>, kCheckedFrames> checked_; ///< of the last frames
    std::uint32_t number_ = 0;                                      ///< of the frame
    double newSamples_ = 0, sampleSeconds_ = 0;
    double otherSeconds_ = 0; ///< of those in which samples were lit: learning, and updating older ones
    RayWave eyePath_;         ///< from the eye of the last frame to that of the next
    std::vector<std::uint8_t> crossed_;
};

} // namespace rtcore
