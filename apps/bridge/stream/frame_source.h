/// Takes frames from a server and encodes what viewers wait for: each frame once for each rung, however many
/// they are.
#pragma once

#include "bridge/stream/server_frames.h"

#include <memory>
#include <string>

namespace bridge {

/// Two threads of its own, from which events are told: one waits for frames and encodes, one, of low
/// priority, encodes what rests.
class FrameSource : public ServerFrames {
  public:
    FrameSource(std::string instance, const RungTable& rungs, FrameEvents events);
    ~FrameSource() override;
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    void setDemand(const FrameDemand& demand) override;
    void setPreview(const std::optional<PreviewRun>& run) override;
    FrameFigures figures() const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace bridge
