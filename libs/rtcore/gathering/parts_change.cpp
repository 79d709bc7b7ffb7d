#include "rtcore/gathering/parts_change.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::size_t kComparedAtOnce = 256; ///< records that pass at once

} // namespace

/// Each part is of records everywhere.
void PartsChange::begin(std::span<const GatherPass> passes, std::size_t records, const Box3& bounds,
                        std::uint32_t frame) {
    difference_.begin(bounds);
    passes_.clear();
    sites_.clear();
    const std::size_t parts = (passes.size() + kComparedAtOnce - 1) / kComparedAtOnce;
    for (std::size_t part = 0; part < parts; ++part)
        for (std::size_t i = part; i < passes.size(); i += parts) passes_.push_back(passes[i]);
    records_ = records;
    frame_ = frame;
    passed_ = 0;
    passedBefore_ = taken_ = false;
    left_ = step_ = 0;
}

bool PartsChange::compare(const GatherTask& now, std::uint32_t step, std::size_t records,
                          PassGatherer& gatherer, OutgoingCells& cells) {
    if (step_ != step) left_ = records;
    step_ = step;
    const GatherTask before = taskBefore(now);
    while (left_ > 0 && passed_ < passes_.size()) {
        const auto part =
            std::span(passes_).subspan(passed_, std::min(kComparedAtOnce, passes_.size() - passed_));
        if (!passedBefore_ && !difference_.passBefore(before, part, gatherer)) return false;
        passedBefore_ = true;
        if (!difference_.passNow(now, part, gatherer, cells)) return false;
        passedBefore_ = false;
        sites_.insert(sites_.end(), gatherer.hits().sites().begin(), gatherer.hits().sites().end());
        passed_ += part.size();
        left_ -= std::min(left_, part.size());
    }
    return true;
}

} // namespace rtcore
