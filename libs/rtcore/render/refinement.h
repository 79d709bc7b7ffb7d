/// One image rendered from coarse to fine, for a quick first look.
#pragma once

#include "rtcore/render/frame_renderer.h"

#include <functional>
#include <mutex>
#include <vector>

namespace rtcore {

/// One pass of the refinement.
struct RefinementPass {
    int block = 1;        ///< pixels a side of the squares that share one sample
    int antialiasing = 1; ///< samples per pixel, each way; 1 while pixels share them
    friend bool operator==(const RefinementPass&, const RefinementPass&) = default;
};

/// From one sample for 8 x 8 pixels on, each pass with four times the samples of the one before it; the last
/// is the image itself. All but the first are left out if the passes before the last would take more than a
/// tenth of its time together.
std::vector<RefinementPass> planRefinement(const RenderSettings& settings);

/// Renders one image after another; one thread calls render(), others may look meanwhile.
class Refinement {
  public:
    /// Gets a pass that is over and its frame, which it may read until it returns.
    using Show = std::function<void(const RefinementPass&, const Frame&)>;

    /// As FrameRenderer::render, and with its result, to the bit: what comes before is thrown away. Calls
    /// `show` for each pass but the last one.
    bool render(FrameRenderer& renderer, const View& view, RenderControl& control, Frame& frame,
                const Show& show);

    /// The fraction of all work that is done, 0..1. Any thread.
    double fraction(const RenderControl& control) const;
    /// The parts of the last pass that are done. Any thread.
    FinishedTiles& finishedTiles() { return finished_; }

  private:
    void enter(double fraction, RenderControl& control);

    FinishedTiles finished_;
    Frame frame_;              ///< of the passes before the last
    mutable std::mutex mutex_; ///< guards all below, and the way of the control from pass to pass
    double before_ = 0;        ///< fraction of the passes that are over
    double fraction_ = 0;      ///< of the pass under way
};

} // namespace rtcore
