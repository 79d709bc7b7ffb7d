/// Takes frames from a server and encodes what viewers wait for: each frame once for each rung, however many
/// they are.
#pragma once

#include "bridge/stream/encoded_frame.h"
#include "bridge/stream/histogram.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace bridge {

/// What all viewers of an instance wait for together.
struct FrameDemand {
    static constexpr std::uint64_t kNothing = std::numeric_limits<std::uint64_t>::max();

    bool anyone = false;      ///< a page is open; else the server is left alone
    std::uint32_t stream = 0; ///< that the numbers are of: of another one every frame is wanted
    std::array<std::uint64_t, kRungCount> above{}; ///< of each rung: frames above this number; kNothing
    bool still = false, fine = false;              ///< at rest
    FrameDemand() { above.fill(kNothing); }
    friend bool operator==(const FrameDemand&, const FrameDemand&) = default;
};

/// Figures of all frames so far.
struct FrameFigures {
    std::uint64_t published = 0;              ///< by the server, and taken
    std::array<Histogram, kRungCount> encode; ///< of moving frames
    Histogram still;                          ///< of what is sent at rest
    double framesCpu = 0, stillsCpu = 0;      ///< seconds of the two threads
};

/// Two threads of its own: one waits for frames and encodes, one, of low priority, encodes what rests.
class FrameSource {
  public:
    /// `deliver` is called from these threads with what there is of the newest frame, again when more of it
    /// is encoded; it must not throw.
    FrameSource(std::string instance, const RungTable& rungs, std::function<void(FrameSet)> deliver);
    ~FrameSource();
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    /// Any thread.
    void setDemand(const FrameDemand& demand);
    FrameFigures figures() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace bridge
