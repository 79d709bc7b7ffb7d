#include "rtcore/post/effect_chain.h"

#include "rtcore/post/effects.h"

namespace rtcore {

EffectChain::EffectChain() {
    for (const EffectRow* row : effects()) effects_.push_back(row->make());
    ofRows_.reserve(effects_.size());
}

const HdrImage& EffectChain::apply(const Frame& frame, const EffectRun& run) {
    const HdrImage* picture = &frame.radiance;
    EffectRun own = run;
    own.guides = frame.guides.empty() ? nullptr : &frame.guides;
    own.covered = &frame.covered;
    own.transmitted = frame.transmitted.empty() ? nullptr : &frame.transmitted;
    own.behind = frame.behind;
    own.halves = frame.halves.empty() ? nullptr : &frame.halves;
    own.steady = frame.steady.empty() ? nullptr : &frame.steady;
    for (std::size_t i = 0; i < effects_.size(); ++i) {
        const EffectRow& row = *effects()[i];
        if (row.stage != EffectStage::Radiance || !row.wanted(run.settings)) continue;
        if (row.needsAovs && frame.aovs.empty()) continue;
        if (row.needsGuides && frame.guides.empty()) continue;
        picture = &effects_[i]->apply(*picture, frame.aovs, own);
        if (run.stop != nullptr && *run.stop) return frame.radiance;
    }
    return *picture;
}

void EffectChain::beginRows(EffectStage first, const HdrImage& coarse, int block, const EffectRun& run) {
    ofRows_.clear();
    for (std::size_t i = 0; i < effects_.size(); ++i) {
        const EffectRow& row = *effects()[i];
        if (row.stage < first || !row.wanted(run.settings)) continue;
        if (effects_[i]->beginRows(coarse, block, run)) ofRows_.push_back(effects_[i].get());
    }
}

const Colour* EffectChain::changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const {
    for (const Effect* effect : ofRows_) {
        effect->changeRow(part, radiance, changed);
        radiance = changed;
    }
    return radiance;
}

} // namespace rtcore
