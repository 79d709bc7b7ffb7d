/// The status that clients read of a server without asking it.
#pragma once

#include "rtserver/frames/frame_maker.h"
#include "rtserver/walk/workspace.h"

#include "ipc/layout/status.h"

#include <cstdint>

namespace rtserver {

/// The facts of a status that the state and its last frame do not tell.
struct Activity {
    float progress = 1; ///< of a scene that is being loaded, 0..1; 1 when there is none
    double framesPerSecond = 0;
    double wholeSeconds = 0;         ///< see FrameDrawing::wholeSeconds()
    std::uint64_t stateRevision = 0; ///< see StateRevision
    std::uint64_t imageRevision = 0; ///< see ImageRevision
    std::uint32_t messages = 0;      ///< so far
    bool idle = false;               ///< see FrameDrawing::idle()
};

/// The camera is that of the state, which the last frame may not show yet; what a frame took and its exposure
/// are the last frame's. Before there is a scene: what is known without one.
ipc::Status statusOf(const Workspace& state, const FrameMaker& frames, const Activity& activity);

} // namespace rtserver
