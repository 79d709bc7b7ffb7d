/// Images of a Renderer that shows what it renders (docs/protocol.md, "A preview"), in place of the frames of
/// a server that rests.
#pragma once

#include "ipc/endpoint/frame.h"
#include "ipc/endpoint/viewer.h"

#include <cstdint>
#include <optional>
#include <string>

namespace bridge {

/// The image that is to be seen once there is something of it.
struct PreviewRun {
    std::string instance; ///< of the Renderer
    std::uint64_t run = 0;
    std::int64_t since = 0; ///< nanoseconds: a frame that the server publishes later shows something else
    friend bool operator==(const PreviewRun&, const PreviewRun&) = default;
};

/// How far it is.
struct PreviewProgress {
    std::uint64_t run = 0;
    double part = 0; ///< of the work, 0 to 1
    bool done = false;
    std::uint32_t samples = 0;           ///< of each pixel, at least; 0: several pixels share one
    float error = -1, largestError = -1; ///< codes of 255 (rtcore/post/net_mix.h); negative: not known
    friend bool operator==(const PreviewProgress&, const PreviewProgress&) = default;
};

/// By what its frame says.
PreviewProgress progressOf(const ipc::FrameInfo& preview);

/// One thread.
class PreviewFrames {
  public:
    /// True: `frame` holds a newer image of that run, whole: where it has no pixels yet, those of `live`. One
    /// of another size than `live` is passed over. Never waits. Throws ipc::Error, but not for a Renderer
    /// that is not there yet.
    bool read(const PreviewRun& run, const ipc::Frame& live, ipc::Frame& frame);
    /// Lets go of the Renderer.
    void leave() { viewer_.reset(); }

  private:
    bool find(const std::string& instance);

    std::string instance_;
    std::optional<ipc::Viewer> viewer_;
    ipc::FrameInfo last_; ///< that was read
    std::uint64_t epoch_ = 0;
};

} // namespace bridge
