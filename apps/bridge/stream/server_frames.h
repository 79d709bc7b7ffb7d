/// Frames of a server, as a room takes them: FrameSource in the bridge, something else in tests.
#pragma once

#include "bridge/stream/encoded_frame.h"
#include "bridge/stream/histogram.h"
#include "bridge/stream/preview_frames.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace bridge {

/// The frames that all viewers of an instance together wait for.
struct FrameDemand {
    static constexpr std::uint64_t kNothing = std::numeric_limits<std::uint64_t>::max();

    bool anyone = false;      ///< a page is open; else the server is left alone
    std::uint32_t stream = 0; ///< that the numbers are of: of another one every frame is wanted
    std::array<std::uint64_t, kRungCount> above{}; ///< of each rung: frames above this number; kNothing
    bool still = false, fine = false;              ///< at rest
    FrameDemand() { above.fill(kNothing); }
    friend bool operator==(const FrameDemand&, const FrameDemand&) = default;
};

/// Called from any thread; must not throw.
struct FrameEvents {
    /// Takes the encodings of the newest frame, again when there are more of them.
    std::function<void(FrameSet)> deliver;
    /// A server is there, and its frames cannot be taken or encoded: no slot or no memory is left. Told once,
    /// and again after a frame that could be.
    std::function<void(std::string why)> failed;
    std::function<void(const PreviewProgress&)> preview; ///< an image of setPreview() got better
};

/// Figures of all frames so far.
struct FrameFigures {
    std::uint64_t published = 0;              ///< by the server, and taken
    std::array<Histogram, kRungCount> encode; ///< of moving frames
    Histogram still;                          ///< of what is sent at rest
    double framesCpu = 0, stillsCpu = 0;      ///< seconds of the two threads
};

/// Any thread; none waits.
class ServerFrames {
  public:
    virtual ~ServerFrames() = default;
    virtual void setDemand(const FrameDemand& demand) = 0;
    /// The images of that run are taken as well, as soon as there are any, until the server publishes a frame
    /// after PreviewRun::since. Nothing: the server's frames only; what is shown stays until its next one.
    virtual void setPreview(const std::optional<PreviewRun>& run) = 0;
    virtual FrameFigures figures() const = 0;
};

} // namespace bridge
