/// The indirect light of views.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/view.h"

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Has indirect light learn what pixels of views see, in mirrors and through glass, too. Keeps its memory.
/// Not for several threads at once: it uses those of the control itself.
class ViewSteps {
  public:
    /// A step about pixels of the view, whose `sub` is 0. False when control.cancel was set.
    bool step(const View& view, std::span<const SampleId> pixels, const GatherBudget& budget,
              RenderControl& control, IndirectLight& light);

  private:
    FrameRenderer renderer_;
    std::vector<Colour> radiance_; ///< of the pixels; not used
    std::vector<Receiver> receivers_;
    std::vector<ArrivingLight> arriving_;
};

/// The light of one view, learned from nothing by a fixed schedule: an image that is lit by it depends on the
/// view alone, whatever was walked through before.
class ViewLight {
  public:
    /// The same bits for any number of threads. Returns false when control.cancel was set: only a
    /// part is known then. Takes some seconds of two processors.
    bool learn(const View& view, RenderControl& control);
    /// Progress of learn(), 0..1. Any thread.
    float fraction() const { return done_; }
    const IrradianceCache& cache() const { return light_.cache(); }

  private:
    ViewSteps steps_;
    IndirectLight light_;
    std::atomic<float> done_ = 0;
};

} // namespace rtcore
