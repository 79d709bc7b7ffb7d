/// Frames of a moving camera: what each pixel sees is traced anew, its light is kept from frame to frame as
/// long as it holds. (docs/live.md)
#pragma once

#include "rtcore/live/guide_pass.h"
#include "rtcore/live/live_points.h"
#include "rtcore/live/point_choice.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/view.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

/// What a frame may cost. The picture depends on these numbers and the frames before, on nothing else.
struct LiveBudget {
    int guides = 1;          ///< one of so many pixels has a primary ray: 1, 2 or 4
    double newPoints = 0.15; ///< of the pixels; they get new light
};

/// Keeps the memory of a sequence of frames, 40 bytes per pixel and some lists beside the frame. Not for
/// several threads at once: it uses all of them itself.
class LiveRenderer {
  public:
    LiveRenderer();
    ~LiveRenderer();
    LiveRenderer(const LiveRenderer&) = delete;
    LiveRenderer& operator=(const LiveRenderer&) = delete;

    /// Whether such a view can be drawn: of a perspective camera, one sample per pixel in its middle.
    static bool draws(const View& view);

    /// Draws the next frame. The same bits for every number of threads. Returns false when control.cancel was
    /// set: the frame is undefined then, and the past as it was.
    bool render(const View& view, const LiveBudget& budget, RenderControl& control, Frame& frame);

    /// Keeps the light of a whole frame of that view, which `frame` holds; it may have other samples. Returns
    /// false when control.cancel was set, with the past as it was.
    bool keep(const View& view, const Frame& frame, RenderControl& control);

    /// The light that is kept does not hold any more: lights, materials or settings changed.
    void forget() { past_.points.clear(); }

    /// Of the last frame: pixels that got new light, and those of which none was known, of all.
    double newPoints() const { return newPoints_; }
    double unknownPoints() const { return choice_.unknown(); }

    static std::size_t bytesPerPixel() {
        return 2 * sizeof(LivePoint) + sizeof(float) + 1 + sizeof(SampleId);
    }

  private:
    void begin(const View& view);
    bool findPoints(const View& view, const LiveBudget& budget, RenderControl& control, RayStatistics& rays);
    bool lightPoints(const View& view, RenderControl& control, Frame& frame);

    FrameRenderer renderer_;
    MaterialTable materials_;
    std::vector<std::unique_ptr<GuidePass>> passes_; ///< by thread
    PointChoice choice_;
    std::vector<Colour> light_;               ///< of the chosen points
    std::vector<LightVisibility> visibility_; ///< the same
    LiveImage past_, present_;
    std::uint32_t number_ = 0; ///< of the frame
    double newPoints_ = 0;
};

} // namespace rtcore
