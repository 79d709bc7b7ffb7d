/// Steps by which indirect light is learned of what views show.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/view.h"

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
    /// The same about the pixels whose turn it is, of `turns` in which all have theirs.
    bool stepOfTurn(const View& view, std::uint32_t turn, std::uint32_t turns, const GatherBudget& budget,
                    RenderControl& control, IndirectLight& light);
    /// Steps until all records that the view uses have budget.enough passes, about; some dozens at most.
    /// Quick where the light knows the view.
    bool learnEnough(const View& view, const GatherBudget& budget, RenderControl& control,
                     IndirectLight& light);

  private:
    FrameRenderer renderer_;
    std::vector<Colour> radiance_; ///< of the pixels; not used
    std::vector<Receiver> receivers_;
    std::vector<ArrivingLight> arriving_;
    std::vector<Colour> alongLobes_; ///< not used
};

} // namespace rtcore
