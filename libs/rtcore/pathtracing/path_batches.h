/// The rays of one step of all paths, in batches that are small enough to be shaded in the cache.
#pragma once

#include "rtcore/pathtracing/path_batch.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace rtcore {

/// Keeps its memory.
class PathBatches {
  public:
    /// Rays that are shaded together, a multiple of kWaveBlock: what is known of them takes about 1 MB.
    static constexpr std::size_t kBatch = 2048;

    void clear() { used_ = 0; }
    bool empty() const { return used_ == 0 || all_[0].queue.empty(); }
    /// None but the last is empty.
    std::span<PathBatch> batches() { return std::span(all_).first(used_); }

    /// A batch with room for `count` rays more. Valid until the next call.
    PathBatch& roomFor(std::size_t count) {
        if (used_ > 0 && all_[used_ - 1].queue.size() + count <= 2 * kBatch) return all_[used_ - 1];
        if (used_ == 0 || !all_[used_ - 1].queue.empty()) ++used_;
        if (used_ > all_.size()) all_.emplace_back();
        all_[used_ - 1].start(std::max(count, 2 * kBatch));
        return all_[used_ - 1];
    }

  private:
    std::vector<PathBatch> all_;
    std::size_t used_ = 0;
};

} // namespace rtcore
