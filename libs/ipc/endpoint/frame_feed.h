/// Follows the server's frame segments from size to size.
#pragma once

#include "ipc/channel/frame_ring.h"
#include "ipc/endpoint/frame.h"
#include "ipc/endpoint/link.h"

#include <optional>

namespace ipc {

/// One thread.
class FrameFeed {
  public:
    explicit FrameFeed(const Names& names) : names_(names) {}
    /// True: `frame` holds a newer frame than before. Works on a dead server's last frame, too.
    bool read(const Link& link, Frame& frame);

  private:
    bool follow(const Link& link);

    Names names_;
    std::uint64_t epoch_ = 0, generation_ = 0;
    std::optional<Segment> segment_;
    std::optional<FrameRingReader> reader_;
};

} // namespace ipc
