/// The effects of images, one after another in the order of the list.
#pragma once

#include "rtcore/post/effect.h"
#include "rtcore/render/frame.h"

#include <memory>
#include <vector>

namespace rtcore {

/// One of each effect. Keeps their memory; not for several threads at once, except changeRow().
class EffectChain {
  public:
    EffectChain();

    /// The frame's radiance after the wanted effects of EffectStage::Radiance: frame.radiance itself when
    /// there are none or `run.stop` became true, else valid until the next call.
    const HdrImage& apply(const Frame& frame, const EffectRun& run);

    /// From here on changeRow() applies the wanted effects from the stage `first` on. `coarse` and `block` as
    /// in Effect::beginRows().
    void beginRows(EffectStage first, const HdrImage& coarse, int block, const EffectRun& run);
    bool changesRows() const { return !ofRows_.empty(); }
    /// Effect::changeRow() of all of them: returns `changed`, or `radiance` itself where none changes it;
    /// then `changed` may be null.
    const Colour* changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const;

  private:
    std::vector<std::unique_ptr<Effect>> effects_; ///< by row of the list
    std::vector<const Effect*> ofRows_;
};

} // namespace rtcore
