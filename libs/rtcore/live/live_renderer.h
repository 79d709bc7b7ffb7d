/// Frames of a moving camera: the light of the frame before is taken along to where it is seen now, and where
/// it does not hold, new light is traced. (docs/live.md)
#pragma once

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

/// Keeps the memory of a sequence of frames. Not for several threads at once: it uses all of them itself.
/// Throws std::bad_alloc; what is kept is undefined then.
class LiveRenderer {
  public:
    /// What it keeps for each pixel, beside the frame: where nothing mirrors and few pixels are traced; and
    /// at most, where something mirrors and all are traced. Some megabytes for each thread are not counted.
    static constexpr std::size_t kBytesPerPixel = 103, kMaxBytesPerPixel = 369;

    /// Whether such a view can be drawn: of a perspective camera, one sample per pixel in its middle, fewer
    /// than Reprojection::kMaxPixels.
    static bool supports(const View& view);
    static ImagePlane planeOf(const View& view);

    /// Draws the next frame, with about `newSamples` (0..1) of its pixels traced. The image depends on these
    /// numbers and on the frames before; it has the same bits for every number of threads. Returns false when
    /// control.cancel was set: the frame is undefined then, and what is kept as it was.
    bool render(const View& view, double newSamples, RenderControl& control, Frame& frame);

    /// Keeps the light of a whole frame, which has Frame::seen, of a view on that plane. It may have any
    /// number of samples per pixel. Light that was traced roughly counts as so many frames old: it is soon
    /// replaced.
    void seed(const ImagePlane& plane, const Frame& frame, int threads, std::uint8_t age = 0);

    /// Keeps the light of those parts of a whole frame of that view, which was left before it was finished,
    /// in place of what is known there.
    void seedParts(const View& view, const Frame& frame, std::span<const PixelArea> parts, int threads);

    /// Lights have changed: forgets the light of surfaces that this reaches, and all that is mirrored, since
    /// that is not known to be where it seems to be. Returns the part of the pixels of which none is known.
    double invalidate(const LightChange& change, int threads);

    /// What is kept does not hold any more: lights, materials or settings changed. The frames from here on
    /// are those of a new LiveRenderer.
    void forget() {
        past_.clear();
        number_ = 0;
        forgetChecks();
    }
    /// Whether the light that is kept shows what is seen from there: it is not much nearer to, or further
    /// from, what was seen before, else things would be seen through gaps in others that are new; and on the
    /// way there is no surface, behind which all is different.
    bool canReuse(Vec3 eye, const RayTracer& tracer);
    bool empty() const { return past_.surface.size() == 0; } ///< nothing is kept

    /// Seconds that the traced pixels of the last frame took.
    double sampleSeconds() const { return sampleSeconds_; }
    /// Of the last frame: pixels that were traced, and those of which nothing was known, of all.
    double newSamples() const { return newSamples_; }
    double unknown() const { return selector_.unknown(); }

  private:
    bool isFar(Vec3 eye) const;
    bool crossesSurface(Vec3 eye, const RayTracer& tracer);
    void check();
    void forgetChecks();
    void meter(int threads, Frame& frame) const;
    void beginMirroring();
    bool lightSamples(const View& view, RenderControl& control, Frame& frame);
    LightVisibility surelyKnown(int x, int y) const;

    FrameRenderer renderer_;
    Reprojection reprojection_;
    PixelSelector selector_;
    Reconstruction reconstruction_;
    std::vector<Colour> light_;               ///< of the chosen pixels
    std::vector<LightVisibility> visibility_; ///< the same
    std::vector<SeenPoint> seen_;             ///< the same
    LiveLayers past_, present_;
    static constexpr std::size_t kCheckedFrames = 24;
    std::array<std::vector<CheckedPixel>, kCheckedFrames> checked_; ///< of the last frames
    std::uint32_t number_ = 0;                                      ///< of the frame
    double newSamples_ = 0, sampleSeconds_ = 0;
    RayWave eyePath_; ///< of the eye, from frame to frame
    std::vector<std::uint8_t> crossed_;
};

} // namespace rtcore
