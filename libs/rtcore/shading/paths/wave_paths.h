/// The paths of the rays that are being traced.
#pragma once

#include "rtcore/shading/paths/path_queue.h"

namespace rtcore {

/// Primary rays have no queue: they are those of consecutive samples, of weight 1, and have met nothing yet;
/// where they begin in solids, one holds how (`past`). Other rays are those of a queue, which must outlive
/// this and is only read here.
class WavePaths {
  public:
    /// Primary rays, of the samples from the first, or `first`, on.
    WavePaths() = default;
    explicit WavePaths(std::uint32_t first, PathQueue* past = nullptr) : past_(past), first_(first) {}
    explicit WavePaths(PathQueue& queue) : queue_(&queue), past_(&queue) {}

    bool primary() const { return queue_ == nullptr; }
    /// Null for primary rays.
    PathQueue* queue() const { return queue_; }
    /// Null for primary rays that begin in air.
    PathQueue* past() const { return past_; }

    std::uint32_t sample(std::size_t ray) const {
        return primary() ? first_ + static_cast<std::uint32_t>(ray) : queue_->sample[ray];
    }
    /// As in PathQueue.
    std::uint32_t bounces(std::size_t ray) const { return past_ == nullptr ? 0 : past_->bounces[ray]; }
    Path path(std::size_t ray) const {
        if (past_ != nullptr) return past_->path(ray);
        Path path;
        path.sample = sample(ray);
        return path;
    }

  private:
    PathQueue *queue_ = nullptr, *past_ = nullptr;
    std::uint32_t first_ = 0;
};

} // namespace rtcore
