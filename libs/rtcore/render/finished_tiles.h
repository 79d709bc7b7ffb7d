/// Finished areas of a frame, for another thread to read while the rest is rendered.
#pragma once

#include "rtcore/render/pixel_area.h"

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace rtcore {

/// Any threads. A thread that takes an area may read its pixels: they are written before it is added, and not
/// again.
class FinishedTiles {
  public:
    /// For another frame.
    void clear() {
        const std::lock_guard lock(mutex_);
        areas_.clear();
        taken_ = 0;
    }
    void add(const PixelArea& area) {
        const std::lock_guard lock(mutex_);
        areas_.push_back(area);
    }
    /// Those that were added since the last call.
    std::vector<PixelArea> take() {
        const std::lock_guard lock(mutex_);
        const auto first = static_cast<std::ptrdiff_t>(std::exchange(taken_, areas_.size()));
        return {areas_.begin() + first, areas_.end()};
    }
    std::vector<PixelArea> all() const {
        const std::lock_guard lock(mutex_);
        return areas_;
    }

  private:
    mutable std::mutex mutex_;
    std::vector<PixelArea> areas_;
    std::size_t taken_ = 0; ///< of them
};

} // namespace rtcore
