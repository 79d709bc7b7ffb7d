/// Finished areas of a frame, for another thread to read while the rest is rendered.
#pragma once

#include "rtcore/render/pixel_area.h"

#include <mutex>
#include <utility>
#include <vector>

namespace rtcore {

/// Any threads. A thread that takes an area may read its pixels: they are written before it is added, and not
/// again.
class FinishedTiles {
  public:
    void add(const PixelArea& area) {
        const std::lock_guard lock(mutex_);
        areas_.push_back(area);
    }
    /// Those that were added since the last call.
    std::vector<PixelArea> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(areas_, {});
    }

  private:
    std::mutex mutex_;
    std::vector<PixelArea> areas_;
};

} // namespace rtcore
